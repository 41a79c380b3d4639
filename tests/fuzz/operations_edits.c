/* operations_edits.c: operations that change single values of bodies and shapes, apply forces,
 * convert points and vectors of bodies, and read single values. */
#include "operations.h"

#include <thud/thud_edits.h>
#include <thud/thud_forces.h>
#include <thud/thud_locks.h>
#include <thud/thud_reads.h>
#include <thud/thud_version.h>

void play_shape_edit(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    switch (next_choice(&s->bytes, 9)) {
    case 0: {
        thud_filter filter = {1u << next_choice(&s->bytes, 4), next_byte(&s->bytes) | 0xf0u, 0};
        filter.group = next_choice(&s->bytes, 5) - 2;
        TRY(s, thud_shape_set_filter(s->world, shape, filter));
        return;
    }
    case 1: {
        float friction = next_float(&s->bytes, 0, 0.0078125);
        TRY(s, thud_shape_set_friction(s->world, shape, friction));
        return;
    }
    case 2: {
        float restitution = next_float(&s->bytes, 0, 1.0 / 239);
        TRY(s, thud_shape_set_restitution(s->world, shape, restitution));
        return;
    }
    case 3: {
        float speed = pick_speed(s);
        TRY(s, thud_shape_set_surface_speed(s->world, shape, speed));
        return;
    }
    case 4: {
        float density = next_float(&s->bytes, 0, 0.125);
        TRY(s, thud_shape_set_density(s->world, shape, density));
        return;
    }
    case 5: {
        bool sensor = next_choice(&s->bytes, 2) == 0;
        TRY(s, thud_shape_set_sensor(s->world, shape, sensor));
        return;
    }
    case 6: {
        float radius = pick_size(s);
        TRY(s, thud_shape_set_radius(s->world, shape, radius));
        return;
    }
    case 7: {
        thud_vec2 half = pick_sizes(s);
        TRY(s, thud_shape_set_half_extents(s->world, shape, half));
        return;
    }
    default: {
        uint64_t data = next_byte(&s->bytes);
        TRY(s, thud_shape_set_user_data(s->world, shape, data));
    }
    }
}

void play_events(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    bool events = next_choice(&s->bytes, 2) == 0;
    thud_shape_state state;
    TRY(s, thud_shape_set_events(s->world, shape, events));
    if (s->result == THUD_OK && thud_shape_get_state(s->world, shape, &state) == THUD_OK &&
        state.events != events) {
        fuzz_fail(s, "events of shape %u are %d and were set %d", shape.index1, state.events,
                  events);
    }
}

void play_locks(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    int axes = next_choice(&s->bytes, 4);
    bool x = false, y = false;
    TRY(s, thud_body_set_locks(s->world, body, axes & 1, axes & 2));
    bool set = s->result == THUD_OK;
    TRY(s, thud_body_get_locks(s->world, body, &x, &y));
    if (set && (x != (axes & 1) || y != axes >> 1)) {
        fuzz_fail(s, "locks of body %u are %d, %d and were set %d", body.index1, x, y, axes);
    }
}

void play_body_edit(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    switch (next_choice(&s->bytes, 7)) {
    case 0: {
        thud_body_kind kind = (thud_body_kind)next_choice(&s->bytes, 3);
        TRY(s, thud_body_set_kind(s->world, body, kind));
        return;
    }
    case 1: {
        float linear = next_float(&s->bytes, 0, 0.125), turn = next_float(&s->bytes, 0, 0.125);
        TRY(s, thud_body_set_damping(s->world, body, linear, turn));
        return;
    }
    case 2: {
        float scale = next_float(&s->bytes, -1, 0.0625);
        TRY(s, thud_body_set_gravity_scale(s->world, body, scale));
        return;
    }
    case 3: {
        bool fixed = next_choice(&s->bytes, 2) == 0;
        TRY(s, thud_body_set_fixed_rotation(s->world, body, fixed));
        return;
    }
    case 4: {
        const thud_detection *detection = pick_detection(s, next_byte(&s->bytes));
        TRY(s, thud_body_set_detection(s->world, body, detection));
        return;
    }
    case 5: {
        bool may = next_choice(&s->bytes, 2) == 0;
        TRY(s, thud_body_set_may_sleep(s->world, body, may));
        return;
    }
    default: {
        thud_mass mass = {.mass = next_float(&s->bytes, 0.125, 0.125)};
        mass.inertia = next_float(&s->bytes, 0, 0.125);
        mass.center.x = pick_size(s);
        bool own = next_choice(&s->bytes, 3) == 0;
        TRY(s, thud_body_set_mass(s->world, body, own ? NULL : &mass));
    }
    }
}

void play_push(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    int which = next_choice(&s->bytes, 4);
    thud_vec2 push = pick_velocity(s);
    thud_pos place = pick_place(s);
    float turn = next_float(&s->bytes, -16, 0.125);
    if (which == 0) {
        TRY(s, thud_body_apply_force(s->world, body, push, place));
    } else if (which == 1) {
        TRY(s, thud_body_apply_center_impulse(s->world, body, push));
    } else if (which == 2) {
        TRY(s, thud_body_apply_angular_impulse(s->world, body, turn));
    } else {
        TRY(s, thud_body_set_target(s->world, body, place, (double)turn));
    }
}

/* Called, but not added to the digest: velocities that no step has processed need not be finite. */
void play_points(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_pos place = pick_place(s), out = {0, 0};
    thud_vec2 vector = pick_velocity(s), told = {0, 0};
    TRY(s, thud_body_get_velocity_at(s->world, body, place, &told));
    TRY(s, thud_body_get_world_point(s->world, body, vector, &out));
    TRY(s, thud_body_get_local_point(s->world, body, place, &told));
    TRY(s, thud_body_get_world_vector(s->world, body, vector, &told));
    TRY(s, thud_body_get_local_vector(s->world, body, vector, &told));
}

void play_reads(fuzz_session *s) {
    thud_body_id body = pick_body(s), owner = {0, 0};
    thud_shape_id shape = pick_shape(s);
    thud_pos place = {0, 0};
    thud_vec2 velocity;
    double angle = 0;
    float c, sine, turn;
    uint64_t data = 0;
    thud_step_settings settings;
    TRY(s, thud_body_get_position(s->world, body, &place));
    TRY(s, thud_body_get_rotation(s->world, body, &angle, &c, &sine));
    TRY(s, thud_body_get_velocity(s->world, body, &velocity, &turn));
    TRY(s, thud_body_get_user_data(s->world, body, &data));
    TRY(s, thud_shape_get_user_data(s->world, shape, &data));
    TRY(s, thud_shape_get_body(s->world, shape, &owner));
    TRY(s, thud_world_get_step_settings(s->world, &settings));
    note_number(s, angle);
    note_bits(s, data + owner.index1 + (uint64_t)settings.substeps);
    note_bits(s, (uint64_t)COUNTED(thud_version()));
}
