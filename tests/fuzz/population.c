/* population.c: the bodies that a session's world has at the beginning, so that a few bytes of
 * input are enough for bodies to collide. */
#include "calls.h"

static thud_body_id add_body(fuzz_session *s, thud_body_kind kind, double x, double y) {
    thud_body_def def = thud_default_body_def();
    thud_body_id body = {0, 0};
    def.kind = kind;
    def.position = (thud_pos){s->shift_x + x * s->unit, s->shift_y + y * s->unit};
    TRY(s, thud_body_create(s->world, &def, &body));
    s->now.bodies[s->now.next_body++ % SESSION_BODIES] = body;
    return body;
}

/* Adds a circle if hy is 0, otherwise a box. */
static void add_shape(fuzz_session *s, thud_body_id body, double hx, double hy, bool sensor) {
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id shape = {0, 0};
    thud_vec2 half = {(float)(hx * s->unit), (float)(hy * s->unit)}, zero = {0, 0};
    def.sensor = sensor;
    if (hy == 0) {
        TRY(s, thud_shape_create_circle(s->world, body, &def, zero, half.x, &shape));
    } else if (s->now.next_shape % 4 == 3) {
        TRY(s, thud_shape_create_aabb(s->world, body, &def, zero, half, &shape));
    } else {
        TRY(s, thud_shape_create_obb(s->world, body, &def, zero, half, 0, &shape));
    }
    s->now.shapes[s->now.next_shape++ % SESSION_SHAPES] = shape;
}

static void add_ground(fuzz_session *s, thud_terrain_kind kind) {
    thud_shape_def def = thud_default_shape_def();
    thud_pos points[17];
    for (int i = 0; i < 17; i++) {
        points[i] = (thud_pos){2 * s->unit * (i - 8), 0.25 * s->unit * (i % 3)};
    }
    thud_terrain line = {.kind = kind,
                         .slope = 0.125,
                         .x0 = -16 * s->unit,
                         .spacing = 2 * s->unit,
                         .points = points,
                         .count = 17};
    thud_shape_id shape = {0, 0};
    thud_body_id body = add_body(s, THUD_BODY_STATIC, 0, 0);
    TRY(s, thud_shape_create_terrain(s->world, body, &def, &line, &shape));
    s->now.shapes[s->now.next_shape++ % SESSION_SHAPES] = shape;
}

static void add_heap(fuzz_session *s, int count) {
    for (int i = 0; i < count; i++) {
        thud_body_id body = add_body(s, THUD_BODY_DYNAMIC, 0.25 * (i % 3), 1 + i);
        add_shape(s, body, 0.5, i % 3 == 2 ? 0 : 0.5, false);
    }
}

void session_populate(fuzz_session *s, int kind) {
    s->operation = "the population";
    if (kind % 8 == 0) {
        return;
    }
    if (kind % 8 < 4) {
        add_ground(s, (thud_terrain_kind)(kind % 8 - 1));
    } else {
        add_shape(s, add_body(s, THUD_BODY_STATIC, 0, -1), 16, 1, false);
    }
    add_heap(s, kind % 8 == 7 ? 12 : kind % 8);
    if (kind & 8) {
        add_shape(s, add_body(s, THUD_BODY_STATIC, 0, 2), 2, 1, true);
    }
    if (kind & 16) {
        thud_body_id lift = add_body(s, THUD_BODY_KINEMATIC, -3, 0.5);
        add_shape(s, lift, 1, 0.25, false);
        TRY(s, thud_body_set_velocity(s->world, lift, (thud_vec2){(float)s->unit, 0}, 0.5f));
        if (s->twin !=
            TWIN_SHIFT) { /* the mover's place depends on positions that a shift rounds */
            s->now.mover.body = lift;
        }
    }
}
