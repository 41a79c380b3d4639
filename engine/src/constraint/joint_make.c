/* joint_make.c: making, changing and ending joints; see thud_joint.h. */
#include "constraint/joining.h"
#include "constraint/joint.h"
#include "islands/island_solve.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

#include "base/rotation.h"
#include "base/trig.h"

/* ---- what is valid ---- */

#define LENGTH_MOST 1e6f /* length scales */
#define FREQUENCY_MOST 1e4f
#define DAMPING_MOST 1e3f
#define ANGLE_MOST 1e6

static bool within(float x, float least, float most) {
    return x >= least && x <= most;
}

static bool is_frame(const thud_world *w, const thud_joint_frame *f) {
    float most = LENGTH_MOST * w->unit;
    return within(f->position.x, -most, most) && within(f->position.y, -most, most) &&
           f->angle >= -ANGLE_MOST && f->angle <= ANGLE_MOST;
}

static bool is_drive(const thud_world *w, thud_joint_kind kind, int direction,
                     const thud_drive *d) {
    float most = LENGTH_MOST * w->unit, least = kind == THUD_DISTANCE ? 0.0f : -most;
    float furthest = direction == THUD_TURN ? 3.14159f : most;
    least = direction == THUD_TURN ? -furthest : least;
    bool limits = d->lower <= d->upper && within(d->lower, least, furthest) &&
                  within(d->upper, least, furthest);
    float fastest = direction == THUD_TURN ? LENGTH_MOST : most;
    return (limits || !d->limited) && within(d->frequency, 0.0f, FREQUENCY_MOST) &&
           within(d->damping, 0.0f, DAMPING_MOST) && within(d->target, least, furthest) &&
           within(d->spring_force, 0.0f, THUD_JOINT_FORCE_MAX) &&
           within(d->motor_speed, -fastest, fastest) &&
           within(d->motor_force, 0.0f, THUD_JOINT_FORCE_MAX);
}

static bool is_dynamic(const thud_world *w, td_body_index body) {
    return td_body_at(w, body)->kind == THUD_DYNAMIC;
}

/* Why not, or null. */
static const char *def_error(const thud_world *w, const thud_joint_def *d, td_body_index a,
                             td_body_index b) {
    if ((int)d->kind < 0 || d->kind >= THUD_JOINT_KIND_COUNT) {
        return "joint create: kind is none";
    }
    if (td_same_body(a, b) || (!is_dynamic(w, a) && !is_dynamic(w, b))) {
        return "joint create: needs two bodies, one of them dynamic";
    }
    if ((d->kind == THUD_WHEEL || d->kind == THUD_TARGET) && !is_dynamic(w, b)) {
        return "joint create: body b of a wheel or a target must be dynamic";
    }
    if (!is_frame(w, &d->frame_a) || !is_frame(w, &d->frame_b)) {
        return "joint create: a frame is out of range";
    }
    if (d->kind == THUD_DISTANCE && !(d->length > 0.0f && d->length <= LENGTH_MOST * w->unit)) {
        return "joint create: length is out of range";
    }
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        if ((td_joint_drivable((int)d->kind) >> i & 1u) && !is_drive(w, d->kind, i, &d->drive[i])) {
            return "joint create: a drive is out of range";
        }
    }
    return NULL;
}

/* ---- making and ending them ---- */

thud_joint_def thud_default_joint_def(thud_joint_kind kind) {
    thud_joint_def def = {.kind = kind, .length = 1.0f};
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        def.drive[i].damping = 0.7f;
        def.drive[i].spring_force = THUD_JOINT_FORCE_MAX;
    }
    return def;
}

static td_drive drive_of(const thud_drive *d) {
    return (td_drive){.limited = d->limited,
                      /* Of what is not limited nobody looked at the limits. */
                      .lower = d->limited ? d->lower : 0.0f,
                      .upper = d->limited ? d->upper : 0.0f,
                      .frequency = d->frequency,
                      .damping = d->damping,
                      .target = d->target,
                      .spring_force = d->spring_force,
                      .motor_speed = d->motor_speed,
                      .motor_force = d->motor_force};
}

