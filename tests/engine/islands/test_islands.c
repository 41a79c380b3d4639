/* test_islands.c: which islands are solved directly, the statistics of that, the budgets that limit
 * it, and that it does not depend on workers or memory. */
#include "island_support.h"

/* ---- which islands are solved directly ---- */

/* At default a light box with a load of 1000 times its density is solved directly, an even column
 * beside it is not. */
static void islands_heavy_on_light_turns_hard_by_itself(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_default);
    add_column(world, -5, 2, NULL);
    add_box(world, 5, 0.5, 0.5f, 0.5f);
    add_heavy(world, 5, 1.5, 0.5f, 1000);
    run(world, 60);
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        assert_int_equal(stats.direct_islands, 1);
        assert_int_equal(stats.direct_bodies, 2);
        assert_int_equal(stats.soft_islands, 0);
    }
    thud_world_destroy(world);
}

/* An island is solved directly for one more second after its load is gone, as the load may come
 * back. */
static void islands_turn_soft_a_second_after_their_load_is_gone(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_default);
    add_column(world, 0, 2, NULL);
    thud_body_id top = add_heavy(world, 0, 2.5, 0.5f, 1000);
    run(world, 60);
    OK(thud_body_destroy(world, top));
    for (int i = 0; i < 90; i++) {
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_bodies, i < 60 ? 2 : 0);
    }
    thud_world_destroy(world);
}

/* A column on a thin kinematic platform turns direct under the load of three boxes, which the
 * platform's thickness makes high, and stays so with two, which would not turn it direct. */
static void islands_on_a_thin_platform_stay_direct_while_loaded(void **state) {
    (void)state;
    thud_world_def def = def_of(&thud_quality_default);
    def.sleeping = false;
    for (int boxes = 2; boxes < 4; boxes++) {
        thud_world *world = make_world(def);
        thud_body_id box[3], platform = add_body(world, THUD_BODY_KINEMATIC, 0, -0.02, 0);
        add_shape(world, platform, 5, 0.02f, false, NULL);
        add_column(world, 0, boxes, box);
        run(world, 60);
        assert_int_equal(thud_stats_of(world).direct_bodies, boxes == 2 ? 0 : 3);
        if (boxes == 3) {
            OK(thud_body_destroy(world, box[2]));
        }
        for (int i = 0; i < 200; i++) {
            run(world, 1);
            assert_int_equal(thud_stats_of(world).direct_bodies, boxes == 2 ? 0 : 2);
        }
        thud_world_destroy(world);
    }
}

static void islands_of_equal_boxes_stay_soft_at_default(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_default);
    add_column(world, 0, 5, NULL);
    for (int i = 0; i < 120; i++) {
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_islands, 0);
        assert_int_equal(thud_stats_of(world).factorings, 0);
    }
    thud_world_destroy(world);
}

/* In a pyramid at rest friction is at its bounds; they must not be searched anew in each step. */
static void islands_pyramid_at_rest_takes_one_matrix_a_step(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_high);
    for (int row = 0; row < 20; row++) {
        for (int i = 0; i < 20 - row; i++) {
            add_box(world, i + 0.5 * row, row + 0.5, 0.5f, 0.5f);
        }
    }
    run(world, 60);
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_islands, 1);
        assert_int_equal(thud_stats_of(world).factorings, 1);
    }
    thud_world_destroy(world);
}

/* Three columns are three islands, though they share the floor; a flying body is in none. */
static void islands_are_all_hard_where_the_limit_is_zero(void **state) {
    (void)state;
    const thud_quality *all[] = {&thud_quality_high, &thud_quality_exact};
    for (int q = 0; q < 2; q++) {
        thud_world *world = world_of(all[q]);
        for (int i = 1; i <= 3; i++) {
            add_column(world, 5 * i, i, NULL);
        }
        add_ball(world, -10, 500, 0.5f);
        run(world, 10);
        thud_stats stats = thud_stats_of(world);
        assert_int_equal(stats.direct_islands, 3);
        assert_int_equal(stats.direct_bodies, 6);
        assert_int_equal(stats.soft_islands, 0);
        assert_true(stats.factorings >= 3);
        thud_world_destroy(world);
    }
}

/* A quality without an island solver solves no island directly, whatever its load. */
static void islands_are_none_without_a_solver(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_draft);
    add_box(world, 0, 0.5, 0.5f, 0.5f);
    add_heavy(world, 0, 1.5, 0.5f, 1e5f);
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_islands, 0);
    }
    thud_world_destroy(world);
}

/* A column of n bodies takes 3 n - 2 operations a factorisation, n for its bodies and 2 n for its
 * contacts, and at rest one factorisation a step. */
static void islands_work_is_what_their_matrices_take(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_exact);
    add_column(world, 0, 20, NULL);
    for (int i = 0; i < 120; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        assert_int_equal(stats.island_work, stats.factorings * (6 * 20 - 2));
    }
    assert_int_equal(thud_stats_of(world).factorings, 1);
    thud_world_destroy(world);
}

