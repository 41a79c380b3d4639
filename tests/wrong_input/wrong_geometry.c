/* wrong_geometry.c: functions of geometry without a world with invalid arguments: refused by a
 * result code or false, with unchanged outputs. */
#include "wrong_input.h"

static const thud_geometry ball = {.kind = THUD_SHAPE_CIRCLE, .x = 1, .y = 5, .c = 1, .hx = 0.5};
static const thud_geometry box = {
    .kind = THUD_SHAPE_OBB, .x = 2, .c = 0.6, .s = 0.8, .hx = 1, .hy = 0.5};
static const thud_motion still = {0, 0, 0};
static const thud_pos hill[] = {{0, 0}, {1, 2}, {4, 0}};
static const thud_terrain ground = {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 3};

static const thud_geometry bad_shapes[] = {
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 0},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = -1},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = NAN},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 1e300},
    {.kind = THUD_SHAPE_CIRCLE, .x = INFINITY, .c = 1, .hx = 1},
    {.kind = THUD_SHAPE_CIRCLE, .y = -1e300, .c = 1, .hx = 1},
    {.kind = THUD_SHAPE_AABB, .c = 1, .hx = 1, .hy = 0},
    {.kind = THUD_SHAPE_AABB, .c = 1, .hx = INFINITY, .hy = 1},
    {.kind = THUD_SHAPE_AABB, .c = 0.6, .s = 0.8, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_OBB, .c = 0, .s = 0, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_OBB, .c = 2, .s = 0, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_OBB, .c = NAN, .s = 0, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_OBB, .y = NAN, .c = 1, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_TERRAIN, .c = 1, .hx = 1, .hy = 1},
    {.kind = (thud_shape_kind)-1, .c = 1, .hx = 1, .hy = 1},
};
static const thud_motion bad_motions[] = {{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, NAN}, {0, 0, 1e7}};
static const double bad_margins[] = {-1, -1e-300, NAN, INFINITY};
static const double bad_tolerances[] = {0, -1, 1e-16, 1.001, NAN, INFINITY};
static const thud_terrain bad_grounds[] = {
    {.kind = (thud_terrain_kind)-1, .points = hill, .count = 3},
    {.kind = (thud_terrain_kind)3, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_FLAT, .slope = NAN},
    {.kind = THUD_TERRAIN_FLAT, .slope = 101},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 0, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = NAN, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_UNIFORM, .spacing = 1, .x0 = INFINITY, .points = hill, .count = 3},
    {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 1},
    {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = -3},
};

