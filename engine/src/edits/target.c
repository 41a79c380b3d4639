/* target.c: a kinematic body's way to a pose; see thud_forces.h. */
#include "thud/thud_forces.h"

#include "base/rotation.h"
#include "solver/motion.h"
#include "state/body.h"
#include "state/handles.h"

/* The time for which a velocity counts that is damped in each substep, as wide_motion.c has it. */
static double time_of(const thud_world *w, float damping) {
    float h = (float)w->def.time_step / (float)w->substeps;
    double left = 1.0, sum = 0.0;
    for (int i = 0; i < w->substeps; i++) {
        left *= (double)(1.0f / (1.0f + h * damping));
        sum += left;
    }
    return sum * (double)h;
}

thud_result thud_body_set_target(thud_world *w, thud_body_id id, thud_pos position, double angle) {
    TD_IN_OWN_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const td_body *body = td_body_at(w, index);
    const td_pose *pose = td_pose_at(w, index);
    if (body->kind != THUD_KINEMATIC) {
        return td_refuse(w, THUD_ERROR_INVALID, "set target: the body is not kinematic");
    }
    result = td_check_place(w, "set target: x or y of position", position.x, position.y);
    if (result == THUD_OK) {
        result = td_check(w, "set target: angle", angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    /* Of what is not dynamic the origin is the centre. */
    td_position to = td_place_from(w, position);
    double x = (double)(to.x - pose->center.x) / w->to_fixed;
    double y = (double)(to.y - pose->center.y) / w->to_fixed;
    double turn = td_angle_radians(td_angle_from(angle) - pose->angle);
    if (body->aabbs && turn != 0.0) {
        return td_refuse(w, THUD_ERROR_INVALID, "set target: a body with an AABB cannot turn");
    }
    double time = time_of(w, body->linear_damping);
    double most = (double)(w->def.maximum_speed * w->unit);
    double v[3] = {x / time, y / time, turn / time_of(w, body->angular_damping)};
    if (!(td_abs(v[0]) <= most && td_abs(v[1]) <= most && td_abs(v[2]) <= (double)THUD_SPIN_MAX)) {
        return td_refuse(w, THUD_ERROR_INVALID, "set target: the body would be too fast");
    }
    const float *now = td_body_velocity(w, body);
    bool stands = now[0] == 0.0f && now[1] == 0.0f && now[2] == 0.0f;
    if (!w->locked && stands && x == 0.0 && y == 0.0 && turn == 0.0) {
        return THUD_OK;
    }
    return thud_body_set_velocity(w, id, (thud_vec2){(float)v[0], (float)v[1]}, (float)v[2]);
}
