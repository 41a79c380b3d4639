/* test_contacts_by_hand.c: contact points of shapes and ground, the shortest way out of the ground,
 * and the nearest approach of circles, against answers derived by hand. */
#include "thud/thud_geometry.h"

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

static thud_contacts contacts(thud_geometry a, thud_geometry b, double margin) {
    thud_contacts c;
    assert_int_equal(thud_geometry_contacts(&a, &b, margin, &c), THUD_OK);
    return c;
}

/* Asserts the point on a and the distance, and that b's point follows from them and the normal. */
static void point_is(const thud_closest *c, double ax, double ay, double distance) {
    NEAR(c->ax, ax);
    NEAR(c->ay, ay);
    NEAR(c->distance, distance);
    NEAR(c->bx, ax + distance * c->nx);
    NEAR(c->by, ay + distance * c->ny);
}

static void contacts_of_a_box_on_a_box_are_the_ends_of_the_shared_face(void **state) {
    (void)state;
    thud_contacts c = contacts(box(0, 0, 2, 1), box(1.5, 1.9, 1, 1), 0.0);
    assert_int_equal(c.count, 2);
    int left = c.point[0].ax > c.point[1].ax;
    point_is(&c.point[left], 0.5, 1.0, -0.1);
    point_is(&c.point[!left], 2.0, 1.0, -0.1);
    NEAR(c.point[1].ny, 1.0);
}

static void contacts_of_a_tilted_box_include_what_is_within_the_margin(void **state) {
    (void)state;
    /* Tilted with the slope 3/4; its lower corners are 0 and 1.2 above the floor. */
    thud_geometry floor = box(0, -1, 9, 1);
    thud_geometry tilted = {
        .kind = THUD_SHAPE_OBB, .x = 0.2, .y = 1.4, .c = 0.8, .s = 0.6, .hx = 1, .hy = 1};
    thud_contacts c = contacts(floor, tilted, 1.1);
    assert_int_equal(c.count, 1);
    point_is(&c.point[0], 0.0, 0.0, 0.0);
    c = contacts(floor, tilted, 1.2 + 1e-9);
    assert_int_equal(c.count, 2);
    point_is(&c.point[0], 0.0, 0.0, 0.0);
    point_is(&c.point[1], 1.6, 0.0, 1.2);
}

static void contacts_of_corners_and_of_circles_are_single(void **state) {
    (void)state;
    thud_contacts c = contacts(box(0, 0, 1, 1), box(2.3, 2.4, 1, 1), 1.0);
    assert_int_equal(c.count, 1);
    point_is(&c.point[0], 1.0, 1.0, 0.5);
    c = contacts(box(0, 0, 1, 1), circle(0.5, 1.25, 0.5), 0.0);
    assert_int_equal(c.count, 1);
    point_is(&c.point[0], 0.5, 1.0, -0.25);
}

static void contacts_beyond_the_margin_are_none(void **state) {
    (void)state;
    assert_int_equal(contacts(box(0, 0, 1, 1), box(0, 2.011, 1, 1), 0.01).count, 0);
    assert_int_equal(contacts(box(0, 0, 1, 1), box(0, 2.009, 1, 1), 0.01).count, 2);
    assert_int_equal(contacts(circle(0, 0, 1), circle(3, 0, 1), 0.9).count, 0);
}

/* A valley of two slopes of 45 degrees, its bottom at (4, 0), between plains of height 4. */
static const thud_pos valley[] = {{-6, 4}, {0, 4}, {4, 0}, {8, 4}, {14, 4}};
static const thud_terrain ground = {.kind = THUD_TERRAIN_IRREGULAR, .points = valley, .count = 5};

static thud_closest closest(thud_geometry shape) {
    thud_closest c;
    assert_int_equal(thud_terrain_closest(&ground, &shape, &c), THUD_OK);
    return c;
}

static void distance_from_ground_is_to_its_nearest_feature(void **state) {
    (void)state;
    thud_closest c = closest(box(-3, 7, 1, 1));
    NEAR(c.distance, 2.0);
    NEAR(c.ny, 1.0);
    c = closest(circle(-9, 8, 2)); /* beyond the end of the terrain */
    NEAR(c.distance, 3.0);
    NEAR(c.nx, -0.6);
    point_is(&c, -6.0, 4.0, 3.0);
    c = closest(box(-9, -20, 1, 1)); /* beside the side of the ground */
    NEAR(c.distance, 2.0);
    NEAR(c.nx, -1.0);
}

static void way_out_of_a_valley_is_between_its_slopes(void **state) {
    (void)state;
    /* A circle of radius 1 fits at a height of sqrt(2). */
    thud_closest c = closest(circle(4, 1, 1));
    NEAR(c.distance, 1.0 - sqrt(2.0));
    NEAR(c.nx, 0.0);
    NEAR(c.ny, 1.0);
    /* A box of width 2 fits with its lower corners on the slopes at height 1. */
    c = closest(box(4, 1.5, 1, 1));
    NEAR(c.distance, -0.5);
    NEAR(c.ny, 1.0);
}

