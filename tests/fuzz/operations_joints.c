/* operations_joints.c: operations that create, change, read and destroy joints. */
#include "driven.h"
#include "operations.h"

#include <math.h>
#include <thud/thud_joint.h>
#include <thud/thud_joint_at.h>

static thud_joint_id pick_joint(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    return byte < FIRST_WRONG_HANDLE ? s->now.joints[byte % SESSION_JOINTS]
                                     : (thud_joint_id){byte % 4, byte * 0x01010101u};
}

/* A drive that is valid in most cases; fields that the bytes do not set have their default. */
static thud_drive pick_drive(fuzz_session *s) {
    thud_drive drive = thud_default_joint_def(THUD_JOINT_WELD).drive[THUD_DIRECTION_ALONG];
    unsigned byte = next_byte(&s->bytes);
    drive.limited = byte & 1;
    drive.lower = byte & 2 ? 0 : next_float(&s->bytes, -3, 0.015625);
    drive.upper = byte & 4 ? drive.lower : drive.lower + next_float(&s->bytes, 0, 0.015625);
    drive.target = byte & 8 ? 0 : next_float(&s->bytes, -2, 0.015625);
    drive.frequency = byte & 16 ? next_float(&s->bytes, 0, 0.25) : 0;
    drive.damping = byte & 32 ? next_float(&s->bytes, 0, 0.0625) : drive.damping;
    drive.motor_force = byte & 64 ? next_float(&s->bytes, 0, 8) : 0;
    drive.motor_speed = byte & 128 ? next_float(&s->bytes, -16, 0.125) : 0;
    return drive;
}

static thud_joint_frame pick_frame(fuzz_session *s) {
    thud_joint_frame frame = {{next_float(&s->bytes, -2, 0.015625), 0}, 0};
    frame.position.x *= (float)s->unit;
    frame.angle = next_choice(&s->bytes, 2) ? pick_angle(s) : 0;
    return frame;
}

static void make_joint(fuzz_session *s, const thud_joint_def *def) {
    thud_joint_id joint = {0, 0};
    TRY(s, thud_joint_create(s->world, def, &joint));
    if (s->result == THUD_OK) {
        note_bits(s, joint.index1);
        s->now.joints[s->now.next_joint++ % SESSION_JOINTS] = joint;
    } else if (joint.index1 || joint.generation) {
        fuzz_fail(s, "a joint that was refused has a handle");
    }
}

void play_joint(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    thud_joint_def def =
        COUNTED(thud_default_joint_def((thud_joint_kind)(byte % THUD_JOINT_KIND_COUNT)));
    def.body_a = pick_body(s);
    def.body_b = pick_body(s);
    def.frame_a = pick_frame(s);
    def.frame_b = pick_frame(s);
    def.collide_connected = next_choice(&s->bytes, 2);
    def.enabled = next_choice(&s->bytes, 8) != 7;
    def.length = pick_size(s);
    def.drive[next_choice(&s->bytes, THUD_DIRECTION_COUNT)] = pick_drive(s);
    for (int i = 0; i < THUD_DIRECTION_COUNT && !s->bytes.hostile; i++) {
        if (!is_driven(def.kind, i)) {
            def.drive[i] = (thud_drive){0};
        }
    }
    if (def.kind == THUD_JOINT_GEAR) {
        def.gear[0] = pick_joint(s);
        def.gear[1] = pick_joint(s);
        def.ratio = next_float(&s->bytes, -4, 0.0625);
    }
    if (s->bytes.hostile && next_chance(&s->bytes, 16)) {
        def.kind = (thud_joint_kind)next_count(&s->bytes, THUD_JOINT_KIND_COUNT + 2);
    }
    make_joint(s, &def);
}

/* ---- linkages: a chain, a loop, a hub or a ladder of joints, created where every joint fits ----
 */

typedef enum linkage_form { CHAIN, LOOP, HUB, LADDER, LINKAGE_FORMS } linkage_form;

enum { LINKAGE_MOST = 12 };

typedef struct linkage {
    linkage_form form;
    thud_joint_kind kind;
    float frequency; /* Hz, of springs along; 0: no springs */
    int count;
    thud_pos at[LINKAGE_MOST]; /* positions relative to the first body, in length scales */
    thud_body_id bodies[LINKAGE_MOST];
} linkage;

static linkage pick_linkage(fuzz_session *s) {
    static const thud_joint_kind kinds[] = {THUD_JOINT_HINGE, THUD_JOINT_DISTANCE, THUD_JOINT_WELD,
                                            THUD_JOINT_SLIDER, THUD_JOINT_WHEEL};
    static const float frequencies[] = {0, 1, 20, 200, 1000, THUD_JOINT_FREQUENCY_MAX};
    linkage l = {.form = (linkage_form)next_choice(&s->bytes, LINKAGE_FORMS)};
    l.kind = kinds[next_choice(&s->bytes, sizeof kinds / sizeof *kinds)];
    l.frequency = frequencies[next_choice(&s->bytes, sizeof frequencies / sizeof *frequencies)];
    l.count = 2 + next_choice(&s->bytes, LINKAGE_MOST - 1);
    for (int i = 0; i < l.count; i++) {
        int row = l.form == LADDER ? i % 2 : l.form == HUB && i > 0 ? 1 + i % 3 : 0;
        l.at[i] = (thud_pos){l.form == LADDER ? i / 2 : i, row};
    }
    return l;
}