void wrong_geometry(void **state) {
    wrong_pair *p = *state;
    thud_closest *closest = &wrong_out.closest;
    thud_contacts *contacts = &wrong_out.contacts;
    thud_approach *approach = &wrong_out.approach;
    double *time = &wrong_out.number, *nx = &wrong_out.nx, *ny = &wrong_out.ny;
    for (int i = 0; i < COUNT(bad_shapes); i++) {
        const thud_geometry *bad = &bad_shapes[i];
        assert_false(thud_geometry_overlap(&ball, bad) || thud_geometry_overlap(bad, &ball));
        assert_false(thud_geometry_cast_ray(bad, (thud_segment){0, 0, 1, 0}, time, nx, ny));
        assert_false(thud_geometry_is_bisectable(&ball, still, bad, still));
        REFUSED_UNTOLD(INVALID, thud_geometry_check(bad));
        REFUSED_UNTOLD(INVALID, thud_geometry_closest(&ball, bad, closest));
        REFUSED_UNTOLD(INVALID, thud_geometry_closest(bad, &box, closest));
        REFUSED_UNTOLD(INVALID, thud_geometry_contacts(&box, bad, 0.1, contacts));
        REFUSED_UNTOLD(INVALID,
                       thud_geometry_time_of_impact(&ball, still, bad, still, 0, OUT_FLAG, time));
        REFUSED_UNTOLD(INVALID, thud_geometry_time_of_collision(bad, still, &box, still, 1e-6,
                                                                OUT_FLAG, time));
        REFUSED_UNTOLD(INVALID, thud_geometry_approach(&ball, still, bad, still, approach));
    }
    for (int i = 0; i < COUNT(bad_motions); i++) {
        thud_motion m = bad_motions[i];
        assert_false(thud_geometry_is_bisectable(&ball, still, &box, m));
        REFUSED_UNTOLD(INVALID,
                       thud_geometry_time_of_impact(&box, m, &ball, still, 0, OUT_FLAG, time));
        REFUSED_UNTOLD(INVALID, thud_geometry_time_of_collision(&ball, still, &box, m, 1e-6,
                                                                OUT_FLAG, time));
        REFUSED_UNTOLD(INVALID, thud_terrain_time_of_impact(&ground, &box, m, 0, OUT_FLAG, time));
        REFUSED_UNTOLD(INVALID,
                       thud_terrain_time_of_collision(&ground, &box, m, 1e-6, OUT_FLAG, time));
    }
    EACH(x, bad_margins) {
        REFUSED_UNTOLD(INVALID, thud_geometry_contacts(&ball, &box, x, contacts));
        REFUSED_UNTOLD(INVALID,
                       thud_geometry_time_of_impact(&ball, still, &box, still, x, OUT_FLAG, time));
    }
    EACH(x, bad_tolerances) {
        REFUSED_UNTOLD(INVALID, thud_geometry_time_of_collision(&ball, still, &box, still, x,
                                                                OUT_FLAG, time));
    }
    EACH(x, not_finite) {
        assert_false(thud_geometry_cast_ray(&ball, (thud_segment){x, 5, 1, 0}, time, nx, ny));
        assert_false(thud_geometry_cast_ray(&ball, (thud_segment){0, 5, x, 0}, time, nx, ny));
    }
    REFUSED_UNTOLD(INVALID, thud_geometry_approach(&ball, still, &box, still, approach));
    REFUSED_UNTOLD(NULL, thud_geometry_check(NULL));
    REFUSED_UNTOLD(NULL, thud_geometry_closest(NULL, &box, closest));
    REFUSED_UNTOLD(NULL, thud_geometry_closest(&ball, NULL, closest));
    REFUSED_UNTOLD(NULL, thud_geometry_closest(&ball, &box, NULL));
    REFUSED_UNTOLD(NULL, thud_geometry_contacts(&ball, &box, 1, NULL));
    REFUSED_UNTOLD(NULL, thud_geometry_time_of_impact(NULL, still, &box, still, 0, OUT_FLAG, time));
    REFUSED_UNTOLD(NULL, thud_geometry_time_of_collision(&ball, still, NULL, still, 1e-6, OUT_FLAG,
                                                         time));
    REFUSED_UNTOLD(NULL, thud_geometry_approach(&ball, still, &ball, still, NULL));
    assert_false(thud_geometry_overlap(NULL, &ball) || thud_geometry_overlap(&ball, NULL));
    assert_false(thud_geometry_cast_ray(NULL, (thud_segment){0, 0, 1, 0}, time, nx, ny));
    assert_false(thud_geometry_is_bisectable(NULL, still, &ball, still));
}

