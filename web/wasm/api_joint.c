/* api_joint.c: exports that create and change joints (thud_joint.h). Their options are the slots
 * joint_options; api.h has the conventions. */
#include "api.h"

#include <math.h>
#include <thud/thud_joint.h>

static thud_joint_id joint_id(uint32_t index1, uint32_t generation) {
    return (thud_joint_id){index1, generation};
}

/* ---- options ---- */

/* Writes a drive to the slots. */
static void tell_drive(const thud_drive *d, struct drive_options *s) {
    *s = (struct drive_options){.lower = d->limited ? d->lower : -INFINITY,
                                .upper = d->limited ? d->upper : INFINITY,
                                .frequency = d->frequency,
                                .damping = d->damping,
                                .target = d->target,
                                .spring_force = d->spring_force,
                                .motor_speed = d->motor_speed,
                                .motor_force = d->motor_force};
}

/* A drive from the slots. Where only one limit is given, the other is the largest length that the
 * engine accepts, `furthest`, or pi for the turn. */
static thud_drive drive_in(const struct drive_options *s, thud_joint_kind kind,
                           thud_direction direction, double furthest) {
    double most = direction == THUD_DIRECTION_TURN ? (double)THUD_JOINT_ANGLE_MAX : furthest;
    double least = kind == THUD_JOINT_DISTANCE ? 0.0 : -most;
    bool limited = !(s->lower == -INFINITY && s->upper == INFINITY);
    return (thud_drive){.limited = limited,
                        .lower = (float)(s->lower == -INFINITY ? limited ? least : 0.0 : s->lower),
                        .upper = (float)(s->upper == INFINITY ? limited ? most : 0.0 : s->upper),
                        .frequency = (float)s->frequency,
                        .damping = (float)s->damping,
                        .target = (float)s->target,
                        .spring_force = (float)s->spring_force,
                        .motor_speed = (float)s->motor_speed,
                        .motor_force = (float)s->motor_force};
}

/* Converts a frame to the slots' form, and back. */
static struct frame_options frame_out(const thud_joint_frame *frame) {
    return (struct frame_options){{frame->position.x, frame->position.y}, frame->angle};
}

static thud_joint_frame frame_in(const struct frame_options *s) {
    return (thud_joint_frame){{(float)s->position[0], (float)s->position[1]}, s->angle};
}

/* Writes a joint's def to the slots joint_options. */
static void tell_def(const thud_joint_def *def) {
    struct joint_options *s = &api_slots.joint_options;
    bool gear = def->kind == THUD_JOINT_GEAR;
    s->collide_connected = def->collide_connected;
    s->break_force = def->break_force;
    s->break_torque = def->break_torque;
    s->only_reports = def->only_reports;
    s->enabled = def->enabled;
    s->user_data = (double)def->user_data;
    s->pair_a.index1 = gear ? def->gear[0].index1 : def->body_a.index1;
    s->pair_a.generation = gear ? def->gear[0].generation : def->body_a.generation;
    s->pair_b.index1 = gear ? def->gear[1].index1 : def->body_b.index1;
    s->pair_b.generation = gear ? def->gear[1].generation : def->body_b.generation;
    s->frame_a = frame_out(&def->frame_a);
    s->frame_b = frame_out(&def->frame_b);
    tell_drive(&def->drive[THUD_DIRECTION_ALONG], &s->along);
    tell_drive(&def->drive[THUD_DIRECTION_ACROSS], &s->across);
    tell_drive(&def->drive[THUD_DIRECTION_TURN], &s->turn);
    s->making = (struct joint_making){.kind = def->kind, .rod = def->length, .ratio = def->ratio};
}

/* The defaults of a kind. Slots out: joint_options. */
void api_joint_defaults(int kind) {
    thud_joint_def def = thud_default_joint_def((thud_joint_kind)kind);
    tell_def(&def);
}

