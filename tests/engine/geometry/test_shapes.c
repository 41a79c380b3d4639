/* test_shapes.c: circles and boxes against answers derived by hand, and input that is refused. */
#include "thud/thud_geometry.h"
#include "base/trig.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-12)

static thud_geometry circle(double x, double y, double r) {
    return (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1.0, .hx = r};
}

static thud_geometry box(double x, double y, double hx, double hy) {
    return (thud_geometry){.kind = THUD_SHAPE_AABB, .x = x, .y = y, .c = 1.0, .hx = hx, .hy = hy};
}

static thud_geometry turned(double x, double y, double hx, double hy, double angle) {
    return (thud_geometry){THUD_SHAPE_OBB, x, y, cos(angle), sin(angle), hx, hy};
}

static thud_closest closest(thud_geometry a, thud_geometry b) {
    thud_closest c;
    assert_int_equal(thud_geometry_closest(&a, &b, &c), THUD_OK);
    return c;
}

/* The time of impact with a shape b at rest, or 2 where there is none. */
static double impact(thud_geometry a, thud_motion ma, thud_geometry b, double target) {
    bool hit;
    double time;
    assert_int_equal(thud_geometry_time_of_impact(&a, ma, &b, (thud_motion){0}, target, &hit,
                                                  &time),
                     THUD_OK);
    assert_true(hit || time == 1.0);
    return hit ? time : 2.0;
}

static void sincos_up_to_a_million_radians_is_within_1e_15(void **state) {
    (void)state;
    double worst = 0.0;
    for (int i = -200000; i <= 200000; i++) {
        double angle = i * 5.0 - 0.3 * sin(i), s, c;
        angle = fabs(angle) <= 1e6 ? angle : 1e6;
        td_sincos(angle, &s, &c);
        worst = fmax(worst, fmax(fabs(s - sin(angle)), fabs(c - cos(angle))));
        td_sincos(angle * 1e-6, &s, &c);
        worst = fmax(worst, fmax(fabs(s - sin(angle * 1e-6)), fabs(c - cos(angle * 1e-6))));
    }
    assert_true(worst < 1e-15);
}

/* Where a body has become non-finite, its angle still gets here. */
static void sincos_of_what_is_not_finite_is_not_either(void **state) {
    (void)state;
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++) {
        double s = 0, c = 0;
        td_sincos(none[i], &s, &c);
        assert_false(isfinite(s) || isfinite(c));
    }
}

static void sincos_of_quarter_turns_hits_the_axes(void **state) {
    (void)state;
    const double quarter = 1.57079632679489661923;
    double s, c;
    for (int i = -9; i <= 9; i++) {
        td_sincos(i * quarter, &s, &c);
        assert_true(fabs(s - (i % 2 ? (((i % 4) + 4) % 4 == 1 ? 1.0 : -1.0) : 0.0)) < 1e-14);
        assert_true(fabs(c - (i % 2 ? 0.0 : i % 4 ? -1.0 : 1.0)) < 1e-14);
    }
    td_sincos(0.0, &s, &c);
    assert_true(s == 0.0 && c == 1.0);
    assert_int_equal(thud_sincos(quarter, &s, &c), THUD_OK);
    assert_true(s == 1.0);
    assert_int_equal(thud_sincos(1.0000001e6, &s, &c), THUD_ERROR_INVALID);
    assert_int_equal(thud_sincos(NAN, &s, &c), THUD_ERROR_INVALID);
    assert_int_equal(thud_sincos(0.0, NULL, &c), THUD_ERROR_NULL);
    assert_true(s == 1.0);
}

