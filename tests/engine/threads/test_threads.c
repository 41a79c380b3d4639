/* test_threads.c: pools of threads (thud_threads.h): what is refused and what fails, how often and
 * by how many threads a task is called, worlds that share a pool, and pools that are idle. */
#define _POSIX_C_SOURCE 200809L

#include "engine_support.h"

#include "build_thud.h"
#include "hostile_memory.h"
#include "scenes.h"

#include <pthread.h>
#include <stdatomic.h>
#include <time.h>

#include <thud/thud_testing.h>
#include <thud/thud_threads.h>

/* ---- a system without threads ---- */

static int threads_allowed = -1; /* threads that start until none does; negative: all do */

int __real_pthread_create(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
int __wrap_pthread_create(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*run_it)(void *),
                          void *argument) {
    if (threads_allowed >= 0 && threads_allowed-- == 0) {
        return 11; /* EAGAIN */
    }
    return __real_pthread_create(thread, how, run_it, argument);
}

static void absurd_pools_are_refused(void **state) {
    (void)state;
    thud_threads *const none = (thud_threads *)state;
    thud_threads *threads = none;
    const int absurd[] = {INT32_MIN, -1, 0, THUD_WORKERS_MAX + 1, INT32_MAX};
    for (size_t i = 0; i < sizeof absurd / sizeof *absurd; i++) {
        assert_int_equal(thud_threads_create(absurd[i], NULL, &threads), THUD_ERROR_INVALID);
    }
    thud_allocator half = hostile_memory();
    half.release = NULL;
    assert_int_equal(thud_threads_create(2, &half, &threads), THUD_ERROR_INVALID);
    assert_int_equal(thud_threads_create(2, NULL, NULL), THUD_ERROR_NULL);
    assert_ptr_equal(threads, none);
    thud_job_system jobs = {.context = &half, .workers = 7};
    assert_int_equal(thud_threads_get_job_system(NULL, &jobs), THUD_ERROR_NULL);
    assert_int_equal(jobs.workers, 7);
    assert_int_equal(thud_job_system_of(NULL).workers, 0);
    OK(thud_threads_destroy(NULL));
}

static void a_pool_without_memory_or_threads_is_not_made(void **state) {
    thud_threads *const none = (thud_threads *)state;
    thud_threads *threads = none;
    thud_allocator memory = hostile_memory();
    memory_allowed = 0;
    assert_int_equal(thud_threads_create(3, &memory, &threads), THUD_ERROR_MEMORY);
    memory_allowed = -1;
    for (int started = 0; started < 4; started++) {
        threads_allowed = started;
        assert_int_equal(thud_threads_create(5, &memory, &threads), THUD_ERROR_MEMORY);
        assert_int_equal(memory_held, 0);
    }
    threads_allowed = -1;
    assert_ptr_equal(threads, none);
    OK(thud_threads_create(5, &memory, &threads));
    assert_true(memory_held > 0);
    OK(thud_threads_destroy(threads));
    assert_int_equal(memory_held, 0);
}

/* ---- calls of a task ---- */

enum { WORKERS = 4 };

typedef struct meeting {
    atomic_int calls, inside;
    int expected; /* calls that wait for each other */
} meeting;

/* Waits until so many calls are inside at the same time. */
static void meet(void *argument) {
    meeting *m = argument;
    atomic_fetch_add(&m->calls, 1);
    atomic_fetch_add(&m->inside, 1);
    while (atomic_load(&m->inside) < m->expected) {
    }
}

static void count(void *argument) {
    meeting *m = argument;
    atomic_fetch_add(&m->calls, 1);
}

static void each_worker_of_a_pool_has_a_thread(void **state) {
    (void)state;
    thud_threads *threads;
    OK(thud_threads_create(WORKERS, NULL, &threads));
    thud_job_system jobs = thud_job_system_of(threads);
    assert_int_equal(jobs.workers, WORKERS);
    for (int i = 0; i < 50; i++) {
        meeting m = {.expected = WORKERS};
        jobs.run(meet, &m, WORKERS, jobs.context);
        assert_int_equal(m.calls, WORKERS);
    }
    OK(thud_threads_destroy(threads));
}

