/* approach.c: time of impact and nearest approach of two moving circles, in closed form. For the
 * relative position p, the relative motion d and u = d / |d|, the distance of the centres is least
 * at the time t = -(p . u) / |d|, clamped to [0, 1]. */
#include "geometry/shape_instance.h"

thud_result thud_geometry_approach(const thud_geometry *a, thud_motion motion_a,
                                   const thud_geometry *b, thud_motion motion_b,
                                   thud_approach *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK ||
        !td_kind_is_round(a->kind) || !td_kind_is_round(b->kind) || !td_motion_valid(motion_a) ||
        !td_motion_valid(motion_b)) {
        return THUD_ERROR_INVALID;
    }
    td_time_of_impact(a, motion_a, b, motion_b, 0.0, &out->hit, &out->time);
    double x = b->x - a->x, y = b->y - a->y;
    double dx = motion_b.dx - motion_a.dx, dy = motion_b.dy - motion_a.dy;
    double path = __builtin_sqrt(dx * dx + dy * dy);
    /* Coordinates along the relative motion and across it; the centres are nearest where the first
     * becomes 0. Lengths are computed instead of squares of positions, whose differences would lose
     * precision for circles that start far apart. */
    double ux = path > 0.0 ? dx / path : 1.0, uy = path > 0.0 ? dy / path : 0.0;
    double along = -(x * ux + y * uy), side = ux * y - uy * x;
    double travelled = td_clamp(along, 0.0, path), remaining = along - travelled;
    out->min_distance_time = path > 0.0 ? travelled / path : 0.0;
    out->min_distance = __builtin_sqrt(remaining * remaining + side * side);
    return THUD_OK;
}