static void add_links(fuzz_session *s, linkage *l) {
    thud_pos place = pick_place(s);
    unsigned flags = next_byte(&s->bytes);
    float size = (float)s->unit * (flags & 1 ? 0.03125f : 0.25f);
    thud_shape_def shape = thud_default_shape_def();
    shape.density = flags & 2 ? 0.0625f : 1;
    for (int i = 0; i < l->count; i++) {
        thud_body_def def = thud_default_body_def();
        thud_shape_id made = {0, 0};
        thud_vec2 zero = {0, 0};
        def.kind = i == 0 && flags & 4 ? THUD_BODY_STATIC : THUD_BODY_DYNAMIC;
        def.position = (thud_pos){place.x + l->at[i].x * s->unit, place.y + l->at[i].y * s->unit};
        TRY(s, thud_body_create(s->world, &def, &l->bodies[i]));
        note_bits(s, l->bodies[i].index1);
        session_keep_body(s, l->bodies[i]);
        if (i % 2) {
            TRY(s, thud_shape_create_circle(s->world, l->bodies[i], &shape, zero, size, &made));
        } else {
            TRY(s, thud_shape_create_obb(s->world, l->bodies[i], &shape, zero,
                                         (thud_vec2){size, size / 2}, 0, &made));
        }
        s->now.shapes[s->now.next_shape++ % SESSION_SHAPES] = made;
    }
}

/* The anchor is half way between the two bodies; a rod's anchors are the bodies' centers. */
static void tie_links(fuzz_session *s, const linkage *l, int a, int b) {
    thud_joint_def def = COUNTED(thud_default_joint_def(l->kind));
    double x = (l->at[b].x - l->at[a].x) * s->unit, y = (l->at[b].y - l->at[a].y) * s->unit;
    def.body_a = l->bodies[a];
    def.body_b = l->bodies[b];
    if (l->kind == THUD_JOINT_DISTANCE) {
        def.length = (float)sqrt(x * x + y * y);
        def.drive[THUD_DIRECTION_ALONG].target = def.length;
    } else {
        def.frame_a.position = (thud_vec2){(float)(0.5 * x), (float)(0.5 * y)};
        def.frame_b.position = (thud_vec2){(float)(-0.5 * x), (float)(-0.5 * y)};
    }
    def.drive[l->kind == THUD_JOINT_WELD ? THUD_DIRECTION_TURN : THUD_DIRECTION_ALONG].frequency =
        l->kind == THUD_JOINT_HINGE ? 0 : l->frequency;
    make_joint(s, &def);
}

void play_linkage(fuzz_session *s) {
    linkage l = pick_linkage(s);
    if (s->depth || COUNTED(thud_stats_of(s->world)).shapes + l.count > SESSION_WORLD_SHAPES_MAX) {
        return;
    }
    add_links(s, &l);
    for (int i = 1; i < l.count; i++) {
        tie_links(s, &l, l.form == HUB ? 0 : i - 1, i);
        if (l.form == LADDER && i > 1) {
            tie_links(s, &l, i - 2, i);
        }
    }
    if (l.form == LOOP && l.count > 2) {
        tie_links(s, &l, l.count - 1, 0);
    }
}

/* ---- joints at places in the world ---- */

void play_joint_at(fuzz_session *s) {
    thud_body_id a = pick_body(s), b = pick_body(s);
    thud_pos from = pick_place(s), to = pick_place(s);
    double angle = pick_angle(s);
    thud_vec2 axis = {(float)cos(angle), (float)sin(angle)};
    thud_joint_def def = COUNTED(thud_hinge_at(s->world, a, b, from));
    switch (next_choice(&s->bytes, 7)) {
    case 1:
        def = COUNTED(thud_weld_at(s->world, a, b, from));
        break;
    case 2:
        def = COUNTED(thud_slider_at(s->world, a, b, from, axis));
        break;
    case 3:
        def = COUNTED(thud_wheel_at(s->world, a, b, from, axis));
        break;
    case 4:
        def = COUNTED(thud_target_at(s->world, a, b, from));
        break;
    case 5:
        def = COUNTED(thud_rod_at(s->world, a, b, from, to));
        break;
    case 6:
        def = COUNTED(thud_rope_at(s->world, a, b, from, to, pick_size(s)));
        break;
    default:
        break;
    }
    thud_joint_id joint = COUNTED(thud_joint_make(s->world, def));
    note_bits(s, joint.index1);
    s->now.joints[s->now.next_joint++ % SESSION_JOINTS] = joint;
}

