/* test_volumes_refused.c: invalid volumes and calls with invalid arguments are refused and change
 * nothing. */
#include "volumes_support.h"

static const thud_pos corner = {1.0, 1.0};

/* Calls every function with this volume as an input; all must refuse it and change nothing. */
static void refused_by_all(const thud_volume *bad) {
    thud_volume out = square;
    bool yes = true;
    INVALID(thud_volume_check(bad));
    INVALID(thud_volumes_overlap(bad, &square, &yes));
    INVALID(thud_volumes_overlap(&square, bad, &yes));
    INVALID(thud_volume_contains(bad, &square, &yes));
    INVALID(thud_volume_contains(&square, bad, &yes));
    INVALID(thud_volume_contains_point(bad, 0.0, 0.0, &yes));
    for (int kind = 0; kind < 3; kind++) {
        thud_shape_kind k = (thud_shape_kind)kind;
        INVALID(thud_volume_around_shape(k, bad, &out));
        INVALID(thud_volume_around_motion(k, bad, (thud_motion){0}, &out));
        INVALID(thud_volume_merge(k, bad, &square, &out));
        INVALID(thud_volume_merge(k, &square, bad, &out));
    }
    assert_true(yes);
    assert_memory_equal(&out, &square, sizeof out);
}

static void volumes_that_cannot_be_are_refused_and_change_nothing(void **state) {
    (void)state;
    thud_volume bad[8];
    for (int i = 0; i < 8; i++) {
        bad[i] = turned(1.0, 1.0, 0.5);
    }
    bad[0].x = NAN;
    bad[1].y = -INFINITY;
    bad[2].hx = -1.0;
    bad[3].hy = NAN;
    bad[4].hx = 1e17;
    bad[5].c = 1.0; /* with that sine not a unit vector */
    bad[6].kind = THUD_SHAPE_TERRAIN;
    bad[7].kind = THUD_SHAPE_AABB; /* rotated, as an AABB is not */
    for (int i = 0; i < 8; i++) {
        refused_by_all(&bad[i]);
    }
}

static void values_out_of_range_are_refused_and_change_nothing(void **state) {
    (void)state;
    thud_volume out = square;
    thud_geometry flat = square;
    bool yes = true;
    flat.hy = 0.0; /* valid as a volume, but not as a shape */
    OK(thud_volume_check(&flat));
    thud_terrain ground = {.kind = THUD_TERRAIN_FLAT}, short_line = {.kind = THUD_TERRAIN_UNIFORM};
    const thud_pos points[2] = {{0.0, 0.0}, {1.0, NAN}}, level[2] = {{0.0, 1.0}, {9.0, 1.0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = level, .count = 2};
    thud_terrain broken = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 2};
    short_line.spacing = 1.0;
    short_line.points = points;
    short_line.count = 1;
    const double off[] = {NAN, INFINITY, -1e17};
    for (int kind = 0; kind < 4; kind++) {
        thud_shape_kind k = (thud_shape_kind)kind;
        INVALID(thud_volume_around_shape(k, &flat, &out));
        INVALID(thud_volume_around_motion(k, &square, (thud_motion){1e300, 0.0, 0.0}, &out));
        INVALID(thud_volume_around_motion(k, &square, (thud_motion){0.0, 0.0, 1e7}, &out));
        INVALID(thud_volume_around_points(k, &corner, 0, &out));
        INVALID(thud_volume_around_points(k, &corner, -1, &out));
        INVALID(thud_volume_around_points(k, points, 2, &out));
        INVALID(thud_volume_around_terrain(k, &ground, 1.0, 0.0, &out));
        INVALID(thud_volume_around_terrain(k, &short_line, 0.0, 1.0, &out));
        INVALID(thud_volume_around_terrain(k, &broken, 0.0, 1.0, &out));
        INVALID(thud_volume_around_terrain(k, &line, 10.0, 11.0, &out));
        INVALID(thud_volume_around_terrain(k, &line, -INFINITY, 1.0, &out));
        INVALID(thud_volume_around_terrain(k, &line, 1.0, INFINITY, &out));
        for (int i = 0; i < 3; i++) {
            const thud_pos point = {0.0, off[i]};
            INVALID(thud_volume_around_motion(k, &square, (thud_motion){off[i], 0, 0}, &out));
            INVALID(thud_volume_around_points(k, &point, 1, &out));
            INVALID(thud_volume_around_terrain(k, &ground, off[i], off[i], &out));
            INVALID(thud_volume_contains_point(&square, off[i], 0.0, &yes));
            INVALID(thud_volume_contains_point(&square, 0.0, off[i], &yes));
        }
    }
    INVALID(thud_volume_around_shape(THUD_SHAPE_TERRAIN, &square, &out));
    INVALID(thud_volume_around_points(THUD_SHAPE_TERRAIN, &corner, 1, &out));
    INVALID(thud_volume_around_terrain((thud_shape_kind)-1, &ground, 0.0, 1.0, &out));
    INVALID(thud_volume_merge(THUD_SHAPE_TERRAIN, &square, &square, &out));
    assert_true(yes);
    assert_memory_equal(&out, &square, sizeof out);
}

static void null_pointers_are_refused_and_change_nothing(void **state) {
    (void)state;
    thud_volume out = square;
    thud_terrain ground = {.kind = THUD_TERRAIN_FLAT};
    thud_terrain line = {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1.0, .count = 2};
    bool yes = true;
    MISSING(thud_volume_check(NULL));
    MISSING(thud_volume_around_shape(THUD_SHAPE_AABB, NULL, &out));
    MISSING(thud_volume_around_shape(THUD_SHAPE_AABB, &square, NULL));
    MISSING(thud_volume_around_motion(THUD_SHAPE_AABB, NULL, (thud_motion){0}, &out));
    MISSING(thud_volume_around_motion(THUD_SHAPE_AABB, &square, (thud_motion){0}, NULL));
    MISSING(thud_volume_around_points(THUD_SHAPE_AABB, NULL, 1, &out));
    MISSING(thud_volume_around_points(THUD_SHAPE_AABB, &corner, 1, NULL));
    MISSING(thud_volume_around_terrain(THUD_SHAPE_AABB, NULL, 0.0, 1.0, &out));
    MISSING(thud_volume_around_terrain(THUD_SHAPE_AABB, &line, 0.0, 1.0, &out));
    MISSING(thud_volume_around_terrain(THUD_SHAPE_AABB, &ground, 0.0, 1.0, NULL));
    MISSING(thud_volume_merge(THUD_SHAPE_AABB, NULL, &square, &out));
    MISSING(thud_volume_merge(THUD_SHAPE_AABB, &square, NULL, &out));
    MISSING(thud_volume_merge(THUD_SHAPE_AABB, &square, &square, NULL));
    MISSING(thud_volumes_overlap(NULL, &square, &yes));
    MISSING(thud_volumes_overlap(&square, NULL, &yes));
    MISSING(thud_volumes_overlap(&square, &square, NULL));
    MISSING(thud_volume_contains(NULL, &square, &yes));
    MISSING(thud_volume_contains(&square, NULL, &yes));
    MISSING(thud_volume_contains(&square, &square, NULL));
    MISSING(thud_volume_contains_point(NULL, 0.0, 0.0, &yes));
    MISSING(thud_volume_contains_point(&square, 0.0, 0.0, NULL));
    assert_true(yes);
    assert_memory_equal(&out, &square, sizeof out);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_that_cannot_be_are_refused_and_change_nothing),
        cmocka_unit_test(values_out_of_range_are_refused_and_change_nothing),
        cmocka_unit_test(null_pointers_are_refused_and_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
