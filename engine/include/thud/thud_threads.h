/* thud_threads.h: a pool of threads as the job system of worlds, for programs that have no job
 * system of their own. thud.h does not include this header; a program that does not use it links
 * no threads. One that does links the target thud::threads of CMake, or what `pkg-config --libs
 * thud-threads` names.
 *
 *     thud_threads *threads;
 *     thud_threads_create(4, NULL, &threads);
 *     def.job_system = thud_job_system_of(threads);
 *     ... create, step and destroy worlds with this def ...
 *     thud_threads_destroy(threads);
 *
 * The threads take part in large steps and in calls for many casts, see thud_hooks.h; the number of
 * workers does not change any result. No thread is pinned to a processor. Between two tasks of a
 * step a thread polls for the next one for a short time, and then sleeps on a condition variable
 * until there is one, so that an idle pool uses no processor.
 *
 * Several worlds may use one pool, and may be stepped at the same time by different threads. A pool
 * works for one task at a time: a step that finds the pool busy does not wait for it, but runs on
 * the calling thread alone. A thread of the pool that is late does not hold up a step either: the
 * calling thread then does that thread's part.
 *
 * When a call fails nothing has changed. A pool has no log, so that the result is all that says why
 * a call failed. */
#ifndef THUD_THREADS_H
#define THUD_THREADS_H

#include "thud_hooks.h"
#include "thud_limits.h"
#include "thud_result.h"

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A pool. It must exist as long as the worlds that use it. */
typedef struct thud_threads thud_threads;

/* Creates a pool of `workers` in [1, THUD_WORKERS_MAX]: workers - 1 threads, since the thread that
 * steps a world is a worker, too. `allocator` provides the pool's memory (not the stacks); null:
 * the C library's. THUD_ERROR_NULL for a null `out`; THUD_ERROR_INVALID for a number out of range,
 * or an allocator with one function alone; THUD_ERROR_MEMORY where memory is short or the system
 * does not start so many threads: those that had started have ended. */
THUD_NODISCARD THUD_API thud_result thud_threads_create(int workers,
                                                        const thud_allocator *allocator,
                                                        thud_threads **out);
/* Ends the threads and frees the pool; null does nothing. To be called only when no world steps or
 * casts with it. THUD_ERROR_LOCKED if a task of a step or of casts runs at that moment. */
THUD_API thud_result thud_threads_destroy(thud_threads *threads);

/* The job system for thud_world_def.job_system. Its `workers` may be set to another number: if
 * there are more workers than threads of the pool, some threads do the work of several.
 * THUD_ERROR_NULL. */
THUD_API thud_result thud_threads_get_job_system(thud_threads *threads, thud_job_system *out);

/* The same; of a null pool: all zero, which is the calling thread alone. */
static inline thud_job_system thud_job_system_of(thud_threads *threads) {
    thud_job_system job_system;
    memset(&job_system, 0, sizeof job_system);
    thud_threads_get_job_system(threads, &job_system);
    return job_system;
}

#ifdef __cplusplus
}
#endif

#endif
