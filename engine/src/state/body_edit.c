/* body_edit.c: edits of a body's pose, velocity, forces and state. Outside callbacks an edit
 * changes the body's own record at once, and the change list (changes.c) does the rest as the next
 * step begins. Inside a callback the whole edit is deferred to the start of the next step. */
#include "state/awake.h"
#include "state/body.h"
#include "state/handles.h"
#include "base/rotation.h"

/* ---- the edits: each takes the four values of td_deferred_kind ---- */

static void set_transform(thud_world *w, td_body_index index, const double v[4]) {
    td_body *body = td_body_at(w, index);
    td_pose *pose = td_pose_at(w, index);
    pose->angle = td_angle_from(v[2]);
    td_angle_turn(pose->angle, &pose->c, &pose->s);
    td_position origin = td_place_from(w, (thud_pos){v[0], v[1]});
    float x = pose->c * body->center_x - pose->s * body->center_y;
    float y = pose->s * body->center_x + pose->c * body->center_y;
    pose->center = (td_position){origin.x + td_length_from(w, x), origin.y + td_length_from(w, y)};
    td_body_mark(w, index, TD_CHANGE_PLACE);
}

static void set_velocity(thud_world *w, td_body_index index, const double v[4]) {
    td_body *body = td_body_at(w, index);
    float *velocity = td_body_velocity(w, body);
    velocity[0] = (float)v[0];
    velocity[1] = (float)v[1];
    velocity[2] = body->kind == THUD_BODY_DYNAMIC && body->inv_inertia == 0.0f ? 0.0f : (float)v[2];
    td_body_mark(w, index, TD_CHANGE_WAKE);
}

/* An impulse (v[0], v[1]) at the point (v[2], v[3]) of the world. Its moment is a double: as
 * a float it may be infinite, and a body that cannot turn would multiply it by 0, which is NaN. */
static void add_impulse(thud_world *w, td_body_index index, const double v[4]) {
    td_body *body = td_body_at(w, index);
    const td_pose *pose = td_pose_at(w, index);
    float *velocity = td_body_velocity(w, body);
    td_position point = td_place_from(w, (thud_pos){v[2], v[3]});
    float x = (float)(point.x - pose->center.x) * w->quantum;
    float y = (float)(point.y - pose->center.y) * w->quantum;
    velocity[0] += body->inv_mass * (float)v[0];
    velocity[1] += body->inv_mass * (float)v[1];
    velocity[2] += (float)(body->inv_inertia * (x * v[1] - y * v[0]));
    td_body_mark(w, index, TD_CHANGE_WAKE);
}

static void add_force(thud_world *w, td_body_index index, const double v[4]) {
    td_body *body = td_body_at(w, index);
    body->force[0] += (float)v[0];
    body->force[1] += (float)v[1];
    body->force[2] += (float)v[2];
    w->substep_gain_stale = true;
    td_body_mark(w, index, TD_CHANGE_WAKE);
}

static void set_awake(thud_world *w, td_body_index index, const double v[4]) {
    td_body_mark(w, index, v[0] != 0.0 ? TD_CHANGE_WAKE : TD_CHANGE_SLEEP);
}

static void set_enabled(thud_world *w, td_body_index index, const double v[4]) {
    td_body *body = td_body_at(w, index);
    uint8_t flags = (uint8_t)(body->flags & ~TD_BODY_DISABLED);
    flags |= v[0] != 0.0 ? 0 : TD_BODY_DISABLED;
    if (flags != body->flags) {
        body->flags = flags;
        td_body_mark(w, index, TD_CHANGE_ENABLE);
    }
}

/* Edits of a quarantined body have no effect: the engine has stopped it because its numbers were
 * not finite. */
