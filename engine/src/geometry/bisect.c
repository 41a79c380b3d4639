/* bisect.c: the time of collision by bisection. Two tests at the ends of the motion, then each
 * overlap test halves the interval that contains it: a tolerance of 2^-20 of the motion takes 22
 * tests. If the shapes are apart again at the end of the motion, the collision is not found:
 * thud_geometry_is_bisectable says when that cannot happen. */
#include "geometry/bisect.h"

bool td_bisect(td_overlap_at_fn *overlap_at, const void *pair, double tolerance, double *time) {
    double low = 0.0, high = 1.0; /* apart at `low`, overlapping at `high` */
    bool collided = overlap_at(pair, 1.0) && !overlap_at(pair, 0.0);
    while (collided && high - low > tolerance) {
        double middle = 0.5 * (low + high);
        if (overlap_at(pair, middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    *time = collided ? low : 1.0;
    return collided;
}

/* Two moving shapes. */
typedef struct shapes {
    const thud_geometry *a, *b;
    thud_motion motion_a, motion_b;
} shapes;

/* A td_overlap_at_fn for `shapes`. */
static bool overlap_at(const void *pair, double time) {
    const shapes *m = pair;
    thud_geometry a = td_placed_at(m->a, &m->motion_a, time);
    thud_geometry b = td_placed_at(m->b, &m->motion_b, time);
    thud_closest closest;
    td_closest(&a, &b, &closest);
    return closest.distance <= 0.0;
}

thud_result thud_geometry_time_of_collision(const thud_geometry *a, thud_motion motion_a,
                                            const thud_geometry *b, thud_motion motion_b,
                                            double tolerance, bool *out_collided,
                                            double *out_time) {
    if (!a || !b || !out_collided || !out_time) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b) ||
        !td_tolerance_valid(tolerance)) {
        return THUD_ERROR_INVALID;
    }
    shapes m = {a, b, motion_a, motion_b};
    *out_collided = td_bisect(overlap_at, &m, tolerance, out_time);
    return THUD_OK;
}

/* The smallest extent of a shape. */
static double thickness(const thud_geometry *shape) {
    return 2.0 * td_kind_half_thickness(shape->kind, shape->hx, shape->hy);
}

/* The allowance for a shape's rotation, length: an upper bound of the distance by which it moves a
 * point of the shape. It is 0 if the shape does not turn. It is 0 also if no point of it is further
 * from its centre than half of the sum of the two shapes' thicknesses, since rotation then carries
 * no point through the middle of the other shape. */
static double turning_reach(const thud_geometry *shape, thud_motion m, const thud_geometry *other) {
    double radius = __builtin_sqrt(shape->hx * shape->hx + shape->hy * shape->hy);
    bool far = radius > 0.5 * (thickness(shape) + thickness(other));
    return td_kind_turns(shape->kind) && far ? td_abs(m.turn) * radius : 0.0;
}

bool thud_geometry_is_bisectable(const thud_geometry *a, thud_motion motion_a,
                                 const thud_geometry *b, thud_motion motion_b) {
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK ||
        !td_motion_valid(motion_a) || !td_motion_valid(motion_b)) {
        return false;
    }
    double x = motion_a.dx - motion_b.dx, y = motion_a.dy - motion_b.dy;
    double thickness_min = thickness(a) < thickness(b) ? thickness(a) : thickness(b);
    double remaining =
        thickness_min - turning_reach(a, motion_a, b) - turning_reach(b, motion_b, a);
    return remaining > 0.0 && x * x + y * y < remaining * remaining;
}