void wrong_ground_geometry(void **state) {
    wrong_pair *p = *state;
    thud_terrain_sample *sample = &wrong_out.sample;
    double *time = &wrong_out.number, *nx = &wrong_out.nx, *ny = &wrong_out.ny;
    for (int i = 0; i < COUNT(bad_grounds); i++) {
        const thud_terrain *bad = &bad_grounds[i];
        int first = 0, last = 0;
        thud_terrain_segments(bad, -9, 9, &first, &last);
        assert_true(first > last);
        assert_false(thud_terrain_overlap(bad, &ball));
        assert_false(thud_terrain_cast_ray(bad, (thud_segment){1, 9, 0, -9}, time, nx, ny));
        REFUSED_UNTOLD(INVALID, thud_terrain_check(bad));
        REFUSED_UNTOLD(INVALID, thud_terrain_sample_at(bad, 1, sample));
        REFUSED_UNTOLD(INVALID, thud_terrain_place_foot(bad, 1, 1, &wrong_out.foot));
        REFUSED_UNTOLD(INVALID, thud_terrain_closest(bad, &ball, &wrong_out.closest));
        REFUSED_UNTOLD(INVALID, thud_terrain_contacts(bad, &ball, 0.1, &wrong_out.contacts));
        REFUSED_UNTOLD(INVALID, thud_terrain_time_of_impact(bad, &ball, still, 0, OUT_FLAG, time));
        REFUSED_UNTOLD(INVALID,
                       thud_terrain_time_of_collision(bad, &ball, still, 1e-6, OUT_FLAG, time));
    }
    const double not_over_it[] = {NAN, INFINITY, -INFINITY, -0.001, 4.001, 1e300};
    EACH(x, not_over_it) {
        REFUSED_UNTOLD(INVALID, thud_terrain_sample_at(&ground, x, sample));
    }
    const thud_terrain steep = {.kind = THUD_TERRAIN_FLAT, .slope = 2};
    REFUSED_UNTOLD(INVALID, thud_terrain_sample_at(&steep, 1e308, sample));
    EACH(x, not_finite) {
        REFUSED_UNTOLD(INVALID, thud_terrain_place_foot(&ground, x, 1, &wrong_out.foot));
        REFUSED_UNTOLD(INVALID, thud_terrain_place_foot(&ground, 1, x, &wrong_out.foot));
    }
    EACH(x, bad_margins) {
        REFUSED_UNTOLD(INVALID, thud_terrain_contacts(&ground, &ball, x, &wrong_out.contacts));
        REFUSED_UNTOLD(INVALID,
                       thud_terrain_time_of_impact(&ground, &ball, still, x, OUT_FLAG, time));
    }
    EACH(x, bad_tolerances) {
        REFUSED_UNTOLD(INVALID,
                       thud_terrain_time_of_collision(&ground, &ball, still, x, OUT_FLAG, time));
    }
    for (int i = 0; i < COUNT(bad_shapes); i++) {
        REFUSED_UNTOLD(INVALID, thud_terrain_closest(&ground, &bad_shapes[i], &wrong_out.closest));
        assert_false(thud_terrain_overlap(&ground, &bad_shapes[i]));
    }
    REFUSED_UNTOLD(INVALID, thud_terrain_place_foot(&ground, 9, 1, &wrong_out.foot));
    REFUSED_UNTOLD(INVALID, thud_terrain_place_foot(&ground, 1, -1, &wrong_out.foot));
    const thud_uv uvs[] = {{0, 0}, {1, 1}, {2, 2}}, lost[] = {{0, NAN}, {INFINITY, 1}, {2, 2}};
    const thud_terrain_sample there = {.segment = 1, .weight = {0.5, 0.5}};
    thud_terrain_sample bad = there;
    bad.segment = -1;
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&bad, uvs, 3, &wrong_out.uv));
    bad.segment = INT32_MAX;
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&bad, uvs, 3, &wrong_out.uv));
    bad = there;
    bad.weight[0] = NAN;
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&bad, uvs, 3, &wrong_out.uv));
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&there, lost, 3, &wrong_out.uv));
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&there, uvs, 2, &wrong_out.uv));
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&there, uvs, -3, &wrong_out.uv));
    REFUSED_UNTOLD(INVALID, thud_terrain_texture_at(&there, uvs, INT32_MIN, &wrong_out.uv));
    REFUSED_UNTOLD(NULL, thud_terrain_texture_at(NULL, uvs, 3, &wrong_out.uv));
    REFUSED_UNTOLD(NULL, thud_terrain_texture_at(&there, NULL, 3, &wrong_out.uv));
    REFUSED_UNTOLD(NULL, thud_terrain_texture_at(&there, uvs, 3, NULL));
    REFUSED_UNTOLD(NULL, thud_terrain_check(NULL));
    REFUSED_UNTOLD(NULL, thud_terrain_sample_at(NULL, 1, sample));
    REFUSED_UNTOLD(NULL, thud_terrain_sample_at(&ground, 1, NULL));
    REFUSED_UNTOLD(NULL, thud_terrain_place_foot(NULL, 1, 1, &wrong_out.foot));
    REFUSED_UNTOLD(NULL, thud_terrain_place_foot(&ground, 1, 1, NULL));
    REFUSED_UNTOLD(NULL, thud_terrain_closest(&ground, NULL, &wrong_out.closest));
    REFUSED_UNTOLD(NULL, thud_terrain_contacts(NULL, &ball, 1, &wrong_out.contacts));
    REFUSED_UNTOLD(NULL, thud_terrain_time_of_impact(NULL, &ball, still, 0, OUT_FLAG, time));
    REFUSED_UNTOLD(NULL,
                   thud_terrain_time_of_collision(&ground, NULL, still, 1e-6, OUT_FLAG, time));
    assert_false(thud_terrain_overlap(NULL, &ball) || thud_terrain_overlap(&ground, NULL));
    assert_false(thud_terrain_cast_ray(NULL, (thud_segment){0, 0, 1, 0}, time, nx, ny));
}