/* ---- budgets ---- */

static void islands_of_more_bodies_than_the_limit_stay_soft(void **state) {
    (void)state;
    thud_quality five = thud_quality_exact;
    five.island_limit = 5;
    thud_world *world = world_of(&five);
    add_column(world, 0, 5, NULL);
    add_column(world, 10, 6, NULL);
    for (int i = 0; i < 30; i++) {
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_islands, 1);
        assert_int_equal(thud_stats_of(world).direct_bodies, 5);
    }
    thud_world_destroy(world);
}

/* The work budget suffices for one of two columns at rest. */
static void islands_for_which_no_work_is_left_stay_soft(void **state) {
    (void)state;
    thud_quality little = thud_quality_exact;
    little.island_work = 70;
    thud_world *world = world_of(&little);
    add_column(world, 0, 10, NULL);
    add_column(world, 10, 10, NULL);
    int hard = 0, soft = 0;
    for (int i = 0; i < 300; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        assert_true(stats.island_work <= little.island_work);
        hard += stats.direct_islands - stats.soft_islands;
        soft += stats.soft_islands;
        assert_true(stats.direct_islands - stats.soft_islands <= 1);
    }
    assert_true(hard > 100);
    assert_true(soft > 0);
    thud_world_destroy(world);
}

/* With no work budget every island that would be solved directly is left to the soft solver. */
static void islands_without_any_work_stay_soft(void **state) {
    (void)state;
    thud_quality none = thud_quality_exact;
    none.island_work = 0;
    thud_world *world = world_of(&none);
    add_column(world, 0, 3, NULL);
    for (int i = 0; i < 30; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        assert_int_equal(stats.direct_islands, stats.soft_islands);
        assert_int_equal(stats.factorings, 0);
    }
    thud_world_destroy(world);
}

/* Of 240 steps in which thrown boxes collide, those with direct solutions; *longest is the longest
 * sequence of them. */
static int direct_steps(int factoring_budget, int *longest) {
    thud_quality quality = thud_quality_exact;
    quality.island_slow_steps = factoring_budget;
    thud_world *world = world_of(&quality);
    uint64_t seed = 5;
    for (int i = 0; i < 40; i++) {
        thud_body_id id = add_box(world, i % 8 * 1.1 - 4, 1 + i / 8 * 1.2, 0.5f, 0.5f);
        thud_vec2 velocity = {(float)random_in(&seed, -5, 5), (float)random_in(&seed, -5, 0)};
        OK(thud_body_set_velocity(world, id, velocity, (float)random_in(&seed, -2, 2)));
    }
    int steps = 0, strained = 0;
    *longest = 0;
    for (int i = 0; i < 240; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        steps += stats.direct_islands > stats.soft_islands;
        strained = stats.factorings > 8 * stats.direct_islands ? strained + 1 : 0;
        *longest = strained > *longest ? strained : *longest;
    }
    thud_world_destroy(world);
    return steps;
}

/* With island_slow_steps 1, islands that exceed the budget of factorisations are solved directly
 * in fewer steps, and fewer in succession, than without that limit. */
static void islands_that_strain_are_left_alone_after_slow_steps(void **state) {
    (void)state;
    int long_one, short_one;
    int any = direct_steps(0, &long_one), few = direct_steps(1, &short_one);
    assert_true(any > few);
    assert_true(long_one > short_one);
}

/* Work on islands in ten seconds of a world, which is then destroyed. */
static int64_t work_of(thud_world *world) {
    int64_t work = 0;
    for (int i = 0; i < 600; i++) {
        run(world, 1);
        work += thud_stats_of(world).island_work;
    }
    thud_world_destroy(world);
    return work;
}

/* Work on islands in ten seconds in which boxes and discs fall on rolling ground and come to
 * rest. */
static int64_t work_of_heap(const thud_quality *quality, int substeps, uint64_t seed) {
    enum { POINTS = 61, BODIES = 150 };
    thud_world_def def = thud_default_world_def_of(quality);
    def.substeps = substeps;
    def.sleeping = false;
    thud_world *world = make_world(def);
    thud_pos points[POINTS];
    for (int i = 0; i < POINTS; i++) {
        points[i] = (thud_pos){i - 30, 1.5 * sin(0.35 * i) + 0.05 * pow(i / 30.0 - 1, 2) * 900};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = POINTS};
    thud_shape_def plain = thud_default_shape_def();
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    OK(thud_shape_create_terrain(world, ground, &plain, &line, NULL));
    for (int i = 0; i < BODIES; i++) {
        float hx = (float)random_in(&seed, 0.25, 0.5), hy = (float)random_in(&seed, 0.25, 0.5);
        thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, i % 10 * 1.2 - 6, 6 + i / 10 * 1.2,
                                   random_in(&seed, -3, 3));
        add_shape(world, id, hx, i % 3 ? hy : 0, false, NULL);
    }
    return work_of(world);
}

