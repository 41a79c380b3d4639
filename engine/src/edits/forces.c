/* forces.c: forces and impulses; see thud_forces.h. */
#include "thud/thud_forces.h"

#include "state/body.h"
#include "state/handles.h"

static bool pushes(double x) {
    return td_abs(x) <= (double)THUD_PUSH_MAX;
}

static thud_result find(const thud_world *w, thud_body_id id, td_body_index *index) {
    thud_result result = td_find_body(w, id, index);
    return result == THUD_OK
               ? td_body_check_dynamic(w, *index, "force or impulse: the body is not dynamic")
               : result;
}

thud_result thud_body_apply_force_at(thud_world *w, thud_body_id id, thud_vec2 force,
                                     thud_pos point) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = find(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    bool valid =
        pushes((double)force.x) && pushes((double)force.y) && td_place_valid(w, point.x, point.y);
    if (valid) {
        thud_pos center = td_place_to(w, td_pose_at(w, index)->center);
        valid = pushes((point.x - center.x) * (double)force.y) &&
                pushes((point.y - center.y) * (double)force.x);
    }
    if (!valid) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "apply force at: force, its torque or point is out of range");
    }
    return td_body_edit(w, index, TD_PUT_FORCE_AT,
                        (double[4]){(double)force.x, (double)force.y, point.x, point.y});
}

static thud_result push(thud_world *w, thud_body_id id, double x, double y, double turn) {
    td_body_index index;
    thud_result result = find(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    double inv_mass = (double)td_body_at(w, index)->inv_mass;
    double inv_inertia = (double)td_body_at(w, index)->inv_inertia;
    if (!(pushes(x) && pushes(y) && pushes(turn) && pushes(x * inv_mass) && pushes(y * inv_mass) &&
          pushes(turn * inv_inertia))) {
        return td_refuse(w, THUD_ERROR_INVALID, "apply impulse: it is out of range");
    }
    return td_body_edit(w, index, TD_PUT_PUSH, (double[4]){x, y, turn, 0.0});
}

thud_result thud_body_apply_center_impulse(thud_world *w, thud_body_id id, thud_vec2 impulse) {
    TD_IN_OWN_MODE;
    return push(w, id, (double)impulse.x, (double)impulse.y, 0.0);
}

thud_result thud_body_apply_angular_impulse(thud_world *w, thud_body_id id, float impulse) {
    TD_IN_OWN_MODE;
    return push(w, id, 0.0, 0.0, (double)impulse);
}
