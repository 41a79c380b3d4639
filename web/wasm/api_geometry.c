/* api_geometry.c: exports for geometry of two shapes without a world: distances, times of impact,
 * Minkowski casts and bounding volumes. All read the shapes and their motions from the slots
 * geometry_pair; api.h has the conventions. */
#include "api.h"

#include <thud/thud_minkowski.h>

static thud_geometry placed(const struct placed *p) {
    thud_geometry shape = api_placed(api_to_int(p->solid.kind), p->solid.half_extents[0],
                                     p->solid.half_extents[1], p->solid.angle);
    shape.x = p->center[0];
    shape.y = p->center[1];
    return shape;
}

static thud_motion motion(const double numbers[3]) {
    return (thud_motion){numbers[0], numbers[1], numbers[2]};
}

/* Two shapes and their motions. */
typedef struct moving_pair {
    thud_geometry a, b;
    thud_motion by_a, by_b;
} moving_pair;

/* Slots in: geometry_pair. */
static moving_pair pair_now(void) {
    const struct geometry_pair *p = &api_slots.geometry_pair;
    return (moving_pair){placed(&p->a), placed(&p->b), motion(p->motion_a), motion(p->motion_b)};
}

/* Slots out: closest_features. */
int api_geometry_closest(void) {
    moving_pair p = pair_now();
    thud_closest c;
    thud_result result = thud_geometry_closest(&p.a, &p.b, &c);
    if (result == THUD_OK)
        api_slots.closest_features =
            (struct closest_features){.overlaps = thud_geometry_overlap(&p.a, &p.b),
                                      .distance = c.distance,
                                      .normal = {c.nx, c.ny},
                                      .point_a = {c.ax, c.ay},
                                      .point_b = {c.bx, c.by}};
    return result;
}

/* `target`: the distance at which the shapes count as meeting, a length. Slots out: meeting. */
int api_geometry_time_of_impact(double target) {
    moving_pair p = pair_now();
    bool hit = false;
    double time = 1.0;
    thud_result result =
        thud_geometry_time_of_impact(&p.a, p.by_a, &p.b, p.by_b, target, &hit, &time);
    if (result == THUD_OK)
        api_slots.meeting = (struct meeting){.found = hit, .time = time};
    return result;
}

/* `tolerance`: a fraction of the motion. Slots out: meeting. */
int api_geometry_time_of_collision(double tolerance) {
    moving_pair p = pair_now();
    bool collided = false;
    double time = 1.0;
    thud_result result =
        thud_geometry_time_of_collision(&p.a, p.by_a, &p.b, p.by_b, tolerance, &collided, &time);
    if (result == THUD_OK)
        api_slots.meeting = (struct meeting){
            .found = collided,
            .time = time,
            .bisectable = thud_geometry_is_bisectable(&p.a, p.by_a, &p.b, p.by_b),
        };
    return result;
}

/* Slots out: meeting. */
int api_geometry_approach(void) {
    moving_pair p = pair_now();
    thud_approach passing;
    thud_result result = thud_geometry_approach(&p.a, p.by_a, &p.b, p.by_b, &passing);
    if (result == THUD_OK)
        api_slots.meeting = (struct meeting){.found = passing.hit,
                                             .time = passing.time,
                                             .min_distance = passing.min_distance,
                                             .min_distance_time = passing.min_distance_time};
    return result;
}

/* Where b's centre, moving relative to a, enters the Minkowski sum of both. Slots out: crossing. */
int api_minkowski_cast(void) {
    moving_pair p = pair_now();
    thud_minkowski sum;
    thud_segment path = {p.b.x - p.a.x, p.b.y - p.a.y, p.by_b.dx - p.by_a.dx,
                         p.by_b.dy - p.by_a.dy};
    bool hit = false;
    double fraction = 1.0, nx = 0.0, ny = 0.0;
    thud_result result = thud_minkowski_sum(&p.a, &p.b, &sum);
    if (result == THUD_OK)
        result = thud_minkowski_cast(&sum, path, &hit, &fraction, &nx, &ny);
    if (result == THUD_OK)
        api_slots.crossing = (struct crossing){hit, fraction, {nx, ny}};
    return result;
}

/* The bounding volume of this kind around shape a. Slots out: volume. */
int api_volume_around_shape(int kind) {
    moving_pair p = pair_now();
    thud_volume v;
    thud_result result = thud_volume_around_shape((thud_shape_kind)kind, &p.a, &v);
    if (result == THUD_OK)
        api_slots.volume = (struct volume){v.kind, {v.x, v.y}, {v.hx, v.hy}, {v.c, v.s}};
    return result;
}

/* Slots out: number. */
int api_volumes_overlap(void) {
    moving_pair p = pair_now();
    bool overlap = false;
    thud_result result = thud_volumes_overlap(&p.a, &p.b, &overlap);
    api_slots.number.value = overlap;
    return result;
}

/* Runs the overlap test of both as shapes (`exact`) or as bounding volumes `count` times, so that
 * JavaScript can measure its time. The two change places each time, so that the compiler cannot
 * move the test out of the loop. Slots out: number, of the tests that found an overlap. */
int api_overlap_often(int exact, int count) {
    moving_pair p = pair_now();
    const thud_geometry *sides[2] = {&p.a, &p.b};
    thud_result result = exact ? thud_geometry_check(&p.a) : thud_volume_check(&p.a);
    if (result == THUD_OK)
        result = exact ? thud_geometry_check(&p.b) : thud_volume_check(&p.b);
    double overlapping = 0.0;
    for (int i = 0; i < count && result == THUD_OK; i++) {
        const thud_geometry *one = sides[i % 2], *other = sides[1 - i % 2];
        bool overlap = false;
        if (exact)
            overlap = thud_geometry_overlap(one, other);
        else
            result = thud_volumes_overlap(one, other, &overlap);
        overlapping += overlap;
    }
    api_slots.number.value = overlapping;
    return result;
}
