/* shared_sweep.c: the search for pairs of awake shapes by workers, each of which takes
 * TD_SHARE_SHAPES shapes of the proxy set at a time.
 *
 * A worker allocates nothing, and has room for a fixed number of pairs. The calling thread then
 * goes through all parts in order: it adds the pairs that a worker found in a part, or searches the
 * part itself if it needs more room or has pairs of which bounds tell nothing
 * (td_bounds_tell_nothing). Which parts it has to search does not depend on the workers, so that
 * pairs come in the same order with any number of workers. */
#include "state/jobs.h"
#include "state/shared_stages.h"

#include <string.h>

/* Workers share the search if at least this many shapes search. With fewer the calling thread
 * finishes before another thread has woken up. Chosen; not tuned. */
enum { SHARED_SHAPES_MIN = 1024 };

/* Room for hits on a worker's stack, ints: the maximum number of bounds that one shape may be
 * compared with. Chosen. */
enum { HITS_OF_SHAPE = 1024 };

/* The argument of all workers. */
typedef struct sweeping {
    thud_world *w;
    td_job job;
} sweeping;

/* The search of one part. */
typedef struct sweeper {
    const thud_world *w;
    td_sweep_share *share;
} sweeper;

static int share_count(const thud_world *w) {
    return (w->awake_shapes.ids.count + TD_SHARE_SHAPES - 1) / TD_SHARE_SHAPES;
}

static td_sweep_share *share_at(const thud_world *w, int index) {
    return &TD_AT(td_share, &w->scratch.shares, index)->sweep;
}

/* Whether workers share the search: enough shapes search, the world is not vast (bounds tell which
 * pairs are new, except for woken shapes), and there is memory. Otherwise the calling thread
 * searches alone. */
static bool is_shared(thud_world *w) {
    const td_proxy_set *set = &w->awake_shapes;
    int searching = td_sweeps_every(set) ? set->ids.count : set->moved_count;
    return td_workers_for_bodies(w) > 1 && searching >= SHARED_SHAPES_MIN && !w->vast &&
           td_array_reserve(&w->memory, &w->scratch.shares, share_count(w));
}

/* Searches the shapes of one part; the arguments are those of a td_sweep_fn. */
static bool sweep_part(const thud_world *w, td_memory *memory, int index, td_array *hits,
                       td_hits_fn *report, void *context, int64_t *tested) {
    td_proxy_set part = w->awake_shapes;
    int first = index * TD_SHARE_SHAPES;
    part.head = first;
    part.tail = td_max_int(part.ids.count - first - TD_SHARE_SHAPES, 0);
    hits->count = 0;
    return w->def.broadphase->sweep[w->wide](&part, memory, w->proxy.data, hits, report, context,
                                             tested);
}

/* ---- a worker ---- */

/* Tests the pairs of a share whose index is new_count or above, and keeps those that are new. False
 * where bounds do not tell whether a pair is new. */
static bool keep_new_pairs(const sweeper *s) {
    const thud_world *w = s->w;
    td_sweep_share *share = s->share;
    for (int i = share->new_count; i < share->count; i++) {
        const td_new_pair *pair = &share->pairs[i];
        int marks = *td_marks_at(w, pair->a) | *td_marks_at(w, pair->b);
        if (td_bounds_tell_nothing(w, marks)) {
            return false;
        }
        if (!td_bounds_had_met(w, marks, td_bounds_before(w, pair->a), pair->b)) {
            share->pairs[share->new_count++] = *pair;
        }
    }
    share->count = share->new_count;
    return true;
}

/* A td_hits_fn: notes the overlapping pairs of a shape, to be tested once their bounds are in the
 * cache. */
static bool note_hits(void *context, int shape, const int *hits, int count) {
    const sweeper *s = context;
    td_sweep_share *share = s->share;
    if (count > TD_SHARE_PAIRS - share->count &&
        (!keep_new_pairs(s) || count > TD_SHARE_PAIRS - share->count)) {
        return false;
    }
    share->overlaps += count;
    for (int i = 0; i < count; i++) {
        if (td_fetches(s->w)) {
            td_bounds_before_fetch(s->w, hits[i]);
        }
        share->pairs[share->count++] = (td_new_pair){shape, hits[i], 0};
    }
    return true;
}

/* Searches one part (a td_chunk_fn). */
static void sweep_share(void *work, int index) {
    const sweeping *shared = work;
    sweeper s = {shared->w, share_at(shared->w, index)};
    int room[HITS_OF_SHAPE];
    td_array hits = td_share_list(room, HITS_OF_SHAPE);
    td_memory none = td_memory_none();
    td_sweep_share *share = s.share;
    share->count = share->new_count = 0;
    share->overlaps = share->tested = 0;
    share->done = sweep_part(shared->w, &none, index, &hits, note_hits, &s, &share->tested) &&
                  keep_new_pairs(&s);
}

static void sweep_as_worker(void *argument) {
    sweeping *shared = argument;
    td_worker worker = td_worker_arrive(&shared->job);
    td_worker_walk(&worker, share_count(shared->w), sweep_share, shared);
}

/* ---- the calling thread ---- */

/* Adds the pairs that a worker found in a part. False when memory is short. */
static bool add_share(td_pair_search *search, const td_sweep_share *share, int64_t *tested) {
    td_array *pairs = &search->w->scratch.pairs;
    if (!td_array_reserve(&search->w->memory, pairs, pairs->count + share->count)) {
        return false;
    }
    if (share->count) {
        memcpy((td_new_pair *)pairs->data + pairs->count, share->pairs,
               (size_t)share->count * sizeof *share->pairs);
    }
    pairs->count += share->count;
    search->overlaps += share->overlaps;
    *tested += share->tested;
    return true;
}

/* Adds the pairs that the workers found, and searches the parts that they left undone. False when
 * memory is short, or where so many pairs overlap that the world becomes crowded. */
static bool join(const sweeping *shared, td_memory *memory, td_array *hits, td_hits_fn *report,
                 td_pair_search *search, int64_t *tested) {
    const thud_world *w = shared->w;
    bool done = true;
    for (int i = 0; i < share_count(w) && done; i++) {
        const td_sweep_share *share = share_at(w, i);
        done = share->done ? add_share(search, share, tested)
                           : sweep_part(w, memory, i, hits, report, search, tested);
    }
    return done && search->overlaps <= search->overlaps_max;
}

bool td_shared_sweep(const td_proxy_set *set, td_memory *memory, const td_shape_proxy *proxy,
                     td_array *hits, td_hits_fn *report, void *context, int64_t *tested) {
    td_pair_search *search = context;
    thud_world *w = search->w;
    if (!search->crowded && is_shared(w)) {
        sweeping shared = {.w = w};
        td_job_begin(&shared.job, w->def.job_system.workers);
        td_job_run(w, &shared.job, sweep_as_worker, &shared);
        int64_t tested_before = *tested;
        if (join(&shared, memory, hits, report, search, tested)) {
            return true;
        }
        /* Undoes the search and has the calling thread repeat it alone: then the world becomes
         * crowded at the same pair for any number of workers. */
        *tested = tested_before;
        search->overlaps = search->held = search->shape_count = 0;
        search->crowded = false;
        w->scratch.pairs.count = hits->count = 0;
    }
    return w->def.broadphase->sweep[w->wide](set, memory, proxy, hits, report, context, tested);
}
