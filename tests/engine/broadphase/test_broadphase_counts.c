/* test_broadphase_counts.c: what thud_world_get_broadphase_counts tells: pairs tested and found,
 * cells of the grid and the moves of insertion sort, in worlds in which they can be said ahead. */
#include "engine_support.h"
#include "every_choice.h"

#include <thud/thud_reads.h>
#include <thud/thud_testing.h>

#include <stdlib.h>

static thud_broadphase_counts counts_of(const thud_world *world) {
    thud_broadphase_counts counts;
    OK(thud_world_get_broadphase_counts(world, &counts));
    return counts;
}

/* A weightless world, without bodies, of a broadphase. */
static thud_world *world_with(const thud_broadphase *broadphase, float cell_size) {
    thud_world_def def = weightless();
    def.broadphase = broadphase;
    def.cell_size = cell_size;
    return make_world(def);
}

/* Adds a ball of radius 0.25 that does not sleep. */
static thud_body_id ball_at(thud_world *world, double x, double y) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){x, y};
    def.may_sleep = false;
    thud_body_id body;
    OK(thud_body_create(world, &def, &body));
    add_shape(world, body, 0.25f, 0, false, NULL);
    return body;
}

/* The counts of the first step of `count` balls, `columns` to a row, so far apart. */
static thud_broadphase_counts counts_of_rows(const thud_broadphase *broadphase, float cell_size,
                                             int count, int columns, double apart) {
    thud_world *world = world_with(broadphase, cell_size);
    for (int i = 0; i < count; i++) {
        ball_at(world, apart * (i % columns), apart * (double)(i / columns));
    }
    OK(thud_world_step(world));
    thud_broadphase_counts counts = counts_of(world);
    assert_int_equal(counts.moved, count);
    assert_int_equal(counts.found, thud_stats_of(world).pairs);
    thud_world_destroy(world);
    return counts;
}

static void every_broadphase_finds_the_same_pairs_of_all_that_there_are(void **state) {
    (void)state;
    /* Bounds of 0.5 and margins that are 0.4 apart overlap with those before, after, above, below
     * and aslant: of a square of 12 x 12 each but those of the edge with 8. */
    int64_t found = 4 * 11 * 11 + 2 * 11;
    for (int b = 0; b < BROADPHASES_IN_ALL; b++) {
        thud_broadphase_counts counts = counts_of_rows(broadphases[b], 0, 144, 12, 0.4);
        assert_int_equal(counts.found, found);
        if (broadphases[b] == &thud_broadphase_all) {
            assert_int_equal(counts.tested, 144 * 143 / 2);
        } else {
            assert_true(counts.tested >= found);
        }
        assert_true((counts.cells > 0) == (broadphases[b] == &thud_broadphase_grid));
    }
}

/* A sweep along the axis across which balls are lined up tests all pairs of a line. */
static void sweeps_test_few_pairs_along_the_axis_on_which_shapes_are_spread(void **state) {
    (void)state;
    enum { COUNT = 200, ALL = COUNT * (COUNT - 1) / 2, FEW = 9 * COUNT };
    for (int upright = 0; upright < 2; upright++) {
        int columns = upright ? 1 : COUNT;
        int64_t x = counts_of_rows(&thud_broadphase_sweep, 0, COUNT, columns, 2).tested;
        int64_t y = counts_of_rows(&thud_broadphase_sweep_y, 0, COUNT, columns, 2).tested;
        int64_t widest = counts_of_rows(&thud_broadphase_sweep_widest, 0, COUNT, columns, 2).tested;
        int64_t both = counts_of_rows(&thud_broadphase_sweep_both, 0, COUNT, columns, 2).tested;
        assert_int_equal(upright ? x : y, ALL);
        assert_true((upright ? y : x) < FEW);
        assert_int_equal(widest, upright ? y : x);
        assert_true(both < FEW);
    }
}

