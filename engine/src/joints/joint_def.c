/* joint_def.c: checks the defs of joints, and converts a def to a td_joint and back. */
#include "joints/joint.h"
#include "state/handles.h"

#include "base/rotation.h"
#include "base/trig.h"

bool td_joint_frame_valid(const thud_world *w, td_reason *why, const thud_joint_frame *f) {
    float max = THUD_JOINT_LENGTH_MAX * w->length_scale;
    return td_float_in(why, "joint: x of a frame's position", f->position.x, -max, max) &&
           td_float_in(why, "joint: y of a frame's position", f->position.y, -max, max) &&
           td_in(why, "joint: angle of a frame", f->angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX);
}

/* The error message for a drive in a direction that this kind of joint does not drive; null if the
 * drive is all default, and so has no effect. */
static const char *undrivable_error(int direction, const thud_drive *d) {
    static const char *const none[TD_JOINT_DIRECTIONS] = {
        "joint drive: this kind of joint has no drive along",
        "joint drive: this kind of joint has no drive across",
        "joint drive: this kind of joint has no drive of turn"};
    bool acts = d->limited || d->frequency != 0.0f || d->motor_force != 0.0f;
    return acts ? none[direction] : NULL;
}

const char *td_joint_drive_error(const thud_world *w, thud_joint_kind kind, int direction,
                                 const thud_drive *d, td_reason *why) {
    bool turns = direction == THUD_DIRECTION_TURN;
    float max_value = turns ? THUD_JOINT_ANGLE_MAX : THUD_JOINT_LENGTH_MAX * w->length_scale;
    float max_speed = turns ? THUD_JOINT_ANGULAR_SPEED_MAX : max_value,
          max_force = THUD_JOINT_FORCE_MAX;
    float min = kind == THUD_JOINT_DISTANCE ? 0.0f : -max_value;
    if (!(td_joint_drivable((int)kind) >> direction & 1u)) {
        return undrivable_error(direction, d);
    }
    bool target_is_length = kind == THUD_JOINT_DISTANCE && td_target_is_length(d->target);
    bool valid =
        (!d->limited || (td_float_in(why, "joint drive: lower", d->lower, min, max_value) &&
                         td_float_in(why, "joint drive: upper", d->upper, min, max_value))) &&
        td_float_in(why, "joint drive: frequency", d->frequency, 0.0f, THUD_JOINT_FREQUENCY_MAX) &&
        td_float_in(why, "joint drive: damping", d->damping, 0.0f, THUD_JOINT_DAMPING_MAX) &&
        (target_is_length || td_float_in(why, "joint drive: target", d->target, min, max_value)) &&
        td_float_in(why, "joint drive: spring_force", d->spring_force, 0.0f, max_force) &&
        td_float_in(why, "joint drive: motor_speed", d->motor_speed, -max_speed, max_speed) &&
        td_float_in(why, "joint drive: motor_force", d->motor_force, 0.0f, max_force);
    if (!valid) {
        return why->text;
    }
    return d->limited && d->lower > d->upper ? "joint drive: lower is above upper" : NULL;
}

void td_joint_warn_of_drive(const thud_world *w, const thud_drive *d) {
    if (d->motor_speed != 0.0f && d->motor_force == 0.0f) {
        td_refuse(w, THUD_OK, "joint drive: motor_speed without a motor_force drives nothing");
    }
}

static bool is_dynamic(const thud_world *w, td_body_index body) {
    return td_body_at(w, body)->kind == THUD_BODY_DYNAMIC;
}

const char *td_joint_def_error(const thud_world *w, const thud_joint_def *d, td_body_index a,
                               td_body_index b, td_reason *why) {
    if (d->cookie != TD_COOKIE) {
        return "joint_create: the def does not start from thud_default_joint_def()";
    }
    if ((int)d->kind < 0 || d->kind >= THUD_JOINT_KIND_COUNT) {
        return "joint create: kind is none";
    }
    if (d->kind == THUD_JOINT_GEAR && td_same_body(a, b)) {
        return "joint create: both joints of a gear move the same body";
    }
    float min = d->ratio < 0.0f ? -THUD_GEAR_RATIO_MAX : THUD_GEAR_RATIO_MIN;
    float max = d->ratio < 0.0f ? -THUD_GEAR_RATIO_MIN : THUD_GEAR_RATIO_MAX;
    if (d->kind == THUD_JOINT_GEAR &&
        !td_float_in(why, "joint create: ratio", d->ratio, min, max)) {
        return why->text;
    }
    if (td_same_body(a, b) || (!is_dynamic(w, a) && !is_dynamic(w, b))) {
        return "joint create: needs two bodies, one dynamic";
    }
    if ((d->kind == THUD_JOINT_WHEEL || d->kind == THUD_JOINT_TARGET) && !is_dynamic(w, b)) {
        return "joint create: body b of a wheel or target must be dynamic";
    }
    if (!td_joint_frame_valid(w, why, &d->frame_a) || !td_joint_frame_valid(w, why, &d->frame_b) ||
        (d->kind == THUD_JOINT_DISTANCE &&
         !td_above_0(why, "joint create: length", (double)d->length,
                     (double)(THUD_JOINT_LENGTH_MAX * w->length_scale))) ||
        !td_joint_break_valid(why, "joint create: break_force", d->break_force) ||
        !td_joint_break_valid(why, "joint create: break_torque", d->break_torque)) {
        return why->text;
    }
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        const char *error = td_joint_drive_error(w, d->kind, i, &d->drive[i], why);
        if (error) {
            return error;
        }
    }
    return NULL;
}

