/* shared_finalize.c: finalize by workers, each of which takes TD_SHARE_BODIES bodies at a time.
 * Their results are joined in the order of the bodies, so that they are the same as those of one
 * worker. */
#include "state/jobs.h"
#include "state/kinds.h"
#include "state/shared_stages.h"

#include <string.h>

static int share_count(const thud_world *w) {
    return (w->body_of.count + TD_SHARE_BODIES - 1) / TD_SHARE_BODIES;
}

/* Whether workers share the stage: there are enough bodies, and memory for the results. Otherwise
 * the calling thread finalizes all bodies alone. */
static bool is_shared(thud_world *w) {
    return td_workers_for_bodies(w) > 1 &&
           td_array_reserve(&w->memory, &w->scratch.shares, share_count(w));
}

static td_finalize_share *share_at(const thud_world *w, int index) {
    return &TD_AT(td_share, &w->scratch.shares, index)->finalize;
}

/* The argument of all workers. */
typedef struct finalizing {
    thud_world *w;
    td_job job;
} finalizing;

static void finalize_share(void *work, int index) {
    thud_world *w = ((const finalizing *)work)->w;
    td_finalize_share *share = share_at(w, index);
    share->odd = td_share_list(share->room[0], TD_SHARE_BODIES);
    share->fast = td_share_list(share->room[1], TD_SHARE_BODIES);
    share->moved = td_share_list(share->room[2], TD_SHARE_BODIES);
    memset(share->sums, 0, sizeof share->sums);
    int first = index * TD_SHARE_BODIES;
    share->part = (td_finalize_part){.first = first,
                                     .end = td_min_int(first + TD_SHARE_BODIES, w->body_of.count),
                                     .odd = &share->odd,
                                     .fast = &share->fast,
                                     .moved = &share->moved,
                                     .sums = share->sums,
                                     .sums_step = 1};
    TD_PICK_WIDE(w, td_finalize_bodies)(w, &share->part);
}

static void finalize_as_worker(void *argument) {
    finalizing *f = argument;
    td_worker worker = td_worker_arrive(&f->job);
    td_worker_walk(&worker, share_count(f->w), finalize_share, f);
}

/* Adds the results of one share to those of all bodies. Energies are added in groups of eight
 * bodies in order, as one worker does it, so that the sums have the same bits. */
static void add_share(td_finalize_part *all, const td_finalize_share *share) {
    td_share_append(all->odd, &share->odd);
    td_share_append(all->fast, &share->fast);
    td_share_append(all->moved, &share->moved);
    all->has_moved |= share->part.has_moved;
    all->idle += share->part.idle;
    all->drowsy += share->part.drowsy;
    for (int i = 0; i < TD_SHARE_BODIES / TD_LANES; i++) {
        all->sums->kinetic += share->sums[i].kinetic;
        all->sums->gained += share->sums[i].gained;
    }
}

void td_shared_finalize(thud_world *w, td_finalize_part *all) {
    if (!is_shared(w)) {
        TD_PICK_WIDE(w, td_finalize_bodies)(w, all);
        return;
    }
    finalizing f = {.w = w};
    td_job_begin(&f.job, w->def.job_system.workers);
    td_job_run(w, &f.job, finalize_as_worker, &f);
    for (int i = 0; i < share_count(w); i++) {
        add_share(all, share_at(w, i));
    }
}