static td_joint joint_of(const thud_world *w, const thud_joint_def *d, td_body_index a,
                         td_body_index b) {
    bool swapped = td_body_at(w, b)->kind == THUD_STATIC;
    const thud_joint_frame *first = swapped ? &d->frame_b : &d->frame_a;
    const thud_joint_frame *second = swapped ? &d->frame_a : &d->frame_b;
    double s, c, sign = swapped ? -1.0 : 1.0;
    td_sincos(first->angle, &s, &c);
    td_joint joint = {.body = {swapped ? b : a, swapped ? a : b},
                      .part = {TD_NONE, TD_NONE, TD_NONE, TD_NONE},
                      .kind = (uint8_t)d->kind,
                      .live = 1,
                      .disabled = d->disabled,
                      .collides = d->collide_connected,
                      .swapped = swapped,
                      .anchor = {{first->position.x, first->position.y},
                                 {second->position.x, second->position.y}},
                      .axis_c = (float)(sign * c),
                      .axis_s = (float)(sign * s),
                      .turn = td_angle_from(first->angle) - td_angle_from(second->angle),
                      .length = d->length,
                      .user_data = d->user_data};
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        joint.drive[i] = drive_of(&d->drive[i]);
    }
    return joint;
}

static bool has_part(const td_joint *joint, int part) {
    unsigned driven = td_joint_driven(joint);
    /* One part is always there, so that the bodies know of the joint. */
    return part == TD_JOINT_HOLD ? td_joint_locked(joint) || !driven : driven >> part & 1u;
}

static bool reserve_parts(thud_world *w, int kind) {
    int more[TD_CONSTRAINT_KINDS] = {0};
    td_joint joint = {.kind = (uint8_t)kind};
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        more[td_joint_part_kind(&joint, i)]++;
    }
    return td_constraints_reserve(w, more);
}

static void wake(thud_world *w, const td_joint *joint) {
    td_body_mark(w, joint->body[0], TD_CHANGE_WAKE);
    td_body_mark(w, joint->body[1], TD_CHANGE_WAKE);
}

static const td_joining_ops joining = {td_joints_engage, td_joints_suspend, td_joints_keep_apart,
                                       td_joints_leave, td_island_solve_joints};

static void plug(thud_world *w) {
    w->kinds[TD_CONSTRAINT_ROD] = td_rod_ops(w);
    w->kinds[TD_CONSTRAINT_HOLD] = td_hold_ops(w);
    for (int kind = TD_CONSTRAINT_DRIVE_LINE; kind < TD_CONSTRAINT_KINDS; kind++) {
        w->kinds[kind] = td_drive_ops(w, kind);
    }
    w->joining = &joining;
}

thud_result thud_world_use_joints(thud_world *w) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "use joints: not inside a callback");
    }
    plug(w);
    return THUD_OK;
}

/* Gives it the parts that it needs, and takes the others away; room is reserved. */
static void settle_parts(thud_world *w, int index) {
    td_joint *joint = td_joint_at(w, index);
    for (int part = TD_JOINT_PARTS - 1; part >= 0; part--) {
        if (has_part(joint, part) && joint->part[part] == TD_NONE) {
            int kind = td_joint_part_kind(joint, part);
            int made = td_constraint_create(w, kind, joint->body[0], joint->body[1]);
            td_constraint_at(w, made)->joint = index;
            joint->part[part] = made;
        }
    }
    for (int part = 0; part < TD_JOINT_PARTS; part++) {
        if (!has_part(joint, part) && joint->part[part] != TD_NONE) {
            td_constraint_destroy(w, joint->part[part]);
        }
    }
    plug(w);
    wake(w, joint);
}

static thud_joint_id handle_of(const thud_world *w, int index) {
    return (thud_joint_id){(uint32_t)index + 1, td_tag(w, td_joint_at(w, index)->generation)};
}

