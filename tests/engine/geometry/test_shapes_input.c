/* test_shapes_input.c: every function of thud_geometry.h refuses invalid input with its result code
 * or with false, and leaves its outputs unchanged. */
#include "thud/thud_geometry.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static const thud_geometry ball = {
    .kind = THUD_SHAPE_CIRCLE, .x = 1.0, .y = 5.0, .c = 1.0, .hx = 0.5};
static const thud_motion still = {0.0, 0.0, 0.0};
static const thud_pos hill[] = {{0.0, 0.0}, {1.0, 2.0}, {4.0, 0.0}};
static const thud_terrain ground = {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 3};

static const thud_geometry bad_shapes[] = {
    {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = 0.0},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = -1.0},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = NAN},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1.0, .hx = INFINITY},
    {.kind = THUD_SHAPE_CIRCLE, .x = NAN, .c = 1.0, .hx = 1.0},
    {.kind = THUD_SHAPE_CIRCLE, .y = -INFINITY, .c = 1.0, .hx = 1.0},
    {.kind = THUD_SHAPE_AABB, .c = 1.0, .hx = 1.0, .hy = 0.0},
    {.kind = THUD_SHAPE_AABB, .c = 1.0, .hx = 1.0, .hy = -1.0},
    {.kind = THUD_SHAPE_AABB, .c = 1.0, .hx = NAN, .hy = 1.0},
    {.kind = THUD_SHAPE_AABB, .c = 1.0, .hx = 1.0, .hy = INFINITY},
    {.kind = THUD_SHAPE_AABB,
     .c = 0.6,
     .s = 0.8,
     .hx = 1.0,
     .hy = 1.0}, /* rotated, as an AABB is not */
    {.kind = THUD_SHAPE_AABB, .x = INFINITY, .c = 1.0, .hx = 1.0, .hy = 1.0},
    {.kind = THUD_SHAPE_OBB, .c = 1.0, .hx = 0.0, .hy = 1.0},
    {.kind = THUD_SHAPE_OBB, .c = 1.0, .hx = 1.0, .hy = NAN},
    {.kind = THUD_SHAPE_OBB, .c = 0.0, .s = 0.0, .hx = 1.0, .hy = 1.0}, /* no direction */
    {.kind = THUD_SHAPE_OBB, .c = NAN, .s = 0.0, .hx = 1.0, .hy = 1.0},
    {.kind = THUD_SHAPE_OBB, .c = 1.0, .s = INFINITY, .hx = 1.0, .hy = 1.0},
    {.kind = THUD_SHAPE_OBB, .y = NAN, .c = 1.0, .hx = 1.0, .hy = 1.0},
    {.kind = THUD_SHAPE_TERRAIN, .c = 1.0, .hx = 1.0, .hy = 1.0},
    {.kind = (thud_shape_kind)-1, .c = 1.0, .hx = 1.0, .hy = 1.0},
    {.kind = (thud_shape_kind)99, .c = 1.0, .hx = 1.0, .hy = 1.0},
};

static const thud_motion bad_motions[] = {
    {NAN, 0.0, 0.0}, {0.0, INFINITY, 0.0}, {0.0, 0.0, NAN}, {0.0, 0.0, -INFINITY}, {0.0, 0.0, 1e7},
};

static const double bad_lengths[] = {-1.0, -1e-300, NAN, INFINITY, -INFINITY};
static const double bad_tolerances[] = {0.0, -1.0, 1e-16, 1.001, NAN, INFINITY};

/* Invalid for every function; what only thud_terrain_check finds is below. */
static const thud_terrain bad_terrains[] = {
    {.kind = (thud_terrain_kind)-1, .points = hill, .count = 3},
    {.kind = (thud_terrain_kind)3, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_FLAT, .slope = NAN},
    {.kind = THUD_TERRAIN_FLAT, .slope = INFINITY},
    {.kind = THUD_TERRAIN_FLAT, .slope = 101.0},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 0.0, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = -1.0, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = NAN, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = INFINITY, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1.0, .x0 = NAN, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1.0, .points = hill, .count = 1},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1.0, .points = hill, .count = 0},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1.0, .points = hill, .count = -3},
    {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 1},
    {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 0},
    {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = -3},
};