void td_edit_apply(thud_world *w, td_body_index index, td_deferred_kind what, const double v[4]) {
    static void (*const EDITS[])(thud_world *, td_body_index,
                                 const double[4]) = {set_transform, set_velocity, add_impulse,
                                                     add_force,     set_awake,    set_enabled};
    if (!(td_body_at(w, index)->flags & TD_BODY_QUARANTINED)) {
        EDITS[what](w, index, v);
    }
}

/* From now on a shape that a callback has made has mass and contacts, even if its body is
 * quarantined. */
static void put_shape(thud_world *w, td_body_index index, int shape) {
    td_shape_at(w, shape)->flags &= (uint8_t)~TD_SHAPE_WAITS;
    if (td_body_at(w, index)->kind != THUD_BODY_STATIC) {
        td_body_weigh(w, index);
    }
}

/* Applies what callbacks have deferred, in the order of the calls. */
void td_deferred_apply(thud_world *w) {
    int kept_count = 0;
    for (int i = 0; i < w->deferred.count; i++) {
        td_deferred_edit edit = *TD_AT(td_deferred_edit, &w->deferred, i);
        const td_body *body = td_body_at(w, edit.body);
        if (!(body->flags & TD_BODY_LIVE) || body->generation != edit.generation) {
            continue;
        }
        /* A force deferred by a callback acts for one whole step. If it were applied before the
         * step has begun, it would count as a force given between two calls of thud_world_advance,
         * which acts only for the time that passes in the call. So it stays deferred, and only
         * wakes the body now. */
        if (edit.what == TD_PUT_SHAPE) {
            put_shape(w, edit.body, (int)edit.value[0]);
        } else if (edit.what == TD_PUT_FORCE && !w->locked) {
            w->edit_apply(w, edit.body, TD_PUT_AWAKE, (double[4]){1.0});
            *TD_AT(td_deferred_edit, &w->deferred, kept_count++) = edit;
        } else {
            w->edit_apply(w, edit.body, (td_deferred_kind)edit.what, edit.value);
        }
    }
    w->deferred.count = kept_count;
}

bool td_deferred_reserve(thud_world *w, int count) {
    return !w->locked || td_array_reserve(&w->memory, &w->deferred, w->deferred.count + count);
}

void td_deferred_add(thud_world *w, td_body_index index, td_deferred_kind what, const double v[4]) {
    TD_PUSH(td_deferred_edit, &w->deferred) =
        (td_deferred_edit){.body = index,
                           .generation = td_body_at(w, index)->generation,
                           .what = (int32_t)what,
                           .value = {v[0], v[1], v[2], v[3]}};
}

/* Whether a deferred edit will rotate the body, so that it cannot get an AABB or a line. */
bool td_deferred_turns(const thud_world *w, td_body_index index) {
    bool rotates = false, kinematic = td_body_at(w, index)->kind == THUD_BODY_KINEMATIC;
    for (int i = 0; i < w->deferred.count; i++) {
        const td_deferred_edit *edit = TD_AT(td_deferred_edit, &w->deferred, i);
        rotates |= td_same_body(edit->body, index) && edit->value[2] != 0.0 &&
                   (edit->what == TD_PUT_TRANSFORM || (edit->what == TD_PUT_VELOCITY && kinematic));
    }
    return rotates;
}

/* Applies an edit, or defers it inside a callback. */
static thud_result apply_or_defer(thud_world *w, td_body_index index, td_deferred_kind what,
                                  const double v[4]) {
    if (!w->locked) {
        td_edit_apply(w, index, what, v);
        return THUD_OK;
    }
    if (!td_deferred_reserve(w, 1)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "body edit: out of memory");
    }
    w->edit_apply = td_edit_apply;
    td_deferred_add(w, index, what, v);
    return THUD_OK;
}

/* Refuses a body that is not dynamic. */
static thud_result check_dynamic(const thud_world *w, td_body_index index, const char *message) {
    return td_body_at(w, index)->kind == THUD_BODY_DYNAMIC
               ? THUD_OK
               : td_refuse(w, THUD_ERROR_INVALID, message);
}

