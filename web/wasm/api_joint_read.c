/* api_joint_read.c: exports that read joints: the state of one, lists, events, and a table of all
 * for drawing. api.h has the conventions. */
#include "api.h"

#include <math.h>
#include <thud/thud_joint.h>

static api_buffer ids, event_rows, table_rows, table_handles;

/* Slots out: joint_state. */
int api_joint_state(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_joint_state state;
    thud_result result = thud_joint_get_state(world, (thud_joint_id){index1, generation}, &state);
    if (result == THUD_OK)
        api_slots.joint_state = (struct joint_state){
            .kind = state.kind,
            .body_a = {state.body_a.index1, state.body_a.generation},
            .body_b = {state.body_b.index1, state.body_b.generation},
            .enabled = state.enabled,
            .value = {state.value[0], state.value[1], state.value[2]},
            .gap = state.gap,
            .angle_gap = state.angle_gap,
            .force = {state.force.x, state.force.y},
            .torque = state.torque,
            .user_data = (double)state.user_data,
        };
    for (int i = 0; i < THUD_DIRECTION_COUNT && result == THUD_OK; i++) {
        api_slots.joint_state.drive[3 * i] = state.drive[i].limit;
        api_slots.joint_state.drive[3 * i + 1] = state.drive[i].spring;
        api_slots.joint_state.drive[3 * i + 2] = state.drive[i].motor;
    }
    return result;
}

/* Gives a list `count` elements of any value; false where memory is short. */
static bool make_room(api_buffer *buffer, int count) {
    api_buffer_clear(buffer);
    for (int i = 0; i < count; i++)
        api_buffer_push(buffer, &(thud_joint_id){0}, sizeof(thud_joint_id));
    return !buffer->failed;
}

/* Writes the handles of all joints to `ids`; returns their number, or -1 where memory is short. */
static int list_all(const thud_world *world) {
    int count = 0;
    thud_world_get_joints(world, NULL, 0, &count);
    if (!make_room(&ids, count))
        return -1;
    thud_world_get_joints(world, (thud_joint_id *)ids.data, count, &count);
    return count;
}

/* Slots out: list, of `ids`. */
static int tell_list(int count) {
    api_slots.list.address = (double)(uintptr_t)ids.data;
    api_slots.list.count = count;
    return count < 0 ? THUD_ERROR_MEMORY : THUD_OK;
}

/* The handles of the world's joints. Slots out: list. */
int api_world_joints(const thud_world *world) {
    return tell_list(list_all(world));
}

/* The handles of a body's joints. Slots out: list. */
int api_body_joints(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_body_id body = api_body(index1, generation);
    int count = 0;
    thud_result result = thud_body_get_joints(world, body, NULL, 0, &count);
    if (result != THUD_OK)
        return result;
    if (!make_room(&ids, count))
        return THUD_ERROR_MEMORY;
    thud_body_get_joints(world, body, (thud_joint_id *)ids.data, count, &count);
    return tell_list(count);
}

/* Slots out: list of joint_event. */
int api_world_joint_events(const thud_world *world) {
    int count = 0;
    const thud_joint_event *events = thud_joint_events_of(world, &count);
    api_buffer_clear(&event_rows);
    for (int i = 0; i < count; i++) {
        const thud_joint_event *e = &events[i];
        struct joint_event row = {.joint = {e->joint.index1, e->joint.generation},
                                  .body_a = {e->body_a.index1, e->body_a.generation},
                                  .body_b = {e->body_b.index1, e->body_b.generation},
                                  .user_data = (double)e->user_data,
                                  .force = e->force,
                                  .torque = e->torque,
                                  .broken = e->broken};
        api_buffer_push(&event_rows, &row, sizeof row);
    }
    api_slots.list.address = (double)(uintptr_t)event_rows.data;
    api_slots.list.count = count;
    return api_buffer_result(&event_rows);
}

/* ---- all at once ---- */

/* The directions that a kind locks (unless a weld or a distance has a drive there), and those that
 * it can drive: a sum of 1 for along, 2 for across, 4 for turn. See the table in thud_joint.h. */
static const struct {
    unsigned char locked, driven;
} DIRECTIONS[THUD_JOINT_KIND_COUNT] = {
    [THUD_JOINT_DISTANCE] = {1, 1}, [THUD_JOINT_HINGE] = {3, 4}, [THUD_JOINT_SLIDER] = {6, 1},
    [THUD_JOINT_WELD] = {7, 7},     [THUD_JOINT_WHEEL] = {2, 5}, [THUD_JOINT_TARGET] = {0, 7},
};

/* The limits of a row in each direction: equal where it is locked (0, or the length of a distance),
 * infinite where it is free. `row` has zeros before. */
static void fill_limits(struct joint_row *row, const thud_joint_def *def) {
    unsigned locked = DIRECTIONS[def->kind].locked, driven = DIRECTIONS[def->kind].driven;
    for (int i = 0; i < THUD_DIRECTION_COUNT; i++) {
        const thud_drive *d = &def->drive[i];
        bool drives =
            driven >> i & 1u && (d->limited || d->frequency > 0.0f || d->motor_force > 0.0f);
        if (drives || !(locked >> i & 1u)) {
            bool limited = drives && d->limited;
            row->lower[i] = limited ? d->lower : -INFINITY;
            row->upper[i] = limited ? d->upper : INFINITY;
        } else if (def->kind == THUD_JOINT_DISTANCE) {
            row->lower[i] = row->upper[i] = def->length;
        }
    }
}

/* A body's centre of mass in the body's frame. */
static void fill_center(float center[2], const thud_body_state *body) {
    double c, s, x = body->center.x - body->position.x, y = body->center.y - body->position.y;
    api_sincos(body->angle, &s, &c);
    center[0] = (float)(c * x + s * y);
    center[1] = (float)(c * y - s * x);
}

