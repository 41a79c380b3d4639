/* operations_bodies.c: operations that create, change, read and destroy bodies. */
#include "operations.h"

#include <thud/thud_edits.h>
#include <thud/thud_make.h>

void session_keep_body(fuzz_session *s, thud_body_id made) {
    thud_body_id *place = &s->now.bodies[s->now.next_body++ % SESSION_BODIES];
    if (thud_body_is_valid(s->world, *place)) {
        s->gone_bodies[s->gone++ % SESSION_GONE] = *place;
        s->destroyed_inside += s->depth > 0;
        TRY(s, thud_body_destroy(s->world, *place));
        if (s->result != THUD_OK) {
            fuzz_fail(s, "a body that is valid cannot go: %s", thud_result_text(s->result));
        }
    }
    *place = made;
}

static void create_body(fuzz_session *s, const thud_body_def *def) {
    thud_body_id body = {0, 0};
    TRY(s, thud_body_create(s->world, def, &body));
    if (s->result == THUD_OK) {
        note_bits(s, body.index1);
        session_keep_body(s, body);
    } else if (body.index1 || body.generation) {
        fuzz_fail(s, "a body that was refused has a handle");
    }
}

/* Creates a body together with up to three shapes. */
static void create_whole_body(fuzz_session *s, const thud_body_def *def) {
    thud_body_shape shapes[3] = {0};
    thud_shape_id made[3] = {0};
    thud_body_id body = {0, 0};
    int room = SESSION_WORLD_SHAPES_MAX - COUNTED(thud_stats_of(s->world)).shapes;
    int count = next_choice(&s->bytes, 4);
    for (int i = 0; i < count; i++) {
        shapes[i].shape = pick_geometry(s);
    }
    count = count <= room ? count : 0;
    TRY(s, thud_body_create_with_shapes(s->world, def, shapes, count, &body, made));
    if (s->result == THUD_OK) {
        note_bits(s, body.index1 + (count ? made[count - 1].index1 : 0));
        session_keep_body(s, body);
    } else if (body.index1 || made[0].index1) {
        fuzz_fail(s, "a body that was refused has a handle, or a shape");
    }
}

static thud_body_def body_def(fuzz_session *s) {
    thud_body_def def = COUNTED(thud_default_body_def());
    unsigned byte = next_byte(&s->bytes);
    static const thud_body_kind kinds[] = {THUD_BODY_DYNAMIC, THUD_BODY_DYNAMIC, THUD_BODY_STATIC,
                                           THUD_BODY_KINEMATIC};
    def.kind = kinds[byte % 4];
    def.position = pick_place(s);
    def.angle = byte & 4 ? pick_angle(s) : 0;
    def.fixed_rotation = (byte & 24) == 24;
    def.may_sleep = (byte & 96) != 96;
    def.velocity =
        byte & 128 && def.kind != THUD_BODY_STATIC ? pick_velocity(s) : (thud_vec2){0, 0};
    return def;
}

void play_body(fuzz_session *s) {
    thud_body_def def = body_def(s);
    create_body(s, &def);
}

/* A body with values from the bytes for all fields of its def. */
void play_wild_body(fuzz_session *s) {
    thud_body_def def = body_def(s);
    def.angular_velocity = next_float(&s->bytes, -16, 0.125);
    def.gravity_scale = next_float(&s->bytes, -1, 0.0625);
    def.linear_damping = next_float(&s->bytes, 0, 0.125);
    def.angular_damping = next_float(&s->bytes, 0, 0.125);
    def.detection = pick_detection(s, next_byte(&s->bytes));
    def.user_data = next_byte(&s->bytes);
    if (s->bytes.hostile && next_chance(&s->bytes, 16)) {
        def.kind = (thud_body_kind)next_count(&s->bytes, 5);
    }
    if (s->bytes.hostile && next_chance(&s->bytes, 16)) {
        def.cookie = next_byte(&s->bytes);
    }
    if (def.user_data % 4 == 3) {
        create_whole_body(s, &def);
    } else {
        create_body(s, &def);
    }
}

void play_body_destroy(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    bool valid = COUNTED(thud_body_is_valid(s->world, body));
    TRY(s, thud_body_destroy(s->world, body));
    if (s->result == THUD_OK) {
        s->gone_bodies[s->gone++ % SESSION_GONE] = body;
        s->destroyed_inside += s->depth > 0;
    }
    if (valid != (s->result == THUD_OK) || COUNTED(thud_body_is_valid(s->world, body))) {
        fuzz_fail(s, "a body that is %s cannot go, or has gone and is valid: %s",
                  valid ? "valid" : "stale", thud_result_text(s->result));
    }
}

/* A velocity is added to the digest only after a step: until then it need not be finite, since
 * impulses may add up to infinity. */
void play_body_get(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_body_state state;
    memset(&state, CALL_FILL, sizeof state);
    TRY(s, thud_body_get_state(s->world, body, &state));
    if (s->result != THUD_OK) {
        call_untouched(s, &state, sizeof state);
        return;
    }
    note_bits(s, (uint64_t)(state.kind + 4 * state.awake + 8 * state.enabled));
    note_bits(s, state.user_data);
    note_bits(s, (uint64_t)state.shape_count);
}

void play_transform(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_pos place = pick_place(s);
    double angle = next_choice(&s->bytes, 4) ? 0 : pick_angle(s);
    TRY(s, thud_body_set_transform(s->world, body, place, angle));
}

void play_velocity(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_vec2 velocity = pick_velocity(s);
    float spin = next_float(&s->bytes, -16, 0.125);
    TRY(s, thud_body_set_velocity(s->world, body, velocity, spin));
}