static void way_out_into_a_corner_touches_what_it_leaves(void **state) {
    (void)state;
    /* The ball leaves past the ridge at (-0.5, -0.25), until the gentle slope on the right stops it
     * too. On the way it overlaps the side of that slope a little; the feature that it leaves is
     * the ridge. */
    const thud_pos points[] = {{-5, -0.5}, {-0.5, -0.25}, {0, -1.25}, {1, -0.875}, {6, 2.25}};
    thud_terrain notch = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 5};
    thud_geometry ball = circle(0, 0, 1.23);
    thud_closest c;
    assert_int_equal(thud_terrain_closest(&notch, &ball, &c), THUD_OK);
    NEAR(c.ax, -0.5);
    NEAR(c.ay, -0.25);
    /* At its end the ball is a radius away from the ridge and from the line of the slope, 5/8. */
    double x = -c.nx * c.distance, y = -c.ny * c.distance;
    NEAR(hypot(x + 0.5, y + 0.25), 1.23);
    NEAR((8 * (y + 0.875) - 5 * (x - 1)) / sqrt(89.0), 1.23);
    assert_true(8 * c.ny - 5 * c.nx < 0.0);
}

static void way_out_of_the_ground_near_its_end_is_sideways(void **state) {
    (void)state;
    thud_closest c = closest(circle(-5, 1, 1));
    NEAR(c.distance, -2.0);
    NEAR(c.nx, -1.0);
    point_is(&c, -6.0, 1.0, -2.0);
}

static void contacts_in_a_valley_have_a_normal_each(void **state) {
    (void)state;
    thud_geometry ball = circle(4, sqrt(2.0) + 0.005, 1);
    thud_contacts c;
    assert_int_equal(thud_terrain_contacts(&ground, &ball, 0.01, &c), THUD_OK);
    assert_int_equal(c.count, 2);
    NEAR(c.point[0].nx, -c.point[1].nx);
    NEAR(fabs(c.point[0].nx), sqrt(0.5));
    NEAR(c.point[0].distance, 0.005 * sqrt(0.5));
    NEAR(c.point[1].distance, 0.005 * sqrt(0.5));
}

static void contacts_of_a_plank_over_a_valley_are_its_outermost(void **state) {
    (void)state;
    /* It lies on both rims and on the plains along its whole length. */
    thud_geometry plank = box(4, 4.5, 9, 0.5);
    thud_contacts c;
    assert_int_equal(thud_terrain_contacts(&ground, &plank, 0.01, &c), THUD_OK);
    assert_int_equal(c.count, 2);
    NEAR(fabs(c.point[1].ax - c.point[0].ax), 18.0);
    NEAR(c.point[0].ny, 1.0);
    NEAR(c.point[1].ny, 1.0);
}

static void approach_of_circles_that_miss_is_where_they_are_abreast(void **state) {
    (void)state;
    thud_geometry a = circle(0, 0, 1), b = circle(-6, 3, 1);
    thud_approach out;
    assert_int_equal(thud_geometry_approach(&a, (thud_motion){-2, 0, 0}, &b, (thud_motion){6, 0, 0},
                                            &out),
                     THUD_OK);
    assert_false(out.hit);
    assert_true(out.time == 1.0);
    NEAR(out.min_distance, 3.0);
    NEAR(out.min_distance_time, 0.75);
}

static void approach_of_circles_that_hit_goes_on_to_the_centres(void **state) {
    (void)state;
    thud_geometry a = circle(0, 0, 1), b = circle(-6, 0, 1);
    thud_approach out;
    assert_int_equal(thud_geometry_approach(&a, (thud_motion){0}, &b, (thud_motion){8, 0, 5}, &out),
                     THUD_OK);
    assert_true(out.hit);
    NEAR(out.time, 0.5);
    NEAR(out.min_distance, 0.0);
    NEAR(out.min_distance_time, 0.75);
}

static void approach_of_circles_that_part_is_at_the_start(void **state) {
    (void)state;
    thud_geometry a = circle(0, 0, 1), b = circle(3, 4, 1);
    thud_approach out;
    assert_int_equal(thud_geometry_approach(&a, (thud_motion){0}, &b, (thud_motion){3, 4, 0}, &out),
                     THUD_OK);
    assert_false(out.hit);
    NEAR(out.min_distance, 5.0);
    assert_true(out.min_distance_time == 0.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_of_a_box_on_a_box_are_the_ends_of_the_shared_face),
        cmocka_unit_test(contacts_of_a_tilted_box_include_what_is_within_the_margin),
        cmocka_unit_test(contacts_of_corners_and_of_circles_are_single),
        cmocka_unit_test(contacts_beyond_the_margin_are_none),
        cmocka_unit_test(distance_from_ground_is_to_its_nearest_feature),
        cmocka_unit_test(way_out_of_a_valley_is_between_its_slopes),
        cmocka_unit_test(way_out_into_a_corner_touches_what_it_leaves),
        cmocka_unit_test(way_out_of_the_ground_near_its_end_is_sideways),
        cmocka_unit_test(contacts_in_a_valley_have_a_normal_each),
        cmocka_unit_test(contacts_of_a_plank_over_a_valley_are_its_outermost),
        cmocka_unit_test(approach_of_circles_that_miss_is_where_they_are_abreast),
        cmocka_unit_test(approach_of_circles_that_hit_goes_on_to_the_centres),
        cmocka_unit_test(approach_of_circles_that_part_is_at_the_start),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
