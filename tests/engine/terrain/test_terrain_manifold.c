/* test_terrain_manifold.c: contacts of circles and boxes with the segments of a terrain, derived by
 * hand: each contact belongs to one segment, with a normal that lets shapes slide smoothly over the
 * vertices. */
#include "terrain/terrain_manifold.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-9)
/* Distance up to which a contact is made, in metres. */
#define MARGIN 0.02

/* Contact points of all segments, each with its normal; how many segments had any. */
typedef struct contacts {
    int count, segments;
    td_terrain_point point[64];
    double nx[64], ny[64];
} contacts;

static thud_geometry circle(double x, double y, double r) {
    return (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1.0, .hx = r};
}

static thud_geometry box(double x, double y, double hx, double hy, double angle) {
    return (thud_geometry){THUD_SHAPE_OBB, x, y, cos(angle), sin(angle), hx, hy};
}

static thud_terrain line(const thud_pos *points, int count) {
    return (thud_terrain){.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = count};
}

/* The contacts that a world finds: those with all segments near the shape. */
static contacts meet(const thud_terrain *t, thud_geometry shape) {
    contacts c = {0};
    double reach = shape.hx + shape.hy + MARGIN;
    int first, last;
    thud_terrain_segments(t, shape.x - reach, shape.x + reach, &first, &last);
    for (int i = first; i <= last; i++) {
        td_terrain_manifold m;
        td_terrain_segment_manifold(t, i, &shape, 0, MARGIN, &m);
        c.segments += m.count > 0;
        for (int k = 0; k < m.count; k++) {
            assert_true(c.count < 64);
            c.point[c.count] = m.point[k];
            c.nx[c.count] = m.nx;
            c.ny[c.count++] = m.ny;
        }
    }
    return c;
}

static void circle_on_endless_slope_has_one_point_between_the_surfaces(void **state) {
    (void)state;
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT, .slope = 0.75};
    /* The centre is 0.99 above the line at the point (4, 3). */
    contacts c = meet(&flat, circle(4 - 0.6 * 0.99, 3 + 0.8 * 0.99, 1));
    assert_int_equal(c.count, 1);
    NEAR(c.point[0].separation, -0.01);
    NEAR(c.nx[0], -0.6);
    NEAR(c.ny[0], 0.8);
    NEAR(c.point[0].px, 0.6 * 0.995);
    NEAR(c.point[0].py, -0.8 * 0.995);
}

static void shapes_beyond_the_margin_have_no_points(void **state) {
    (void)state;
    const thud_pos hill[] = {{-5, 0}, {0, 0}, {5, -2}};
    thud_terrain t = line(hill, 3);
    assert_int_equal(meet(&t, circle(-2, 1.0201, 1)).count, 0);
    assert_int_equal(meet(&t, circle(-2, 1.0199, 1)).count, 1);
    assert_int_equal(meet(&t, box(0, 1.0201, 1, 1, 0)).count, 0);
    assert_int_equal(meet(&t, box(-2, 1.0199, 1, 1, 0)).count, 2);
    assert_int_equal(meet(&t, circle(-5.6, 0.9, 1)).count, 0);
}

static void circle_sliding_over_collinear_segments_meets_one_at_a_time(void **state) {
    (void)state;
    thud_pos points[41];
    for (int slope = -2; slope <= 2; slope++) {
        for (int i = 0; i <= 40; i++) {
            points[i] = (thud_pos){i * 0.25, i * 0.25 * 0.3 * slope};
        }
        thud_terrain t = line(points, 41);
        double length = sqrt(1 + 0.09 * slope * slope);
        for (int i = 0; i < 4000; i++) {
            double x = 2.0 + i * 0.0015;
            contacts c = meet(&t, circle(x, 0.3 * slope * x + 0.49 * length, 0.5));
            assert_int_equal(c.count, 1);
            NEAR(c.nx[0], -0.3 * slope / length);
            NEAR(c.point[0].separation, -0.01);
        }
    }
}