/* The present options of a joint. Slots out: joint_options. */
int api_joint_options(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_joint_def def;
    thud_result result = thud_joint_get_def(world, joint_id(index1, generation), &def);
    if (result == THUD_OK)
        tell_def(&def);
    return result;
}

/* ---- making ---- */

/* Computes the frame in a body from a place in the world (`from_place`) and the angle `turned` of
 * the joint's axis there, radians; or else the place from the frame. */
static thud_result settle_frame(const thud_world *world, thud_body_id id, bool from_place,
                                double place[2], double turned, thud_joint_frame *frame) {
    thud_body_state body;
    thud_result result = thud_body_get_state(world, id, &body);
    if (result != THUD_OK)
        return result;
    double c, s, x = frame->position.x, y = frame->position.y;
    api_sincos(body.angle, &s, &c);
    if (from_place) {
        x = place[0] - body.position.x;
        y = place[1] - body.position.y;
        frame->position = (thud_vec2){(float)(c * x + s * y), (float)(c * y - s * x)};
        frame->angle = turned - body.angle;
    } else {
        place[0] = body.position.x + c * x - s * y;
        place[1] = body.position.y + s * x + c * y;
    }
    return THUD_OK;
}

/* The angle of the vector (x, y), radians. tan(angle / 2) = y / (x + |(x, y)|); two more halvings,
 * tan(a / 2) = tan(a) / (1 + sqrt(1 + tan(a)^2)), make the Taylor series of the arc tangent
 * converge in twelve terms. atan2 of the C library would double the bytes of this layer, and that
 * of JavaScript differs between platforms. */
static double angle_of(double x, double y) {
    double largest = fmax(fabs(x), fabs(y));
    x /= largest;
    y /= largest;
    if (x < 0.0)
        return (y < 0.0 ? -1.0 : 1.0) * 3.14159265358979323846 - angle_of(-x, y);
    double tangent = y / (x + sqrt(x * x + y * y)), angle = 0.0;
    for (int i = 0; i < 2; i++)
        tangent /= 1.0 + sqrt(1.0 + tangent * tangent);
    for (int n = 23; n > 0; n -= 2)
        angle = 1.0 / n - tangent * tangent * angle;
    return 8.0 * tangent * angle;
}

/* Computes what `worked_out` of the slots names: frames from places, the angle of the axis, and the
 * length of a distance from its anchors. */
static thud_result settle_frames(const thud_world *world, thud_joint_def *def) {
    struct joint_making *s = &api_slots.joint_options.making;
    int out = api_to_int(s->worked_out);
    if (out & 8)
        s->turned = angle_of(s->axis[0], s->axis[1]);
    thud_result result =
        settle_frame(world, def->body_a, out & 1, s->place_a, s->turned, &def->frame_a);
    if (result == THUD_OK)
        result = settle_frame(world, def->body_b, out & 2, s->place_b, s->turned, &def->frame_b);
    double x = s->place_b[0] - s->place_a[0], y = s->place_b[1] - s->place_a[1];
    double between = sqrt(x * x + y * y);
    const thud_drive *d = &def->drive[THUD_DIRECTION_ALONG];
    bool rod = !d->limited && d->frequency == 0.0f && d->motor_force == 0.0f;
    bool rests = d->frequency > 0.0f && d->target == -INFINITY; /* the spring pulls to the length */
    /* A distance with another drive does not use its length: where the anchors coincide it keeps
     * the default, since a length of 0 would be refused. */
    if (out & 4 && (rod || rests || between > 0.0))
        def->length = (float)between;
    return result;
}

/* Creates a joint. `furthest`: the largest length of its limits. Slots in: joint_options. Slots
 * out: handle. */
