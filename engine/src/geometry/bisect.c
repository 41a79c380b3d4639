/* bisect.c: moving shapes at a time, and the time of collision by bisection: half of what is left
 * is thrown away with each overlap test, so that a tolerance of 2^-20 of the motion takes twenty.
 */
#include "terrain/terrain.h"
#include "base/trig.h"

thud_shape_instance td_placed_at(const thud_shape_instance *shape, const thud_motion *m, double t) {
    thud_shape_instance p = *shape;
    p.x += m->dx * t;
    p.y += m->dy * t;
    if (td_kind_turns(p.kind) && m->turn != 0.0) {
        double s, c;
        td_sincos(m->turn * t, &s, &c);
        p.c = shape->c * c - shape->s * s;
        p.s = shape->s * c + shape->c * s;
    }
    return p;
}

/* What may meet: two shapes, or a shape and the ground. */
typedef struct meeting {
    const thud_terrain *terrain; /* or null: b is a shape */
    const thud_shape_instance *a, *b;
    thud_motion motion_a, motion_b;
} meeting;

static bool overlap_at(const meeting *m, double time) {
    thud_shape_instance a = td_placed_at(m->a, &m->motion_a, time);
    if (m->terrain) {
        return thud_terrain_overlap(m->terrain, &a);
    }
    thud_shape_instance b = td_placed_at(m->b, &m->motion_b, time);
    thud_closest closest;
    td_closest(&a, &b, &closest);
    return closest.distance <= 0.0;
}

static void bisect(const meeting *m, double tolerance, bool *collided, double *time) {
    double apart = 0.0, together = 1.0;
    *collided = overlap_at(m, 1.0) && !overlap_at(m, 0.0);
    while (*collided && together - apart > tolerance) {
        double middle = 0.5 * (apart + together);
        if (overlap_at(m, middle)) {
            together = middle;
        } else {
            apart = middle;
        }
    }
    *time = *collided ? apart : 1.0;
}

static bool tolerance_valid(double tolerance) {
    return tolerance >= 1e-15 && tolerance <= 1.0;
}

thud_result thud_shapes_time_of_collision(const thud_shape_instance *a, thud_motion motion_a,
                                          const thud_shape_instance *b, thud_motion motion_b,
                                          double tolerance, bool *collided, double *time) {
    if (!a || !b || !collided || !time) {
        return THUD_ERROR_NULL;
    }
    if (thud_placed_check(a) != THUD_OK || thud_placed_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b) || !tolerance_valid(tolerance)) {
        return THUD_ERROR_INVALID;
    }
    meeting m = {.a = a, .b = b, .motion_a = motion_a, .motion_b = motion_b};
    bisect(&m, tolerance, collided, time);
    return THUD_OK;
}

thud_result thud_terrain_time_of_collision(const thud_terrain *terrain,
                                           const thud_shape_instance *shape, thud_motion motion,
                                           double tolerance, bool *collided, double *time) {
    if (!terrain || !shape || !collided || !time) {
        return THUD_ERROR_NULL;
    }
    thud_result readable = td_terrain_readable(terrain);
    if (readable != THUD_OK || thud_placed_check(shape) != THUD_OK || !td_motion_valid(motion) ||
        !tolerance_valid(tolerance)) {
        return readable != THUD_OK ? readable : THUD_ERROR_INVALID;
    }
    meeting m = {.terrain = terrain, .a = shape, .motion_a = motion};
    bisect(&m, tolerance, collided, time);
    return THUD_OK;
}

static double thickness(const thud_shape_instance *shape) {
    return 2.0 * td_kind_half_thickness(shape->kind, shape->hx, shape->hy);
}

/* No point of it goes further by turning. Where it turns about its own middle, only what is further
 * out than both are thick, by halves, can go through the middle of another. */
static double swing(const thud_shape_instance *shape, thud_motion m,
                    const thud_shape_instance *other) {
    double radius = __builtin_sqrt(shape->hx * shape->hx + shape->hy * shape->hy);
    bool far = radius > 0.5 * (thickness(shape) + thickness(other));
    return td_kind_turns(shape->kind) && far ? td_abs(m.turn) * radius : 0.0;
}

bool thud_motion_is_bisectable(const thud_shape_instance *a, thud_motion motion_a,
                               const thud_shape_instance *b, thud_motion motion_b) {
    if (thud_placed_check(a) != THUD_OK || thud_placed_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b)) {
        return false;
    }
    double x = motion_a.dx - motion_b.dx, y = motion_a.dy - motion_b.dy;
    double least = thickness(a) < thickness(b) ? thickness(a) : thickness(b);
    double left = least - swing(a, motion_a, b) - swing(b, motion_b, a);
    return left > 0.0 && x * x + y * y < left * left;
}
