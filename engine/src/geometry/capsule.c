/* capsule.c: capsules against circles, boxes and each other; see thud_capsule.h. The segment of a
 * capsule is a box of thickness 0, which closest.c and minkowski.c accept, and the radius is
 * subtracted from the distance. */
#include "geometry/capsule.h"

thud_result thud_capsule_check(const thud_capsule *capsule) {
    if (!capsule) {
        return THUD_ERROR_NULL;
    }
    bool ends =
        td_abs(capsule->x1) <= THUD_COORDINATE_MAX && td_abs(capsule->y1) <= THUD_COORDINATE_MAX &&
        td_abs(capsule->x2) <= THUD_COORDINATE_MAX && td_abs(capsule->y2) <= THUD_COORDINATE_MAX;
    bool radius = capsule->radius > 0.0 && capsule->radius <= THUD_COORDINATE_MAX;
    return ends && radius ? THUD_OK : THUD_ERROR_INVALID;
}

thud_result thud_capsule_of_motion(const thud_geometry *circle, thud_motion motion,
                                   thud_capsule *out) {
    if (!circle || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(circle) != THUD_OK || !td_kind_is_round(circle->kind) ||
        !td_motion_valid(motion)) {
        return THUD_ERROR_INVALID;
    }
    thud_capsule capsule = {circle->x, circle->y, circle->x + motion.dx, circle->y + motion.dy,
                            circle->hx};
    if (thud_capsule_check(&capsule) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    *out = capsule;
    return THUD_OK;
}

thud_geometry td_capsule_segment(const thud_capsule *capsule) {
    double x = 0.5 * (capsule->x2 - capsule->x1), y = 0.5 * (capsule->y2 - capsule->y1);
    double half = __builtin_sqrt(x * x + y * y);
    thud_geometry segment = {.kind = THUD_SHAPE_CIRCLE,
                             .x = capsule->x1 + x,
                             .y = capsule->y1 + y,
                             .c = 1.0};
    if (half > 0.0) {
        segment.kind = THUD_SHAPE_OBB;
        segment.c = x / half;
        segment.s = y / half;
        segment.hx = half;
    }
    return segment;
}

/* ---- distance ---- */

thud_result thud_capsule_closest(const thud_capsule *a, const thud_geometry *b, thud_closest *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_capsule_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    thud_geometry segment = td_capsule_segment(a);
    td_closest(&segment, b, out);
    td_closest_grow(out, a->radius, 0.0);
    return THUD_OK;
}

thud_result thud_capsules_closest(const thud_capsule *a, const thud_capsule *b, thud_closest *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_capsule_check(a) != THUD_OK || thud_capsule_check(b) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    thud_geometry of_a = td_capsule_segment(a), of_b = td_capsule_segment(b);
    td_closest(&of_a, &of_b, out);
    td_closest_grow(out, a->radius, b->radius);
    return THUD_OK;
}

/* ---- times of impact ---- */

thud_result thud_capsule_time_of_impact(const thud_capsule *a, thud_motion motion_a,
                                        const thud_geometry *b, thud_motion motion_b, double target,
                                        bool *out_hit, double *out_time) {
    if (!a || !b || !out_hit || !out_time) {
        return THUD_ERROR_NULL;
    }
    if (thud_capsule_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK ||
        !td_motion_straight(motion_a) || !td_motion_straight(motion_b) ||
        !td_target_valid(target)) {
        return THUD_ERROR_INVALID;
    }
    thud_geometry segment = td_capsule_segment(a);
    td_time_of_impact(&segment, motion_a, b, motion_b, target + a->radius, out_hit, out_time);
    return THUD_OK;
}

thud_result thud_capsules_time_of_impact(const thud_capsule *a, thud_motion motion_a,
                                         const thud_capsule *b, thud_motion motion_b, double target,
                                         bool *out_hit, double *out_time) {
    if (!a || !b || !out_hit || !out_time) {
        return THUD_ERROR_NULL;
    }
    if (thud_capsule_check(a) != THUD_OK || thud_capsule_check(b) != THUD_OK ||
        !td_motion_straight(motion_a) || !td_motion_straight(motion_b) ||
        !td_target_valid(target)) {
        return THUD_ERROR_INVALID;
    }
    thud_geometry of_a = td_capsule_segment(a), of_b = td_capsule_segment(b);
    td_time_of_impact(&of_a, motion_a, &of_b, motion_b, target + a->radius + b->radius, out_hit,
                      out_time);
    return THUD_OK;
}