static void box_sliding_over_collinear_segments_meets_two_corners_with_one_normal(void **state) {
    (void)state;
    thud_pos points[41];
    for (int slope = -2; slope <= 2; slope++) {
        for (int i = 0; i <= 40; i++) {
            points[i] = (thud_pos){i * 0.25, i * 0.25 * 0.3 * slope};
        }
        thud_terrain t = line(points, 41);
        double length = sqrt(1 + 0.09 * slope * slope);
        for (int i = 0; i < 4000; i++) {
            double x = 2.0 + i * 0.0015;
            thud_geometry b = box(x, 0.3 * slope * x + 0.49 * length, 0.8, 0.5, 0);
            b.c = 1 / length;
            b.s = 0.3 * slope / length;
            contacts c = meet(&t, b);
            assert_int_equal(c.count, 2);
            assert_true((c.point[0].id == 0 && c.point[1].id == 1) ||
                        (c.point[0].id == 1 && c.point[1].id == 0));
            for (int k = 0; k < 2; k++) {
                NEAR(c.nx[k], -0.3 * slope / length);
                NEAR(c.point[k].separation, -0.01);
            }
        }
    }
}

static void box_in_one_segment_orders_its_points_along_the_ground(void **state) {
    (void)state;
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    contacts c = meet(&flat, box(3, 0.99, 2, 1, 0));
    assert_int_equal(c.count, 2);
    assert_true(c.point[0].px < c.point[1].px);
    assert_int_equal(c.point[0].id, 0);
    assert_int_equal(c.point[1].id, 1);
    NEAR(c.point[0].px, -2.0);
    NEAR(c.point[0].py, -0.995);
    /* Upside down, the same corners keep their ids. */
    c = meet(&flat, box(3, 0.99, 2, 1, 3.14159265358979323846));
    assert_int_equal(c.point[0].id, 2);
    assert_int_equal(c.point[1].id, 3);
}

static void circle_in_a_valley_touches_both_slopes(void **state) {
    (void)state;
    const thud_pos valley[] = {{-4, 4}, {0, 0}, {4, 4}};
    thud_terrain t = line(valley, 3);
    contacts c = meet(&t, circle(0, sqrt(2.0) - 0.001, 1));
    assert_int_equal(c.count, 2);
    NEAR(c.nx[0], sqrt(0.5));
    NEAR(c.nx[1], -sqrt(0.5));
}

static void corner_of_a_box_in_a_valley_touches_both_slopes_in_or_over_the_ground(void **state) {
    (void)state;
    const thud_pos valley[] = {{-4, 2}, {0, 0}, {4, 2}}, cliff[] = {{-4, 0}, {0, 0}, {0.001, 4}};
    thud_terrain v = line(valley, 3), wall = line(cliff, 3);
    for (int i = -1; i <= 1; i += 2) {
        double gap = i * 0.002;
        /* Balanced on one corner, it touches both slopes. */
        contacts c = meet(&v, box(0.0001, sqrt(2.0) + gap, 1, 1, 0.78539816339744831));
        assert_true(c.count == 2 && c.point[0].id == 0 && c.point[1].id == 0);
        assert_true(c.nx[0] > 0.0 && c.nx[1] < 0.0);
        c = meet(&wall, box(-1 - 0.001, 1 + gap, 1, 1, 0));
        assert_int_equal(c.segments, 2);
        c = meet(&wall, box(-1 + 0.0005, 1 + gap, 1, 1, 0));
        assert_int_equal(c.segments, 2);
    }
}

static void box_that_hit_a_thin_cliff_is_pushed_back_not_up(void **state) {
    (void)state;
    const thud_pos cliff[] = {{-4, 0}, {0, 0}, {0.001, 4}, {4, 4}};
    thud_terrain t = line(cliff, 4);
    contacts c = meet(&t, box(-0.95, 1.0, 1, 0.9, 0));
    assert_true(c.count > 0);
    for (int k = 0; k < c.count; k++) {
        assert_true(c.nx[k] < -0.99);
        assert_true(c.point[k].separation > -0.06);
    }
}