static const thud_terrain without_points[] = {
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1.0, .count = 3},
    {.kind = THUD_TERRAIN_IRREGULAR, .count = 3},
};

/* All outputs of the functions, filled with a byte pattern to detect writes. */
typedef struct outputs {
    thud_closest closest;
    thud_contacts contacts;
    thud_approach approach;
    thud_terrain_sample sample;
    double time, nx, ny;
    bool hit;
} outputs;

static outputs out;

static void fill(void) {
    memset(&out, 0x5a, sizeof out);
}

static void assert_as_it_was(void) {
    unsigned char bytes[sizeof out];
    memset(bytes, 0x5a, sizeof bytes);
    assert_memory_equal(&out, bytes, sizeof bytes);
}

#define REFUSES(code, call)           \
    do {                              \
        fill();                       \
        assert_int_equal(call, code); \
        assert_as_it_was();           \
    } while (0)

#define NO false

static void functions_of_shapes_refuse_null_pointers(void **state) {
    (void)state;
    const thud_geometry *a = &ball;
    thud_motion m = still;
    REFUSES(THUD_ERROR_NULL, thud_geometry_check(NULL));
    REFUSES(NO, thud_geometry_overlap(NULL, a));
    REFUSES(NO, thud_geometry_overlap(a, NULL));
    REFUSES(THUD_ERROR_NULL, thud_geometry_closest(NULL, a, &out.closest));
    REFUSES(THUD_ERROR_NULL, thud_geometry_closest(a, NULL, &out.closest));
    REFUSES(THUD_ERROR_NULL, thud_geometry_closest(a, a, NULL));
    REFUSES(THUD_ERROR_NULL, thud_geometry_contacts(NULL, a, 0.0, &out.contacts));
    REFUSES(THUD_ERROR_NULL, thud_geometry_contacts(a, NULL, 0.0, &out.contacts));
    REFUSES(THUD_ERROR_NULL, thud_geometry_contacts(a, a, 0.0, NULL));
    REFUSES(NO, thud_geometry_cast_ray(NULL, (thud_segment){-9.0, 5.0, 99.0, 0.0}, &out.time,
                                       &out.nx, &out.ny));
    REFUSES(THUD_ERROR_NULL, thud_geometry_time_of_impact(NULL, m, a, m, 0.0, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_geometry_time_of_impact(a, m, NULL, m, 0.0, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_geometry_time_of_impact(a, m, a, m, 0.0, NULL, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_geometry_time_of_impact(a, m, a, m, 0.0, &out.hit, NULL));
    REFUSES(THUD_ERROR_NULL, thud_geometry_approach(NULL, m, a, m, &out.approach));
    REFUSES(THUD_ERROR_NULL, thud_geometry_approach(a, m, NULL, m, &out.approach));
    REFUSES(THUD_ERROR_NULL, thud_geometry_approach(a, m, a, m, NULL));
    REFUSES(THUD_ERROR_NULL,
            thud_geometry_time_of_collision(NULL, m, a, m, 0.1, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL,
            thud_geometry_time_of_collision(a, m, NULL, m, 0.1, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_geometry_time_of_collision(a, m, a, m, 0.1, NULL, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_geometry_time_of_collision(a, m, a, m, 0.1, &out.hit, NULL));
    REFUSES(NO, thud_geometry_is_bisectable(NULL, m, a, m));
    REFUSES(NO, thud_geometry_is_bisectable(a, m, NULL, m));
}

static void functions_of_terrain_refuse_null_pointers(void **state) {
    (void)state;
    const thud_terrain *t = &ground;
    const thud_geometry *a = &ball;
    thud_motion m = still;
    REFUSES(THUD_ERROR_NULL, thud_terrain_check(NULL));
    REFUSES(THUD_ERROR_NULL, thud_terrain_sample_at(NULL, 1.0, &out.sample));
    REFUSES(THUD_ERROR_NULL, thud_terrain_sample_at(t, 1.0, NULL));
    REFUSES(NO, thud_terrain_cast_ray(NULL, (thud_segment){1.0, 9.0, 0.0, -99.0}, &out.time,
                                      &out.nx, &out.ny));
    REFUSES(NO, thud_terrain_overlap(NULL, a));
    REFUSES(NO, thud_terrain_overlap(t, NULL));
    REFUSES(THUD_ERROR_NULL, thud_terrain_closest(NULL, a, &out.closest));
    REFUSES(THUD_ERROR_NULL, thud_terrain_closest(t, NULL, &out.closest));
    REFUSES(THUD_ERROR_NULL, thud_terrain_closest(t, a, NULL));
    REFUSES(THUD_ERROR_NULL, thud_terrain_contacts(NULL, a, 0.0, &out.contacts));
    REFUSES(THUD_ERROR_NULL, thud_terrain_contacts(t, NULL, 0.0, &out.contacts));
    REFUSES(THUD_ERROR_NULL, thud_terrain_contacts(t, a, 0.0, NULL));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_impact(NULL, a, m, 0.0, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_impact(t, NULL, m, 0.0, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_impact(t, a, m, 0.0, NULL, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_impact(t, a, m, 0.0, &out.hit, NULL));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_collision(NULL, a, m, 0.1, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_collision(t, NULL, m, 0.1, &out.hit, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_collision(t, a, m, 0.1, NULL, &out.time));
    REFUSES(THUD_ERROR_NULL, thud_terrain_time_of_collision(t, a, m, 0.1, &out.hit, NULL));
}

static void functions_of_shapes_refuse_impossible_shapes(void **state) {
    (void)state;
    const thud_geometry *a = &ball;
    thud_motion m = still;
    for (int i = 0; i < COUNT(bad_shapes); i++) {
        const thud_geometry *bad = &bad_shapes[i];
        const thud_geometry *pair[2][2] = {{bad, a}, {a, bad}};
        REFUSES(THUD_ERROR_INVALID, thud_geometry_check(bad));
        REFUSES(NO, thud_geometry_cast_ray(bad, (thud_segment){-9.0, 5.0, 99.0, 0.0}, &out.time,
                                           &out.nx, &out.ny));
        for (int k = 0; k < 2; k++) {
            const thud_geometry *one = pair[k][0], *two = pair[k][1];
            REFUSES(NO, thud_geometry_overlap(one, two));
            REFUSES(THUD_ERROR_INVALID, thud_geometry_closest(one, two, &out.closest));
            REFUSES(THUD_ERROR_INVALID, thud_geometry_contacts(one, two, 0.0, &out.contacts));
            REFUSES(THUD_ERROR_INVALID,
                    thud_geometry_time_of_impact(one, m, two, m, 0.0, &out.hit, &out.time));
            REFUSES(THUD_ERROR_INVALID, thud_geometry_approach(one, m, two, m, &out.approach));
            REFUSES(THUD_ERROR_INVALID,
                    thud_geometry_time_of_collision(one, m, two, m, 0.1, &out.hit, &out.time));
            REFUSES(NO, thud_geometry_is_bisectable(one, m, two, m));
        }
    }
}

static void functions_of_terrain_refuse_impossible_shapes(void **state) {
    (void)state;
    for (int i = 0; i < COUNT(bad_shapes); i++) {
        const thud_geometry *bad = &bad_shapes[i];
        REFUSES(NO, thud_terrain_overlap(&ground, bad));
        REFUSES(THUD_ERROR_INVALID, thud_terrain_closest(&ground, bad, &out.closest));
        REFUSES(THUD_ERROR_INVALID, thud_terrain_contacts(&ground, bad, 0.0, &out.contacts));
        REFUSES(THUD_ERROR_INVALID,
                thud_terrain_time_of_impact(&ground, bad, still, 0.0, &out.hit, &out.time));
        REFUSES(THUD_ERROR_INVALID,
                thud_terrain_time_of_collision(&ground, bad, still, 0.1, &out.hit, &out.time));
    }
}

/* Asserts that every function of terrains refuses this one. */
static void refuse_ground(const thud_terrain *t, thud_result code) {
    int first = 5, last = 9;
    REFUSES(code, thud_terrain_check(t));
    REFUSES(code, thud_terrain_sample_at(t, 1.0, &out.sample));
    REFUSES(NO, thud_terrain_cast_ray(t, (thud_segment){1.0, 9.0, 0.0, -99.0}, &out.time, &out.nx,
                                      &out.ny));
    REFUSES(NO, thud_terrain_overlap(t, &ball));
    REFUSES(code, thud_terrain_closest(t, &ball, &out.closest));
    REFUSES(code, thud_terrain_contacts(t, &ball, 0.0, &out.contacts));
    REFUSES(code, thud_terrain_time_of_impact(t, &ball, still, 0.0, &out.hit, &out.time));
    REFUSES(code, thud_terrain_time_of_collision(t, &ball, still, 0.1, &out.hit, &out.time));
    /* This function has no result code; it returns an empty range. */
    thud_terrain_segments(t, 0.0, 9.0, &first, &last);
    assert_true(first > last);
}

static void functions_of_terrain_refuse_empty_and_unplaced_lines(void **state) {
    (void)state;
    for (int i = 0; i < COUNT(bad_terrains); i++) {
        refuse_ground(&bad_terrains[i], THUD_ERROR_INVALID);
    }
    for (int i = 0; i < COUNT(without_points); i++) {
        refuse_ground(&without_points[i], THUD_ERROR_NULL);
    }
}

static void terrain_check_refuses_lines_that_go_back_or_are_no_number(void **state) {
    (void)state;
    const thud_pos lines[][3] = {
        {{0, 0}, {2, 0}, {1, 0}},         {{0, 0}, {1, 0}, {1, 1}},
        {{0, 0}, {NAN, 0}, {2, 0}},       {{0, 0}, {1, NAN}, {2, 0}},
        {{-INFINITY, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 0}, {2, INFINITY}},
    };
    for (int i = 0; i < COUNT(lines); i++) {
        thud_terrain t = {.kind = THUD_TERRAIN_IRREGULAR, .points = lines[i], .count = 3};
        assert_int_equal(thud_terrain_check(&t), THUD_ERROR_INVALID);
        t.kind = THUD_TERRAIN_UNIFORM;
        t.spacing = 1.0;
        bool height = isfinite(lines[i][0].y + lines[i][1].y + lines[i][2].y);
        assert_int_equal(thud_terrain_check(&t), height ? THUD_OK : THUD_ERROR_INVALID);
        /* The other functions do not check every vertex, but they terminate. */
        for (int k = 0; k < 2; k++, t.kind = THUD_TERRAIN_IRREGULAR) {
            for (int y = -2; y <= 2; y++) {
                thud_geometry low = ball;
                low.y = y;
                (void)thud_terrain_overlap(&t, &low);
                (void)thud_terrain_closest(&t, &low, &out.closest);
                (void)thud_terrain_contacts(&t, &low, 1.0, &out.contacts);
                (void)thud_terrain_time_of_impact(&t, &low, still, 0.0, &out.hit, &out.time);
            }
        }
    }
}

static void functions_refuse_motions_out_of_range(void **state) {
    (void)state;
    const thud_geometry *a = &ball;
    for (int i = 0; i < COUNT(bad_motions); i++) {
        thud_motion bad = bad_motions[i], pair[2][2] = {{bad, still}, {still, bad}};
        for (int k = 0; k < 2; k++) {
            thud_motion m = pair[k][0], n = pair[k][1];
            REFUSES(THUD_ERROR_INVALID,
                    thud_geometry_time_of_impact(a, m, a, n, 0.0, &out.hit, &out.time));
            REFUSES(THUD_ERROR_INVALID, thud_geometry_approach(a, m, a, n, &out.approach));
            REFUSES(THUD_ERROR_INVALID,
                    thud_geometry_time_of_collision(a, m, a, n, 0.1, &out.hit, &out.time));
            REFUSES(NO, thud_geometry_is_bisectable(a, m, a, n));
        }
        REFUSES(THUD_ERROR_INVALID,
                thud_terrain_time_of_impact(&ground, a, bad, 0.0, &out.hit, &out.time));
        REFUSES(THUD_ERROR_INVALID,
                thud_terrain_time_of_collision(&ground, a, bad, 0.1, &out.hit, &out.time));
    }
}

static void functions_refuse_margins_targets_and_tolerances_out_of_range(void **state) {
    (void)state;
    const thud_geometry *a = &ball;
    thud_motion m = still;
    for (int i = 0; i < COUNT(bad_lengths); i++) {
        double bad = bad_lengths[i];
        REFUSES(THUD_ERROR_INVALID, thud_geometry_contacts(a, a, bad, &out.contacts));
        REFUSES(THUD_ERROR_INVALID, thud_terrain_contacts(&ground, a, bad, &out.contacts));
        REFUSES(THUD_ERROR_INVALID,
                thud_geometry_time_of_impact(a, m, a, m, bad, &out.hit, &out.time));
        REFUSES(THUD_ERROR_INVALID,
                thud_terrain_time_of_impact(&ground, a, m, bad, &out.hit, &out.time));
    }
    for (int i = 0; i < COUNT(bad_tolerances); i++) {
        double bad = bad_tolerances[i];
        REFUSES(THUD_ERROR_INVALID,
                thud_geometry_time_of_collision(a, m, a, m, bad, &out.hit, &out.time));
        REFUSES(THUD_ERROR_INVALID,
                thud_terrain_time_of_collision(&ground, a, m, bad, &out.hit, &out.time));
    }
}

static void rays_and_lookups_refuse_what_is_no_number(void **state) {
    (void)state;
    const double bad[] = {NAN, INFINITY, -INFINITY};
    double *f = &out.time, *nx = &out.nx, *ny = &out.ny;
    for (int i = 0; i < COUNT(bad); i++) {
        for (int k = 0; k < 4; k++) {
            double ray[4] = {-9.0, 5.0, 99.0, 0.0};
            ray[k] = bad[i];
            REFUSES(NO,
                    thud_geometry_cast_ray(&ball, (thud_segment){ray[0], ray[1], ray[2], ray[3]}, f,
                                           nx, ny));
            REFUSES(NO,
                    thud_terrain_cast_ray(&ground, (thud_segment){ray[0], ray[1], ray[2], ray[3]},
                                          f, nx, ny));
        }
        REFUSES(THUD_ERROR_INVALID, thud_terrain_sample_at(&ground, bad[i], &out.sample));
    }
    REFUSES(THUD_ERROR_INVALID, thud_terrain_sample_at(&ground, -0.001, &out.sample));
    REFUSES(THUD_ERROR_INVALID, thud_terrain_sample_at(&ground, 4.001, &out.sample));
    int first = 5, last = 9;
    thud_terrain_segments(&ground, NAN, 1.0, &first, &last);
    assert_true(first > last);
    thud_terrain_segments(&ground, 2.0, 1.0, &first, &last);
    assert_true(first > last);
    first = 5;
    thud_terrain_segments(&ground, 0.0, 1.0, &first, NULL);
    thud_terrain_segments(&ground, 0.0, 1.0, NULL, &first);
    assert_int_equal(first, 5);
}

static void approach_refuses_boxes(void **state) {
    (void)state;
    const thud_geometry box = {.kind = THUD_SHAPE_AABB, .c = 1.0, .hx = 1.0, .hy = 1.0};
    REFUSES(THUD_ERROR_INVALID, thud_geometry_approach(&ball, still, &box, still, &out.approach));
    REFUSES(THUD_ERROR_INVALID, thud_geometry_approach(&box, still, &ball, still, &out.approach));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(functions_of_shapes_refuse_null_pointers),
        cmocka_unit_test(functions_of_terrain_refuse_null_pointers),
        cmocka_unit_test(functions_of_shapes_refuse_impossible_shapes),
        cmocka_unit_test(functions_of_terrain_refuse_impossible_shapes),
        cmocka_unit_test(functions_of_terrain_refuse_empty_and_unplaced_lines),
        cmocka_unit_test(terrain_check_refuses_lines_that_go_back_or_are_no_number),
        cmocka_unit_test(functions_refuse_motions_out_of_range),
        cmocka_unit_test(functions_refuse_margins_targets_and_tolerances_out_of_range),
        cmocka_unit_test(rays_and_lookups_refuse_what_is_no_number),
        cmocka_unit_test(approach_refuses_boxes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