thud_result thud_body_set_transform(thud_world *w, thud_body_id id, thud_pos position,
                                    double angle) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_place(w, "set transform: x or y of position", position.x, position.y);
    if (result == THUD_OK) {
        result = td_check(w, "set transform: angle", angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    const td_body *body = td_body_at(w, index);
    bool upright = body->aabbs > 0;
    for (int i = body->first_shape; i != TD_NONE && !upright; i = td_shape_at(w, i)->next) {
        upright = td_kind_is_line(td_shape_at(w, i)->kind);
    }
    if (upright && angle != 0.0) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "set transform: a body with an AABB or terrain keeps angle 0");
    }
    return apply_or_defer(w, index, TD_PUT_TRANSFORM,
                          (double[4]){position.x, position.y, angle, 0.0});
}

thud_result thud_body_set_velocity(thud_world *w, thud_body_id id, thud_vec2 velocity,
                                   float angular_velocity) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_finite(w, "set velocity: velocity or angular_velocity", velocity.x,
                             velocity.y, angular_velocity);
    if (result != THUD_OK) {
        return result;
    }
    const td_body *body = td_body_at(w, index);
    if (body->kind == THUD_BODY_STATIC) {
        return td_refuse(w, THUD_ERROR_INVALID, "set velocity: the body is static");
    }
    if (body->kind == THUD_BODY_KINEMATIC && body->aabbs && angular_velocity != 0.0f) {
        return td_refuse(w, THUD_ERROR_INVALID, "set velocity: a body with an AABB cannot turn");
    }
    return apply_or_defer(w, index, TD_PUT_VELOCITY,
                          (double[4]){(double)velocity.x, (double)velocity.y,
                                      (double)angular_velocity, 0.0});
}

thud_result thud_body_apply_impulse(thud_world *w, thud_body_id id, thud_vec2 value,
                                    thud_pos point) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_finite(w, "apply impulse: impulse", value.x, value.y, 0.0f);
    if (result == THUD_OK) {
        result = td_check_place(w, "apply impulse: x or y of point", point.x, point.y);
    }
    if (result == THUD_OK) {
        result = check_dynamic(w, index, "apply impulse: the body is not dynamic");
    }
    return result != THUD_OK
               ? result
               : apply_or_defer(w, index, TD_PUT_IMPULSE,
                                (double[4]){(double)value.x, (double)value.y, point.x, point.y});
}

thud_result td_body_apply_force(thud_world *w, thud_body_id id, thud_vec2 value, float torque) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_finite(w, "apply force: force or torque", value.x, value.y, torque);
    if (result == THUD_OK) {
        result = check_dynamic(w, index, "apply force: the body is not dynamic");
    }
    return result != THUD_OK
               ? result
               : apply_or_defer(w, index, TD_PUT_FORCE,
                                (double[4]){(double)value.x, (double)value.y, (double)torque, 0.0});
}

thud_result thud_body_apply_center_force(thud_world *w, thud_body_id id, thud_vec2 force) {
    TD_IN_OWN_FLOAT_MODE;
    return td_body_apply_force(w, id, force, 0.0f);
}

thud_result thud_body_apply_torque(thud_world *w, thud_body_id id, float torque) {
    TD_IN_OWN_FLOAT_MODE;
    return td_body_apply_force(w, id, (thud_vec2){0.0f, 0.0f}, torque);
}

thud_result thud_body_set_awake(thud_world *w, thud_body_id id, bool awake) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = check_dynamic(w, index, "set awake: the body is not dynamic");
    return result != THUD_OK
               ? result
               : apply_or_defer(w, index, TD_PUT_AWAKE, (double[4]){awake ? 1.0 : 0.0});
}

thud_result thud_body_set_enabled(thud_world *w, thud_body_id id, bool enabled) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    return result != THUD_OK
               ? result
               : apply_or_defer(w, index, TD_PUT_ENABLED, (double[4]){enabled ? 1.0 : 0.0});
}
