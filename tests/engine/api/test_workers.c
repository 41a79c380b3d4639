/* test_workers.c: steps that several threads share, or that a job system runs as one call after
 * another, give the same bits. */
#include "engine_support.h"

#include "build_thud.h"
#include "some_threads.h"
#include "scenes.h"
#include "share.h"

/* The hash of a scene's world after some steps, and of the change of energy that each reports. */
static uint64_t hash_after(const char *name, int size, int steps, thud_job_system job_system) {
    scene s;
    assert_true(scenes_fill(scenes_find(name), size, &s));
    thud_world_def def = thud_default_world_def();
    def.job_system = job_system;
    thud_world *world;
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    uint64_t energies = 0;
    for (int i = 0; i < steps; i++) {
        OK(thud_world_step(world));
        double change = thud_step_error_of(world).energy_change;
        uint64_t bits;
        memcpy(&bits, &change, sizeof bits);
        energies = energies * 31 + bits;
    }
    uint64_t hash = thud_hash_of(world) ^ energies;
    thud_world_destroy(world);
    scene_free(&s);
    return hash;
}

/* A job system with a single thread: it calls the task for each worker in turn. */
static void one_after_the_other(thud_task_fn *task, void *argument, int workers, void *context) {
    *(int *)context += 1;
    for (int i = 0; i < workers; i++) {
        task(argument);
    }
}

static const struct {
    const char *name;
    int size, steps;
} SCENES[] = {{"pyramid", 40, 60},    {"circle_pit", 3000, 120}, {"mixed_terrain", 2000, 120},
              {"tumbler", 1000, 100}, {"platformer", 1000, 80},  {"sizes", 1000, 80}};

static void any_number_of_workers_gives_the_same_bits(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof SCENES / sizeof *SCENES; i++) {
        uint64_t alone =
            hash_after(SCENES[i].name, SCENES[i].size, SCENES[i].steps, (thud_job_system){0});
        /* A share of the cases begins with the most workers. */
        for (int workers = 5; workers >= 2; workers -= TEST_SHARE) {
            thud_threads *p = some_threads(workers);
            assert_non_null(p);
            uint64_t shared =
                hash_after(SCENES[i].name, SCENES[i].size, SCENES[i].steps, thud_job_system_of(p));
            thud_threads_destroy(p);
            if (shared != alone) {
                fail_msg("%s differs with %d workers", SCENES[i].name, workers);
            }
        }
    }
}

static void workers_one_after_the_other_give_the_same_bits(void **state) {
    (void)state;
    int calls = 0;
    thud_job_system job_system = {one_after_the_other, &calls, 3, NULL};
    assert_true(hash_after("pyramid", 40, 40, job_system) ==
                hash_after("pyramid", 40, 40, (thud_job_system){0}));
    assert_true(calls >= 40);
}

/* A job system that asks for it also gets the end of each step. */
static void the_most_workers_share_more_stages_to_the_same_bits(void **state) {
    (void)state;
    enum { STEPS = 60 };
    int calls = 0, more_calls = 0;
    thud_job_system few = {one_after_the_other, &calls, THUD_WORKERS_MAX, NULL};
    thud_job_system all = {one_after_the_other, &more_calls, THUD_WORKERS_MAX,
                           &thud_shared_stages_all};
    uint64_t alone = hash_after("circle_pit", 3000, STEPS, (thud_job_system){0});
    assert_true(hash_after("circle_pit", 3000, STEPS, few) == alone);
    assert_true(hash_after("circle_pit", 3000, STEPS, all) == alone);
    assert_true(more_calls >= calls + STEPS);
}

/* A world with little work does not call the job system. */
static void small_worlds_ask_nobody(void **state) {
    (void)state;
    int calls = 0;
    thud_job_system job_system = {one_after_the_other, &calls, 3, NULL};
    hash_after("tall_stack", 10, 20, job_system);
    assert_int_equal(calls, 0);
}

static void absurd_job_systems_are_refused(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    thud_world *world = NULL;
    def.job_system = (thud_job_system){.workers = 2};
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    def.job_system = (thud_job_system){one_after_the_other, NULL, THUD_WORKERS_MAX + 1, NULL};
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    def.job_system = (thud_job_system){one_after_the_other, NULL, -1, NULL};
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    assert_null(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_of_workers_gives_the_same_bits),
        cmocka_unit_test(workers_one_after_the_other_give_the_same_bits),
        cmocka_unit_test(the_most_workers_share_more_stages_to_the_same_bits),
        cmocka_unit_test(small_worlds_ask_nobody),
        cmocka_unit_test(absurd_job_systems_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