/* Half of the balls stand in a column, half in a row: only a sweep of both has few tests. */
static void sweep_of_both_takes_the_better_list_for_each_shape(void **state) {
    (void)state;
    enum { COUNT = 400 };
    int64_t tested[BROADPHASES_IN_ALL];
    for (int b = 0; b < BROADPHASES_IN_ALL; b++) {
        thud_world *world = world_with(broadphases[b], 0);
        for (int i = 1; i <= COUNT; i++) {
            ball_at(world, i % 2 ? i : 0, i % 2 ? 0 : i);
        }
        OK(thud_world_step(world));
        tested[b] = counts_of(world).tested;
        thud_world_destroy(world);
        bool one_axis = broadphases[b] == &thud_broadphase_sweep ||
                        broadphases[b] == &thud_broadphase_sweep_y ||
                        broadphases[b] == &thud_broadphase_sweep_widest;
        if (one_axis) {
            assert_true(tested[b] > COUNT / 2 * (COUNT / 2 - 1) / 2);
        } else if (broadphases[b] == &thud_broadphase_sweep_both) {
            assert_true(tested[b] < 4 * COUNT);
        }
    }
}

static void cells_of_a_width_of_ones_own_hold_what_they_have_room_for(void **state) {
    (void)state;
    /* Of 16 x 16 balls a little more than 1 apart 4 x 4 share a cell
     * of 4, and those 100 wide hold all. */
    thud_broadphase_counts fours = counts_of_rows(&thud_broadphase_grid, 4, 256, 16, 1.01);
    assert_int_equal(fours.cells, 16);
    assert_int_equal(fours.cell_shapes, 256);
    assert_int_equal(fours.cell_shapes_max, 16);
    thud_broadphase_counts one = counts_of_rows(&thud_broadphase_grid, 100, 256, 16, 1.01);
    assert_int_equal(one.cells, 1);
    assert_int_equal(one.cell_shapes_max, 256);
    assert_int_equal(one.tested, 256 * 255 / 2);
    /* Cells that no shape fits into are as without a width. */
    thud_broadphase_counts none = counts_of_rows(&thud_broadphase_grid, 0.1f, 256, 16, 1.01);
    thud_broadphase_counts usual = counts_of_rows(&thud_broadphase_grid, 0, 256, 16, 1.01);
    assert_int_equal(none.cells, usual.cells);
    assert_int_equal(none.tested, usual.tested);
    assert_true(usual.tested < fours.tested && fours.tested < one.tested);
}

static void larger_shapes_have_cells_of_their_own(void **state) {
    (void)state;
    thud_world *world = world_with(&thud_broadphase_grid, 2);
    for (int i = 0; i < 9; i++) {
        ball_at(world, 1.01 * (i % 3), 1.01 * (double)(i / 3));
    }
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 30, 0, 0);
    add_shape(world, body, 3, 0, false, NULL);
    OK(thud_world_step(world));
    thud_broadphase_counts counts = counts_of(world);
    assert_int_equal(counts.cells, 5);
    assert_int_equal(counts.cell_shapes, 10);
    assert_int_equal(counts.cell_shapes_max, 4);
    thud_world_destroy(world);
}

static void insertion_sort_moves_a_key_past_each_that_it_has_overtaken(void **state) {
    (void)state;
    const thud_broadphase *sweeps[] = {&thud_broadphase_sweep, &thud_broadphase_sweep_y,
                                       &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both};
    for (int b = 0; b < 4; b++) {
        bool upright = b == 1;
        thud_world *world = world_with(sweeps[b], 0);
        thud_body_id body[10];
        for (int i = 0; i < 10; i++) {
            body[i] = upright ? ball_at(world, 0, i) : ball_at(world, i, 0);
        }
        OK(thud_world_step(world));
        OK(thud_world_step(world));
        assert_int_equal(counts_of(world).sort_moves, 0);
        thud_pos to = upright ? (thud_pos){0, 6.5} : (thud_pos){6.5, 0};
        OK(thud_body_set_transform(world, body[2], to, 0));
        OK(thud_world_step(world));
        assert_int_equal(counts_of(world).sort_moves, 4);
        thud_world_destroy(world);
    }
}

