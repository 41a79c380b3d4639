/* pool.c: the worker threads of a job system. A step has several tasks in short succession: between
 * two of them a thread polls for the next one, since waking it would take longer; between two steps
 * it sleeps on a condition variable. */
#include "pool.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Polls of `round` before a thread sleeps: a load and a branch each, so that they take of the order
 * of a millisecond together. With fewer, threads sleep between two tasks of a step; with more, they
 * occupy their processors for longer after it. Chosen; not tuned. */
enum { POLLS_BEFORE_SLEEP = 1000000 };

struct pool {
    pthread_mutex_t mutex;
    pthread_cond_t new_round; /* broadcast when `round` changes */
    thud_task_fn *task;       /* of the present round, with its argument */
    void *argument;
    atomic_uint round;   /* incremented for every task, and once when the pool is destroyed */
    atomic_int busy;     /* threads that have not finished the present task */
    atomic_bool closing; /* the threads shall end */
    int workers;         /* threads that run a task: those of the pool and the calling one */
    int thread_count;    /* threads that pool_create has started: workers - 1 unless one failed */
    pthread_t threads[THUD_WORKERS_MAX];
};

/* Waits until `round` differs from `done`: first by polling, then on the condition variable. */
static void wait_for_round(pool *p, unsigned done) {
    for (int i = 0; i < POLLS_BEFORE_SLEEP; i++)
        if (atomic_load_explicit(&p->round, memory_order_acquire) != done)
            return;
    pthread_mutex_lock(&p->mutex);
    while (atomic_load(&p->round) == done)
        pthread_cond_wait(&p->new_round, &p->mutex);
    pthread_mutex_unlock(&p->mutex);
}

/* The function of a thread: runs each task once, until the pool is closing. `done` counts the tasks
 * that it has run. */
static void *run_rounds(void *context) {
    pool *p = context;
    for (unsigned done = 0;; done++) {
        wait_for_round(p, done);
        if (atomic_load(&p->closing))
            return NULL;
        p->task(p->argument);
        atomic_fetch_sub_explicit(&p->busy, 1, memory_order_release);
    }
}

/* Publishes the task in p->task, or p->closing, to all threads and wakes those that sleep. */
static void start_round(pool *p) {
    pthread_mutex_lock(&p->mutex);
    atomic_fetch_add_explicit(&p->round, 1, memory_order_release);
    pthread_cond_broadcast(&p->new_round);
    pthread_mutex_unlock(&p->mutex);
}

/* The job system's function: runs `task` once on each thread of the pool and on the calling thread,
 * and returns when all have finished. `workers` is ignored: it is the number that pool_job_system
 * gave to the world, p->workers. */
static void run(thud_task_fn *task, void *argument, int workers, void *context) {
    pool *p = context;
    (void)workers;
    p->task = task;
    p->argument = argument;
    atomic_store(&p->busy, p->thread_count);
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
    pthread_cond_init(&p->new_round, NULL);
    p->workers = workers;
    while (p->thread_count < workers - 1) {
        if (pthread_create(&p->threads[p->thread_count], NULL, run_rounds, p) != 0) {
            pool_destroy(p);
            return NULL;
        }
        p->thread_count++;
    }
    return p;
}

void pool_destroy(pool *p) {
    if (!p)
        return;
    atomic_store(&p->closing, true);
    start_round(p);
    for (int i = 0; i < p->thread_count; i++)
        pthread_join(p->threads[i], NULL);
    pthread_cond_destroy(&p->new_round);
    pthread_mutex_destroy(&p->mutex);
    free(p);
}

thud_job_system pool_job_system(pool *p) {
    return p ? (thud_job_system){.run = run, .context = p, .workers = p->workers}
             : (thud_job_system){0};
}
