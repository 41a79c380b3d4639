/* some_threads.h: a pool of threads for tests that step the same world with different numbers of
 * workers. */
#ifndef SOME_THREADS_H
#define SOME_THREADS_H

#include <thud/thud_threads.h>

/* A pool of so many workers; null for fewer than 2, and where threads cannot be started. */
static inline thud_threads *some_threads(int workers) {
    thud_threads *threads = NULL;
    return workers >= 2 && thud_threads_create(workers, NULL, &threads) == THUD_OK ? threads : NULL;
}

/* The job system of a pool, which shares steps from 512 points of blocks on, a quarter of the
 * default, so that small worlds test it. */
static inline thud_job_system jobs_of_small_steps(thud_threads *threads) {
    thud_job_system job_system = thud_job_system_of(threads);
    job_system.share_from = 512;
    return job_system;
}

#endif
