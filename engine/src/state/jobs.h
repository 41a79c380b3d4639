/* jobs.h: shares the work of a task among the workers of the caller's job system.
 *
 * A task is a sequence of phases, each of a number of chunks. Every worker goes through all phases
 * in the same order. In a phase it takes chunks that are not taken yet: first those of its own
 * part, an equal share of consecutive chunks, so that the same data come to the same processor in
 * every phase; then those of the other parts (work stealing). When none is left it waits in a spin
 * loop until the chunks taken by other workers are done, which is the barrier between phases. A
 * worker that starts late finds the early phases done.
 *
 * Chunks of a phase write no common data, but for the dummy, awake slot 0, so the result does not
 * depend on which worker runs which chunk. */
#ifndef TD_JOBS_H
#define TD_JOBS_H

#include "state/world.h"

#include <stdatomic.h>

/* What the workers of one task share. */
typedef struct td_job {
    atomic_int
        *counters; /* zero at first. For each phase: chunks done; then, for each worker's part,
                      chunks taken of it. Null: the calling thread runs the task alone */
    int workers;
    atomic_int arrived; /* workers that have started */
} td_job;

/* One worker's position in a task. */
typedef struct td_worker {
    atomic_int *phase;  /* counters of its next phase; null: it works alone */
    int workers, index; /* index: in the order of arrival */
} td_worker;

/* Runs one chunk of a phase. */
typedef void td_chunk_fn(void *work, int chunk);

/* The calling thread as a new worker of the task. */
static inline td_worker td_worker_arrive(td_job *task) {
    return (td_worker){task->counters, task->workers, atomic_fetch_add(&task->arrived, 1)};
}

/* Takes part in the worker's next phase, and returns when all its chunks are done. */
void td_worker_walk(td_worker *worker, int chunks, td_chunk_fn *run, void *work);

/* Makes room for the counters of any task over the present chunks. False when memory is short. */
bool td_job_reserve(thud_world *w);
/* A new task. It is for the calling thread alone where the job system has less than two workers, or
 * where there are fewer than SHARED_BLOCKS_MIN blocks. */
td_job td_job_begin(thud_world *w);
/* Calls run(argument) on every worker, and returns when all are done. */
void td_job_run(const thud_world *w, const td_job *task, thud_task_fn *run, void *argument);

#endif