static void circle_over_a_ridge_meets_its_vertex_once(void **state) {
    (void)state;
    const thud_pos ridge[] = {{-4, -4}, {0, 0}, {4, -4}};
    thud_terrain t = line(ridge, 3);
    for (int i = -70; i <= 70; i++) {
        double angle = i * 0.01;
        contacts c = meet(&t, circle(0.99 * sin(angle), 0.99 * cos(angle), 1));
        assert_int_equal(c.count, 1);
        NEAR(c.nx[0], sin(angle));
        NEAR(c.point[0].separation, -0.01);
    }
}

static void box_across_a_gentle_ridge_is_held_by_it(void **state) {
    (void)state;
    const thud_pos ridge[] = {{-4, -0.02}, {0, 0}, {4, -0.02}};
    thud_terrain t = line(ridge, 3);
    contacts c = meet(&t, box(0.1, 0.99, 1, 1, 0));
    double deepest = 0.0;
    for (int k = 0; k < c.count; k++) {
        deepest = fmin(deepest, c.point[k].separation);
        assert_true(fabs(c.nx[k]) <= 0.00501);
    }
    assert_true(fabs(deepest + 0.01) < 1e-6);
}

static void box_on_a_sharp_ridge_takes_the_normal_of_its_face(void **state) {
    (void)state;
    const thud_pos ridge[] = {{-4, -4}, {0, 0}, {4, -4}};
    thud_terrain t = line(ridge, 3);
    for (int i = -7; i <= 7; i++) {
        double angle = i * 0.1;
        contacts c = meet(&t, box(-sin(angle) * 0.99, cos(angle) * 0.99, 1, 1, angle));
        assert_int_equal(c.count, 1);
        NEAR(c.nx[0], -sin(angle));
        NEAR(c.point[0].separation, -0.01);
        assert_int_equal(c.point[0].id, 4);
    }
}

static void box_on_a_needle_of_rock_rests_on_its_point(void **state) {
    (void)state;
    const thud_pos needle[] = {{-4, -9}, {-1e-4, -9}, {0, 0}, {1e-4, -9}, {4, -9}};
    thud_terrain t = line(needle, 5);
    contacts c = meet(&t, box(0.3, 0.99, 1, 1, 0));
    assert_int_equal(c.count, 1);
    NEAR(c.ny[0], 1.0);
    NEAR(c.point[0].px, -0.3);
    NEAR(c.point[0].separation, -0.01);
}

static void deep_shapes_are_pushed_out_through_the_line(void **state) {
    (void)state;
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    contacts c = meet(&flat, circle(0, -50, 1));
    assert_int_equal(c.count, 1);
    NEAR(c.point[0].separation, -51.0);
    NEAR(c.ny[0], 1.0);
    c = meet(&flat, box(0, -50, 2, 1, 0));
    assert_int_equal(c.count, 2);
    NEAR(c.point[0].separation, -51.0);
    const thud_pos points[] = {{-9, 0}, {-3, 0}, {-1, 0}, {1, 0}, {3, 0}, {9, 0}};
    thud_terrain t = line(points, 6);
    c = meet(&t, circle(0.5, -2, 0.5));
    assert_int_equal(c.count, 1);
    NEAR(c.point[0].separation, -2.5);
}