thud_joint_def thud_default_joint_def(thud_joint_kind kind) {
    thud_joint_def def = {.kind = kind,
                          .length = 1.0f,
                          .enabled = true,
                          .ratio = 1.0f,
                          .collide_connected = kind == THUD_JOINT_GEAR,
                          .break_force = THUD_JOINT_FORCE_MAX,
                          .break_torque = THUD_JOINT_FORCE_MAX,
                          .cookie = TD_COOKIE};
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        def.drive[i].damping = 0.7f;
        def.drive[i].spring_force = THUD_JOINT_FORCE_MAX;
    }
    if (kind == THUD_JOINT_DISTANCE) {
        def.drive[THUD_DIRECTION_ALONG].target = -__builtin_inff();
    }
    return def;
}

td_drive td_drive_of(const thud_drive *d) {
    return (td_drive){.limited = d->limited,
                      /* Unused limits were not checked, and may be not-a-number. */
                      .lower = d->limited ? d->lower : 0.0f,
                      .upper = d->limited ? d->upper : 0.0f,
                      .frequency = d->frequency,
                      .damping = d->damping,
                      .target = d->target,
                      .spring_force = d->spring_force,
                      .motor_speed = d->motor_speed,
                      .motor_force = d->motor_force};
}

void td_joint_set_place(td_joint *joint, int side, const thud_joint_frame *f) {
    joint->anchor[side][0] = f->position.x;
    joint->anchor[side][1] = f->position.y;
    uint32_t angle = td_angle_from(f->angle);
    joint->turn += side == 0 ? angle - joint->angle[0] : joint->angle[1] - angle;
    joint->angle[side] = angle;
    if (side == 0) {
        double s, c, sign = joint->swapped ? -1.0 : 1.0;
        td_sincos(f->angle, &s, &c);
        joint->axis_c = (float)(sign * c);
        joint->axis_s = (float)(sign * s);
    }
}

td_joint td_joint_of_def(const thud_world *w, const thud_joint_def *d, td_body_index a,
                         td_body_index b) {
    bool swapped = td_body_at(w, b)->kind == THUD_BODY_STATIC;
    td_joint joint = {.body = {swapped ? b : a, swapped ? a : b},
                      .part = {TD_NONE, TD_NONE, TD_NONE, TD_NONE},
                      .kind = (uint8_t)d->kind,
                      .live = 1,
                      .disabled = !d->enabled,
                      .collides = d->collide_connected,
                      .swapped = swapped,
                      .length = d->length,
                      .only_reports = d->only_reports,
                      .break_force = d->break_force,
                      .break_torque = d->break_torque,
                      .user_data = d->user_data};
    for (int i = 0; i < TD_JOINT_DIRECTIONS && d->kind != THUD_JOINT_GEAR; i++) {
        joint.drive[i] = td_drive_of(&d->drive[i]);
    }
    td_joint_set_place(&joint, swapped, &d->frame_a);
    td_joint_set_place(&joint, !swapped, &d->frame_b);
    return joint;
}

/* ---- reading ---- */

/* The frame in body[side]. */
static thud_joint_frame frame_of(const td_joint *joint, int side) {
    return (thud_joint_frame){{joint->anchor[side][0], joint->anchor[side][1]},
                              td_angle_radians(joint->angle[side])};
}

/* Copies the drives of the directions that the kind allows to drive; others keep their defaults. */
static void read_drives(const td_joint *joint, thud_joint_def *def) {
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        const td_drive *d = &joint->drive[i];
        if (td_joint_drivable(joint->kind) >> i & 1u) {
            def->drive[i] =
                (thud_drive){d->limited, d->lower,        d->upper,       d->frequency,  d->damping,
                             d->target,  d->spring_force, d->motor_speed, d->motor_force};
        }
    }
}

thud_result thud_joint_get_def(const thud_world *w, thud_joint_id id, thud_joint_def *out) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, false, &index);
    if (result != THUD_OK || !out) {
        return result != THUD_OK ? result : td_refuse(w, THUD_ERROR_NULL, "joint get: out is null");
    }
    const td_joint *joint = td_joint_at(w, index);
    thud_joint_def def = thud_default_joint_def((thud_joint_kind)joint->kind);
    def.body_a = td_body_handle(w, joint->body[joint->swapped]);
    def.body_b = td_body_handle(w, joint->body[!joint->swapped]);
    def.frame_a = frame_of(joint, joint->swapped);
    def.frame_b = frame_of(joint, !joint->swapped);
    read_drives(joint, &def);
    if (joint->kind == THUD_JOINT_GEAR) {
        def.gear[0] = td_joint_handle(w, joint->gear.joint[0]);
        def.gear[1] = td_joint_handle(w, joint->gear.joint[1]);
        def.ratio = joint->gear.ratio;
    }
    def.length = joint->length;
    def.collide_connected = joint->collides;
    def.break_force = joint->break_force;
    def.break_torque = joint->break_torque;
    def.only_reports = joint->only_reports;
    def.enabled = !joint->disabled;
    def.user_data = joint->user_data;
    *out = def;
    return THUD_OK;
}
