/* test_bisection.c: the time of collision by bisection, and which motions can be bisected, against
 * answers derived by hand. */
#include "thud/thud_geometry.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static const thud_geometry ball = {
    .kind = THUD_SHAPE_CIRCLE, .x = 0.0, .y = 0.0, .c = 1.0, .hx = 0.5};
static const thud_geometry wall = {
    .kind = THUD_SHAPE_AABB, .x = 3.0, .c = 1.0, .hx = 0.5, .hy = 4.0};
static const thud_motion still = {0.0, 0.0, 0.0};

/* Time at which the ball collides with the wall. */
static double collision(thud_motion motion, double tolerance, bool *collided) {
    double time;
    assert_int_equal(thud_geometry_time_of_collision(&ball, motion, &wall, still, tolerance,
                                                     collided, &time),
                     THUD_OK);
    return time;
}

static void bisection_stops_before_a_wall_by_no_more_than_its_tolerance(void **state) {
    (void)state;
    for (double tolerance = 0.5; tolerance >= 1e-15; tolerance *= 0.5) {
        bool collided;
        double time = collision((thud_motion){2.9, 0.0, 0.0}, tolerance, &collided);
        assert_true(collided);
        assert_true(time <= 2.0 / 2.9 && time >= 2.0 / 2.9 - tolerance - 1e-15);
    }
}

static void bisection_does_not_see_a_wall_that_was_passed_through(void **state) {
    (void)state;
    bool collided;
    thud_motion fast = {6.0, 0.0, 0.0};
    assert_true(collision(fast, 1e-6, &collided) == 1.0);
    assert_false(collided);
    assert_false(thud_geometry_is_bisectable(&ball, fast, &wall, still));
    /* Ball and wall are both 1 thick. */
    assert_true(thud_geometry_is_bisectable(&ball, (thud_motion){0.999, 0, 0}, &wall, still));
    assert_false(thud_geometry_is_bisectable(&ball, (thud_motion){1.0, 0, 0}, &wall, still));
    assert_true(thud_geometry_is_bisectable(&ball, fast, &wall, fast));
}

/* The end of a bar moves by its half length for each radian. */
static void turn_counts_for_what_is_bisectable(void **state) {
    (void)state;
    thud_geometry bar = {.kind = THUD_SHAPE_OBB, .c = 1.0, .hx = 3.0, .hy = 4.0}, upright = bar;
    upright.kind = THUD_SHAPE_AABB;
    thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .x = 9.0, .c = 1.0, .hx = 0.5};
    assert_true(thud_geometry_is_bisectable(&disc, still, &bar, (thud_motion){0, 0, 0.199}));
    assert_false(thud_geometry_is_bisectable(&disc, still, &bar, (thud_motion){0, 0, -0.201}));
    assert_false(thud_geometry_is_bisectable(&bar, (thud_motion){0.5, 0, 0.101}, &disc, still));
    assert_true(thud_geometry_is_bisectable(&bar, (thud_motion){0.5, 0, 0.099}, &disc, still));
    assert_true(thud_geometry_is_bisectable(&disc, (thud_motion){0, 0, 9}, &upright, still));
}

static void bisection_of_shapes_that_overlap_at_the_start_is_no_collision(void **state) {
    (void)state;
    bool collided = true;
    double time = 0.0;
    assert_int_equal(thud_geometry_time_of_collision(&ball, still, &ball, still, 0.1, &collided,
                                                     &time),
                     THUD_OK);
    assert_false(collided);
    assert_true(time == 1.0);
}

static void bisection_of_a_turning_bar_is_when_its_end_comes_down(void **state) {
    (void)state;
    thud_geometry bar = {THUD_SHAPE_OBB, 0.0, 1.0, 1.0, 0.0, 2.0, 0.001};
    thud_terrain floor = {.kind = THUD_TERRAIN_FLAT};
    bool collided;
    double time;
    assert_int_equal(thud_terrain_time_of_collision(&floor, &bar, (thud_motion){0, 0, 1.0}, 1e-9,
                                                    &collided, &time),
                     THUD_OK);
    assert_true(collided);
    /* The height of the end is 1 - 2 sin(turn) - 0.001 cos(turn). */
    double end = 1.0 - 2.0 * sin(time) - 0.001 * cos(time);
    assert_true(end > 0.0 && end < 1e-8);
}

static void bisection_refuses_bad_input_and_leaves_the_answers(void **state) {
    (void)state;
    thud_terrain floor = {.kind = THUD_TERRAIN_FLAT}, steep = {.slope = 1e9};
    thud_geometry bad = ball;
    bad.hx = -1.0;
    bool collided = true;
    double time = 7.0;
    thud_motion wild = {(double)NAN, 0.0, 0.0};
    const double tolerances[] = {0.0, -1.0, 2.0, (double)NAN};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(thud_geometry_time_of_collision(&ball, still, &wall, still, tolerances[i],
                                                         &collided, &time),
                         THUD_ERROR_INVALID);
        assert_int_equal(thud_terrain_time_of_collision(&floor, &ball, still, tolerances[i],
                                                        &collided, &time),
                         THUD_ERROR_INVALID);
    }
    assert_int_equal(thud_geometry_time_of_collision(&bad, still, &wall, still, 0.1, &collided,
                                                     &time),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_geometry_time_of_collision(&ball, wild, &wall, still, 0.1, &collided,
                                                     &time),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_geometry_time_of_collision(&ball, still, NULL, still, 0.1, &collided,
                                                     &time),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_time_of_collision(&ball, still, &wall, still, 0.1, NULL, &time),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_time_of_collision(&steep, &ball, still, 0.1, &collided, &time),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_time_of_collision(NULL, &ball, still, 0.1, &collided, &time),
                     THUD_ERROR_NULL);
    assert_false(thud_geometry_is_bisectable(&bad, still, &wall, still));
    assert_false(thud_geometry_is_bisectable(NULL, still, &wall, still));
    assert_true(collided && time == 7.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bisection_stops_before_a_wall_by_no_more_than_its_tolerance),
        cmocka_unit_test(bisection_does_not_see_a_wall_that_was_passed_through),
        cmocka_unit_test(turn_counts_for_what_is_bisectable),
        cmocka_unit_test(bisection_of_shapes_that_overlap_at_the_start_is_no_collision),
        cmocka_unit_test(bisection_of_a_turning_bar_is_when_its_end_comes_down),
        cmocka_unit_test(bisection_refuses_bad_input_and_leaves_the_answers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
