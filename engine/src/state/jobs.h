/* jobs.h: sharing the work of a phase among workers.
 *
 * Every worker walks the same phases in the same order. Of each phase it takes chunks that nobody
 * has taken yet, those of its own part first, so that the same data come to the same processor
 * again; when there are none left it waits for those that others have begun. Whoever comes late
 * finds the early phases done. Chunks of a phase touch nothing in common but the dummy, slot 0,
 * which the solver's take turns at, so it does not matter who does which. */
#ifndef TD_JOBS_H
#define TD_JOBS_H

#include "state/world.h"

#include <stdatomic.h>

/* What the workers of one task share: counters of its phases, all zero at first. */
typedef struct td_job {
    atomic_int *counters; /* of each phase: chunks done, then taken of each worker's part; null: one
                             worker does it all */
    int workers;
    atomic_int arrived;
} td_job;

/* Where one worker is. */
typedef struct td_worker {
    atomic_int *phase; /* null: alone */
    int workers, index;
} td_worker;

typedef void td_chunk_fn(void *work, int chunk);

static inline td_worker td_worker_arrive(td_job *task) {
    return (td_worker){task->counters, task->workers, atomic_fetch_add(&task->arrived, 1)};
}

/* Walks the worker's next phase. */
void td_worker_walk(td_worker *worker, int chunks, td_chunk_fn *run, void *work);

/* Room for the phases of any task over the chunks of blocks as they are. */
bool td_job_reserve(thud_world *w);
/* A task with all its phases; for the calling thread alone where there is nobody else, or too
 * little to share. */
td_job td_job_begin(thud_world *w);
/* Runs it by all workers. */
void td_job_run(const thud_world *w, const td_job *task, thud_task_fn *run, void *argument);

#endif
