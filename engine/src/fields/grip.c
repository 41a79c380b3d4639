/* grip.c: thud_body_apply_grip: a bounded force that brings a point of a body to a speed along an
 * axis.
 *
 * With n the axis, r the point's lever arm, h the time step and J = (n, r x n), the force along n
 * that brings the point to the speed at the end of the step is f = (speed - J (v + h a)) / (h J
 * M^-1 J'), |f| <= max_force, where a is the acceleration by gravity and the forces that were
 * applied so far. */
#include "fields/fields.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* Transforms a vector from the body's frame to world axes. */
static thud_pos to_world(const td_pose *pose, double x, double y) {
    double c = (double)pose->c, s = (double)pose->s;
    return (thud_pos){c * x - s * y, s * x + c * y};
}

thud_result thud_body_apply_grip(thud_world *w, thud_body_id id, thud_vec2 point, thud_vec2 axis,
                                 float speed, float max_force) {
    TD_IN_OWN_FLOAT_MODE;
    td_field_body a;
    thud_result result = td_field_body_find(w, id, &a);
    if (result != THUD_OK) {
        return result;
    }
    double x = (double)axis.x, y = (double)axis.y, length = __builtin_sqrt(x * x + y * y);
    double max_speed = (double)THUD_FLOW_MAX * (double)w->length_scale;
    td_reason why;
    if (!td_offset_in(w, &why, "apply grip: x or y of point", point) ||
        !td_in(&why, "apply grip: speed", (double)speed, -max_speed, max_speed) ||
        !td_in(&why, "apply grip: max_force", (double)max_force, 0.0, (double)THUD_FORCE_MAX)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    if (!td_finite(length) || length == 0.0) {
        return td_refuse(w, THUD_ERROR_INVALID, "apply grip: axis is 0 or not finite");
    }
    if (!a.takes_force) {
        return THUD_OK;
    }
    const td_body *body = td_body_at(w, a.index);
    const td_pose *pose = td_pose_at(w, a.index);
    double inv_mass = (double)body->inv_mass, inv_inertia = (double)body->inv_inertia;
    thud_pos arm = to_world(pose, (double)point.x - (double)body->center_x,
                            (double)point.y - (double)body->center_y);
    thud_pos n = to_world(pose, x / length, y / length);
    double turn = arm.x * n.y - arm.y * n.x; /* r x n: torque of a unit force along n */
    /* The error of the speed along n at the end of the step, without this force. */
    double time = w->def.time_step, scale = (double)body->gravity_scale;
    double acceleration_x = scale * (double)w->def.gravity.x + inv_mass * (double)body->force[0];
    double acceleration_y = scale * (double)w->def.gravity.y + inv_mass * (double)body->force[1];
    double speed_error = n.x * (a.x + time * acceleration_x) + n.y * (a.y + time * acceleration_y) +
                         turn * (a.turn + time * inv_inertia * (double)body->force[2]) -
                         (double)speed;
    double response = inv_mass * (n.x * n.x + n.y * n.y) + inv_inertia * turn * turn;
    double push = td_min_double(td_abs(speed_error) / (time * response), (double)max_force);
    push = speed_error > 0.0 ? -push : push;
    return td_field_push(w, &a, (td_push){push * n.x, push * n.y, push * turn});
}
