/* jobs.h: shares the work of a task among the workers of the caller's job system.
 *
 * A task is a sequence of phases, each of a number of chunks. Every worker goes through all phases
 * in the same order. In a phase it takes chunks that are not taken yet: first those of its own
 * part, chosen so that the same data come to the same processor in every phase; then those of the
 * other parts (work stealing), of which it leaves the last ones to their owner for a while. When
 * none is left it waits in a spin loop until the chunks taken by other workers are done, which is
 * the barrier between phases. A worker that starts late finds the early phases done.
 *
 * Chunks of a phase write no common data, but for the dummy, awake slot 0, so the result does not
 * depend on which worker runs which chunk. */
#ifndef TD_JOBS_H
#define TD_JOBS_H

#include "state/world.h"

#include <stdatomic.h>

/* A counter that different processors write, alone in its two cache lines: processors fetch lines
 * in pairs, and a line travels to whoever writes it. */
typedef struct td_counter {
    atomic_int value;
    char padding[128 - sizeof(atomic_int)];
} td_counter;

/* The data that all workers of one task share. Its counters are not reset between phases: they
 * count since the task began, so that no worker has to wait for a reset. */
typedef struct td_job {
    int workers;                        /* 1: the calling thread runs the task alone */
    td_counter arrived;                 /* workers that have started */
    td_counter done;                    /* chunks that are done */
    td_counter taken[THUD_WORKERS_MAX]; /* chunks that are taken, by the part they belong to */
} td_job;

/* One worker's position in a task. */
typedef struct td_worker {
    td_job *job; /* null: it works alone */
    int index;   /* in the order of arrival */
    int before;  /* chunks of all phases before the worker's next one; before_of: those of each part
                  */
    int before_of[THUD_WORKERS_MAX];
} td_worker;

/* Runs one chunk of a phase. */
typedef void td_chunk_fn(void *work, int chunk);

/* A task over blocks is shared among workers if the blocks have at least this many contact points
 * in all (td_scratch.points), unless the job system sets another number
 * (thud_job_system.share_from). Sharing costs time in each phase, since the data of bodies move
 * between the caches of processors. Two threads take as long as one at about 900 points in a
 * pyramid, 2,600 on terrain and 4,000 in a tumbler, whose bodies have mixed (measured with two
 * processors, at several sizes of these scenes). A greater value leaves more worlds to one thread.
 */
enum { TD_SHARED_POINTS_MIN = 2048 };

/* The number of points from which on this world shares a task among workers. */
static inline uint32_t td_share_from(const thud_world *w) {
    uint32_t from = w->def.job_system.share_from;
    return from ? from : TD_SHARED_POINTS_MIN;
}

/* How many workers shall share a task over the blocks of scratch.blocks: those of the job system,
 * or 1 where the blocks have too few points. */
static inline int td_workers_for_blocks(const thud_world *w) {
    uint32_t points = (uint32_t)w->scratch.points;
    bool shared = TD_HAS_THREADS && points > 0 && points >= td_share_from(w);
    return shared ? td_max_int(1, w->def.job_system.workers) : 1;
}

/* So many bodies without contacts count as one point. Chosen; not tuned. */
enum { TD_BODIES_A_POINT = 4 };

/* How many workers shall share the passes of the solver, and the stages of a step that are shared
 * on demand (shared_stages.h): in a step whose solver one thread runs, the other threads have
 * fallen asleep, and the data are in the cache of that one, so that sharing another stage takes
 * longer than it saves (measured with 2,000 to 4,000 bodies). Before the blocks of this step are
 * listed, the points of the step before are counted. */
static inline int td_workers_for_bodies(const thud_world *w) {
    bool many =
        TD_HAS_THREADS && (uint32_t)w->body_of.count / TD_BODIES_A_POINT >= td_share_from(w);
    return many ? td_max_int(1, w->def.job_system.workers) : td_workers_for_blocks(w);
}

/* Whether several workers run the task. */
static inline bool td_job_is_shared(const td_job *job) {
    return TD_HAS_THREADS && job->workers > 1;
}

void td_job_begin_shared(td_job *job);

/* Begins a task for so many workers. */
static inline void td_job_begin(td_job *job, int workers) {
    job->workers = TD_HAS_THREADS ? workers : 1;
    if (td_job_is_shared(job)) {
        td_job_begin_shared(job);
    }
}

/* Whether the worker has others beside it. */
static inline bool td_worker_shares(const td_worker *worker) {
    return TD_HAS_THREADS && worker->job;
}

/* The calling thread as a new worker of the task. */
static inline td_worker td_worker_arrive(td_job *job) {
    return (td_worker){.job = td_job_is_shared(job) ? job : NULL,
                       .index =
                           td_job_is_shared(job) ? atomic_fetch_add(&job->arrived.value, 1) : 0};
}

/* Runs chunks of the next phase of one of several workers until all of them are taken. The part of
 * worker i are the chunks from shares[i] to the one before shares[i + 1]; shares[0] is 0. Other
 * workers may still be running theirs when it returns. */
void td_worker_take(td_worker *worker, const int *shares, td_chunk_fn *run, void *work);
/* Returns when all chunks that have been taken are done. */
void td_worker_wait(const td_worker *worker);
/* Sets shares (td_worker_take) of so many chunks that differ by at most one. */
void td_share_evenly(int chunks, int workers, int *shares);
void td_worker_walk_shared(td_worker *worker, int chunks, td_chunk_fn *run, void *work);

/* td_worker_take with equal parts of so many chunks, then td_worker_wait: returns when all chunks
 * of the next phase are done. A worker that is alone runs them all. */
static inline void td_worker_walk(td_worker *worker, int chunks, td_chunk_fn *run_chunk,
                                  void *work) {
    if (td_worker_shares(worker)) {
        td_worker_walk_shared(worker, chunks, run_chunk, work);
        return;
    }
    for (int i = 0; i < chunks; i++) {
        run_chunk(work, i);
    }
}

void td_job_run_shared(const thud_world *w, const td_job *job, thud_task_fn *task, void *argument);

/* Calls task(argument) on every worker, and returns when all are done. */
static inline void td_job_run(const thud_world *w, const td_job *job, thud_task_fn *task,
                              void *argument) {
    if (td_job_is_shared(job)) {
        td_job_run_shared(w, job, task, argument);
    } else {
        task(argument);
    }
}

#endif
