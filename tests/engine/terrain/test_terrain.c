/* test_terrain.c: terrains against answers derived by hand (look-up, rays, overlap, impact), and
 * input that is refused. */
#include "thud/thud_geometry.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-12)

/* Up to a peak at 2, down to a valley at 6, up again. */
static const thud_pos hills[] = {{0, 0}, {2, 2}, {6, -2}, {10, 0}};
static const thud_terrain irregular = {.kind = THUD_TERRAIN_IRREGULAR, .points = hills, .count = 4};

static const thud_pos steps[] = {{0, 1}, {0, 1}, {0, 3}, {0, 1}};
static const thud_terrain uniform = {
    .kind = THUD_TERRAIN_UNIFORM, .x0 = -2, .spacing = 2, .points = steps, .count = 4};

static const thud_terrain flat = {.kind = THUD_TERRAIN_FLAT, .slope = 0.75};

static thud_geometry circle(double x, double y, double r) {
    return (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1.0, .hx = r};
}

static thud_geometry box(double x, double y, double hx, double hy) {
    return (thud_geometry){.kind = THUD_SHAPE_AABB, .x = x, .y = y, .c = 1.0, .hx = hx, .hy = hy};
}

/* The time of impact, or 2 where there is none. */
static double impact(const thud_terrain *t, thud_geometry shape, double dx, double dy,
                     double target) {
    bool hit;
    double time;
    thud_motion m = {dx, dy, 0.0};
    assert_int_equal(thud_terrain_time_of_impact(t, &shape, m, target, &hit, &time), THUD_OK);
    assert_true(hit || time == 1.0);
    return hit ? time : 2.0;
}

static bool overlaps(const thud_terrain *t, thud_geometry shape) {
    return thud_terrain_overlap(t, &shape);
}

