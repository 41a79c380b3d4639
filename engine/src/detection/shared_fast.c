/* shared_fast.c: the search for shapes near the paths of fast bodies, by workers, each of which
 * takes TD_SHARE_FAST bodies at a time. Most fast bodies have no shape near. The bodies that have
 * one are swept by the calling thread in order, since stopping a body also stops the bodies that
 * joints tie to it. Stopping a body only shortens its motion, so that a body without a shape near
 * its path needs no second search. */
#include "detection/detection.h"
#include "state/jobs.h"
#include "state/shared_stages.h"

/* Workers share the search if there are at least this many fast bodies. With fewer the calling
 * thread finishes before another thread has woken up. Chosen; not tuned. */
enum { SHARED_FAST_MIN = 1024 };

/* Room for the hits of a query on a worker's stack, ints. A body with more hits counts as having a
 * shape near. Chosen. */
enum { HITS_OF_BODY = 256 };

/* The argument of all workers. */
typedef struct sifting {
    thud_world *w;
    td_job job;
} sifting;

static int share_count(const thud_world *w) {
    return (w->scratch.fast.count + TD_SHARE_FAST - 1) / TD_SHARE_FAST;
}

static td_fast_share *share_at(const thud_world *w, int index) {
    return &TD_AT(td_share, &w->scratch.shares, index)->fast;
}

/* Searches for one share of the bodies (a td_chunk_fn). */
static void sift_share(void *work, int index) {
    thud_world *w = ((const sifting *)work)->w;
    td_fast_share *share = share_at(w, index);
    int room[HITS_OF_BODY];
    td_array hits = td_share_list(room, HITS_OF_BODY);
    td_memory none = td_memory_none();
    int first = index * TD_SHARE_FAST;
    int end = td_min_int(first + TD_SHARE_FAST, w->scratch.fast.count);
    share->meeting = td_share_list(share->room, TD_SHARE_FAST);
    for (int i = first; i < end; i++) {
        td_fast_fetch(w, i);
        td_awake_slot slot = td_slot_in(&w->scratch.fast, i);
        if (td_fast_meets(w, slot, &hits, &none)) {
            td_push_slot(&share->meeting, slot);
        }
    }
}

static void sift_as_worker(void *argument) {
    sifting *s = argument;
    td_worker worker = td_worker_arrive(&s->job);
    td_worker_walk(&worker, share_count(s->w), sift_share, s);
}

/* Removes the bodies without a shape near from scratch.fast. If memory for the results is short,
 * all bodies stay in the list. */
void td_shared_sift_fast(thud_world *w) {
    int shares = share_count(w);
    if (td_workers_for_bodies(w) <= 1 || w->scratch.fast.count < SHARED_FAST_MIN ||
        !td_array_reserve(&w->memory, &w->scratch.shares, shares)) {
        return;
    }
    sifting s = {.w = w};
    td_job_begin(&s.job, w->def.job_system.workers);
    td_job_run(w, &s.job, sift_as_worker, &s);
    w->scratch.fast.count = 0;
    for (int i = 0; i < shares; i++) {
        td_share_append(&w->scratch.fast, &share_at(w, i)->meeting);
    }
}
