/* pool.c: the worker threads of a job system. Between two tasks of a step, which follow each other
 * within microseconds, a worker polls for the next one; between two steps it sleeps on a condition
 * variable. */
#include "pool.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Polls of `round` before a worker sleeps, about half a millisecond. */
enum { LOOKS_BEFORE_SLEEP = 1000000 };

struct pool {
    pthread_mutex_t mutex;
    pthread_cond_t work;
    thud_task_fn *task;
    void *argument;
    atomic_uint round; /* incremented for every task, and once when the pool is destroyed */
    atomic_int busy;   /* workers that have not finished the current task */
    atomic_bool closing;
    int workers, started;
    pthread_t threads[THUD_WORKERS_MAX];
};

/* Waits until `round` differs from `done`: first by polling, then on the condition variable. */
static void wait_for_round(pool *p, unsigned done) {
    for (int i = 0; i < LOOKS_BEFORE_SLEEP; i++)
        if (atomic_load_explicit(&p->round, memory_order_acquire) != done)
            return;
    pthread_mutex_lock(&p->mutex);
    while (atomic_load(&p->round) == done)
        pthread_cond_wait(&p->work, &p->mutex);
    pthread_mutex_unlock(&p->mutex);
}

/* The function of a worker's thread: runs each task until the pool is closing. `done` counts the
 * tasks that this worker has run. */
static void *work(void *context) {
    pool *p = context;
    for (unsigned done = 0;; done++) {
        wait_for_round(p, done);
        if (atomic_load(&p->closing))
            return NULL;
        p->task(p->argument);
        atomic_fetch_sub_explicit(&p->busy, 1, memory_order_release);
    }
}

/* Publishes the task in p->task, or p->closing, to all workers and wakes those that sleep. */
static void start_round(pool *p) {
    pthread_mutex_lock(&p->mutex);
    atomic_fetch_add_explicit(&p->round, 1, memory_order_release);
    pthread_cond_broadcast(&p->work);
    pthread_mutex_unlock(&p->mutex);
}

/* The job system's function: runs `task` once on each thread of the pool and on the calling thread,
 * and returns when all have finished. `workers` is ignored: it is the pool's own number. */
static void run(thud_task_fn *task, void *argument, int workers, void *context) {
    pool *p = context;
    (void)workers;
    p->task = task;
    p->argument = argument;
    atomic_store(&p->busy, p->started);
    start_round(p);
    task(argument);
    while (atomic_load_explicit(&p->busy, memory_order_acquire) > 0) {
    }
}

pool *pool_create(int workers) {
    pool *p = workers >= 2 && workers <= THUD_WORKERS_MAX ? calloc(1, sizeof *p) : NULL;
    if (!p)
        return NULL;
    pthread_mutex_init(&p->mutex, NULL);
    pthread_cond_init(&p->work, NULL);
    p->workers = workers;
    while (p->started < workers - 1) {
        if (pthread_create(&p->threads[p->started], NULL, work, p) != 0) {
            pool_destroy(p);
            return NULL;
        }
        p->started++;
    }
    return p;
}

void pool_destroy(pool *p) {
    if (!p)
        return;
    atomic_store(&p->closing, true);
    start_round(p);
    for (int i = 0; i < p->started; i++)
        pthread_join(p->threads[i], NULL);
    pthread_cond_destroy(&p->work);
    pthread_mutex_destroy(&p->mutex);
    free(p);
}

thud_job_system pool_job_system(pool *p) {
    return p ? (thud_job_system){run, p, p->workers} : (thud_job_system){0};
}
