/* test_minkowski_by_hand.c: Minkowski sums derived by hand, casts that hit corners and faces
 * exactly, and input that is refused. */
#include "thud/thud_minkowski.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-12)
#define OK(call) assert_int_equal(call, THUD_OK)
#define INVALID(call) assert_int_equal(call, THUD_ERROR_INVALID)
#define MISSING(call) assert_int_equal(call, THUD_ERROR_NULL)

static thud_geometry box(double hx, double hy) {
    return (thud_geometry){.kind = THUD_SHAPE_AABB, .c = 1.0, .hx = hx, .hy = hy};
}

static void sum_of_boxes_by_hand_has_the_sums_of_their_extents(void **state) {
    (void)state;
    thud_geometry a = box(1.0, 2.0), b = box(0.5, 0.25);
    thud_minkowski m;
    OK(thud_minkowski_sum(&a, &b, &m));
    assert_int_equal(m.count, 4);
    const double x[4] = {-1.5, 1.5, 1.5, -1.5}, y[4] = {-2.25, -2.25, 2.25, 2.25};
    for (int i = 0; i < 4; i++) {
        NEAR(m.vertices[i].x, x[i]);
        NEAR(m.vertices[i].y, y[i]);
    }
}

static void sum_of_square_and_diamond_by_hand_is_an_octagon(void **state) {
    (void)state;
    double half = sqrt(0.5);
    thud_geometry a = box(1.0, 1.0), b = {THUD_SHAPE_OBB, 0.0, 0.0, half, half, half, half};
    thud_minkowski m;
    bool inside;
    OK(thud_minkowski_sum(&a, &b, &m));
    assert_int_equal(m.count, 8);
    NEAR(m.offsets[0], 2.0);
    NEAR(m.offsets[1], half + sqrt(2.0));
    OK(thud_minkowski_contains(&m, 1.99, 0.99, &inside));
    assert_true(inside);
    OK(thud_minkowski_contains(&m, 1.51, 1.51, &inside));
    assert_false(inside);
}

static void sum_of_circles_is_a_point_with_both_radii(void **state) {
    (void)state;
    thud_geometry a = {.kind = THUD_SHAPE_CIRCLE, .hx = 2.0},
                  b = {.kind = THUD_SHAPE_CIRCLE, .hx = 0.5};
    thud_minkowski m;
    memset(&m, 0xff, sizeof m);
    OK(thud_minkowski_sum(&a, &b, &m));
    assert_int_equal(m.count, 1);
    NEAR(m.radius, 2.5);
    assert_true(m.vertices[0].x == 0.0 && m.vertices[7].y == 0.0 && m.offsets[3] == 0.0);
}

static void cast_along_a_face_touches_its_end(void **state) {
    (void)state;
    thud_geometry a = box(1.0, 2.0), b = box(0.5, 0.25);
    thud_minkowski m;
    bool hit;
    double f, nx, ny;
    OK(thud_minkowski_sum(&a, &b, &m));
    OK(thud_minkowski_cast(&m, (thud_segment){-4.5, 2.25, 6.0, 0.0}, &hit, &f, &nx, &ny));
    assert_true(hit);
    NEAR(f, 0.5);
    NEAR(nx, -1.0);
    OK(thud_minkowski_cast(&m, (thud_segment){-4.5, 2.2500001, 6.0, 0.0}, &hit, &f, &nx, &ny));
    assert_false(hit);
}

static void ray_from_inside_through_a_corner_hits_nothing(void **state) {
    (void)state;
    thud_geometry a = box(1.0, 1.0);
    double f, nx, ny;
    for (int i = 0; i < 4; i++) {
        double dx = i % 2 ? 2.0 : -2.0, dy = i / 2 ? 2.0 : -2.0;
        assert_false(thud_geometry_cast_ray(&a, (thud_segment){0.0, 0.0, dx, dy}, &f, &nx, &ny));
    }
}

static void ray_from_afar_does_not_pass_a_needle_thinner_than_its_rounding(void **state) {
    (void)state;
    thud_geometry a = box(1.0, 1e-12);
    double f, nx, ny;
    for (int i = 1; i < 1000; i++) {
        assert_true(
            thud_geometry_cast_ray(&a, (thud_segment){0.0, 1e7 / i, 0.0, -1e7}, &f, &nx, &ny));
        NEAR(f, 1.0 / i);
    }
}

