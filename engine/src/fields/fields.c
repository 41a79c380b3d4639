/* fields.c: bodies in fields, the poses of their shapes, and the dissipative part of a force; see
 * fields.h. */
#include "fields/fields.h"

#include "base/trig.h"
#include "state/body.h"
#include "state/handles.h"

thud_result td_field_body_find(const thud_world *w, thud_body_id id, td_field_body *out) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "field: not inside a callback");
    }
    const td_body *body = td_body_at(w, index);
    if (body->kind != THUD_BODY_DYNAMIC) {
        return td_refuse(w, THUD_ERROR_INVALID, "field: the body is not dynamic");
    }
    const float *velocity = td_body_velocity(w, body);
    *out = (td_field_body){
        .index = index,
        .x = (double)velocity[0],
        .y = (double)velocity[1],
        .turn = body->inv_inertia > 0.0f ? (double)velocity[2] : 0.0,
        .takes_force = td_body_is_awake(body) && !(body->flags & TD_BODY_QUARANTINED),
    };
    return THUD_OK;
}

thud_result td_field_body_in_flow(const thud_world *w, const char *name, thud_vec2 flow,
                                  td_field_body *a) {
    double max = (double)THUD_FLOW_MAX * (double)w->length_scale;
    a->x -= (double)flow.x;
    a->y -= (double)flow.y;
    thud_result result = td_check(w, name, (double)flow.x, -max, max);
    return result != THUD_OK ? result : td_check(w, name, (double)flow.y, -max, max);
}

thud_geometry td_field_shape(const thud_world *w, const td_field_body *a, const td_shape *shape,
                             double turn) {
    const td_body *body = td_body_at(w, a->index);
    const td_pose *pose = td_pose_at(w, a->index);
    thud_geometry at = {(thud_shape_kind)shape->kind,
                        0.0,
                        0.0,
                        (double)pose->c,
                        (double)pose->s,
                        (double)shape->half_x,
                        (double)shape->half_y};
    /* One Newton step for 1 / sqrt(c^2 + s^2), starting from 1: the vector (c, s) in single
     * precision does not have exactly unit length. */
    double scale = 1.5 - 0.5 * (at.c * at.c + at.s * at.s), c, s;
    td_sincos(td_clamp(turn, -THUD_ANGLE_MAX, THUD_ANGLE_MAX), &s, &c);
    double turned_c = scale * (at.c * c - at.s * s), turned_s = scale * (at.s * c + at.c * s);
    double arm_x = (double)shape->x - (double)body->center_x;
    double arm_y = (double)shape->y - (double)body->center_y;
    at.x = turned_c * arm_x - turned_s * arm_y;
    at.y = turned_s * arm_x + turned_c * arm_y;
    double own_c = (double)shape->angle_c, own_s = (double)shape->angle_s;
    bool turns = shape->kind == THUD_SHAPE_OBB;
    at.c = turns ? turned_c * own_c - turned_s * own_s : 1.0;
    at.s = turns ? turned_s * own_c + turned_c * own_s : 0.0;
    return at;
}

/* Scales the force by the share p in [0, 1] by which it removes the most energy from the motion
 * relative to the flow. */
td_push td_push_dissipative(const thud_world *w, const td_field_body *a, td_push force) {
    const td_body *body = td_body_at(w, a->index);
    double inv_mass = (double)body->inv_mass, inv_inertia = (double)body->inv_inertia;
    double power = -(force.x * a->x + force.y * a->y + force.turn * a->turn);
    double response =
        inv_mass * (force.x * force.x + force.y * force.y) + inv_inertia * force.turn * force.turn;
    /* With force f, velocity u, M = diag(mass, mass, inertia) and h the time step, the share p of
     * the force changes the kinetic energy by
     *     -p h power + p^2 h^2 response / 2,   power = -f u,   response = f M^-1 f,
     * with its minimum at p = power / (h response). */
    double max = w->def.time_step * response;
    if (power >= max) {
        return force;
    }
    double part = power > 0.0 ? power / max : 0.0;
    return (td_push){part * force.x, part * force.y, part * force.turn};
}

/* Adds a force to those that act throughout the next step. */
thud_result td_field_push(thud_world *w, const td_field_body *a, td_push force) {
    if (!td_push_valid(force)) {
        return td_refuse(w, THUD_ERROR_INVALID, "field: its force is out of range");
    }
    if (force.x != 0.0 || force.y != 0.0 || force.turn != 0.0) {
        float *sum = td_body_at(w, a->index)->force;
        sum[0] += (float)force.x;
        sum[1] += (float)force.y;
        sum[2] += (float)force.turn;
        w->substep_gain_stale = true;
    }
    return THUD_OK;
}
