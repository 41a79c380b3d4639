/* bisect.c: the time of collision by bisection: half of what is left is thrown away with each
 * overlap test, so that a tolerance of 2^-20 of the motion takes twenty. */
#include "geometry/bisect.h"

bool td_bisect(td_overlap_at_fn *overlap_at, const void *meeting, double tolerance, double *time) {
    double apart = 0.0, together = 1.0;
    bool collided = overlap_at(meeting, 1.0) && !overlap_at(meeting, 0.0);
    while (collided && together - apart > tolerance) {
        double middle = 0.5 * (apart + together);
        if (overlap_at(meeting, middle)) {
            together = middle;
        } else {
            apart = middle;
        }
    }
    *time = collided ? apart : 1.0;
    return collided;
}

typedef struct shapes {
    const thud_shape_instance *a, *b;
    thud_motion motion_a, motion_b;
} shapes;

static bool overlap_at(const void *meeting, double time) {
    const shapes *m = meeting;
    thud_shape_instance a = td_placed_at(m->a, &m->motion_a, time);
    thud_shape_instance b = td_placed_at(m->b, &m->motion_b, time);
    thud_closest closest;
    td_closest(&a, &b, &closest);
    return closest.distance <= 0.0;
}

thud_result thud_shapes_time_of_collision(const thud_shape_instance *a, thud_motion motion_a,
                                          const thud_shape_instance *b, thud_motion motion_b,
                                          double tolerance, bool *collided, double *time) {
    if (!a || !b || !collided || !time) {
        return THUD_ERROR_NULL;
    }
    if (thud_placed_check(a) != THUD_OK || thud_placed_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b) ||
        !td_tolerance_valid(tolerance)) {
        return THUD_ERROR_INVALID;
    }
    shapes m = {a, b, motion_a, motion_b};
    *collided = td_bisect(overlap_at, &m, tolerance, time);
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