static void placed_check_refuses_what_no_shape_can_be(void **state) {
    (void)state;
    thud_geometry good = turned(1.0, 2.0, 3.0, 4.0, 0.5), bad[9];
    assert_int_equal(thud_geometry_check(NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_check(&good), THUD_OK);
    for (int i = 0; i < 9; i++) {
        bad[i] = good;
    }
    bad[0].x = NAN;
    bad[1].y = INFINITY;
    bad[2].hx = 0.0;
    bad[3].hy = -1.0;
    bad[4].hx = NAN;
    bad[5].c = 1.0; /* with that sine not a unit vector */
    bad[6].kind = THUD_SHAPE_TERRAIN;
    bad[7].kind = (thud_shape_kind)-1;
    bad[8].hy = INFINITY;
    for (int i = 0; i < 9; i++) {
        thud_closest c;
        bool hit;
        double time, f, nx, ny;
        assert_int_equal(thud_geometry_check(&bad[i]), THUD_ERROR_INVALID);
        assert_int_equal(thud_geometry_closest(&bad[i], &good, &c), THUD_ERROR_INVALID);
        assert_int_equal(thud_geometry_closest(&good, &bad[i], &c), THUD_ERROR_INVALID);
        assert_false(thud_geometry_overlap(&bad[i], &good));
        assert_false(thud_geometry_cast_ray(&bad[i], (thud_segment){-9, 2, 20, 0}, &f, &nx, &ny));
        assert_int_equal(thud_geometry_time_of_impact(&good, (thud_motion){0}, &bad[i],
                                                      (thud_motion){0}, 0.0, &hit, &time),
                         THUD_ERROR_INVALID);
    }
}

static void null_pointers_are_refused(void **state) {
    (void)state;
    thud_geometry a = circle(0, 0, 1);
    thud_closest c;
    bool hit;
    double time;
    thud_motion still = {0};
    assert_false(thud_geometry_overlap(NULL, &a));
    assert_false(thud_geometry_overlap(&a, NULL));
    assert_int_equal(thud_geometry_closest(NULL, &a, &c), THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_closest(&a, &a, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_time_of_impact(&a, still, &a, still, 0.0, NULL, &time),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_geometry_time_of_impact(&a, still, NULL, still, 0.0, &hit, &time),
                     THUD_ERROR_NULL);
}

static void impact_refuses_motion_and_target_out_of_range(void **state) {
    (void)state;
    thud_geometry a = circle(0, 0, 1), b = circle(5, 0, 1);
    thud_motion bad[] = {{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, 1e7}, {0, 0, NAN}}, still = {0};
    double targets[] = {-1.0, NAN, INFINITY};
    bool hit;
    double time;
    for (int i = 0; i < 4; i++) {
        assert_int_equal(thud_geometry_time_of_impact(&a, bad[i], &b, still, 0.0, &hit, &time),
                         THUD_ERROR_INVALID);
        assert_int_equal(thud_geometry_time_of_impact(&a, still, &b, bad[i], 0.0, &hit, &time),
                         THUD_ERROR_INVALID);
    }
    for (int i = 0; i < 3; i++) {
        assert_int_equal(thud_geometry_time_of_impact(&a, still, &b, still, targets[i], &hit,
                                                      &time),
                         THUD_ERROR_INVALID);
    }
}

static void overlap_of_touching_shapes_is_true(void **state) {
    (void)state;
    thud_geometry unit = circle(0, 0, 1), side = circle(2, 0, 1), above = box(0, 2, 1, 1);
    thud_geometry square = box(0, 0, 1, 1), corner = box(2, 2, 1, 1), apart = box(2.001, 0, 1, 1);
    assert_true(thud_geometry_overlap(&unit, &side));
    assert_true(thud_geometry_overlap(&unit, &above));
    assert_true(thud_geometry_overlap(&square, &corner));
    assert_false(thud_geometry_overlap(&square, &apart));
    assert_false(thud_geometry_overlap(&unit, &corner));
}

static void closest_of_circles_at_one_place_has_a_normal(void **state) {
    (void)state;
    thud_closest c = closest(circle(3, 3, 1), circle(3, 3, 2));
    NEAR(c.distance, -3.0);
    NEAR(c.nx * c.nx + c.ny * c.ny, 1.0);
}

static void closest_of_circle_inside_box_leaves_through_nearest_face(void **state) {
    (void)state;
    thud_closest c = closest(box(0, 0, 4, 2), circle(1, -1.5, 0.25));
    NEAR(c.distance, -0.75);
    NEAR(c.nx, 0.0);
    NEAR(c.ny, -1.0);
    NEAR(c.ax, 1.0);
    NEAR(c.ay, -2.0);
    NEAR(c.by, -1.25);
    c = closest(circle(3.5, 0, 0.25), box(0, 0, 4, 2));
    NEAR(c.distance, -0.75);
    NEAR(c.nx, -1.0);
}

static void closest_of_boxes_corner_to_corner_is_the_diagonal(void **state) {
    (void)state;
    thud_closest c = closest(box(0, 0, 1, 1), box(5, 6, 1, 1));
    NEAR(c.distance, 5.0);
    NEAR(c.nx, 0.6);
    NEAR(c.ny, 0.8);
    NEAR(c.ax, 1.0);
    NEAR(c.by, 5.0);
}

static void closest_of_turned_box_over_face_is_its_corner(void **state) {
    (void)state;
    thud_closest c = closest(box(0, 0, 3, 1), turned(0.5, 3, 1, 1, 0.78539816339744831));
    NEAR(c.distance, 2.0 - sqrt(2.0));
    NEAR(c.ny, 1.0);
    NEAR(c.bx, 0.5);
    NEAR(c.ax, 0.5);
}

static void closest_of_overlapping_boxes_is_the_least_axis(void **state) {
    (void)state;
    thud_closest c = closest(box(0, 0, 2, 1), box(3.5, 0.5, 2, 1));
    NEAR(c.distance, -0.5);
    NEAR(c.nx, 1.0);
    NEAR(c.ax, 2.0);
    NEAR(c.bx, 1.5);
}

static void ray_at_circle_and_box_gives_fraction_and_normal(void **state) {
    (void)state;
    thud_geometry c = circle(5, 0, 1), b = box(0, 0, 1, 2);
    double f, nx, ny;
    assert_true(thud_geometry_cast_ray(&c, (thud_segment){0, 0, 8, 0}, &f, &nx, &ny));
    NEAR(f, 0.5);
    NEAR(nx, -1.0);
    assert_true(thud_geometry_cast_ray(&b, (thud_segment){0.5, 6, 0, -8}, &f, &nx, &ny));
    NEAR(f, 0.5);
    NEAR(ny, 1.0);
    assert_false(thud_geometry_cast_ray(&c, (thud_segment){0, 0, 3.9, 0}, &f, &nx, &ny));
    assert_false(thud_geometry_cast_ray(&c, (thud_segment){0, 1.001, 8, 0}, &f, &nx, &ny));
    assert_false(thud_geometry_cast_ray(&b, (thud_segment){3, 0, 5, 0}, &f, &nx, &ny));
}

static void ray_that_starts_inside_or_has_no_length_hits_nothing(void **state) {
    (void)state;
    thud_geometry shapes[] = {circle(0, 0, 1), box(0, 0, 1, 1), turned(0, 0, 1, 1, 0.3)};
    double f, nx, ny;
    for (int i = 0; i < 3; i++) {
        assert_false(
            thud_geometry_cast_ray(&shapes[i], (thud_segment){0.1, 0.2, 9, 9}, &f, &nx, &ny));
        assert_false(thud_geometry_cast_ray(&shapes[i], (thud_segment){4, 0, 0, 0}, &f, &nx, &ny));
        assert_false(
            thud_geometry_cast_ray(&shapes[i], (thud_segment){NAN, 0, 1, 0}, &f, &nx, &ny));
        assert_false(
            thud_geometry_cast_ray(&shapes[i], (thud_segment){4, 0, -INFINITY, 0}, &f, &nx, &ny));
    }
}

static void ray_from_a_million_away_finds_a_small_circle_edge(void **state) {
    (void)state;
    thud_geometry c = circle(0, 0, 1e-3);
    double f, nx, ny;
    assert_true(thud_geometry_cast_ray(&c, (thud_segment){-1e6, 0.999e-3, 2e6, 0}, &f, &nx, &ny));
    assert_true(fabs(ny - 0.999) < 1e-6);
    assert_false(thud_geometry_cast_ray(&c, (thud_segment){-1e6, 1.001e-3, 2e6, 0}, &f, &nx, &ny));
}

static void impact_of_circles_is_exact(void **state) {
    (void)state;
    /* With an offset of 1 and radii 1 and 1, they touch where the centres are sqrt(3) apart in
     * x. */
    NEAR(impact(circle(-5, 1, 1), (thud_motion){10, 0, 0}, circle(0, 0, 1), 0.0),
         (5.0 - sqrt(3.0)) / 10.0);
    NEAR(impact(circle(-5, 0, 1), (thud_motion){10, 0, 0}, circle(0, 0, 1), 0.5), 0.25);
    assert_true(impact(circle(-5, 2.001, 1), (thud_motion){10, 0, 0}, circle(0, 0, 1), 0.0) > 1.0);
    assert_true(impact(circle(-5, 0, 1), (thud_motion){2.9, 0, 0}, circle(0, 0, 1), 0.0) > 1.0);
}

static void impact_of_box_at_the_very_end_counts(void **state) {
    (void)state;
    NEAR(impact(box(-4, 0, 1, 1), (thud_motion){2, 0, 0}, box(0, 0, 1, 1), 0.0), 1.0);
}

static void impact_of_shapes_within_target_is_at_zero(void **state) {
    (void)state;
    assert_true(impact(box(0, 0, 1, 1), (thud_motion){-5, 0, 0}, box(1.5, 0, 1, 1), 0.0) == 0.0);
    assert_true(impact(circle(0, 0, 1), (thud_motion){-5, 0, 0}, circle(2.5, 0, 1), 1.0) == 0.0);
    assert_true(impact(circle(0, 0, 1), (thud_motion){-5, 0, 0}, box(2.5, 0, 1, 1), 1.0) == 0.0);
}

static void impact_of_turning_bar_is_when_its_end_comes_down(void **state) {
    (void)state;
    /* A bar of half length 2 rotates by half a turn above a floor that is 1 below its centre. */
    double time = impact(turned(0, 1, 2, 1e-6, 0.0), (thud_motion){0, 0, -3.14159265358979},
                         box(0, -1, 9, 1), 0.0);
    assert_true(fabs(time - 1.0 / 6.0) < 1e-5);
}

static void impact_heeds_turn_of_obb_alone(void **state) {
    (void)state;
    assert_true(impact(box(0, 1.5, 2, 0.1), (thud_motion){0, 0, 3}, box(0, -1, 9, 1), 0.0) > 1.0);
}

static void results_far_away_are_those_at_home(void **state) {
    (void)state;
    /* Whole numbers are exact at a million, so the results have the same bits. */
    thud_closest home = closest(turned(0, 0, 1, 2, 0.7), box(4, 1, 0.5, 0.25));
    thud_closest away =
        closest(turned(1048576, -1048576, 1, 2, 0.7), box(1048580, -1048575, 0.5, 0.25));
    assert_true(home.distance == away.distance);
    assert_true(home.nx == away.nx && home.ny == away.ny);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sincos_up_to_a_million_radians_is_within_1e_15),
        cmocka_unit_test(sincos_of_what_is_not_finite_is_not_either),
        cmocka_unit_test(sincos_of_quarter_turns_hits_the_axes),
        cmocka_unit_test(placed_check_refuses_what_no_shape_can_be),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(impact_refuses_motion_and_target_out_of_range),
        cmocka_unit_test(overlap_of_touching_shapes_is_true),
        cmocka_unit_test(closest_of_circles_at_one_place_has_a_normal),
        cmocka_unit_test(closest_of_circle_inside_box_leaves_through_nearest_face),
        cmocka_unit_test(closest_of_boxes_corner_to_corner_is_the_diagonal),
        cmocka_unit_test(closest_of_turned_box_over_face_is_its_corner),
        cmocka_unit_test(closest_of_overlapping_boxes_is_the_least_axis),
        cmocka_unit_test(ray_at_circle_and_box_gives_fraction_and_normal),
        cmocka_unit_test(ray_that_starts_inside_or_has_no_length_hits_nothing),
        cmocka_unit_test(ray_from_a_million_away_finds_a_small_circle_edge),
        cmocka_unit_test(impact_of_circles_is_exact),
        cmocka_unit_test(impact_of_box_at_the_very_end_counts),
        cmocka_unit_test(impact_of_shapes_within_target_is_at_zero),
        cmocka_unit_test(impact_of_turning_bar_is_when_its_end_comes_down),
        cmocka_unit_test(impact_heeds_turn_of_obb_alone),
        cmocka_unit_test(results_far_away_are_those_at_home),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