static void circle_rolls_off_the_end_round_its_vertex(void **state) {
    (void)state;
    const thud_pos shelf[] = {{0, 0}, {5, 0}};
    thud_terrain t = line(shelf, 2);
    for (int i = 0; i <= 20; i++) {
        double angle = i * 1.5707963267948966 / 20;
        contacts left = meet(&t, circle(-0.99 * sin(angle), 0.99 * cos(angle), 1));
        contacts right = meet(&t, circle(5 + 0.99 * sin(angle), 0.99 * cos(angle), 1));
        assert_int_equal(left.count, 1);
        assert_int_equal(right.count, 1);
        NEAR(left.nx[0], -sin(angle));
        NEAR(right.nx[0], sin(angle));
    }
    /* Beside the ground, the circle touches the vertical side. */
    contacts c = meet(&t, circle(-0.99, -30, 1));
    assert_int_equal(c.count, 1);
    NEAR(c.nx[0], -1.0);
    NEAR(c.point[0].separation, -0.01);
    assert_int_equal(meet(&t, circle(-1.05, -30, 1)).count, 0);
}

static void box_over_the_end_is_held_by_vertex_and_corner(void **state) {
    (void)state;
    const thud_pos shelf[] = {{0, 0}, {5, 0}};
    thud_terrain t = line(shelf, 2);
    contacts c = meet(&t, box(0.3, 0.99, 1, 1, 0));
    assert_int_equal(c.count, 2);
    NEAR(c.point[0].px, -0.3);
    NEAR(c.point[1].px, 1.0);
    NEAR(c.ny[0], 1.0);
    /* Tilted, only the vertex touches it, with the normal of its face. */
    double cs = cos(0.5), sn = sin(0.5);
    c = meet(&t, box(-0.2 * cs - 0.99 * sn, 0.99 * cs - 0.2 * sn, 1, 1, 0.5));
    assert_int_equal(c.count, 1);
    NEAR(c.nx[0], -sin(0.5));
    NEAR(c.point[0].separation, -0.01);
    /* Beside the ground, both its corners touch the side. */
    c = meet(&t, box(-0.99, -30, 1, 1, 0));
    assert_int_equal(c.count, 2);
    NEAR(c.nx[0], -1.0);
    NEAR(c.point[0].separation, -0.01);
}

static void manifold_has_the_same_bits_every_time(void **state) {
    (void)state;
    const thud_pos hills[] = {{-4, 1}, {-1, 0}, {0, 0.5}, {4, -4}};
    thud_terrain t = line(hills, 4);
    thud_geometry b = box(-0.3, 0.8, 1, 0.6, 0.3);
    for (int i = 0; i < 3; i++) {
        td_terrain_manifold one, two;
        memset(&one, 0, sizeof one);
        memset(&two, 0, sizeof two);
        td_terrain_segment_manifold(&t, i, &b, 0, MARGIN, &one);
        td_terrain_segment_manifold(&t, i, &b, 0, MARGIN, &two);
        assert_memory_equal(&one, &two, sizeof one);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circle_on_endless_slope_has_one_point_between_the_surfaces),
        cmocka_unit_test(shapes_beyond_the_margin_have_no_points),
        cmocka_unit_test(circle_sliding_over_collinear_segments_meets_one_at_a_time),
        cmocka_unit_test(box_sliding_over_collinear_segments_meets_two_corners_with_one_normal),
        cmocka_unit_test(box_in_one_segment_orders_its_points_along_the_ground),
        cmocka_unit_test(circle_in_a_valley_touches_both_slopes),
        cmocka_unit_test(corner_of_a_box_in_a_valley_touches_both_slopes_in_or_over_the_ground),
        cmocka_unit_test(box_that_hit_a_thin_cliff_is_pushed_back_not_up),
        cmocka_unit_test(circle_over_a_ridge_meets_its_vertex_once),
        cmocka_unit_test(box_across_a_gentle_ridge_is_held_by_it),
        cmocka_unit_test(box_on_a_sharp_ridge_takes_the_normal_of_its_face),
        cmocka_unit_test(box_on_a_needle_of_rock_rests_on_its_point),
        cmocka_unit_test(deep_shapes_are_pushed_out_through_the_line),
        cmocka_unit_test(circle_rolls_off_the_end_round_its_vertex),
        cmocka_unit_test(box_over_the_end_is_held_by_vertex_and_corner),
        cmocka_unit_test(manifold_has_the_same_bits_every_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