/* Bounds are tested eight at a time with either instruction set. */
static void counts_are_those_of_the_baseline_instruction_set(void **state) {
    (void)state;
    for (int b = 0; b < BROADPHASES_IN_ALL; b++) {
        thud_broadphase_counts counts[2];
        for (int baseline = 0; baseline < 2; baseline++) {
            thud_world_def def = weightless();
            def.broadphase = broadphases[b];
            thud_world_def_set_baseline_simd(&def, baseline);
            thud_world *world = make_world(def);
            uint64_t seed = 3;
            for (int i = 0; i < 300; i++) {
                thud_body_id body =
                    ball_at(world, random_in(&seed, -9, 9), random_in(&seed, -9, 9));
                OK(thud_body_set_velocity(world, body, (thud_vec2){(float)(i % 7 - 3), 2}, 0));
            }
            run(world, 30);
            counts[baseline] = counts_of(world);
            thud_world_destroy(world);
        }
        assert_memory_equal(&counts[0], &counts[1], sizeof counts[0]);
        assert_true(counts[0].moved > 0);
    }
}

/* Tests of bounds a shape, by the grid, in the first step of a square of balls 1 apart. */
static double tests_a_shape(int side) {
    thud_broadphase_counts counts = counts_of_rows(&thud_broadphase_grid, 0, side * side, side, 1);
    return (double)counts.tested / ((double)side * side);
}

/* With THUD_CASES of a thousand or more up to a million shapes, which takes seconds. */
static void grid_tests_as_many_bounds_a_shape_among_many_as_among_few(void **state) {
    (void)state;
    const char *wanted = getenv("THUD_CASES");
    double few = tests_a_shape(32);
    static const int sides[] = {100, 316, 1000};
    for (int i = 0; i < (wanted && atoi(wanted) >= 1000 ? 3 : 2); i++) {
        double many = tests_a_shape(sides[i]);
        print_message("%d shapes: %.3f tests a shape\n", sides[i] * sides[i], many);
        assert_true(many < 1.1 * few && few < 8);
    }
}

/* The pairs that are found in a step in which a hundred balls fly about near three resting ones,
 * among ten thousand that rest elsewhere; `stray`: one more ball flies far away from all, so that
 * the resting balls near what moves are not few. */
static int64_t pairs_near_rest(const thud_broadphase *broadphase, bool stray) {
    thud_world *world = world_with(broadphase, 0);
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_def def = thud_default_shape_def();
    for (int i = 0; i < 10000; i++) {
        thud_vec2 center = {4 * (float)(i % 100), -20 - 4 * (float)(i / 100)};
        OK(thud_shape_create_circle(world, ground, &def, center, 0.5f, NULL));
    }
    for (int i = 0; i < 3; i++) {
        thud_vec2 center = {85 + 10 * (float)i, 10};
        OK(thud_shape_create_circle(world, ground, &def, center, 3, NULL));
    }
    for (int i = 0; i < 100 + stray; i++) {
        double x = i < 100 ? 80 + 3 * (i % 10) : 390, y = i < 100 ? 3 * (double)(i / 10) : -410;
        OK(thud_body_set_velocity(world, ball_at(world, x, y), (thud_vec2){20, 20}, 0));
    }
    run(world, 2); /* in the first step all shapes are new */
    thud_broadphase_counts counts = counts_of(world);
    assert_int_equal(counts.moved, 100 + stray);
    thud_world_destroy(world);
    return counts.found;
}

static void what_rests_near_what_moves_is_found_among_much_that_rests(void **state) {
    (void)state;
    int64_t found = pairs_near_rest(&thud_broadphase_grid, true);
    assert_true(found > 10);
    for (int b = 0; b < BROADPHASES_IN_ALL; b++) {
        assert_int_equal(pairs_near_rest(broadphases[b], false), found);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_broadphase_finds_the_same_pairs_of_all_that_there_are),
        cmocka_unit_test(sweeps_test_few_pairs_along_the_axis_on_which_shapes_are_spread),
        cmocka_unit_test(sweep_of_both_takes_the_better_list_for_each_shape),
        cmocka_unit_test(cells_of_a_width_of_ones_own_hold_what_they_have_room_for),
        cmocka_unit_test(larger_shapes_have_cells_of_their_own),
        cmocka_unit_test(insertion_sort_moves_a_key_past_each_that_it_has_overtaken),
        cmocka_unit_test(counts_are_those_of_the_baseline_instruction_set),
        cmocka_unit_test(what_rests_near_what_moves_is_found_among_much_that_rests),
        cmocka_unit_test(grid_tests_as_many_bounds_a_shape_among_many_as_among_few),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