int api_joint_create(thud_world *world, double furthest) {
    const struct joint_options *s = &api_slots.joint_options;
    thud_joint_kind kind = (thud_joint_kind)api_to_int(s->making.kind);
    thud_joint_def def = thud_default_joint_def(kind);
    thud_result result = THUD_OK;
    def.drive[THUD_DIRECTION_ALONG] = drive_in(&s->along, kind, THUD_DIRECTION_ALONG, furthest);
    def.drive[THUD_DIRECTION_ACROSS] = drive_in(&s->across, kind, THUD_DIRECTION_ACROSS, furthest);
    def.drive[THUD_DIRECTION_TURN] = drive_in(&s->turn, kind, THUD_DIRECTION_TURN, furthest);
    def.length = (float)s->making.rod;
    def.ratio = (float)s->making.ratio;
    def.collide_connected = s->collide_connected != 0.0;
    def.break_force = (float)s->break_force;
    def.break_torque = (float)s->break_torque;
    def.only_reports = s->only_reports != 0.0;
    def.enabled = s->enabled != 0.0;
    def.user_data = (uint64_t)s->user_data;
    uint32_t a = api_to_u32(s->pair_a.index1), a_generation = api_to_u32(s->pair_a.generation);
    uint32_t b = api_to_u32(s->pair_b.index1), b_generation = api_to_u32(s->pair_b.generation);
    if (kind == THUD_JOINT_GEAR) {
        def.gear[0] = joint_id(a, a_generation);
        def.gear[1] = joint_id(b, b_generation);
    } else {
        def.body_a = api_body(a, a_generation);
        def.body_b = api_body(b, b_generation);
        def.frame_a = frame_in(&s->frame_a);
        def.frame_b = frame_in(&s->frame_b);
        result = settle_frames(world, &def);
    }
    thud_joint_id id = {0};
    if (result == THUD_OK)
        result = thud_joint_create(world, &def, &id);
    api_slots.handle.index1 = id.index1;
    api_slots.handle.generation = id.generation;
    return result;
}

int api_joint_destroy(thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_joint_destroy(world, joint_id(index1, generation));
}

int api_joint_is_valid(const thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_joint_is_valid(world, joint_id(index1, generation));
}

int api_world_use_joints(thud_world *world) {
    return thud_world_use_joints(world);
}

/* ---- setting ---- */

/* This and the next two set a part of the options: JavaScript has called api_joint_options and
 * changed the slots joint_options, from which they read. */
int api_joint_set_drive(thud_world *world, uint32_t index1, uint32_t generation, int direction,
                        double furthest) {
    const struct joint_options *s = &api_slots.joint_options;
    thud_drive drive =
        drive_in(direction == THUD_DIRECTION_ALONG    ? &s->along
                 : direction == THUD_DIRECTION_ACROSS ? &s->across
                                                      : &s->turn,
                 (thud_joint_kind)api_to_int(s->making.kind), (thud_direction)direction, furthest);
    return thud_joint_set_drive(world, joint_id(index1, generation), (thud_direction)direction,
                                &drive);
}

int api_joint_set_frame(thud_world *world, uint32_t index1, uint32_t generation, int side) {
    const struct joint_options *s = &api_slots.joint_options;
    return thud_joint_set_frame(world, joint_id(index1, generation), side,
                                frame_in(side == 0 ? &s->frame_a : &s->frame_b));
}

int api_joint_set_breaking(thud_world *world, uint32_t index1, uint32_t generation) {
    const struct joint_options *s = &api_slots.joint_options;
    return thud_joint_set_breaking(world, joint_id(index1, generation), (float)s->break_force,
                                   (float)s->break_torque, s->only_reports != 0.0);
}

int api_joint_set_length(thud_world *world, uint32_t index1, uint32_t generation, double length) {
    return thud_joint_set_length(world, joint_id(index1, generation), (float)length);
}

int api_joint_set_enabled(thud_world *world, uint32_t index1, uint32_t generation, int enabled) {
    return thud_joint_set_enabled(world, joint_id(index1, generation), enabled != 0);
}

int api_joint_set_user_data(thud_world *world, uint32_t index1, uint32_t generation, double data) {
    return thud_joint_set_user_data(world, joint_id(index1, generation), (uint64_t)data);
}
