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

#endif
