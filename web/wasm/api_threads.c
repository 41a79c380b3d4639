/* api_threads.c: a pool of threads as the job system of worlds, in thud-threads.wasm alone. The
 * threads are workers of the host: web/package/src/threads.ts starts them, each with an instance of
 * the module on the same memory and with a stack of its own, and each of them calls
 * api_thread_serve.
 *
 * A task has to be called `workers` times. The thread that brings it makes the first call and
 * offers the others as `calls_left`; each thread that decrements it makes one of them, and so does
 * the bringing thread once its own call has returned. Hence a thread that is late, or has never
 * started, is not waited for. The bringing thread never sleeps, which the main thread of a page may
 * not: it polls until the calls that others have begun have returned. There is one such thread, the
 * one whose instance JavaScript calls. */
#include "api.h"

#include <stdatomic.h>

/* Polls before a thread sleeps. With fewer, threads sleep between two tasks of a step; with more,
 * they occupy their processors for longer after a step. Chosen; not tuned. */
enum { POLLS_BEFORE_SLEEP = 1 << 16 };

static struct {
    thud_task_fn *task; /* the present one */
    void *argument;
    atomic_int calls_left; /* calls of the task that no thread has begun */
    atomic_int unfinished; /* calls of the task, but the first, that have not returned */
    atomic_int offers;     /* counts the tasks; threads sleep on it */
    atomic_int sleeping;   /* threads that sleep, or are about to */
    atomic_int closing;    /* the threads shall end */
    atomic_int helped;     /* counts the calls that threads of the pool have made */
    int workers;           /* of worlds that are created; at most 1: the calling thread alone */
    uint32_t share_from;   /* thud_job_system.share_from, likewise */
} pool;

/* Makes one of the calls that are left; false: none was. */
static bool make_call(void) {
    int left = atomic_load(&pool.calls_left);
    while (left > 0 && !atomic_compare_exchange_weak(&pool.calls_left, &left, left - 1)) {
    }
    if (left == 0)
        return false;
    pool.task(pool.argument);
    atomic_fetch_sub(&pool.unfinished, 1);
    return true;
}

/* Returns when `offers` is no longer `seen`. A thread that sleeps has incremented `sleeping` before
 * the comparison of the wait, and run_on_threads reads it after it has incremented `offers`: one of
 * both sees the other. */
static void await_offer(int seen) {
    for (int i = 0; i < POLLS_BEFORE_SLEEP; i++)
        if (atomic_load(&pool.offers) != seen)
            return;
    atomic_fetch_add(&pool.sleeping, 1);
    __builtin_wasm_memory_atomic_wait32((int *)&pool.offers, seen, -1);
    atomic_fetch_sub(&pool.sleeping, 1);
}

static void wake_threads(void) {
    atomic_fetch_add(&pool.offers, 1);
    if (atomic_load(&pool.sleeping) > 0)
        __builtin_wasm_memory_atomic_notify((int *)&pool.offers, THUD_WORKERS_MAX);
}

/* What a thread of the pool does until api_threads_end. */
void api_thread_serve(void) {
    while (!atomic_load(&pool.closing)) {
        int seen = atomic_load(&pool.offers);
        if (make_call())
            atomic_fetch_add(&pool.helped, 1);
        else if (!atomic_load(&pool.closing))
            await_offer(seen);
    }
}

/* A thud_parallel_fn. */
static void run_on_threads(thud_task_fn *task, void *argument, int workers, void *context) {
    (void)context;
    pool.task = task;
    pool.argument = argument;
    atomic_store(&pool.unfinished, workers - 1);
    atomic_store(&pool.calls_left, workers - 1);
    wake_threads();
    task(argument);
    while (make_call()) {
    }
    while (atomic_load(&pool.unfinished) > 0) {
    }
}

thud_job_system api_job_system(void) {
    return (thud_job_system){.run = run_on_threads,
                             .workers = pool.workers,
                             .stages = &thud_shared_stages_all,
                             .share_from = pool.share_from};
}

/* Sets the number of workers of worlds that are created from now on, in [0, THUD_WORKERS_MAX], and
 * their thud_job_system.share_from. */
void api_threads_set(int workers, uint32_t share_from) {
    pool.workers = workers;
    pool.share_from = share_from;
}

/* How many calls of tasks the threads of the pool have made. */
int api_threads_helped(void) {
    return atomic_load(&pool.helped);
}

/* Lets the threads return from api_thread_serve. Worlds go on, on the calling thread. */
void api_threads_end(void) {
    atomic_store(&pool.closing, 1);
    wake_threads();
}