void wrong_volumes(void **state) {
    wrong_pair *p = *state;
    thud_volume *out = &wrong_out.volume;
    for (int i = 0; i < COUNT(bad_shapes); i++) {
        const thud_geometry *bad = &bad_shapes[i];
        REFUSED_UNTOLD(INVALID, thud_volume_around_shape(THUD_SHAPE_AABB, bad, out));
        REFUSED_UNTOLD(INVALID, thud_volume_around_motion(THUD_SHAPE_OBB, bad, still, out));
    }
    const thud_volume bad_volumes[] = {
        {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = -1},
        {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = NAN},
        {.kind = THUD_SHAPE_CIRCLE, .x = 2e16, .c = 1},
        {.kind = THUD_SHAPE_AABB, .c = 1, .hx = INFINITY},
        {.kind = THUD_SHAPE_AABB, .c = 0.6, .s = 0.8},
        {.kind = THUD_SHAPE_OBB, .c = 0, .s = 0},
        {.kind = THUD_SHAPE_OBB, .c = 1, .s = NAN},
        {.kind = THUD_SHAPE_TERRAIN, .c = 1},
        {.kind = (thud_shape_kind)99, .c = 1},
    };
    for (int i = 0; i < COUNT(bad_volumes); i++) {
        const thud_volume *bad = &bad_volumes[i];
        REFUSED_UNTOLD(INVALID, thud_volume_check(bad));
        REFUSED_UNTOLD(INVALID, thud_volume_merge(THUD_SHAPE_CIRCLE, &ball, bad, out));
        REFUSED_UNTOLD(INVALID, thud_volumes_overlap(bad, &box, OUT_FLAG));
        REFUSED_UNTOLD(INVALID, thud_volume_contains_point(bad, 0, 0, OUT_FLAG));
        REFUSED_UNTOLD(INVALID, thud_volume_contains(&box, bad, OUT_FLAG));
    }
    const thud_shape_kind no_kinds[] = {THUD_SHAPE_TERRAIN, (thud_shape_kind)-1,
                                        (thud_shape_kind)99};
    for (int i = 0; i < COUNT(no_kinds); i++) {
        thud_shape_kind kind = no_kinds[i];
        REFUSED_UNTOLD(INVALID, thud_volume_around_shape(kind, &ball, out));
        REFUSED_UNTOLD(INVALID, thud_volume_around_motion(kind, &ball, still, out));
        REFUSED_UNTOLD(INVALID, thud_volume_around_points(kind, hill, 3, out));
        REFUSED_UNTOLD(INVALID, thud_volume_around_terrain(kind, &ground, 0, 4, out));
        REFUSED_UNTOLD(INVALID, thud_volume_merge(kind, &ball, &box, out));
    }
    const thud_pos far_off[] = {{0, 0}, {1e16, 0}}, lost[] = {{0, 0}, {0, NAN}};
    REFUSED_UNTOLD(INVALID, thud_volume_around_points(THUD_SHAPE_CIRCLE, far_off, 2, out));
    REFUSED_UNTOLD(INVALID, thud_volume_around_points(THUD_SHAPE_OBB, lost, 2, out));
    REFUSED_UNTOLD(INVALID, thud_volume_around_points(THUD_SHAPE_AABB, hill, 0, out));
    REFUSED_UNTOLD(INVALID, thud_volume_around_points(THUD_SHAPE_AABB, hill, -3, out));
    for (int i = 0; i < COUNT(bad_grounds); i++) {
        REFUSED_UNTOLD(INVALID,
                       thud_volume_around_terrain(THUD_SHAPE_AABB, &bad_grounds[i], 0, 4, out));
    }
    for (int i = 0; i < COUNT(bad_motions); i++) {
        REFUSED_UNTOLD(INVALID,
                       thud_volume_around_motion(THUD_SHAPE_OBB, &box, bad_motions[i], out));
    }
    EACH(x, not_finite) {
        REFUSED_UNTOLD(INVALID, thud_volume_contains_point(&box, x, 0, OUT_FLAG));
        REFUSED_UNTOLD(INVALID, thud_volume_contains_point(&box, 0, x, OUT_FLAG));
    }
    REFUSED_UNTOLD(INVALID, thud_volume_around_terrain(THUD_SHAPE_AABB, &ground, 5, 9, out));
    REFUSED_UNTOLD(INVALID, thud_volume_around_terrain(THUD_SHAPE_AABB, &ground, NAN, 9, out));
    REFUSED_UNTOLD(INVALID, thud_volume_around_terrain(THUD_SHAPE_AABB, &ground, 3, 1, out));
    REFUSED_UNTOLD(NULL, thud_volume_check(NULL));
    REFUSED_UNTOLD(NULL, thud_volume_around_shape(THUD_SHAPE_AABB, NULL, out));
    REFUSED_UNTOLD(NULL, thud_volume_around_shape(THUD_SHAPE_AABB, &ball, NULL));
    REFUSED_UNTOLD(NULL, thud_volume_around_motion(THUD_SHAPE_AABB, NULL, still, out));
    REFUSED_UNTOLD(NULL, thud_volume_around_points(THUD_SHAPE_AABB, NULL, 3, out));
    REFUSED_UNTOLD(NULL, thud_volume_around_points(THUD_SHAPE_AABB, hill, 3, NULL));
    REFUSED_UNTOLD(NULL, thud_volume_around_terrain(THUD_SHAPE_AABB, NULL, 0, 4, out));
    REFUSED_UNTOLD(NULL, thud_volume_merge(THUD_SHAPE_AABB, NULL, &box, out));
    REFUSED_UNTOLD(NULL, thud_volume_merge(THUD_SHAPE_AABB, &ball, &box, NULL));
    REFUSED_UNTOLD(NULL, thud_volumes_overlap(&ball, NULL, OUT_FLAG));
    REFUSED_UNTOLD(NULL, thud_volumes_overlap(&ball, &box, NULL));
    REFUSED_UNTOLD(NULL, thud_volume_contains_point(NULL, 0, 0, OUT_FLAG));
    REFUSED_UNTOLD(NULL, thud_volume_contains(&ball, &box, NULL));
}

