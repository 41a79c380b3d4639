/* test_islands_bits.c: islands that are solved directly have the same bits with any number of
 * workers, without AVX2, after failed allocations, and far from the origin; and they sleep and wake
 * without loss. */
#include "island_support.h"

#include "hostile_memory.h"
#include "some_threads.h"

#include <thud/thud_testing.h>

/* ---- the same bits ---- */

/* A column, a heavy box on a light one, and falling rubble: islands of all sizes. */
static void fill_yard(thud_world *world, double x) {
    add_column(world, x, 12, NULL);
    add_box(world, x + 5, 0.5, 0.5f, 0.5f);
    add_heavy(world, x + 5, 1.5, 0.5f, 1000);
    uint64_t seed = 11;
    for (int i = 0; i < 60; i++) {
        double across = x + 10 + i % 10 + random_in(&seed, 0, 0.2);
        add_box(world, floor(across * 1024) / 1024, 1 + i / 10 * 1.2, 0.4f, 0.4f);
    }
}

/* Runs the world, and asserts that bodies were solved directly. */
static void run_hard(thud_world *world, int steps) {
    int64_t bodies = 0;
    for (int i = 0; i < steps; i++) {
        run(world, 1);
        bodies += thud_stats_of(world).direct_bodies;
    }
    assert_true(bodies > 20);
}

static uint64_t hash_of_yard(thud_world_def def) {
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    fill_yard(world, 0);
    run_hard(world, 90);
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    return hash;
}

static void islands_are_the_same_for_any_number_of_workers(void **state) {
    (void)state;
    for (int q = 1; q < QUALITIES; q++) {
        thud_world_def def = def_of(qualities[q]);
        uint64_t alone = hash_of_yard(def);
        for (int workers = 2; workers <= 4; workers++) {
            thud_threads *p = some_threads(workers);
            assert_non_null(p);
            def.job_system = jobs_of_small_steps(p);
            assert_true(hash_of_yard(def) == alone);
            thud_threads_destroy(p);
        }
    }
}

static void islands_are_the_same_without_avx2(void **state) {
    (void)state;
    for (int q = 1; q < QUALITIES; q++) {
        thud_world_def def = def_of(qualities[q]);
        uint64_t wide = hash_of_yard(def);
        thud_world_def_set_baseline_simd(&def, true);
        assert_true(hash_of_yard(def) == wide);
    }
}

/* Each allocation of each step fails once; the step then gives the same bits as if it had succeeded
 * at once. */
static void islands_are_the_same_after_memory_failed(void **state) {
    (void)state;
    thud_world_def def = def_of(&thud_quality_exact);
    thud_world *never = make_world(def);
    def.allocator = hostile_memory();
    memory_allowed = -1;
    thud_world *often = make_world(def);
    add_floor(never, NULL);
    add_floor(often, NULL);
    fill_yard(never, 0);
    fill_yard(often, 0);
    int failures = 0;
    for (int i = 0; i < 60; i++) {
        bool done = false;
        for (int allowed = 0; !done; allowed++) {
            uint64_t before = thud_hash_of(often);
            memory_allowed = allowed;
            thud_result result = thud_world_step(often);
            memory_allowed = -1;
            done = result == THUD_OK;
            if (!done) {
                assert_int_equal(result, THUD_ERROR_MEMORY);
                assert_true(thud_hash_of(often) == before);
                failures++;
            }
        }
        run(never, 1);
        assert_true(thud_hash_of(often) == thud_hash_of(never));
    }
    assert_true(failures > 20);
    thud_world_destroy(often);
    thud_world_destroy(never);
    assert_int_equal(memory_held, 0);
}

/* The whole scene is shifted; positions are on a grid that is exact there. */
static void islands_are_the_same_far_from_the_origin(void **state) {
    (void)state;
    enum { BODIES = 75 };
    const double away = 1 << 23;
    thud_world *near = make_world(def_of(&thud_quality_exact));
    thud_world *far = make_world(def_of(&thud_quality_exact));
    add_floor(near, NULL);
    add_shape(far, add_body(far, THUD_BODY_STATIC, away, -1, 0), 100, 1, true, NULL);
    fill_yard(near, 0);
    fill_yard(far, away);
    run_hard(near, 90);
    run_hard(far, 90);
    int count;
    const thud_pose *poses = thud_poses_of(near, (thud_pos){0, 0}, 1, &count);
    assert_int_equal(count, BODIES);
    thud_pose kept[BODIES];
    memcpy(kept, poses, sizeof kept);
    poses = thud_poses_of(far, (thud_pos){away, 0}, 1, &count);
    assert_memory_equal(poses, kept, sizeof kept);
    thud_world_destroy(near);
    thud_world_destroy(far);
}

/* ---- sleep ---- */

static void islands_sleep_and_wake_without_loss(void **state) {
    (void)state;
    for (int q = 1; q < QUALITIES; q++) {
        thud_world *world = make_world(def_of(qualities[q]));
        add_floor(world, NULL);
        add_box(world, 0, 0.5, 0.5f, 0.5f);
        thud_body_id top = add_heavy(world, 0, 1.5, 0.5f, 1000);
        run(world, 300);
        double lost = lost_by(world, top, 1.5);
        for (int i = 0; i < 5; i++) {
            assert_int_equal(thud_stats_of(world).awake_bodies, 0);
            assert_int_equal(thud_stats_of(world).direct_islands, 0);
            OK(thud_body_set_awake(world, top, true));
            run(world, 20);
            assert_int_equal(thud_stats_of(world).direct_bodies, 2);
            run(world, 280);
        }
        near_to(lost_by(world, top, 1.5), lost, 1e-3);
        near_to(lost, 0, 0.02);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(islands_are_the_same_for_any_number_of_workers),
        cmocka_unit_test(islands_are_the_same_without_avx2),
        cmocka_unit_test(islands_are_the_same_after_memory_failed),
        cmocka_unit_test(islands_are_the_same_far_from_the_origin),
        cmocka_unit_test(islands_sleep_and_wake_without_loss),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
