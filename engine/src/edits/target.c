/* target.c: thud_body_set_target, the velocity by which a kinematic body reaches a pose at the end
 * of the next step:
 *
 *     velocity = (target - pose) / T,   T = h * sum_{i=1..n} q^i,   q = exp(-h * damping)
 *
 * n: substeps; h = time_step / n: length of a substep; q: the factor by which damping scales the
 * velocity at the start of each substep (damping.h). Without damping T = time_step. */
#include "thud/thud_forces.h"

#include "base/rotation.h"
#include "solver/damping.h"
#include "solver/motion.h"
#include "state/body.h"
#include "state/handles.h"

/* T as defined at the head of this file, s. */
static double damped_time(const thud_world *w, float damping) {
    float h = (float)w->def.time_step / (float)w->substeps;
    double kept = 1.0 - (double)td_damping_of(h * damping).lost, share = 1.0, sum = 0.0;
    for (int i = 0; i < w->substeps; i++) {
        share *= kept;
        sum += share;
    }
    return sum * (double)h;
}

thud_result thud_body_set_target(thud_world *w, thud_body_id id, thud_pos position, double angle) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const td_body *body = td_body_at(w, index);
    const td_pose *pose = td_pose_at(w, index);
    if (body->kind != THUD_BODY_KINEMATIC) {
        return td_refuse(w, THUD_ERROR_INVALID, "set target: the body is not kinematic");
    }
    result = td_check_place(w, "set target: x or y of position", position.x, position.y);
    if (result == THUD_OK) {
        result = td_check(w, "set target: angle", angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    /* The centre of a body that is not dynamic is its origin. */
    td_position to = td_place_from(w, position);
    double x = (double)(to.x - pose->center.x) / w->to_fixed;
    double y = (double)(to.y - pose->center.y) / w->to_fixed;
    double turn = td_angle_radians(td_angle_from(angle) - pose->angle);
    if (body->aabbs && turn != 0.0) {
        return td_refuse(w, THUD_ERROR_INVALID, "set target: a body with an AABB cannot turn");
    }
    double time = damped_time(w, body->linear_damping);
    double max_speed = (double)(w->def.maximum_speed * w->length_scale);
    double v[3] = {x / time, y / time, turn / damped_time(w, body->angular_damping)};
    if (!(td_abs(v[0]) <= max_speed && td_abs(v[1]) <= max_speed &&
          td_abs(v[2]) <= (double)THUD_ANGULAR_SPEED_MAX)) {
        return td_refuse(w, THUD_ERROR_INVALID, "set target: the body would be too fast");
    }
    const float *now = td_body_velocity(w, body);
    bool stands = now[0] == 0.0f && now[1] == 0.0f && now[2] == 0.0f;
    if (!w->locked && stands && x == 0.0 && y == 0.0 && turn == 0.0) {
        return THUD_OK;
    }
    return thud_body_set_velocity(w, id, (thud_vec2){(float)v[0], (float)v[1]}, (float)v[2]);
}
