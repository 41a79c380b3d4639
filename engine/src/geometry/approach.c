/* approach.c: how two moving circles pass each other, in closed form. */
#include "geometry/shape_instance.h"

thud_result thud_circles_approach(const thud_shape_instance *a, thud_motion motion_a,
                                  const thud_shape_instance *b, thud_motion motion_b,
                                  thud_approach *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_placed_check(a) != THUD_OK || thud_placed_check(b) != THUD_OK ||
        !td_kind_is_round(a->kind) || !td_kind_is_round(b->kind) || !td_motion_valid(motion_a) ||
        !td_motion_valid(motion_b)) {
        return THUD_ERROR_INVALID;
    }
    td_time_of_impact(a, motion_a, b, motion_b, 0.0, &out->hit, &out->time);
    double x = b->x - a->x, y = b->y - a->y;
    double dx = motion_b.dx - motion_a.dx, dy = motion_b.dy - motion_a.dy;
    double way = __builtin_sqrt(dx * dx + dy * dy);
    /* Along the relative motion and across it; the centres are nearest where nothing is left of the
     * first. Lengths only, no squared ones: they would cancel for circles that start far apart. */
    double ux = way > 0.0 ? dx / way : 1.0, uy = way > 0.0 ? dy / way : 0.0;
    double ahead = -(x * ux + y * uy), side = ux * y - uy * x;
    double part = td_clamp(ahead, 0.0, way), left = ahead - part;
    out->least_time = way > 0.0 ? part / way : 0.0;
    out->least = __builtin_sqrt(left * left + side * side);
    return THUD_OK;
}
