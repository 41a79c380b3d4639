/* api_geometry.c: exports for geometry without a world: of two shapes (distances, contact points,
 * times of impact, Minkowski casts, bounding volumes), and of shape a and a terrain line. All read
 * the shapes and their motions from the slots geometry_pair; api.h has the conventions. */
#include "api.h"

#include <thud/thud_capsule.h>
#include <thud/thud_minkowski.h>
#include <thud/thud_terrain.h>

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

static int put_closest(thud_result result, const thud_closest *c, bool overlaps) {
    if (result == THUD_OK)
        api_slots.closest_features = (struct closest_features){.overlaps = overlaps,
                                                               .distance = c->distance,
                                                               .normal = {c->nx, c->ny},
                                                               .point_a = {c->ax, c->ay},
                                                               .point_b = {c->bx, c->by}};
    return result;
}

static struct touching_point point_of(const thud_closest *c) {
    return (struct touching_point){c->distance, {c->nx, c->ny}, {c->ax, c->ay}, {c->bx, c->by}};
}

static int put_contacts(thud_result result, const thud_contacts *contacts) {
    struct touching_points *out = &api_slots.touching_points;
    if (result != THUD_OK)
        return result;
    out->count = contacts->count;
    if (contacts->count > 0)
        out->first = point_of(&contacts->point[0]);
    if (contacts->count > 1)
        out->second = point_of(&contacts->point[1]);
    return result;
}

static int put_crossing(thud_result result, bool found, double fraction, double nx, double ny) {
    if (result == THUD_OK)
        api_slots.crossing = (struct crossing){found, fraction, {nx, ny}};
    return result;
}

static int put_meeting(thud_result result, bool found, double time, bool bisectable) {
    if (result == THUD_OK)
        api_slots.meeting =
            (struct meeting){.found = found, .time = time, .bisectable = bisectable};
    return result;
}

static int put_volume(thud_result result, const thud_volume *v) {
    if (result == THUD_OK)
        api_slots.volume = (struct volume){v->kind, {v->x, v->y}, {v->hx, v->hy}, {v->c, v->s}};
    return result;
}

static int put_number(thud_result result, double number) {
    api_slots.number.value = number;
    return result;
}

/* ---- two shapes ---- */

/* Slots out: closest_features. */
int api_geometry_closest(void) {
    moving_pair p = pair_now();
    thud_closest c;
    thud_result result = thud_geometry_closest(&p.a, &p.b, &c);
    return put_closest(result, &c, thud_geometry_overlap(&p.a, &p.b));
}

/* `margin`: the distance up to which points count, a length. Slots out: touching_points. */
int api_geometry_contacts(double margin) {
    moving_pair p = pair_now();
    thud_contacts contacts;
    thud_result result = thud_geometry_contacts(&p.a, &p.b, margin, &contacts);
    return put_contacts(result, &contacts);
}

/* Casts refuse no ray: one with a number that is not finite hits nothing. */
static thud_result check_ray(const thud_segment *ray) {
    double zero = (ray->x - ray->x) + (ray->y - ray->y) + (ray->dx - ray->dx) + (ray->dy - ray->dy);
    return zero == 0.0 ? THUD_OK : THUD_ERROR_INVALID;
}

/* A ray from (x, y) by (dx, dy) against shape a. Slots out: crossing. */
int api_geometry_cast_ray(double x, double y, double dx, double dy) {
    moving_pair p = pair_now();
    thud_segment ray = {x, y, dx, dy};
    double fraction = 1.0, nx = 0.0, ny = 0.0;
    bool hit = thud_geometry_cast_ray(&p.a, ray, &fraction, &nx, &ny);
    thud_result result = thud_geometry_check(&p.a);
    return put_crossing(result == THUD_OK ? check_ray(&ray) : result, hit, fraction, nx, ny);
}

/* `target`: the distance at which the shapes count as meeting, a length. Slots out: meeting. */
int api_geometry_time_of_impact(double target) {
    moving_pair p = pair_now();
    bool hit = false;
    double time = 1.0;
    thud_result result =
        thud_geometry_time_of_impact(&p.a, p.by_a, &p.b, p.by_b, target, &hit, &time);
    return put_meeting(result, hit, time, false);
}

/* `tolerance`: a fraction of the motion. Slots out: meeting. */
int api_geometry_time_of_collision(double tolerance) {
    moving_pair p = pair_now();
    bool collided = false;
    double time = 1.0;
    thud_result result =
        thud_geometry_time_of_collision(&p.a, p.by_a, &p.b, p.by_b, tolerance, &collided, &time);
    return put_meeting(result, collided, time,
                       thud_geometry_is_bisectable(&p.a, p.by_a, &p.b, p.by_b));
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
    return put_crossing(result, hit, fraction, nx, ny);
}

/* ---- bounding volumes ---- */

/* The bounding volume of this kind around shape a. Slots out: volume. */
int api_volume_around_shape(int kind) {
    moving_pair p = pair_now();
    thud_volume v;
    thud_result result = thud_volume_around_shape((thud_shape_kind)kind, &p.a, &v);
    return put_volume(result, &v);
}

