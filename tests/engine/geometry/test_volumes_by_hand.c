/* test_volumes_by_hand.c: bounding volumes derived by hand, degenerate ones, and input that is
 * refused. */
#include "volumes_support.h"

static void circle_around_square_reaches_its_corners(void **state) {
    (void)state;
    thud_volume v;
    OK(thud_volume_around_shape(THUD_SHAPE_CIRCLE, &square, &v));
    assert_int_equal(v.kind, THUD_SHAPE_CIRCLE);
    NEAR(v.x, 3.0);
    NEAR(v.y, 4.0);
    NEAR(v.hx, sqrt(2.0));
}

static void obb_around_obb_is_itself(void **state) {
    (void)state;
    thud_geometry box = turned(2.0, 0.5, 0.3);
    thud_volume v;
    OK(thud_volume_around_shape(THUD_SHAPE_OBB, &box, &v));
    NEAR(v.c, box.c);
    NEAR(v.s, box.s);
    NEAR(v.hx, 2.0);
    NEAR(v.hy, 0.5);
}

static void aabb_around_turning_bar_is_widest_on_the_way(void **state) {
    (void)state;
    /* A bar of half length 2 rotates from -45 to +45 degrees: its extent is greatest, 2, in the
     * middle and not at an end of the motion. */
    thud_geometry bar = turned(2.0, 1e-9, -0.78539816339744831);
    thud_volume v;
    OK(thud_volume_around_motion(THUD_SHAPE_AABB, &bar, (thud_motion){0.0, 0.0, 1.5707963267948966},
                                 &v));
    assert_true(fabs(v.hx - 2.0) < 1e-8);
    assert_true(fabs(v.hy - sqrt(2.0)) < 1e-8);
}

static void volumes_around_whole_turn_are_as_wide_as_the_diagonal(void **state) {
    (void)state;
    thud_geometry box = turned(4.0, 3.0, 0.0);
    thud_volume v;
    OK(thud_volume_around_motion(THUD_SHAPE_AABB, &box, (thud_motion){2.0, 0.0, -7.0}, &v));
    NEAR(v.x, 1.0);
    NEAR(v.hx, 6.0);
    NEAR(v.hy, 5.0);
    OK(thud_volume_around_motion(THUD_SHAPE_CIRCLE, &box, (thud_motion){0.0, 0.0, -7.0}, &v));
    NEAR(v.hx, 5.0);
}

static void turn_of_an_aabb_is_not_heeded(void **state) {
    (void)state;
    thud_volume v;
    OK(thud_volume_around_motion(THUD_SHAPE_AABB, &square, (thud_motion){0.0, 2.0, 4.0}, &v));
    NEAR(v.hx, 1.0);
    NEAR(v.hy, 2.0);
}

static void obb_around_diagonal_flight_lies_along_it(void **state) {
    (void)state;
    thud_geometry ball = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 0.5};
    thud_volume v;
    OK(thud_volume_around_motion(THUD_SHAPE_OBB, &ball, (thud_motion){30.0, 40.0, 0.0}, &v));
    NEAR(v.c, 0.6);
    NEAR(v.s, 0.8);
    NEAR(v.hx, 25.5);
    NEAR(v.hy, 0.5);
}

static void obb_around_turning_bar_lies_as_the_bar_halfway(void **state) {
    (void)state;
    thud_geometry bar = turned(2.0, 1e-9, 0.2);
    thud_volume v;
    OK(thud_volume_around_motion(THUD_SHAPE_OBB, &bar, (thud_motion){0.0, 0.0, 0.4}, &v));
    NEAR(v.c, cos(0.4));
    NEAR(v.s, sin(0.4));
    assert_true(fabs(v.hx - 2.0) < 1e-8);
    assert_true(fabs(v.hy - 2.0 * sin(0.2)) < 1e-8);
}

static void circle_around_flight_reaches_both_ends(void **state) {
    (void)state;
    thud_geometry ball = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 0.5};
    thud_volume v;
    OK(thud_volume_around_motion(THUD_SHAPE_CIRCLE, &ball, (thud_motion){30.0, 40.0, 0.0}, &v));
    NEAR(v.x, 15.0);
    NEAR(v.y, 20.0);
    NEAR(v.hx, 25.5);
    assert_true(v.hy == 0.0);
}