void wrong_sums(void **state) {
    wrong_pair *p = *state;
    double *number = &wrong_out.number, *nx = &wrong_out.nx, *ny = &wrong_out.ny;
    thud_minkowski sum;
    OK(thud_minkowski_sum(&ball, &box, &sum));
    for (int i = 0; i < COUNT(bad_shapes); i++) {
        REFUSED_UNTOLD(INVALID, thud_minkowski_sum(&bad_shapes[i], &box, &wrong_out.sum));
        REFUSED_UNTOLD(INVALID, thud_minkowski_sum(&ball, &bad_shapes[i], &wrong_out.sum));
    }
    const double not_in_range[] = {NAN, INFINITY, -INFINITY, 2e16, -1e300};
    EACH(x, not_in_range) {
        REFUSED_UNTOLD(INVALID, thud_minkowski_contains(&sum, x, 0, OUT_FLAG));
        REFUSED_UNTOLD(INVALID, thud_minkowski_contains(&sum, 0, x, OUT_FLAG));
        REFUSED_UNTOLD(INVALID, thud_minkowski_distance(&sum, x, 0, number, nx, ny));
        REFUSED_UNTOLD(INVALID, thud_minkowski_cast(&sum, (thud_segment){x, 0, 1, 0}, OUT_FLAG,
                                                    number, nx, ny));
        REFUSED_UNTOLD(INVALID, thud_minkowski_cast(&sum, (thud_segment){9, 0, x, 0}, OUT_FLAG,
                                                    number, nx, ny));
        REFUSED_UNTOLD(INVALID, thud_minkowski_cast(&sum, (thud_segment){9, 0, 0, x}, OUT_FLAG,
                                                    number, nx, ny));
    }
    thud_minkowski bad[] = {sum, sum, sum, sum, sum};
    bad[0].count = 3;
    bad[1].count = -1;
    bad[2].count = 99;
    bad[3].radius = NAN;
    bad[4].radius = -1;
    for (int i = 0; i < COUNT(bad); i++) {
        REFUSED_UNTOLD(INVALID, thud_minkowski_contains(&bad[i], 0, 0, OUT_FLAG));
        REFUSED_UNTOLD(INVALID, thud_minkowski_distance(&bad[i], 0, 0, number, nx, ny));
        REFUSED_UNTOLD(INVALID, thud_minkowski_cast(&bad[i], (thud_segment){9, 0, -9, 0}, OUT_FLAG,
                                                    number, nx, ny));
    }
    REFUSED_UNTOLD(NULL, thud_minkowski_sum(NULL, &box, &wrong_out.sum));
    REFUSED_UNTOLD(NULL, thud_minkowski_sum(&ball, &box, NULL));
    REFUSED_UNTOLD(NULL, thud_minkowski_contains(NULL, 0, 0, OUT_FLAG));
    REFUSED_UNTOLD(NULL, thud_minkowski_contains(&sum, 0, 0, NULL));
    REFUSED_UNTOLD(NULL, thud_minkowski_distance(NULL, 0, 0, number, nx, ny));
    REFUSED_UNTOLD(NULL,
                   thud_minkowski_cast(NULL, (thud_segment){9, 0, 1, 0}, OUT_FLAG, number, nx, ny));
}