/* ... around all places of shape a during its motion. Slots out: volume. */
int api_volume_around_motion(int kind) {
    moving_pair p = pair_now();
    thud_volume v;
    thud_result result = thud_volume_around_motion((thud_shape_kind)kind, &p.a, p.by_a, &v);
    return put_volume(result, &v);
}

/* ... around points. Slots out: volume. */
int api_volume_around_points(int kind, const thud_pos *points, int count) {
    thud_volume v;
    thud_result result = thud_volume_around_points((thud_shape_kind)kind, points, count, &v);
    return put_volume(result, &v);
}

/* ... around the volumes a and b. Slots out: volume. */
int api_volume_merge(int kind) {
    moving_pair p = pair_now();
    thud_volume v;
    thud_result result = thud_volume_merge((thud_shape_kind)kind, &p.a, &p.b, &v);
    return put_volume(result, &v);
}

/* Slots out: number. */
int api_volumes_overlap(void) {
    moving_pair p = pair_now();
    bool overlap = false;
    thud_result result = thud_volumes_overlap(&p.a, &p.b, &overlap);
    return put_number(result, overlap);
}

/* Whether volume a contains volume b. Slots out: number. */
int api_volume_contains(void) {
    moving_pair p = pair_now();
    bool inside = false;
    thud_result result = thud_volume_contains(&p.a, &p.b, &inside);
    return put_number(result, inside);
}

/* Whether volume a contains a point. Slots out: number. */
int api_volume_contains_point(double x, double y) {
    moving_pair p = pair_now();
    bool inside = false;
    thud_result result = thud_volume_contains_point(&p.a, x, y, &inside);
    return put_number(result, inside);
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
    return put_number(result, overlapping);
}

/* ---- a terrain line ---- */

/* The line that the calls below read. JavaScript sets it before each of them, since it owns the
 * points only until the call returns. */
static thud_terrain line;

/* `points`: x and y of each vertex; a uniform line has its heights there. */
int api_line_set(int kind, double slope, double x0, double spacing, const thud_pos *points,
                 int count) {
    line = (thud_terrain){.kind = (thud_terrain_kind)kind,
                          .slope = slope,
                          .x0 = x0,
                          .spacing = spacing,
                          .points = points,
                          .count = count};
    return thud_terrain_check(&line);
}

/* Slots out: ground. */
int api_line_at(double x) {
    thud_terrain_sample sample;
    thud_result result = thud_terrain_sample_at(&line, x, &sample);
    if (result == THUD_OK)
        api_slots.ground = (struct ground){.height = sample.height,
                                           .normal = {sample.nx, sample.ny},
                                           .segment = sample.segment,
                                           .weights = {sample.weight[0], sample.weight[1]}};
    return result;
}

/* The texture coordinates at x, from those of each vertex. Slots out: place. */
int api_line_texture(double x, const thud_uv *vertices, int count) {
    thud_terrain_sample sample;
    thud_uv uv;
    thud_result result = thud_terrain_sample_at(&line, x, &sample);
    if (result == THUD_OK)
        result = thud_terrain_texture_at(&sample, vertices, count, &uv);
    if (result == THUD_OK)
        api_slots.place = (struct place){{uv.u, uv.v}};
    return result;
}

/* The friction at x, from a texture as api_texture takes it. Slots out: number. */
int api_line_friction(double x, double *numbers, int count, int table_count, int has_table,
                      int repeats) {
    thud_texture texture = api_texture(numbers, count, table_count, has_table, repeats);
    thud_terrain_sample sample;
    float friction = 0.0f;
    thud_result result = thud_terrain_sample_at(&line, x, &sample);
    if (result == THUD_OK)
        result = thud_texture_friction_at(&texture, &sample, &friction);
    return put_number(result, (double)friction);
}

/* Looks the ground up `count` times, at places from `from` to `to` in no order, so that JavaScript
 * can measure its time. They are the fractional parts of multiples of the golden ratio, which
 * spread evenly. Slots out: number, of the segments found together. */
int api_line_often(double from, double to, int count) {
    const double golden = 0.6180339887498949;
    double part = 0.0, segments = 0.0;
    thud_result result = THUD_OK;
    for (int i = 0; i < count && result == THUD_OK; i++) {
        thud_terrain_sample sample;
        result = thud_terrain_sample_at(&line, from + (to - from) * part, &sample);
        segments += sample.segment;
        part += golden;
        part -= part >= 1.0 ? 1.0 : 0.0;
    }
    return put_number(result, segments);
}

/* The place of a foot with its middle at x. Slots out: foot. */
int api_line_foot(double x, double width) {
    thud_foot foot;
    thud_result result = thud_terrain_place_foot(&line, x, width, &foot);
    if (result == THUD_OK)
        api_slots.foot =
            (struct foot){.height = foot.height, .x = foot.x, .normal = {foot.nx, foot.ny}};
    return result;
}

