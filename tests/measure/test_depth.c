/* test_depth.c: tests the penetration depths that engines are judged by, on cases with known
 * results and against a search over directions. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "depth.h"
#include "random.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

static depth_shape circle(double x, double y, double radius) {
    return (depth_shape){.circle = true, .x = x, .y = y, .cosine = 1, .hx = radius};
}

static depth_shape box(double x, double y, double hx, double hy, double angle) {
    return (
        depth_shape){.x = x, .y = y, .cosine = cos(angle), .sine = sin(angle), .hx = hx, .hy = hy};
}

static void assert_near(double actual, double expected, double tolerance) {
    if (!(fabs(actual - expected) <= tolerance))
        fail_msg("%.9g is not within %.2g of %.9g", actual, tolerance, expected);
}

static void depth_circles_overlapping_is_radii_less_distance(void **state) {
    (void)state;
    depth_shape a = circle(0, 0, 1), b = circle(1.2, 1.6, 1.5);
    assert_near(depth_of_pair(&a, &b), 0.5, 1e-12);
}

static void depth_circle_inside_box_includes_way_to_nearest_face(void **state) {
    (void)state;
    depth_shape a = circle(0.2, 0.7, 0.25), b = box(0, 0, 2, 1, 0);
    assert_near(depth_of_pair(&a, &b), 0.25 + 0.3, 1e-12);
    assert_near(depth_of_pair(&b, &a), 0.25 + 0.3, 1e-12);
}

static void depth_circle_at_corner_of_turned_box_is_measured_to_corner(void **state) {
    (void)state;
    depth_shape a = circle(sqrt(2) + 0.3, 0, 0.5), b = box(0, 0, 1, 1, PI / 4);
    assert_near(depth_of_pair(&a, &b), 0.2, 1e-12);
}

static void depth_box_on_box_is_smallest_overlap_of_projections(void **state) {
    (void)state;
    depth_shape a = box(0, 0, 1, 1, 0), b = box(0.3, 1.99, 1, 1, 0);
    assert_near(depth_of_pair(&a, &b), 0.01, 1e-12);
    b = box(0, 1 + sqrt(2) - 0.05, 1, 1, PI / 4);
    assert_near(depth_of_pair(&a, &b), 0.05, 1e-12);
}

enum { DIRECTIONS = 3600 };
static const double BISECTION_END = 1e-9; /* a distance */
/* A distance by which any two shapes of random_shape are apart: their centres are at most 2 sqrt(2)
 * from each other, and their corners at most sqrt(2) from their centres. */
static const double APART = 20;

/* The smallest distance, over DIRECTIONS, by which b must be moved so that the shapes separate.
 * Found by bisection on the sign of the depth alone; both shapes are convex, so that b stays apart
 * once it is. */
static double depth_by_search(const depth_shape *a, const depth_shape *b) {
    double smallest = HUGE_VAL;
    for (int i = 0; i < DIRECTIONS; i++) {
        double angle = i * 2 * PI / DIRECTIONS, inside = 0, outside = APART;
        while (outside - inside > BISECTION_END) {
            double middle = 0.5 * (inside + outside);
            depth_shape moved = *b;
            moved.x += middle * cos(angle);
            moved.y += middle * sin(angle);
            if (depth_of_pair(a, &moved) > 0)
                inside = middle;
            else
                outside = middle;
        }
        smallest = outside < smallest ? outside : smallest;
    }
    return smallest;
}

static depth_shape random_shape(scene_random *random) {
    double x = scene_random_range(random, -1, 1), y = scene_random_range(random, -1, 1);
    double hx = scene_random_range(random, 0.2, 1), hy = scene_random_range(random, 0.2, 1);
    double angle = scene_random_range(random, -PI, PI);
    return scene_random_range(random, 0, 1) < 0.4 ? circle(x, y, hx) : box(x, y, hx, hy, angle);
}

/* The search tries directions 0.1 degrees apart, so that it misses the best one by at most 0.05
 * degrees. The distance that it finds exceeds the depth then by a factor of at most
 * 1 / cos(0.05 degrees) = 1 + 3.8e-7 where a face is left, and by less where a circle is; and by up
 * to BISECTION_END. */
