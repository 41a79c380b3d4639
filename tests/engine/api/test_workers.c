/* test_workers.c: steps that several threads share, or that a job system runs as one call after
 * another, give the same bits. */
#include "engine_support.h"

#include <thud/thud_reads.h>

#include "build_thud.h"
#include "some_threads.h"
#include "scenes.h"
#include "share.h"

/* The hash of a scene's world after some steps, and of the change of energy and the work of the
 * broadphase that each reports. */
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
        thud_broadphase_counts counts;
        OK(thud_world_get_broadphase_counts(world, &counts));
        energies = energies * 31 + (uint64_t)counts.tested * 7 + (uint64_t)counts.found;
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
              {"tumbler", 1000, 100}, {"platformer", 1000, 80},  {"sizes", 1000, 80},
              {"gas", 4000, 20},      {"one_spot", 1500, 30},    {"asleep", 3000, 60}};

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
                hash_after(SCENES[i].name, SCENES[i].size, SCENES[i].steps, jobs_of_small_steps(p));
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
    thud_job_system job_system = {.run = one_after_the_other,
                                  .context = &calls,
                                  .workers = 3,
                                  .share_from = 512};
    assert_true(hash_after("pyramid", 40, 40, job_system) ==
                hash_after("pyramid", 40, 40, (thud_job_system){0}));
    assert_true(calls >= 40);
}

/* A job system that asks for it also gets the end of each step. */
static void the_most_workers_share_more_stages_to_the_same_bits(void **state) {
    (void)state;
    enum { STEPS = 60 };
    int calls = 0, more_calls = 0;
    thud_job_system few = {.run = one_after_the_other,
                           .context = &calls,
                           .workers = THUD_WORKERS_MAX,
                           .share_from = 1};
    thud_job_system all = few;
    all.context = &more_calls;
    all.stages = &thud_shared_stages_all;
    uint64_t alone = hash_after("circle_pit", 3000, STEPS, (thud_job_system){0});
    assert_true(hash_after("circle_pit", 3000, STEPS, few) == alone);
    assert_true(hash_after("circle_pit", 3000, STEPS, all) == alone);
    assert_true(more_calls >= calls + STEPS);
}

/* The hash after a step in which circles fall faster than their size, a third of them through
 * plates that are thinner than their way. *held is how many were stopped. */
static uint64_t hash_of_shots(thud_job_system job_system, int *held) {
    enum { SHOTS = 3000 };
    thud_world_def def = weightless();
    def.job_system = job_system;
    thud_world *world = make_world(def);
    for (int i = 0; i < SHOTS; i++) {
        thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, i, 0, 0);
        add_shape(world, body, 0.2f, 0, false, NULL);
        OK(thud_body_set_velocity(world, body, (thud_vec2){0, -90}, 0));
        if (i % 3 == 0) {
            body = add_body(world, THUD_BODY_STATIC, i, -0.75, 0);
            add_shape(world, body, 0.4f, 0.05f, false, NULL);
        }
    }
    OK(thud_world_step(world));
    *held = thud_stats_of(world).held_bodies;
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    return hash;
}

static void fast_bodies_are_stopped_by_any_number_of_workers(void **state) {
    (void)state;
    int alone = 0, shared = 0;
    uint64_t hash = hash_of_shots((thud_job_system){0}, &alone);
    assert_int_equal(alone, 1000);
    for (int workers = 2; workers <= 4; workers += 2) {
        thud_threads *p = some_threads(workers);
        assert_non_null(p);
        assert_true(hash_of_shots(jobs_of_small_steps(p), &shared) == hash);
        assert_int_equal(shared, alone);
        thud_threads_destroy(p);
    }
}

/* The hash of a step's result, and of the work of its broadphase. */
static uint64_t hash_of_step(thud_world *world) {
    OK(thud_world_step(world));
    thud_broadphase_counts counts;
    OK(thud_world_get_broadphase_counts(world, &counts));
    return thud_hash_of(world) * 31 + (uint64_t)counts.tested * 7 + (uint64_t)counts.found;
}

/* The hash of some steps of circles of which `clump` at a time overlap. On their way they sleep for
 * a step and wake, so that bounds do not tell which pairs have a contact. */