/* Points whose squared distance underflows to 0 in a double give no direction. */
static void impact_on_ground_with_points_next_to_each_other_is_found(void **state) {
    (void)state;
    const thud_pos points[4] = {{-5.0, 0.0}, {0.0, 0.0}, {1e-200, 0.0}, {5.0, 0.0}};
    thud_terrain ground = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
    for (int kind = THUD_SHAPE_CIRCLE; kind <= THUD_SHAPE_OBB; kind++) {
        thud_geometry a = {(thud_shape_kind)kind, 0.0, 3.0, 1.0, 0.0, 1.0, 1.0};
        bool hit;
        double time;
        OK(thud_terrain_time_of_impact(&ground, &a, (thud_motion){0.0, -4.0, 0.0}, 0.0, &hit,
                                       &time));
        assert_true(hit);
        NEAR(time, 0.5);
    }
}

static void sum_of_box_with_inexact_rotation_has_unit_normals(void **state) {
    (void)state;
    thud_geometry b = {THUD_SHAPE_OBB, 0.0, 0.0, 0.6 * (1.0 + 4e-6), 0.8 * (1.0 + 4e-6), 2.0, 1.0};
    thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 1e-9};
    thud_minkowski m;
    OK(thud_minkowski_sum(&b, &point, &m));
    for (int i = 0; i < 2; i++) {
        assert_true(fabs(hypot(m.normals[i].x, m.normals[i].y) - 1.0) < 1e-10);
    }
    assert_true(fabs(hypot(m.vertices[0].x, m.vertices[0].y) - sqrt(5.0)) < 1e-9);
}

static void cast_past_rounded_corner_by_hand_misses_where_a_sharp_one_would_not(void **state) {
    (void)state;
    thud_geometry a = box(1.0, 1.0), b = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 1.0};
    thud_minkowski m;
    bool hit;
    double f, nx, ny;
    OK(thud_minkowski_sum(&a, &b, &m));
    /* Diagonally past the corner (1, 1), at distances 0.99 and 1.01 from it. */
    double near = 2.0 + 0.99 * sqrt(2.0), far = 2.0 + 1.01 * sqrt(2.0);
    OK(thud_minkowski_cast(&m, (thud_segment){near + 3.0, -3.0, -6.0, 6.0}, &hit, &f, &nx, &ny));
    assert_true(hit);
    OK(thud_minkowski_cast(&m, (thud_segment){far + 3.0, -3.0, -6.0, 6.0}, &hit, &f, &nx, &ny));
    assert_false(hit);
    OK(thud_minkowski_cast(&m, (thud_segment){0.0, 6.0, 0.0, -8.0}, &hit, &f, &nx, &ny));
    assert_true(hit);
    NEAR(f, 0.5);
    NEAR(ny, 1.0);
}

static void sum_of_needles_near_parallel_loses_no_face(void **state) {
    (void)state;
    for (double angle = 1e-15; angle < 1.0; angle *= 10.0) {
        thud_geometry a = {THUD_SHAPE_OBB, 0.0, 0.0, 1.0, 0.0, 1.0, 1e-6};
        thud_geometry b = {THUD_SHAPE_OBB, 0.0, 0.0, cos(angle), sin(angle), 1.0, 1e-6};
        thud_minkowski m;
        bool hit;
        double f, nx, ny;
        OK(thud_minkowski_sum(&a, &b, &m));
        assert_int_equal(m.count, 8);
        /* Casts straight down onto it, everywhere along its upper side, all hit. */
        for (double x = -1.99; x < 2.0; x += 0.0398) {
            OK(thud_minkowski_cast(&m, (thud_segment){x * cos(angle), 5.0, 0.0, -10.0}, &hit, &f,
                                   &nx, &ny));
            assert_true(hit);
        }
    }
}