/* The anchor of a gear on a body: that of the joint which it couples there, on the dynamic body. */
static void fill_gear_anchor(float anchor[2], const thud_world *world, thud_joint_id id) {
    thud_joint_def def;
    thud_body_state a;
    if (thud_joint_get_def(world, id, &def) != THUD_OK ||
        thud_body_get_state(world, def.body_a, &a) != THUD_OK)
        return;
    const thud_joint_frame *frame = a.kind == THUD_BODY_DYNAMIC ? &def.frame_a : &def.frame_b;
    anchor[0] = frame->position.x;
    anchor[1] = frame->position.y;
}

/* Fills a row except for the places in the world, which depend on poses; center_a and center_b are
 * in the bodies' frames until then. */
static thud_result fill_row(struct joint_row *row, struct joint_handles *handles,
                            const thud_world *world, thud_joint_id id) {
    thud_joint_def def;
    thud_joint_state state;
    thud_body_state a, b;
    thud_result result = thud_joint_get_def(world, id, &def);
    if (result == THUD_OK)
        result = thud_joint_get_state(world, id, &state);
    if (result == THUD_OK)
        result = thud_body_get_state(world, state.body_a, &a);
    if (result == THUD_OK)
        result = thud_body_get_state(world, state.body_b, &b);
    if (result != THUD_OK)
        return result;
    double c, s;
    api_sincos(def.frame_a.angle, &s, &c);
    *row = (struct joint_row){
        .kind = (float)state.kind,
        .slot_a = (float)(state.body_a.index1 - 1),
        .slot_b = (float)(state.body_b.index1 - 1),
        .enabled = state.enabled,
        .awake = a.awake || b.awake,
        .anchor_a = {def.frame_a.position.x, def.frame_a.position.y},
        .anchor_b = {def.frame_b.position.x, def.frame_b.position.y},
        .axis = {(float)c, (float)s},
        .value = {(float)state.value[0], (float)state.value[1], (float)state.value[2]},
        .gap = (float)state.gap,
        .angle_gap = (float)state.angle_gap,
        .force = {state.force.x, state.force.y},
        .torque = state.torque,
    };
    fill_limits(row, &def);
    if (def.kind == THUD_JOINT_GEAR) {
        fill_gear_anchor(row->anchor_a, world, def.gear[0]);
        fill_gear_anchor(row->anchor_b, world, def.gear[1]);
    }
    fill_center(row->center_a, &a);
    fill_center(row->center_b, &b);
    *handles = (struct joint_handles){{id.index1, id.generation},
                                      {state.body_a.index1, state.body_a.generation},
                                      {state.body_b.index1, state.body_b.generation}};
    return THUD_OK;
}

/* Rotates a vector from a body's frame to the world. */
static void turn(float out[2], const thud_pose *pose, const float in[2]) {
    float x = pose->c * in[0] - pose->s * in[1], y = pose->s * in[0] + pose->c * in[1];
    out[0] = x;
    out[1] = y;
}

/* Transforms a point from a body's frame to the world. */
static void place(float out[2], const thud_pose *pose, const float in[2]) {
    turn(out, pose, in);
    out[0] += pose->x;
    out[1] += pose->y;
}

/* Whether both bodies of a joint exist: a joint whose body was destroyed is listed until the next
 * step. */
static bool has_bodies(const thud_world *world, thud_joint_id id) {
    thud_joint_state state;
    return thud_joint_get_state(world, id, &state) == THUD_OK &&
           thud_body_is_valid(world, state.body_a) && thud_body_is_valid(world, state.body_b);
}

/* Fills a table of all joints, with bodies at their poses of thud_world_get_poses for this origin
 * and alpha; empty where those are refused. Slots out: joint_table, with a joint_row and a
 * joint_handles for each joint. */
int api_joint_table(thud_world *world, double x, double y, double alpha) {
    int count = list_all(world), bodies = 0;
    if (count < 0)
        return THUD_ERROR_MEMORY;
    api_buffer_clear(&table_rows);
    api_buffer_clear(&table_handles);
    int listed = count;
    count = 0;
    for (int i = 0; i < listed; i++) {
        struct joint_row row;
        struct joint_handles handles;
        thud_joint_id id = ((const thud_joint_id *)ids.data)[i];
        if (!has_bodies(world, id))
            continue;
        count++;
        thud_result result = fill_row(&row, &handles, world, id);
        if (result != THUD_OK)
            return result;
        api_buffer_push(&table_rows, &row, sizeof row);
        api_buffer_push(&table_handles, &handles, sizeof handles);
    }
    if (table_rows.failed || table_handles.failed)
        return THUD_ERROR_MEMORY;
    const thud_pose *poses = thud_poses_of(world, (thud_pos){x, y}, alpha, &bodies);
    struct joint_row *rows = (struct joint_row *)table_rows.data;
    for (int i = 0; i < count && poses; i++) {
        const thud_pose *a = &poses[(int)rows[i].slot_a], *b = &poses[(int)rows[i].slot_b];
        place(rows[i].place_a, a, rows[i].anchor_a);
        place(rows[i].place_b, b, rows[i].anchor_b);
        turn(rows[i].direction, a, rows[i].axis);
        place(rows[i].center_a, a, rows[i].center_a);
        place(rows[i].center_b, b, rows[i].center_b);
    }
    api_slots.joint_table.rows = (double)(uintptr_t)rows;
    api_slots.joint_table.handles = (double)(uintptr_t)table_handles.data;
    api_slots.joint_table.count = poses || count == 0 ? count : 0;
    return THUD_OK;
}