static uint64_t hash_of_clumps(int count, int clump, thud_job_system job_system) {
    enum { MAX = 1260, WAY = 3 };
    thud_world_def def = weightless();
    def.sleeping = true;
    def.job_system = job_system;
    thud_world *world = make_world(def);
    thud_body_id ids[MAX];
    for (int i = 0; i < count; i++) {
        int place = i / clump, at = i % clump;
        ids[i] = add_body(world, THUD_BODY_DYNAMIC, 3.0 * (place % 40) + 0.002 * at,
                          3.0 * (place / 40), 0);
        add_shape(world, ids[i], 0.5f, 0, false, NULL);
        OK(thud_body_set_velocity(world, ids[i], (thud_vec2){(float)(i % 3), 1}, 0));
    }
    uint64_t hash = 0;
    for (int way = 0; way < WAY; way++) {
        for (int i = 0; i < 3; i++) {
            hash = hash * 31 + hash_of_step(world);
        }
        for (int awake = 0; awake < 2; awake++) {
            for (int i = 0; i < count; i++) {
                OK(thud_body_set_awake(world, ids[i], awake));
            }
            hash = hash * 31 + hash_of_step(world);
        }
    }
    thud_world_destroy(world);
    return hash;
}

/* Pairs for which workers have no room, those of woken shapes, and those of a crowd are left to the
 * calling thread. */
static void pairs_that_workers_leave_are_found(void **state) {
    (void)state;
    const struct {
        int count, clump;
    } cases[] = {{1200, 3}, {1200, 40}, {1260, 210}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int calls = 0;
        thud_job_system all = {.run = one_after_the_other,
                               .context = &calls,
                               .workers = 3,
                               .stages = &thud_shared_stages_all,
                               .share_from = 512};
        uint64_t shared = hash_of_clumps(cases[i].count, cases[i].clump, all);
        if (shared != hash_of_clumps(cases[i].count, cases[i].clump, (thud_job_system){0})) {
            fail_msg("%d circles, %d in a clump, differ", cases[i].count, cases[i].clump);
        }
    }
}

/* What workers need room for is kept from step to step. */
static void workers_allocate_nothing_in_a_settled_world(void **state) {
    (void)state;
    int calls = 0;
    scene s;
    assert_true(scenes_fill(scenes_find("gas"), 4000, &s));
    thud_world_def def = thud_default_world_def();
    def.job_system = (thud_job_system){.run = one_after_the_other,
                                       .context = &calls,
                                       .workers = 5,
                                       .stages = &thud_shared_stages_all,
                                       .share_from = 1};
    thud_world *world;
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    uint64_t allocations = 0;
    for (int i = 0; i < 40; i++) {
        OK(thud_world_step(world));
        allocations = i < 30 ? 0 : allocations + thud_stats_of(world).step_allocations;
    }
    assert_true(calls >= 40 * 2);
    assert_int_equal(allocations, 0);
    thud_world_destroy(world);
    scene_free(&s);
}

/* A world with little work does not call the job system. */
static void small_worlds_ask_nobody(void **state) {
    (void)state;
    int calls = 0;
    thud_job_system job_system = {.run = one_after_the_other,
                                  .context = &calls,
                                  .workers = 3,
                                  .share_from = 512};
    hash_after("tall_stack", 10, 20, job_system);
    assert_int_equal(calls, 0);
}

/* A pile of boxes for which a second thread does not pay; the game may want to share it. */
static void game_says_how_small_a_step_is_shared(void **state) {
    (void)state;
    enum { STEPS = 20 };
    const uint32_t froms[] = {0, UINT32_MAX, 512, 1};
    uint64_t hash = 0;
    for (int i = 0; i < 4; i++) {
        int calls = 0;
        thud_job_system job_system = {.run = one_after_the_other,
                                      .context = &calls,
                                      .workers = 2,
                                      .share_from = froms[i]};
        uint64_t own = hash_after("pyramid", 40, STEPS, job_system);
        /* One call a step for the manifolds, one for the solver. */
        assert_int_equal(calls, froms[i] == 0 || froms[i] == UINT32_MAX ? 0 : 2 * STEPS);
        assert_true(i == 0 || own == hash);
        hash = own;
    }
}

static void absurd_job_systems_are_refused(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    thud_world *world = NULL;
    def.job_system = (thud_job_system){.workers = 2};
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    def.job_system = (thud_job_system){.run = one_after_the_other, .workers = THUD_WORKERS_MAX + 1};
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    def.job_system = (thud_job_system){.run = one_after_the_other, .workers = -1};
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    assert_null(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_of_workers_gives_the_same_bits),
        cmocka_unit_test(workers_one_after_the_other_give_the_same_bits),
        cmocka_unit_test(the_most_workers_share_more_stages_to_the_same_bits),
        cmocka_unit_test(fast_bodies_are_stopped_by_any_number_of_workers),
        cmocka_unit_test(pairs_that_workers_leave_are_found),
        cmocka_unit_test(workers_allocate_nothing_in_a_settled_world),
        cmocka_unit_test(small_worlds_ask_nobody),
        cmocka_unit_test(game_says_how_small_a_step_is_shared),
        cmocka_unit_test(absurd_job_systems_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
