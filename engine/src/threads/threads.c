/* threads.c: a pool of threads as a job system (thud_threads.h).
 *
 * A task has to be called `workers` times. The thread that starts the task makes the first call
 * itself, and offers the others as the number `calls_left`. Each thread that decrements this number
 * makes one of them; the starting thread does so too once its first call has returned, so that it
 * does not wait for threads that have not woken by then. The starting thread returns only when
 * `unfinished`, the number of calls that have not returned, is 0: until then the task stays valid
 * for the threads that run it. */
#include "thud/thud_threads.h"

#include "base/memory.h"
#include "base/simd.h"

#include <stdatomic.h>

/* ---- what the system provides ---- */

#ifdef _WIN32

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

typedef HANDLE thread_handle;
typedef SRWLOCK lock;
typedef CONDITION_VARIABLE condition;

static bool make_lock(lock *l, condition *a, condition *b) {
    InitializeSRWLock(l);
    InitializeConditionVariable(a);
    InitializeConditionVariable(b);
    return true;
}

static void end_lock(lock *l, condition *a, condition *b) {
    (void)l, (void)a, (void)b;
}

static void take(lock *l) {
    AcquireSRWLockExclusive(l);
}

static void give_back(lock *l) {
    ReleaseSRWLockExclusive(l);
}

static void sleep_on(condition *c, lock *l) {
    SleepConditionVariableSRW(c, l, INFINITE, 0);
}

static void wake_all(condition *c) {
    WakeAllConditionVariable(c);
}

static void serve(thud_threads *threads);

static DWORD WINAPI thread_main(LPVOID threads) {
    serve(threads);
    return 0;
}

static bool start_thread(thread_handle *out, thud_threads *threads) {
    *out = CreateThread(NULL, 0, thread_main, threads, 0, NULL);
    return *out != NULL;
}

static void join_thread(thread_handle thread) {
    WaitForSingleObject(thread, INFINITE);
    CloseHandle(thread);
}

#else

#include <pthread.h>

typedef pthread_t thread_handle;
typedef pthread_mutex_t lock;
typedef pthread_cond_t condition;

static bool make_lock(lock *l, condition *a, condition *b) {
    if (pthread_mutex_init(l, NULL) != 0) {
        return false;
    }
    if (pthread_cond_init(a, NULL) == 0) {
        if (pthread_cond_init(b, NULL) == 0) {
            return true;
        }
        pthread_cond_destroy(a);
    }
    pthread_mutex_destroy(l);
    return false;
}

static void end_lock(lock *l, condition *a, condition *b) {
    pthread_cond_destroy(b);
    pthread_cond_destroy(a);
    pthread_mutex_destroy(l);
}

static void take(lock *l) {
    pthread_mutex_lock(l);
}

static void give_back(lock *l) {
    pthread_mutex_unlock(l);
}

static void sleep_on(condition *c, lock *l) {
    pthread_cond_wait(c, l);
}

static void wake_all(condition *c) {
    pthread_cond_broadcast(c);
}

static void serve(thud_threads *threads);

static void *thread_main(void *threads) {
    serve(threads);
    return NULL;
}

static bool start_thread(thread_handle *out, thud_threads *threads) {
    return pthread_create(out, NULL, thread_main, threads) == 0;
}

static void join_thread(thread_handle thread) {
    pthread_join(thread, NULL);
}

#endif

/* ---- the pool ---- */

/* A thread that waits tests this many times whether there is work, with a short pause of the
 * processor each time, before it sleeps. With fewer tests, threads sleep between two tasks of a
 * step, and waking them takes longer than a small task; with more, they keep their processors busy
 * for longer after a step. Chosen; not tuned. */
enum { POLLS_BEFORE_SLEEP = 1 << 14 };

struct thud_threads {
    thud_task_fn *task; /* the present one: written by the thread that has set `busy` */
    void *argument;
    atomic_int calls_left; /* calls of the task that no thread has begun */
    atomic_int unfinished; /* calls of the task, but the first, that have not returned */
    atomic_bool busy;      /* a task is under way, or the pool is being destroyed */
    atomic_bool closing;   /* the threads shall end */
    atomic_int sleeping;   /* threads that sleep, or are about to, on `offered` */
    atomic_bool waiting;   /* the thread that started the task sleeps, or is about to, on `finished`
                            */
    lock lock;
    condition offered, finished;
    int workers;
    int thread_count; /* threads that have started */
    thread_handle handles[THUD_WORKERS_MAX - 1];
    td_memory memory;
};