static void check_refuses_what_no_ground_can_be(void **state) {
    (void)state;
    const thud_pos back[] = {{0, 0}, {2, 0}, {2, 1}}, holes[] = {{0, 0}, {1, NAN}, {2, 0}};
    thud_terrain bad[] = {
        {.kind = (thud_terrain_kind)7, .points = hills, .count = 4},
        {.kind = THUD_TERRAIN_FLAT, .slope = 101},
        {.kind = THUD_TERRAIN_FLAT, .slope = NAN},
        {.kind = THUD_TERRAIN_UNIFORM, .spacing = 0, .points = steps, .count = 4},
        {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1, .x0 = INFINITY, .points = steps, .count = 4},
        {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1e-9, .x0 = 1e8, .points = steps, .count = 4},
        {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1, .points = holes, .count = 3},
        {.kind = THUD_TERRAIN_IRREGULAR, .points = hills, .count = 1},
        {.kind = THUD_TERRAIN_IRREGULAR, .points = back, .count = 3},
        {.kind = THUD_TERRAIN_IRREGULAR, .points = holes, .count = 3},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(thud_terrain_check(&bad[i]), THUD_ERROR_INVALID);
    }
    thud_terrain none = {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1, .count = 3};
    assert_int_equal(thud_terrain_check(NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_check(&none), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_check(&irregular), THUD_OK);
    assert_int_equal(thud_terrain_check(&uniform), THUD_OK);
    assert_int_equal(thud_terrain_check(&flat), THUD_OK);
}

static void calls_with_bad_input_are_refused(void **state) {
    (void)state;
    thud_geometry shape = circle(0, 9, 1), bad_shape = circle(NAN, 9, 1);
    thud_terrain none = {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1, .count = 3};
    thud_terrain_sample sample;
    thud_motion still = {0}, wild = {0, 0, NAN};
    double f, nx, ny, time;
    bool hit;
    int first, last;
    assert_int_equal(thud_terrain_sample_at(NULL, 0, &sample), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_sample_at(&flat, 0, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_sample_at(&none, 0, &sample), THUD_ERROR_NULL);
    assert_int_equal(thud_terrain_sample_at(&flat, NAN, &sample), THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_sample_at(&irregular, -0.001, &sample), THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_sample_at(&irregular, 10.001, &sample), THUD_ERROR_INVALID);
    thud_terrain_segments(NULL, 0, 1, &first, &last);
    assert_true(first > last);
    thud_terrain_segments(&flat, NAN, 1, &first, &last);
    assert_true(first > last);
    assert_false(thud_terrain_cast_ray(&none, (thud_segment){0, 9, 0, -99}, &f, &nx, &ny));
    assert_false(thud_terrain_cast_ray(&flat, (thud_segment){0, 9, 0, -INFINITY}, &f, &nx, &ny));
    assert_false(thud_terrain_overlap(&none, &shape));
    assert_false(thud_terrain_overlap(&flat, &bad_shape));
    assert_false(thud_terrain_overlap(&flat, NULL));
    assert_int_equal(thud_terrain_time_of_impact(&flat, &shape, wild, 0, &hit, &time),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_time_of_impact(&flat, &bad_shape, still, 0, &hit, &time),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_time_of_impact(&flat, &shape, still, -1, &hit, &time),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_terrain_time_of_impact(&flat, &shape, still, 0, NULL, &time),
                     THUD_ERROR_NULL);
}

static void sample_gives_height_normal_and_weights(void **state) {
    (void)state;
    thud_terrain_sample s;
    assert_int_equal(thud_terrain_sample_at(&flat, 4, &s), THUD_OK);
    NEAR(s.height, 3.0);
    NEAR(s.nx, -0.6);
    NEAR(s.ny, 0.8);
    assert_true(s.segment == 0 && s.weight[0] == -3.0 && s.weight[1] == 4.0);
    assert_int_equal(thud_terrain_sample_at(&irregular, 5, &s), THUD_OK);
    NEAR(s.height, -1.0);
    NEAR(s.nx, sqrt(0.5));
    assert_int_equal(s.segment, 1);
    NEAR(s.weight[0], 0.25);
    NEAR(s.weight[1], 0.75);
    assert_int_equal(thud_terrain_sample_at(&uniform, 1, &s), THUD_OK);
    NEAR(s.height, 2.0);
    assert_int_equal(s.segment, 1);
}

static void sample_at_a_vertex_is_of_the_segment_it_begins(void **state) {
    (void)state;
    thud_terrain_sample s;
    assert_int_equal(thud_terrain_sample_at(&irregular, 2, &s), THUD_OK);
    assert_true(s.segment == 1 && s.height == 2.0);
    assert_int_equal(thud_terrain_sample_at(&irregular, 10, &s), THUD_OK);
    assert_true(s.segment == 2 && s.height == 0.0 && s.weight[1] == 1.0);
}

static void segments_of_an_interval_include_touched_ones(void **state) {
    (void)state;
    const double cases[][4] = {{0.5, 1, 0, 0}, {1, 3, 0, 1},   {2, 3, 0, 1},
                               {3, 6, 1, 2},   {-9, 99, 0, 2}, {-5, 0, 0, 0},
                               {10, 11, 2, 2}, {6, 6, 1, 2},   {-INFINITY, INFINITY, 0, 2}};
    int first, last;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        thud_terrain_segments(&irregular, cases[i][0], cases[i][1], &first, &last);
        assert_int_equal(first, (int)cases[i][2]);
        assert_int_equal(last, (int)cases[i][3]);
    }
    thud_terrain_segments(&irregular, -5, -0.1, &first, &last);
    assert_true(first > last);
    thud_terrain_segments(&irregular, 10.1, 12, &first, &last);
    assert_true(first > last);
    thud_terrain_segments(&flat, -1e9, 1e9, &first, &last);
    assert_true(first == 0 && last == 0);
}

static void ray_from_above_hits_the_first_segment_on_its_way(void **state) {
    (void)state;
    double f, nx, ny;
    assert_true(thud_terrain_cast_ray(&irregular, (thud_segment){9, 1, -9, 0}, &f, &nx, &ny));
    NEAR(9 - 9 * f, 3.0);
    NEAR(nx, sqrt(0.5));
    assert_true(thud_terrain_cast_ray(&irregular, (thud_segment){2, 5, 0, -6}, &f, &nx, &ny));
    NEAR(f, 0.5);
    assert_true(thud_terrain_cast_ray(&irregular, (thud_segment){-5, 1, 20, 0}, &f, &nx, &ny));
    NEAR(f, 0.3);
    assert_true(thud_terrain_cast_ray(&flat, (thud_segment){-4, 0, 8, 0}, &f, &nx, &ny));
    NEAR(f, 0.5);
    NEAR(ny, 0.8);
    assert_true(thud_terrain_cast_ray(&flat, (thud_segment){0, 1, 0, -1}, NULL, NULL, NULL));
}

static void ray_that_starts_below_or_comes_from_below_hits_nothing(void **state) {
    (void)state;
    double f, nx, ny;
    assert_false(thud_terrain_cast_ray(&irregular, (thud_segment){2, 1, 0, 5}, &f, &nx, &ny));
    /* It starts inside a hill and comes down on the next one. */
    assert_false(thud_terrain_cast_ray(&irregular, (thud_segment){2, 1, 8, -1.5}, &f, &nx, &ny));
    /* It enters through the side and leaves through the line. */
    assert_false(thud_terrain_cast_ray(&irregular, (thud_segment){-1, -1, 4, 8}, &f, &nx, &ny));
    assert_false(thud_terrain_cast_ray(&flat, (thud_segment){0, -1, 0, -5}, &f, &nx, &ny));
    /* Beyond the ends, and too short. */
    assert_false(thud_terrain_cast_ray(&irregular, (thud_segment){-1, 5, 0, -50}, &f, &nx, &ny));
    assert_false(thud_terrain_cast_ray(&irregular, (thud_segment){2, 5, 0, -2.9}, &f, &nx, &ny));
}

static void ray_at_a_vertex_does_not_slip_through(void **state) {
    (void)state;
    double f, nx, ny;
    for (int i = -50; i <= 50; i++) {
        double x = 6 + i * 0.02;
        assert_true(thud_terrain_cast_ray(&irregular, (thud_segment){x, 3, 1.2 * (6 - x), -6}, &f,
                                          &nx, &ny));
        NEAR(3 - 6 * f, -2.0);
        x = i * 0.2;
        assert_true(thud_terrain_cast_ray(&uniform, (thud_segment){x, 4, 1.2 * (2 - x), -1.2}, &f,
                                          &nx, &ny));
    }
}

static void overlap_sees_line_ground_and_sides(void **state) {
    (void)state;
    assert_true(overlaps(&irregular, circle(5, 0, 1))); /* leans on the slope */
    /* fits between the slopes of the valley */
    assert_false(overlaps(&irregular, circle(6, 0, 1)));
    assert_true(overlaps(&irregular, circle(5, -50, 1)));   /* deep below */
    assert_true(overlaps(&irregular, box(5, -50, 100, 1))); /* deep below and wider */
    assert_true(overlaps(&irregular, box(2, 4, 3, 2)));     /* touches the peak */
    assert_false(overlaps(&irregular, box(2, 4.001, 3, 2)));
    assert_true(overlaps(&irregular, circle(-1, -7, 1))); /* touches the left side */
    assert_false(overlaps(&irregular, circle(-1.001, -7, 1)));
    assert_true(overlaps(&irregular, box(11, -9, 1, 1)));
    assert_false(overlaps(&irregular, box(11.001, -9, 1, 1)));
    assert_true(overlaps(&flat, circle(0, 1.25, 1)));
    assert_false(overlaps(&flat, circle(0, 1.251, 1)));
    assert_true(overlaps(&flat, box(4, -99, 1, 1)));
}

static void impact_on_ground_is_when_the_shape_comes_down(void **state) {
    (void)state;
    NEAR(impact(&flat, circle(0, 6.25, 1), 0, -10, 0.0), 0.5);
    NEAR(impact(&irregular, box(2, 8, 0.5, 1), 0, -10, 0.0), 0.5);
    NEAR(impact(&irregular, box(2, 8, 0.5, 1), 0, -10, 1.0), 0.4);
    assert_true(impact(&irregular, box(2, 8, 0.5, 1), 0, -4.9, 0.0) > 1.0);
    /* Beyond the left end, beside the ground, and into its side. */
    assert_true(impact(&irregular, circle(-2, 8, 1), 0, -100, 0.0) > 1.0);
    NEAR(impact(&irregular, circle(-2, -8, 1), 10, 0, 0.0), 0.1);
    /* A motion away from the ground has no impact; one that starts in the ground has it at once. */
    assert_true(impact(&flat, circle(0, 3, 1), 0, 10, 0.0) > 1.0);
    assert_true(impact(&flat, circle(0, -3, 1), 0, 10, 0.0) == 0.0);
}

static void impact_of_a_bullet_with_a_spike_is_not_missed(void **state) {
    (void)state;
    const thud_pos points[] = {{-500, 0}, {-1e-6, 0}, {0, 3}, {1e-6, 0}, {500, 0}};
    thud_terrain spike = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 5};
    double time = impact(&spike, box(-400, 2, 0.1, 0.1), 800, 0, 0.0);
    assert_true(fabs(time - 399.9 / 800) < 1e-8);
    time = impact(&spike, circle(400, 2, 0.1), -800, 0, 0.0);
    assert_true(fabs(time - 399.9 / 800) < 1e-8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(check_refuses_what_no_ground_can_be),
        cmocka_unit_test(calls_with_bad_input_are_refused),
        cmocka_unit_test(sample_gives_height_normal_and_weights),
        cmocka_unit_test(sample_at_a_vertex_is_of_the_segment_it_begins),
        cmocka_unit_test(segments_of_an_interval_include_touched_ones),
        cmocka_unit_test(ray_from_above_hits_the_first_segment_on_its_way),
        cmocka_unit_test(ray_that_starts_below_or_comes_from_below_hits_nothing),
        cmocka_unit_test(ray_at_a_vertex_does_not_slip_through),
        cmocka_unit_test(overlap_sees_line_ground_and_sides),
        cmocka_unit_test(impact_on_ground_is_when_the_shape_comes_down),
        cmocka_unit_test(impact_of_a_bullet_with_a_spike_is_not_missed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