thud_result thud_joint_create(thud_world *w, const thud_joint_def *def, thud_joint_id *out) {
    TD_IN_OWN_MODE;
    td_body_index a, b;
    if (!w || !def) {
        return td_refuse(w, THUD_ERROR_NULL, "joint create: world or def is null");
    }
    thud_result result = td_find_body(w, def->body_a, &a);
    result = result == THUD_OK ? td_find_body(w, def->body_b, &b) : result;
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "joint create: not inside a callback");
    }
    const char *error = def_error(w, def, a, b);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (!td_slots_reserve(&w->memory, &w->joints, 1) || !reserve_parts(w, (int)def->kind)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "joint create: out of memory");
    }
    int index = td_slots_take(&w->joints);
    td_joint *joint = td_joint_at(w, index);
    uint32_t generation = joint->generation;
    *joint = joint_of(w, def, a, b);
    joint->generation = generation;
    settle_parts(w, index);
    if (out) {
        *out = handle_of(w, index);
    }
    return THUD_OK;
}

/* Shapes that passed through each other look for each other. */
static void look_around(thud_world *w, const td_joint *joint) {
    for (int side = 0; side < 2 && !joint->collides; side++) {
        int i = td_body_at(w, joint->body[side])->first_shape;
        for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
            td_shape_mark_moved(w, i);
            *td_marks_at(w, i) |= TD_MARK_WOKEN;
        }
    }
}

thud_result thud_joint_destroy(thud_world *w, thud_joint_id id) {
    TD_IN_OWN_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint *joint = td_joint_at(w, index);
    int part[TD_JOINT_PARTS];
    __builtin_memcpy(part, joint->part, sizeof part);
    wake(w, joint);
    look_around(w, joint);
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        if (part[i] != TD_NONE) {
            td_constraint_destroy(w, part[i]);
        }
    }
    return THUD_OK;
}

/* ---- setting ---- */

thud_result thud_joint_set_drive(thud_world *w, thud_joint_id id, thud_direction direction,
                                 const thud_drive *drive) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (!drive) {
        return td_refuse(w, THUD_ERROR_NULL, "joint set drive: drive is null");
    }
    td_joint *joint = td_joint_at(w, index);
    if ((int)direction < 0 || direction >= THUD_DIRECTION_COUNT ||
        !(td_joint_drivable(joint->kind) >> direction & 1u)) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "joint set drive: this kind of joint drives no such direction");
    }
    if (!is_drive(w, (thud_joint_kind)joint->kind, (int)direction, drive)) {
        return td_refuse(w, THUD_ERROR_INVALID, "joint set drive: the drive is out of range");
    }
    if (!reserve_parts(w, joint->kind)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "joint set drive: out of memory");
    }
    joint->drive[direction] = drive_of(drive);
    settle_parts(w, index);
    return THUD_OK;
}

thud_result thud_joint_set_length(thud_world *w, thud_joint_id id, float length) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint *joint = td_joint_at(w, index);
    if (joint->kind != THUD_DISTANCE || !(length > 0.0f && length <= LENGTH_MOST * w->unit)) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "joint set length: the joint is no distance, or length is out of range");
    }
    joint->length = length;
    wake(w, joint);
    return THUD_OK;
}

thud_result thud_joint_set_enabled(thud_world *w, thud_joint_id id, bool enabled) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint *joint = td_joint_at(w, index);
    if (joint->disabled == !enabled) {
        return THUD_OK;
    }
    joint->disabled = !enabled;
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        int part = joint->part[i];
        if (!enabled && part != TD_NONE && td_constraint_at(w, part)->state == TD_TOUCHING) {
            td_lane_remove(w, part);
            td_constraint_wait(w, part);
        }
    }
    wake(w, joint);
    return THUD_OK;
}

thud_result thud_joint_set_user_data(thud_world *w, thud_joint_id id, uint64_t user_data) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result == THUD_OK) {
        td_joint_at(w, index)->user_data = user_data;
    }
    return result;
}