/* The segments that an interval touches. Slots out: segments. */
int api_line_segments(double x_min, double x_max) {
    int first = 0, last = -1;
    thud_terrain_segments(&line, x_min, x_max, &first, &last);
    api_slots.segments = (struct segments){first, last};
    return THUD_OK;
}

/* A ray from (x, y) by (dx, dy), from above. Slots out: crossing. */
int api_line_cast_ray(double x, double y, double dx, double dy) {
    thud_segment ray = {x, y, dx, dy};
    double fraction = 1.0, nx = 0.0, ny = 0.0;
    bool hit = thud_terrain_cast_ray(&line, ray, &fraction, &nx, &ny);
    return put_crossing(check_ray(&ray), hit, fraction, nx, ny);
}

/* The line is a, shape a is b. Slots out: closest_features. */
int api_line_closest(void) {
    moving_pair p = pair_now();
    thud_closest c;
    thud_result result = thud_terrain_closest(&line, &p.a, &c);
    return put_closest(result, &c, thud_terrain_overlap(&line, &p.a));
}

/* Likewise; as api_geometry_contacts. Slots out: touching_points. */
int api_line_contacts(double margin) {
    moving_pair p = pair_now();
    thud_contacts contacts;
    thud_result result = thud_terrain_contacts(&line, &p.a, margin, &contacts);
    return put_contacts(result, &contacts);
}

/* Shape a moves; as api_geometry_time_of_impact. Slots out: meeting. */
int api_line_time_of_impact(double target) {
    moving_pair p = pair_now();
    bool hit = false;
    double time = 1.0;
    thud_result result = thud_terrain_time_of_impact(&line, &p.a, p.by_a, target, &hit, &time);
    return put_meeting(result, hit, time, false);
}

/* Shape a moves; as api_geometry_time_of_collision. Slots out: meeting. */
int api_line_time_of_collision(double tolerance) {
    moving_pair p = pair_now();
    bool collided = false;
    double time = 1.0;
    thud_result result =
        thud_terrain_time_of_collision(&line, &p.a, p.by_a, tolerance, &collided, &time);
    return put_meeting(result, collided, time, false);
}

/* The bounding volume of this kind around the line from x_min to x_max. Slots out: volume. */
int api_volume_around_line(int kind, double x_min, double x_max) {
    thud_volume v;
    thud_result result = thud_volume_around_terrain((thud_shape_kind)kind, &line, x_min, x_max, &v);
    return put_volume(result, &v);
}

/* ---- capsules ---- */

static thud_capsule capsule_of(const struct capsule *c) {
    return (thud_capsule){c->from[0], c->from[1], c->to[0], c->to[1], c->radius};
}

/* Capsule a against shape or capsule b. Slots in: capsule_pair. Slots out: closest_features. */
int api_capsule_closest(void) {
    const struct capsule_pair *p = &api_slots.capsule_pair;
    thud_capsule a = capsule_of(&p->a), other = capsule_of(&p->capsule_b);
    thud_geometry b = placed(&p->shape_b);
    thud_closest c;
    thud_result result = p->is_capsule != 0.0 ? thud_capsules_closest(&a, &other, &c)
                                              : thud_capsule_closest(&a, &b, &c);
    return put_closest(result, &c, result == THUD_OK && c.distance <= 0.0);
}

/* Both move; as api_geometry_time_of_impact. Slots in: capsule_pair. Slots out: meeting. */
int api_capsule_time_of_impact(double target) {
    const struct capsule_pair *p = &api_slots.capsule_pair;
    thud_capsule a = capsule_of(&p->a), other = capsule_of(&p->capsule_b);
    thud_geometry b = placed(&p->shape_b);
    thud_motion by_a = {p->motion_a[0], p->motion_a[1], 0.0};
    thud_motion by_b = {p->motion_b[0], p->motion_b[1], 0.0};
    bool hit = false;
    double time = 1.0;
    thud_result result =
        p->is_capsule != 0.0
            ? thud_capsules_time_of_impact(&a, by_a, &other, by_b, target, &hit, &time)
            : thud_capsule_time_of_impact(&a, by_a, &b, by_b, target, &hit, &time);
    return put_meeting(result, hit, time, false);
}

/* The line is a, capsule a is b. Slots in: capsule_pair. Slots out: closest_features. */
int api_line_capsule_closest(void) {
    thud_capsule capsule = capsule_of(&api_slots.capsule_pair.a);
    thud_closest c;
    thud_result result = thud_terrain_capsule_closest(&line, &capsule, &c);
    return put_closest(result, &c, result == THUD_OK && c.distance <= 0.0);
}

/* Capsule a moves. Slots in: capsule_pair. Slots out: meeting. */
int api_line_capsule_time_of_impact(double target) {
    const struct capsule_pair *p = &api_slots.capsule_pair;
    thud_capsule capsule = capsule_of(&p->a);
    thud_motion motion_a = {p->motion_a[0], p->motion_a[1], 0.0};
    bool hit = false;
    double time = 1.0;
    thud_result result =
        thud_terrain_capsule_time_of_impact(&line, &capsule, motion_a, target, &hit, &time);
    return put_meeting(result, hit, time, false);
}