void play_impulse(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_vec2 impulse = pick_velocity(s);
    thud_pos place = pick_place(s);
    TRY(s, thud_body_apply_impulse(s->world, body, impulse, place));
}

void play_force(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_vec2 force = pick_velocity(s);
    float torque = next_float(&s->bytes, -64, 0.5);
    force.x *= 16;
    TRY(s, thud_body_apply_center_force(s->world, body, force));
    TRY(s, thud_body_apply_torque(s->world, body, torque));
}

void play_awake(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    bool awake = next_choice(&s->bytes, 3) == 0;
    TRY(s, thud_body_set_awake(s->world, body, awake));
}

void play_enabled(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    bool enabled = next_choice(&s->bytes, 2) == 0;
    TRY(s, thud_body_set_enabled(s->world, body, enabled));
}

void play_user_data(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    uint64_t data = next_byte(&s->bytes);
    TRY(s, thud_body_set_user_data(s->world, body, data));
}

void play_body_shapes(fuzz_session *s) {
    enum { ROOM = 6 };
    thud_body_id body = pick_body(s);
    thud_shape_id shapes[ROOM];
    int capacity = next_count(&s->bytes, ROOM), count = -7;
    capacity = capacity > ROOM ? ROOM : capacity;
    TRY(s, thud_body_get_shapes(s->world, body, shapes, capacity, &count));
    if (s->result != THUD_OK) {
        return;
    }
    note_bits(s, (uint64_t)count);
    for (int i = 0; i < count && i < capacity; i++) {
        note_bits(s, shapes[i].index1);
        if (!COUNTED(thud_shape_is_valid(s->world, shapes[i]))) {
            fuzz_fail(s, "shape %u of a body is gone", shapes[i].index1);
        }
    }
}

void play_body_contacts(fuzz_session *s) {
    enum { ROOM = 6 };
    thud_body_id body = pick_body(s);
    thud_manifold contacts[ROOM];
    int capacity = next_count(&s->bytes, ROOM), count = -7;
    capacity = capacity > ROOM ? ROOM : capacity;
    TRY(s, thud_body_get_contacts(s->world, body, contacts, capacity, &count));
    if (s->result != THUD_OK) {
        return;
    }
    note_bits(s, (uint64_t)count);
    for (int i = 0; i < count && i < capacity; i++) {
        const thud_manifold *m = &contacts[i];
        note_bits(s, (uint64_t)m->shape_a.index1 << 32 | m->shape_b.index1);
        note_vector(s, m->normal);
        note_number(s, (double)m->tangent_impulse);
        if (m->point_count < 0 || m->point_count > 2) {
            fuzz_fail(s, "a contact of %d points", m->point_count);
        }
        for (int k = 0; k < m->point_count; k++) {
            note_place(s, m->point[k]);
            note_number(s, (double)m->separation[k]);
            note_number(s, (double)m->normal_impulse[k]);
        }
    }
}

void play_body_volume(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_shape_kind kind = (thud_shape_kind)next_choice(&s->bytes, 4);
    thud_pos origin = pick_place(s);
    thud_volume volume;
    memset(&volume, CALL_FILL, sizeof volume);
    TRY(s, thud_body_get_volume(s->world, body, kind, origin, &volume));
    if (s->result != THUD_OK) {
        call_untouched(s, &volume, sizeof volume);
    } else if (COUNTED(thud_volume_check(&volume)) != THUD_OK) {
        fuzz_fail(s, "a body's volume is none");
    }
}

/* thud_body_make with options, each of which is the default in half of the cases. */
void play_make(fuzz_session *s) {
    thud_geometry at = pick_centred_geometry(s);
    thud_pos place = pick_place(s);
    at.x = place.x;
    at.y = place.y;
    unsigned kinds = next_byte(&s->bytes), flags = next_byte(&s->bytes);
    thud_body_options o = {.kind = (thud_body_kind)(kinds % 4), .user_data = kinds};
    o.velocity = o.kind != THUD_BODY_STATIC ? pick_velocity(s) : o.velocity;
    o.detection = pick_detection(s, kinds / 4);
    o.weightless = flags & 1;
    o.fixed_rotation = flags & 2;
    o.frictionless = flags & 4;
    o.sensor = flags & 8;
    o.friction = flags & 16 ? next_float(&s->bytes, 0, 0.0625) : 0;
    o.density = flags & 32 ? next_float(&s->bytes, 0, 0.0625) : 0;
    o.restitution = flags & 64 ? next_float(&s->bytes, 0, 0.0078125) : 0;
    o.category = flags & 128 ? 1u << kinds % 4 : 0;
    bool room = COUNTED(thud_stats_of(s->world)).shapes < SESSION_WORLD_SHAPES_MAX;
    thud_body_id made = {0, 0};
    if (room) {
        TRY(s, (made = thud_body_make(s->world, at, &o)).index1 ? THUD_OK : s->heard);
        note_bits(s, made.index1);
        if (s->result == THUD_OK) {
            session_keep_body(s, made);
        }
    }
}

/* thud_world_make; a gravity that is not finite makes no world. */
void play_make_world(fuzz_session *s) {
    thud_vec2 gravity = pick_velocity(s);
    const thud_quality *quality = pick_quality(s, next_byte(&s->bytes));
    thud_world *made = COUNTED(thud_world_make(gravity, quality));
    if (!made != !(isfinite(gravity.x) && isfinite(gravity.y)) ||
        COUNTED(thud_world_make(gravity, NULL))) {
        fuzz_fail(s, "a world of gravity %g %g", (double)gravity.x, (double)gravity.y);
    }
    thud_world_destroy(made);
}