void play_joint_destroy(fuzz_session *s) {
    thud_joint_id joint = pick_joint(s);
    bool valid = COUNTED(thud_joint_is_valid(s->world, joint));
    TRY(s, thud_joint_destroy(s->world, joint));
    bool gone = s->result == THUD_OK;
    if (s->result != THUD_ERROR_LOCKED &&
        (valid != gone || COUNTED(thud_joint_is_valid(s->world, joint)))) {
        fuzz_fail(s, "a joint that is %s cannot go, or has gone and is valid: %s",
                  valid ? "valid" : "stale", thud_result_text(s->result));
    }
}

void play_joint_edit(fuzz_session *s) {
    thud_joint_id joint = pick_joint(s);
    unsigned byte = next_byte(&s->bytes);
    if (byte % 5 == 0) {
        float length = pick_size(s);
        TRY(s, thud_joint_set_length(s->world, joint, length));
    } else if (byte % 5 == 1) {
        TRY(s, thud_joint_set_enabled(s->world, joint, byte & 128));
    } else if (byte % 5 == 2) {
        TRY(s, thud_joint_set_user_data(s->world, joint, byte));
    } else {
        thud_direction direction = (thud_direction)next_choice(&s->bytes, THUD_DIRECTION_COUNT);
        thud_drive drive = pick_drive(s);
        TRY(s, thud_joint_set_drive(s->world, joint, direction, &drive));
    }
}

/* Reads a joint's def; a joint created from it must be accepted. */
static void read_def(fuzz_session *s, thud_joint_id joint) {
    thud_joint_def def;
    memset(&def, CALL_FILL, sizeof def);
    TRY(s, thud_joint_get_def(s->world, joint, &def));
    if (s->result != THUD_OK) {
        call_untouched(s, &def, sizeof def);
        return;
    }
    note_number(s, def.frame_a.angle);
    note_number(s, (double)def.frame_b.position.x);
    note_number(s, (double)def.length);
    for (int i = 0; i < THUD_DIRECTION_COUNT; i++) {
        note_number(s, (double)(def.drive[i].target + def.drive[i].motor_force));
    }
}

/* The forces of the last substep may have any value that a float can hold, also infinite; they are
 * not added to the digest. */
void play_joint_get(fuzz_session *s) {
    thud_joint_id joint = pick_joint(s);
    thud_joint_state state;
    memset(&state, CALL_FILL, sizeof state);
    TRY(s, thud_joint_get_state(s->world, joint, &state));
    if (s->result != THUD_OK) {
        call_untouched(s, &state, sizeof state);
        return;
    }
    note_bits(s, (uint64_t)(state.kind + 8 * state.enabled));
    note_bits(s, state.user_data);
    note_bits(s, state.body_a.index1);
    note_bits(s, state.body_b.index1);
    note_number(s, state.gap);
    note_number(s, state.angle_gap);
    for (int i = 0; i < THUD_DIRECTION_COUNT; i++) {
        note_number(s, state.value[i]);
    }
    read_def(s, joint);
}

void play_joint_frame(fuzz_session *s) {
    thud_joint_id joint = pick_joint(s);
    unsigned byte = next_byte(&s->bytes);
    thud_joint_frame frame = pick_frame(s);
    TRY(s, thud_joint_set_frame(s->world, joint, byte < 8 ? (int)byte : (int)(byte % 2), frame));
}

void play_joint_breaking(fuzz_session *s) {
    thud_joint_id joint = pick_joint(s);
    unsigned byte = next_byte(&s->bytes);
    float force = byte & 1 ? THUD_JOINT_FORCE_MAX : next_float(&s->bytes, 0, 4);
    float torque = byte & 2 ? THUD_JOINT_FORCE_MAX : next_float(&s->bytes, 0, 4);
    TRY(s, thud_joint_set_breaking(s->world, joint, force, torque, byte & 4));
}

/* Lists return the full number of joints, whatever their capacity. */
void play_joint_lists(fuzz_session *s) {
    enum { ROOM = 4 };
    thud_joint_id list[ROOM];
    int room = (int)next_choice(&s->bytes, ROOM + 1), broken = 0;
    thud_body_id body = pick_body(s);
    int all = 0, of_body = 0;
    TRY(s, thud_world_get_joints(s->world, room ? list : NULL, room, &all));
    for (int i = 0; i < all && i < room; i++) {
        note_bits(s, list[i].index1);
    }
    TRY(s, thud_body_get_joints(s->world, body, list, room, &of_body));
    for (int i = 0; i < of_body && i < room; i++) {
        note_bits(s, list[i].index1);
    }
    if (of_body > all) {
        fuzz_fail(s, "a body has %d joints, and its world %d", of_body, all);
    }
    const thud_joint_event *events = COUNTED(thud_joint_events_of(s->world, &broken));
    for (int i = 0; i < broken; i++) {
        note_bits(s, events[i].joint.index1 + events[i].broken);
    }
}