static void depth_random_pairs_equals_smallest_distance_by_search(void **state) {
    (void)state;
    scene_random random = {7};
    int overlapping = 0;
    for (int i = 0; i < 60; i++) {
        depth_shape a = random_shape(&random), b = random_shape(&random);
        double depth = depth_of_pair(&a, &b);
        if (depth <= 0)
            continue;
        overlapping++;
        assert_near(depth, depth_by_search(&a, &b), 4e-7 * depth + 2 * BISECTION_END);
    }
    assert_true(overlapping > 20); /* else hardly anything was compared */
}

static const scene_point VALLEY[] = {{-4, 4}, {0, 0}, {4, 4}};

static void depth_circle_in_valley_is_radius_less_distance_to_both_sides(void **state) {
    (void)state;
    depth_ground ground = {VALLEY, 3};
    depth_shape ball = circle(0, sqrt(2) - 0.1, 1);
    assert_near(depth_in_ground(&ground, &ball), 0.1 / sqrt(2), 1e-12);
    ball.y = sqrt(2) + 0.1;
    assert_true(depth_in_ground(&ground, &ball) <= 0);
}

static void depth_circle_below_ground_adds_distance_to_line(void **state) {
    (void)state;
    depth_ground ground = {VALLEY, 3};
    depth_shape ball = circle(2, 1, 0.5);
    assert_near(depth_in_ground(&ground, &ball), 0.5 + sqrt(0.5), 1e-12);
}

/* A box on the right slope of the valley (45 degrees), flush and tilted against it, so far in that
 * its deepest corners are 0.02 below the line, at a right angle to it. */
static void depth_box_on_slope_is_distance_of_deepest_corner_from_line(void **state) {
    (void)state;
    depth_ground ground = {VALLEY, 3};
    const double hx = 0.3, hy = 0.5, tilts[] = {0, 0.2};
    for (int i = 0; i < 2; i++) {
        double corner = hx * sin(tilts[i]) + hy * cos(tilts[i]); /* below the centre */
        double above = corner - 0.02; /* of the centre, from the point (2, 2) of the line */
        depth_shape crate =
            box(2 - above * sqrt(0.5), 2 + above * sqrt(0.5), hx, hy, PI / 4 + tilts[i]);
        assert_near(depth_in_ground(&ground, &crate), 0.02, 1e-12);
    }
}

static void depth_box_on_peak_is_depth_of_the_peak_in_the_box(void **state) {
    (void)state;
    static const scene_point peak[] = {{-4, -4}, {0, 0}, {4, -4}};
    depth_ground ground = {peak, 3};
    depth_shape crate = box(0.1, 0.47, 1, 0.5, 0);
    assert_near(depth_in_ground(&ground, &crate), 0.03, 1e-12);
}

static void depth_beyond_ends_of_ground_is_none(void **state) {
    (void)state;
    depth_ground ground = {VALLEY, 3};
    depth_shape ball = circle(4.5, 0, 0.4), crate = box(6, 0, 0.4, 0.4, 0);
    assert_true(depth_in_ground(&ground, &ball) <= 0);
    assert_true(depth_in_ground(&ground, &crate) <= 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_circles_overlapping_is_radii_less_distance),
        cmocka_unit_test(depth_circle_inside_box_includes_way_to_nearest_face),
        cmocka_unit_test(depth_circle_at_corner_of_turned_box_is_measured_to_corner),
        cmocka_unit_test(depth_box_on_box_is_smallest_overlap_of_projections),
        cmocka_unit_test(depth_random_pairs_equals_smallest_distance_by_search),
        cmocka_unit_test(depth_circle_in_valley_is_radius_less_distance_to_both_sides),
        cmocka_unit_test(depth_circle_below_ground_adds_distance_to_line),
        cmocka_unit_test(depth_box_on_slope_is_distance_of_deepest_corner_from_line),
        cmocka_unit_test(depth_box_on_peak_is_depth_of_the_peak_in_the_box),
        cmocka_unit_test(depth_beyond_ends_of_ground_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
