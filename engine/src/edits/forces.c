/* forces.c: a force at a point, and impulses at the centre of mass; see thud_forces.h. */
#include "thud/thud_forces.h"

#include "state/body.h"
#include "state/handles.h"

/* Whether |x| <= THUD_FORCE_MAX; false for NaN. */
static bool is_push(double x) {
    return td_abs(x) <= (double)THUD_FORCE_MAX;
}

/* Finds a dynamic body. */
static thud_result find(const thud_world *w, thud_body_id id, td_body_index *index) {
    thud_result result = td_find_body(w, id, index);
    return result == THUD_OK && td_body_at(w, *index)->kind != THUD_BODY_DYNAMIC
               ? td_refuse(w, THUD_ERROR_INVALID, "force or impulse: the body is not dynamic")
               : result;
}

thud_result thud_body_apply_force(thud_world *w, thud_body_id id, thud_vec2 force, thud_pos point) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = find(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    double max = (double)THUD_FORCE_MAX;
    td_reason why;
    if (!td_in(&why, "apply force: x of force", (double)force.x, -max, max) ||
        !td_in(&why, "apply force: y of force", (double)force.y, -max, max) ||
        !td_in_world(w, &why, "apply force: x or y of point", point.x, point.y)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    td_position place = td_place_from(w, point), center = td_pose_at(w, index)->center;
    /* torque = x - y = arm.x * force.y - arm.y * force.x */
    double x = (double)(place.x - center.x) / w->to_fixed * (double)force.y;
    double y = (double)(place.y - center.y) / w->to_fixed * (double)force.x;
    if (!(is_push(x) && is_push(y) && is_push(x - y))) {
        return td_refuse(w, THUD_ERROR_INVALID, "apply force: its torque is out of range");
    }
    return td_body_apply_force(w, id, force, (float)(x - y));
}

/* Applies the impulse (x, y) at the centre of mass and the angular impulse `turn`. Inside a
 * callback it becomes the force impulse / time_step through the next step. */
static thud_result apply_impulse(thud_world *w, thud_body_id id, double x, double y, double turn) {
    td_body_index index;
    thud_result result = find(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_body *body = td_body_at(w, index);
    double time = w->locked ? w->def.time_step : 1.0;
    double inv_mass = (double)body->inv_mass, inv_inertia = (double)body->inv_inertia;
    if (!(is_push(x / time) && is_push(y / time) && is_push(turn / time) && is_push(x * inv_mass) &&
          is_push(y * inv_mass) && is_push(turn * inv_inertia))) {
        return td_refuse(w, THUD_ERROR_INVALID, "apply impulse: it is out of range");
    }
    if (w->locked) {
        thud_vec2 force = {(float)(x / time), (float)(y / time)};
        return td_body_apply_force(w, id, force, (float)(turn / time));
    }
    if (!(body->flags & TD_BODY_QUARANTINED)) {
        float *velocity = td_body_velocity(w, body);
        velocity[0] += body->inv_mass * (float)x;
        velocity[1] += body->inv_mass * (float)y;
        velocity[2] += body->inv_inertia * (float)turn;
        td_body_mark(w, index, TD_CHANGE_WAKE);
    }
    return THUD_OK;
}

thud_result thud_body_apply_center_impulse(thud_world *w, thud_body_id id, thud_vec2 impulse) {
    TD_IN_OWN_FLOAT_MODE;
    return apply_impulse(w, id, (double)impulse.x, (double)impulse.y, 0.0);
}

thud_result thud_body_apply_angular_impulse(thud_world *w, thud_body_id id, float impulse) {
    TD_IN_OWN_FLOAT_MODE;
    return apply_impulse(w, id, 0.0, 0.0, (double)impulse);
}