/* Makes one of the calls that are left. False if there was none. */
static bool make_call(thud_threads *t) {
    int left = atomic_load(&t->calls_left);
    while (left > 0 && !atomic_compare_exchange_weak(&t->calls_left, &left, left - 1)) {
    }
    if (left == 0) {
        return false;
    }
    t->task(t->argument);
    if (atomic_fetch_sub(&t->unfinished, 1) == 1 && atomic_load(&t->waiting)) {
        take(&t->lock);
        wake_all(&t->finished);
        give_back(&t->lock);
    }
    return true;
}

static bool is_called(thud_threads *t) {
    return atomic_load(&t->calls_left) > 0 || atomic_load(&t->closing);
}

/* Returns when there is a call to make, or the pool is closing. No wake-up is lost: this thread
 * increments `sleeping` before it tests is_called, and offer_calls reads `sleeping` after it has
 * offered calls. So either this thread sees the calls, or offer_calls sees that it sleeps. */
static void await_call(thud_threads *t) {
    for (int i = 0; i < POLLS_BEFORE_SLEEP; i++) {
        if (is_called(t)) {
            return;
        }
        td_pause();
    }
    take(&t->lock);
    atomic_fetch_add(&t->sleeping, 1);
    while (!is_called(t)) {
        sleep_on(&t->offered, &t->lock);
    }
    atomic_fetch_sub(&t->sleeping, 1);
    give_back(&t->lock);
}

/* The function of a thread. */
static void serve(thud_threads *t) {
    while (!atomic_load(&t->closing)) {
        if (!make_call(t)) {
            await_call(t);
        }
    }
}

static void wake_threads(thud_threads *t) {
    if (atomic_load(&t->sleeping) > 0) {
        take(&t->lock);
        wake_all(&t->offered);
        give_back(&t->lock);
    }
}

/* Returns when all calls have returned. */
static void await_calls(thud_threads *t) {
    for (int i = 0; i < POLLS_BEFORE_SLEEP; i++) {
        if (atomic_load(&t->unfinished) == 0) {
            return;
        }
        td_pause();
    }
    take(&t->lock);
    atomic_store(&t->waiting, true);
    while (atomic_load(&t->unfinished) > 0) {
        sleep_on(&t->finished, &t->lock);
    }
    atomic_store(&t->waiting, false);
    give_back(&t->lock);
}

/* The job system's function, a thud_parallel_fn. */
static void run_on_threads(thud_task_fn *task, void *argument, int workers, void *context) {
    thud_threads *t = context;
    if (atomic_exchange(&t->busy, true)) {
        for (int i = 0; i < workers; i++) {
            task(argument);
        }
        return;
    }
    t->task = task;
    t->argument = argument;
    atomic_store(&t->unfinished, workers - 1);
    atomic_store(&t->calls_left, workers - 1);
    wake_threads(t);
    task(argument);
    while (make_call(t)) {
    }
    await_calls(t);
    atomic_store(&t->busy, false);
}

/* ---- making and ending ---- */

static void end_threads(thud_threads *t) {
    atomic_store(&t->closing, true);
    wake_threads(t);
    for (int i = 0; i < t->thread_count; i++) {
        join_thread(t->handles[i]);
    }
    end_lock(&t->lock, &t->offered, &t->finished);
    td_memory memory = t->memory;
    td_memory_put(&memory, t, sizeof *t);
}

thud_result thud_threads_create(int workers, const thud_allocator *allocator, thud_threads **out) {
    if (!out) {
        return THUD_ERROR_NULL;
    }
    if (workers < 1 || workers > THUD_WORKERS_MAX ||
        (allocator && !allocator->allocate != !allocator->release)) {
        return THUD_ERROR_INVALID;
    }
    td_memory memory = td_memory_make(allocator ? *allocator : (thud_allocator){0});
    thud_threads *t = td_memory_get(&memory, sizeof *t);
    if (!t) {
        return THUD_ERROR_MEMORY;
    }
    t->memory = memory;
    t->workers = workers;
    if (!make_lock(&t->lock, &t->offered, &t->finished)) {
        td_memory_put(&memory, t, sizeof *t);
        return THUD_ERROR_MEMORY;
    }
    for (; t->thread_count < workers - 1; t->thread_count++) {
        if (!start_thread(&t->handles[t->thread_count], t)) {
            end_threads(t);
            return THUD_ERROR_MEMORY;
        }
    }
    *out = t;
    return THUD_OK;
}

thud_result thud_threads_destroy(thud_threads *threads) {
    if (threads) {
        if (atomic_exchange(&threads->busy, true)) {
            return THUD_ERROR_LOCKED;
        }
        end_threads(threads);
    }
    return THUD_OK;
}

thud_result thud_threads_get_job_system(thud_threads *threads, thud_job_system *out) {
    if (!threads || !out) {
        return THUD_ERROR_NULL;
    }
    *out = (thud_job_system){.run = run_on_threads,
                             .context = threads,
                             .workers = threads->workers,
                             .stages = &thud_shared_stages_all};
    return THUD_OK;
}