static void a_task_is_called_as_often_as_asked(void **state) {
    (void)state;
    for (int workers = 1; workers <= THUD_WORKERS_MAX; workers += 21) {
        thud_threads *threads;
        OK(thud_threads_create(workers, NULL, &threads));
        thud_job_system jobs = thud_job_system_of(threads);
        for (int asked = 1; asked <= THUD_WORKERS_MAX; asked++) {
            meeting m = {0};
            jobs.run(count, &m, asked, jobs.context);
            assert_int_equal(m.calls, asked);
        }
        OK(thud_threads_destroy(threads));
    }
}

typedef struct inner {
    thud_threads *threads;
    atomic_int destroyed, calls;
} inner;

/* Inside a task: the pool is not destroyed, and a second task runs on the calling thread. */
static void try_inside(void *argument) {
    inner *in = argument;
    meeting m = {0};
    thud_job_system jobs = thud_job_system_of(in->threads);
    jobs.run(count, &m, WORKERS, jobs.context);
    atomic_fetch_add(&in->calls, m.calls);
    atomic_fetch_add(&in->destroyed, thud_threads_destroy(in->threads) != THUD_ERROR_LOCKED);
}

static void a_pool_in_use_is_not_destroyed(void **state) {
    (void)state;
    for (int workers = 1; workers <= WORKERS; workers++) {
        inner in = {0};
        OK(thud_threads_create(workers, NULL, &in.threads));
        thud_job_system jobs = thud_job_system_of(in.threads);
        jobs.run(try_inside, &in, WORKERS, jobs.context);
        assert_int_equal(in.destroyed, 0);
        assert_int_equal(in.calls, WORKERS * WORKERS);
        OK(thud_threads_destroy(in.threads));
    }
}

/* ---- worlds ---- */

static uint64_t hash_of_pyramid(thud_job_system job_system) {
    scene s;
    assert_true(scenes_fill(scenes_find("pyramid"), 30, &s));
    thud_world_def def = thud_default_world_def();
    def.job_system = job_system;
    thud_world *world;
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    for (int i = 0; i < 40; i++) {
        OK(thud_world_step(world));
    }
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    scene_free(&s);
    return hash;
}

typedef struct stepper {
    pthread_t thread;
    thud_threads *threads;
    uint64_t hash;
} stepper;

static void *step_pyramid(void *argument) {
    stepper *s = argument;
    s->hash = hash_of_pyramid(thud_job_system_of(s->threads));
    return NULL;
}

static void worlds_stepped_at_the_same_time_share_a_pool(void **state) {
    (void)state;
    uint64_t alone = hash_of_pyramid((thud_job_system){0});
    thud_threads *threads;
    OK(thud_threads_create(2, NULL, &threads));
    stepper steppers[3];
    for (int i = 0; i < 3; i++) {
        steppers[i].threads = threads;
        assert_int_equal(pthread_create(&steppers[i].thread, NULL, step_pyramid, &steppers[i]), 0);
    }
    for (int i = 0; i < 3; i++) {
        pthread_join(steppers[i].thread, NULL);
        assert_true(steppers[i].hash == alone);
    }
    OK(thud_threads_destroy(threads));
}

static double seconds_of(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void sleep_for(long milliseconds) {
    nanosleep(&(struct timespec){0, milliseconds * 1000000}, NULL);
}

/* Threads that polled would use a large part of the processors. */
static void an_idle_pool_sleeps_and_wakes(void **state) {
    (void)state;
    thud_threads *threads;
    OK(thud_threads_create(WORKERS, NULL, &threads));
    thud_job_system jobs = thud_job_system_of(threads);
    for (int i = 0; i < 3; i++) {
        sleep_for(300);
        double before = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        sleep_for(200);
        assert_true(seconds_of(CLOCK_PROCESS_CPUTIME_ID) - before < 0.02);
        meeting m = {.expected = WORKERS};
        jobs.run(meet, &m, WORKERS, jobs.context);
        assert_int_equal(m.calls, WORKERS);
    }
    sleep_for(300);
    OK(thud_threads_destroy(threads));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(absurd_pools_are_refused),
        cmocka_unit_test(a_pool_without_memory_or_threads_is_not_made),
        cmocka_unit_test(each_worker_of_a_pool_has_a_thread),
        cmocka_unit_test(a_task_is_called_as_often_as_asked),
        cmocka_unit_test(a_pool_in_use_is_not_destroyed),
        cmocka_unit_test(worlds_stepped_at_the_same_time_share_a_pool),
        cmocka_unit_test(an_idle_pool_sleeps_and_wakes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
