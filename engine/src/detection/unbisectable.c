/* unbisectable.c: see unbisectable.h. The test is that of thud_geometry_is_bisectable
 * (geometry/bisect.c), for a body against the thinnest shape of the world. */
#include "detection/unbisectable.h"

#include "detection/detection.h"
#include "geometry/shape_instance.h"
#include "state/shape.h"

/* The greatest distance from the centre of mass of any point that a rotation of the body moves. A
 * circle about the centre of mass looks the same in every rotation, and does not count. 0 if that
 * distance is at most min_extent plus half of `thickness`, the thickness of the thinnest shape:
 * then no rotation takes a corner through the middle of another shape, as in
 * thud_geometry_is_bisectable. */
static double turning_reach(const thud_world *w, const td_body *body, double thickness) {
    double reach = 0.0;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *s = td_shape_at(w, i);
        double x = (double)s->arm_x, y = (double)s->arm_y, hx = (double)s->half_x,
               hy = (double)s->half_y;
        double own = td_kind_turns(s->kind) ? __builtin_sqrt(hx * hx + hy * hy) : 0.0;
        reach = td_max_double(reach, __builtin_sqrt(x * x + y * y) + own);
    }
    return reach > (double)body->min_extent + 0.5 * thickness ? reach : 0.0;
}

bool td_is_unbisectable(thud_world *w, td_awake_slot slot) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    if (!w->detections[TD_RANK_BISECT] ||
        (body->kind == THUD_BODY_DYNAMIC && body->detection->rank > TD_RANK_BISECT)) {
        return false;
    }
    const float *delta = td_row(&w->delta, slot);
    double x = (double)delta[0], y = (double)delta[1], turn = td_abs((double)delta[2]);
    double thickness = (double)td_thinnest(w);
    double reach_left = thickness - (turn > 0.0 ? turn * turning_reach(w, body, thickness) : 0.0);
    return !(reach_left > 0.0 && x * x + y * y < reach_left * reach_left);
}