/* Fewer substeps must not cost more work, summed over six heaps, since single ones vary. And in a
 * moving heap default uses little of its budget. */
static void heap_takes_no_more_work_at_fewer_substeps(void **state) {
    (void)state;
    int64_t sum[3] = {0};
    enum { HEAPS = 6 };
    for (uint64_t seed = 1; seed <= HEAPS; seed++) {
        for (int k = 0; k < 3; k++) {
            sum[k] += work_of_heap(&thud_quality_default, 4 >> k, seed);
        }
    }
    assert_true(sum[1] <= sum[0] && sum[2] <= sum[0]);
    assert_true(sum[0] < thud_quality_default.island_work / 50 * (600 * HEAPS));
}

/* Work on islands in ten seconds in which discs and boxes of sizes 1 to 20 fall between two walls.
 */
static int64_t work_of_sizes(uint64_t seed) {
    thud_world_def def = def_of(&thud_quality_default);
    def.sleeping = false;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    for (int i = 0; i < 2; i++) {
        add_shape(world, add_body(world, THUD_BODY_STATIC, i ? 10 : -10, 10, 0), 1, 10, false,
                  NULL);
    }
    for (int i = 0; i < 200; i++) {
        float size = (float)(0.1 * pow(20, pow(random_in(&seed, 0, 1), 2)));
        thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, i % 8 * 2.2 - 8, 2 + i / 8 * 2.2,
                                   random_in(&seed, -3, 3));
        add_shape(world, id, size, i % 2 ? 0 : 0.8f * size, false, NULL);
    }
    return work_of(world);
}

/* While contacts of heavy bodies on light ones move, the direct solver would not lessen the
 * overlap, and takes less than a 250th of its budget, summed over six heaps; an 83rd before it gave
 * up islands in motion after eight factorisations. */
static void islands_of_many_sizes_in_motion_take_little_work(void **state) {
    (void)state;
    enum { HEAPS = 6 };
    int64_t sum = 0;
    for (uint64_t seed = 1; seed <= HEAPS; seed++) {
        sum += work_of_sizes(seed);
    }
    assert_true(sum > 0 && sum < thud_quality_default.island_work / 250 * (600 * HEAPS));
}

/* ---- the caller's quality ---- */

/* A world copies the caller's quality: later changes of that struct have no effect. */
static void islands_follow_a_copy_of_the_callers_quality(void **state) {
    (void)state;
    thud_quality mine = thud_quality_draft;
    mine.name = "mine";
    mine.islands = &thud_islands_direct;
    mine.overlap_limit = 0;
    mine.island_limit = 10;
    mine.island_work = 1000000;
    thud_world *world = world_of(&mine);
    mine.islands = NULL;
    mine.island_limit = 1;
    add_column(world, 0, 4, NULL);
    run(world, 10);
    assert_int_equal(thud_stats_of(world).direct_bodies, 4);
    assert_int_equal(thud_stats_of(world).substeps, 2);
    thud_world_destroy(world);
}

/* A column stands while the quality changes back and forth. */
static void islands_follow_the_quality_back_and_forth(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_exact);
    thud_body_id ids[30];
    add_column(world, 0, 30, ids);
    run(world, 30);
    for (int i = 0; i < 12; i++) {
        const thud_quality *quality = qualities[i % QUALITIES];
        OK(thud_world_set_quality(world, quality));
        run(world, 20);
        if (quality->overlap_limit == 0 && quality->islands) {
            assert_int_equal(thud_stats_of(world).direct_bodies, 30);
        }
    }
    OK(thud_world_set_quality(world, &thud_quality_exact));
    run(world, 240);
    near_to(lost_by(world, ids[29], 29.5), 0, 0.05);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(islands_heavy_on_light_turns_hard_by_itself),
        cmocka_unit_test(islands_turn_soft_a_second_after_their_load_is_gone),
        cmocka_unit_test(islands_on_a_thin_platform_stay_direct_while_loaded),
        cmocka_unit_test(islands_of_equal_boxes_stay_soft_at_default),
        cmocka_unit_test(islands_pyramid_at_rest_takes_one_matrix_a_step),
        cmocka_unit_test(islands_are_all_hard_where_the_limit_is_zero),
        cmocka_unit_test(islands_are_none_without_a_solver),
        cmocka_unit_test(islands_work_is_what_their_matrices_take),
        cmocka_unit_test(islands_of_more_bodies_than_the_limit_stay_soft),
        cmocka_unit_test(islands_for_which_no_work_is_left_stay_soft),
        cmocka_unit_test(islands_without_any_work_stay_soft),
        cmocka_unit_test(islands_that_strain_are_left_alone_after_slow_steps),
        cmocka_unit_test(heap_takes_no_more_work_at_fewer_substeps),
        cmocka_unit_test(islands_of_many_sizes_in_motion_take_little_work),
        cmocka_unit_test(islands_follow_a_copy_of_the_callers_quality),
        cmocka_unit_test(islands_follow_the_quality_back_and_forth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