static void volumes_around_one_point_have_no_size(void **state) {
    (void)state;
    const thud_pos points[3] = {{5.0, -7.0}, {5.0, -7.0}, {5.0, -7.0}};
    for (int i = 0; i < 6; i++) {
        thud_volume v;
        bool inside;
        OK(thud_volume_around_points((thud_shape_kind)(i % 3), points, i < 3 ? 1 : 3, &v));
        OK(thud_volume_check(&v));
        assert_true(v.hx < 1e-13 && v.hy < 1e-13);
        OK(thud_volume_contains_point(&v, 5.0, -7.0, &inside));
        assert_true(inside);
        OK(thud_volume_contains_point(&v, 5.0, -7.0001, &inside));
        assert_false(inside);
    }
}

static void volumes_around_points_on_a_line_lie_along_it(void **state) {
    (void)state;
    const thud_pos points[4] = {{1.0, 1.0}, {4.0, 5.0}, {7.0, 9.0}, {2.5, 3.0}};
    thud_volume v;
    OK(thud_volume_around_points(THUD_SHAPE_OBB, points, 4, &v));
    NEAR(fabs(v.c * 0.6 + v.s * 0.8), 1.0);
    NEAR(v.hx, 5.0);
    NEAR(v.hy, 0.0);
    OK(thud_volume_around_points(THUD_SHAPE_CIRCLE, points, 4, &v));
    NEAR(v.x, 4.0);
    NEAR(v.y, 5.0);
    NEAR(v.hx, 5.0);
}

static void circle_around_right_triangle_rests_on_its_longest_side(void **state) {
    (void)state;
    const thud_pos points[4] = {{0.0, 0.0}, {6.0, 0.0}, {0.0, 8.0}, {1.0, 1.0}};
    thud_volume v;
    OK(thud_volume_around_points(THUD_SHAPE_CIRCLE, points, 4, &v));
    NEAR(v.x, 3.0);
    NEAR(v.y, 4.0);
    NEAR(v.hx, 5.0);
}

static void circle_around_three_points_just_too_far_for_two_rests_on_all(void **state) {
    (void)state;
    const double height = 1.0002;
    const thud_pos points[3] = {{-1.0, 0.0}, {1.0, 0.0}, {0.0, height}};
    thud_volume v;
    OK(thud_volume_around_points(THUD_SHAPE_CIRCLE, points, 3, &v));
    NEAR(v.hx, (1.0 + height * height) / (2.0 * height));
}

static void obb_around_many_points_on_a_ring_ends_with_the_sides_it_tries(void **state) {
    (void)state;
    enum { MANY = 4000 };
    static thud_pos points[MANY];
    for (int i = 0; i < MANY; i++) {
        points[i] = (thud_pos){cos(i * 6.2831853 / MANY), sin(i * 6.2831853 / MANY)};
    }
    thud_volume v;
    OK(thud_volume_around_points(THUD_SHAPE_OBB, points, MANY, &v));
    assert_true(v.hx <= 1.0 + 1e-9 && v.hy <= 1.0 + 1e-9 && v.hx > 0.999 && v.hy > 0.999);
}

static void aabb_around_ground_covers_only_the_range(void **state) {
    (void)state;
    const thud_pos points[4] = {{0.0, 0.0}, {1.0, 4.0}, {2.0, 0.0}, {3.0, 100.0}};
    thud_terrain ground = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
    thud_volume v;
    OK(thud_volume_around_terrain(THUD_SHAPE_AABB, &ground, 0.5, 1.75, &v));
    NEAR(v.x, 1.125);
    NEAR(v.hx, 0.625);
    NEAR(v.y, 2.5);
    NEAR(v.hy, 1.5);
    OK(thud_volume_around_terrain(THUD_SHAPE_AABB, &ground, -9.0, 0.5, &v));
    NEAR(v.hx, 0.25);
    thud_terrain plane = {.kind = THUD_TERRAIN_FLAT, .slope = 0.75};
    OK(thud_volume_around_terrain(THUD_SHAPE_OBB, &plane, -4.0, 4.0, &v));
    NEAR(v.c, 0.8);
    NEAR(v.hx, 5.0);
    NEAR(v.hy, 0.0);
}

static void merge_into_an_input_is_allowed(void **state) {
    (void)state;
    thud_volume a = {.kind = THUD_SHAPE_CIRCLE, .hx = 1.0};
    thud_volume b = {.kind = THUD_SHAPE_CIRCLE, .x = 4.0, .hx = 2.0};
    OK(thud_volume_merge(THUD_SHAPE_CIRCLE, &a, &b, &a));
    NEAR(a.x, 2.5);
    NEAR(a.hx, 3.5);
    OK(thud_volume_merge(THUD_SHAPE_CIRCLE, &a, &b, &b)); /* one is inside of the other */
    NEAR(b.x, 2.5);
    NEAR(b.hx, 3.5);
}