static void refused_input_leaves_every_output_as_it_was(void **state) {
    (void)state;
    thud_geometry good = box(1.0, 1.0), bad[4] = {good, good, good, good};
    thud_minkowski m, kept, wrong[3];
    bad[0].x = NAN;
    bad[1].hx = 0.0;
    bad[2].hy = -1.0;
    bad[3].kind = THUD_SHAPE_TERRAIN;
    OK(thud_minkowski_sum(&good, &good, &m));
    memcpy(&kept, &m, sizeof m);
    for (int i = 0; i < 4; i++) {
        INVALID(thud_minkowski_sum(&bad[i], &good, &m));
        INVALID(thud_minkowski_sum(&good, &bad[i], &m));
    }
    MISSING(thud_minkowski_sum(NULL, &good, &m));
    MISSING(thud_minkowski_sum(&good, NULL, &m));
    MISSING(thud_minkowski_sum(&good, &good, NULL));
    assert_memory_equal(&m, &kept, sizeof m);

    bool yes = true;
    double d = 7.0, nx = 8.0, ny = 9.0;
    wrong[0] = wrong[1] = wrong[2] = m;
    wrong[0].count = 9;
    wrong[1].radius = NAN;
    wrong[2].radius = -1.0;
    for (int i = 0; i < 3; i++) {
        INVALID(thud_minkowski_contains(&wrong[i], 9, 0, &yes));
        INVALID(thud_minkowski_distance(&wrong[i], 9, 0, &d, &nx, &ny));
        INVALID(thud_minkowski_cast(&wrong[i], (thud_segment){9, 0, 1, 0}, &yes, &d, &nx, &ny));
    }
    const double off[] = {NAN, INFINITY, -1e17};
    for (int i = 0; i < 3; i++) {
        double o = off[i];
        INVALID(thud_minkowski_contains(&m, o, 0, &yes));
        INVALID(thud_minkowski_contains(&m, 9, o, &yes));
        INVALID(thud_minkowski_distance(&m, o, 0, &d, &nx, &ny));
        INVALID(thud_minkowski_distance(&m, 9, o, &d, &nx, &ny));
        INVALID(thud_minkowski_cast(&m, (thud_segment){o, 0, 1, 0}, &yes, &d, &nx, &ny));
        INVALID(thud_minkowski_cast(&m, (thud_segment){9, o, 1, 0}, &yes, &d, &nx, &ny));
        INVALID(thud_minkowski_cast(&m, (thud_segment){9, 0, o, 0}, &yes, &d, &nx, &ny));
        INVALID(thud_minkowski_cast(&m, (thud_segment){9, 0, 1, o}, &yes, &d, &nx, &ny));
    }
    MISSING(thud_minkowski_contains(NULL, 9, 0, &yes));
    MISSING(thud_minkowski_contains(&m, 9, 0, NULL));
    MISSING(thud_minkowski_distance(NULL, 9, 0, &d, &nx, &ny));
    MISSING(thud_minkowski_distance(&m, 9, 0, NULL, &nx, &ny));
    MISSING(thud_minkowski_distance(&m, 9, 0, &d, NULL, &ny));
    MISSING(thud_minkowski_distance(&m, 9, 0, &d, &nx, NULL));
    MISSING(thud_minkowski_cast(NULL, (thud_segment){9, 0, 1, 0}, &yes, &d, &nx, &ny));
    MISSING(thud_minkowski_cast(&m, (thud_segment){9, 0, 1, 0}, NULL, &d, &nx, &ny));
    MISSING(thud_minkowski_cast(&m, (thud_segment){9, 0, 1, 0}, &yes, NULL, &nx, &ny));
    MISSING(thud_minkowski_cast(&m, (thud_segment){9, 0, 1, 0}, &yes, &d, NULL, &ny));
    MISSING(thud_minkowski_cast(&m, (thud_segment){9, 0, 1, 0}, &yes, &d, &nx, NULL));
    assert_true(yes && d == 7.0 && nx == 8.0 && ny == 9.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sum_of_boxes_by_hand_has_the_sums_of_their_extents),
        cmocka_unit_test(sum_of_square_and_diamond_by_hand_is_an_octagon),
        cmocka_unit_test(sum_of_circles_is_a_point_with_both_radii),
        cmocka_unit_test(cast_along_a_face_touches_its_end),
        cmocka_unit_test(ray_from_inside_through_a_corner_hits_nothing),
        cmocka_unit_test(ray_from_afar_does_not_pass_a_needle_thinner_than_its_rounding),
        cmocka_unit_test(impact_on_ground_with_points_next_to_each_other_is_found),
        cmocka_unit_test(sum_of_box_with_inexact_rotation_has_unit_normals),
        cmocka_unit_test(cast_past_rounded_corner_by_hand_misses_where_a_sharp_one_would_not),
        cmocka_unit_test(sum_of_needles_near_parallel_loses_no_face),
        cmocka_unit_test(refused_input_leaves_every_output_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