static void merged_obbs_in_a_row_stay_as_thin_as_they_are(void **state) {
    (void)state;
    thud_volume a = {THUD_SHAPE_OBB, 0.0, 0.0, 0.6, 0.8, 2.0, 0.5}, b = a, v;
    b.x = 3.0;
    b.y = 4.0;
    OK(thud_volume_merge(THUD_SHAPE_OBB, &a, &b, &v));
    NEAR(v.hx, 4.5);
    NEAR(v.hy, 0.5);
    /* Side by side: the merged box keeps their direction, across the line between their centres. */
    b.x = -0.8 + 0.06;
    b.y = 0.6 + 0.08;
    OK(thud_volume_merge(THUD_SHAPE_OBB, &a, &b, &v));
    NEAR(v.hx, 2.05);
    NEAR(v.hy, 1.0);
    a = (thud_volume){.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 0.5}, b = a;
    b.x = 3.0;
    b.y = 4.0;
    OK(thud_volume_merge(THUD_SHAPE_OBB, &a, &b, &v));
    NEAR(v.hx, 3.0);
    NEAR(v.hy, 0.5);
}

static void merged_obb_lies_along_the_larger_of_two(void **state) {
    (void)state;
    thud_volume large = {THUD_SHAPE_OBB, 0.0, 0.0, 0.6, 0.8, 2.0, 0.5};
    thud_volume small = {THUD_SHAPE_OBB, -0.4, 0.7, 1.0, 0.0, 0.01, 0.01}, v;
    for (int i = 0; i < 2; i++) {
        OK(thud_volume_merge(THUD_SHAPE_OBB, i ? &small : &large, i ? &large : &small, &v));
        NEAR(v.c, 0.6);
        NEAR(v.s, 0.8);
        NEAR(v.hx, 2.0);
    }
}

static void merged_equal_places_stay_a_place(void **state) {
    (void)state;
    thud_volume a = {.kind = THUD_SHAPE_OBB, .c = 0.6, .s = 0.8}, v;
    for (int kind = 0; kind < 3; kind++) {
        OK(thud_volume_merge((thud_shape_kind)kind, &a, &a, &v));
        assert_true(v.hx == 0.0 && v.hy == 0.0 && v.x == 0.0);
    }
}

static void touching_volumes_overlap_and_edges_belong_to_them(void **state) {
    (void)state;
    thud_volume a = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 1.0, .hy = 1.0}, b = a;
    b.x = 2.0;
    for (int i = 0; i < 9; i++) {
        bool yes;
        a.kind = (thud_shape_kind)(i / 3);
        b.kind = (thud_shape_kind)(i % 3);
        OK(thud_volumes_overlap(&a, &b, &yes));
        assert_true(yes);
        b.x = 2.0000001;
        OK(thud_volumes_overlap(&a, &b, &yes));
        assert_false(yes);
        b.x = 2.0;
        OK(thud_volume_contains_point(&a, -1.0, 0.0, &yes));
        assert_true(yes);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circle_around_square_reaches_its_corners),
        cmocka_unit_test(obb_around_obb_is_itself),
        cmocka_unit_test(aabb_around_turning_bar_is_widest_on_the_way),
        cmocka_unit_test(volumes_around_whole_turn_are_as_wide_as_the_diagonal),
        cmocka_unit_test(turn_of_an_aabb_is_not_heeded),
        cmocka_unit_test(obb_around_diagonal_flight_lies_along_it),
        cmocka_unit_test(obb_around_turning_bar_lies_as_the_bar_halfway),
        cmocka_unit_test(circle_around_flight_reaches_both_ends),
        cmocka_unit_test(volumes_around_one_point_have_no_size),
        cmocka_unit_test(volumes_around_points_on_a_line_lie_along_it),
        cmocka_unit_test(circle_around_right_triangle_rests_on_its_longest_side),
        cmocka_unit_test(circle_around_three_points_just_too_far_for_two_rests_on_all),
        cmocka_unit_test(obb_around_many_points_on_a_ring_ends_with_the_sides_it_tries),
        cmocka_unit_test(aabb_around_ground_covers_only_the_range),
        cmocka_unit_test(merge_into_an_input_is_allowed),
        cmocka_unit_test(merged_obbs_in_a_row_stay_as_thin_as_they_are),
        cmocka_unit_test(merged_obb_lies_along_the_larger_of_two),
        cmocka_unit_test(merged_equal_places_stay_a_place),
        cmocka_unit_test(touching_volumes_overlap_and_edges_belong_to_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
