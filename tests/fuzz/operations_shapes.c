/* operations_shapes.c: operations that create, read and destroy shapes, and that edit terrain
 * lines. */
#include "operations.h"

/* Whether the world has as many shapes as a session may create. */
static bool full(fuzz_session *s) {
    return COUNTED(thud_stats_of(s->world)).shapes >= SESSION_WORLD_SHAPES_MAX;
}

static thud_shape_def shape_def(fuzz_session *s) {
    thud_shape_def def = COUNTED(thud_default_shape_def());
    unsigned byte = next_byte(&s->bytes);
    def.sensor = (byte & 7) == 7;
    if (byte & 8) {
        def.density = next_float(&s->bytes, 0, 0.125);
        def.friction = next_float(&s->bytes, 0, 0.0078125);
    }
    if (byte & 16) {
        def.restitution = next_float(&s->bytes, 0, 1.0 / 239);
        def.surface_speed = pick_speed(s);
    }
    if (byte & 32) {
        def.filter.category = 1u << next_choice(&s->bytes, 4);
        def.filter.mask = next_byte(&s->bytes) | 0xf0u;
        def.filter.group = next_choice(&s->bytes, 5) - 2;
    }
    def.user_data = byte;
    return def;
}

static void keep_shape(fuzz_session *s, thud_shape_id made) {
    if (s->result == THUD_OK) {
        note_bits(s, made.index1);
        thud_shape_id *place = &s->now.shapes[s->now.next_shape++ % SESSION_SHAPES];
        s->gone_shapes[s->gone++ % SESSION_GONE] = *place;
        *place = made;
    } else if (made.index1 || made.generation) {
        fuzz_fail(s, "a shape that was refused has a handle");
    }
}

static void add_circle(fuzz_session *s, thud_body_id body) {
    if (full(s)) {
        return;
    }
    thud_shape_def def = shape_def(s);
    thud_shape_id made = {0, 0};
    float radius = pick_size(s);
    thud_vec2 offset = {next_choice(&s->bytes, 4) ? 0 : pick_size(s), 0};
    TRY(s, thud_shape_create_circle(s->world, body, &def, offset, radius, &made));
    keep_shape(s, made);
}

static void add_aabb(fuzz_session *s, thud_body_id body) {
    if (full(s)) {
        return;
    }
    thud_shape_def def = shape_def(s);
    thud_shape_id made = {0, 0};
    thud_vec2 half = pick_sizes(s), offset = {0, next_choice(&s->bytes, 4) ? 0 : pick_size(s)};
    TRY(s, thud_shape_create_aabb(s->world, body, &def, offset, half, &made));
    keep_shape(s, made);
}

static void add_obb(fuzz_session *s, thud_body_id body) {
    if (full(s)) {
        return;
    }
    thud_shape_def def = shape_def(s);
    thud_shape_id made = {0, 0};
    thud_vec2 half = pick_sizes(s), offset = {next_choice(&s->bytes, 4) ? 0 : pick_size(s), 0};
    double angle = pick_angle(s);
    TRY(s, thud_shape_create_obb(s->world, body, &def, offset, half, angle, &made));
    keep_shape(s, made);
}

void play_circle(fuzz_session *s) {
    add_circle(s, pick_body(s));
}

void play_aabb(fuzz_session *s) {
    add_aabb(s, pick_body(s));
}

void play_obb(fuzz_session *s) {
    add_obb(s, pick_body(s));
}

/* A body with a shape, which a fuzzer would seldom find with two operations. */
void play_thing(fuzz_session *s) {
    int next = s->now.next_body;
    play_body(s);
    if (s->now.next_body != next) {
        thud_body_id body = s->now.bodies[next % SESSION_BODIES];
        static void (*const add[])(fuzz_session *, thud_body_id) = {add_circle, add_obb, add_aabb};
        add[next_choice(&s->bytes, 3)](s, body);
    }
}

void play_ground(fuzz_session *s) {
    if (full(s)) {
        return;
    }
    thud_body_id body = pick_body(s);
    thud_shape_def def = shape_def(s);
    thud_shape_id made = {0, 0};
    thud_pos points[PICK_POINTS];
    thud_terrain line = pick_line(s, points);
    TRY(s, thud_shape_create_terrain(s->world, body, &def, &line, &made));
    keep_shape(s, made);
}

void play_shape_destroy(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    bool valid = COUNTED(thud_shape_is_valid(s->world, shape));
    TRY(s, thud_shape_destroy(s->world, shape));
    s->destroyed_inside += s->depth && s->result == THUD_OK;
    if (valid != (s->result == THUD_OK) || COUNTED(thud_shape_is_valid(s->world, shape))) {
        fuzz_fail(s, "a shape that is %s cannot go, or has gone and is valid: %s",
                  valid ? "valid" : "stale", thud_result_text(s->result));
    }
}

void play_shape_get(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    thud_shape_state state;
    memset(&state, CALL_FILL, sizeof state);
    TRY(s, thud_shape_get_state(s->world, shape, &state));
    if (s->result != THUD_OK) {
        call_untouched(s, &state, sizeof state);
        return;
    }
    note_bits(s, state.body.index1);
    note_vector(s, state.offset);
    note_vector(s, state.half_extents);
    note_number(s, state.angle);
    note_number(s, (double)(state.density + state.friction + state.restitution));
    note_number(s, (double)state.surface_speed);
    if (!COUNTED(thud_body_is_valid(s->world, state.body))) {
        fuzz_fail(s, "a shape's body is gone");
    }
}

/* ---- terrain lines ---- */

static void check_line(fuzz_session *s, thud_shape_id shape) {
    thud_terrain line;
    if (COUNTED(thud_shape_get_terrain(s->world, shape, &line)) != THUD_OK) {
        return;
    }
    note_bits(s, (uint64_t)line.count);
    if (COUNTED(thud_terrain_check(&line)) != THUD_OK) {
        fuzz_fail(s, "a world's line is none");
    }
    s->calls[s->depth].text = "thud_shape_get_terrain";
    for (int i = 0; i < (line.kind == THUD_TERRAIN_FLAT ? 0 : line.count); i++) {
        note_number(s, line.points[i].y);
    }
}

void play_line_of(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    thud_terrain line;
    memset(&line, CALL_FILL, sizeof line);
    TRY(s, thud_shape_get_terrain(s->world, shape, &line));
    if (s->result != THUD_OK) {
        call_untouched(s, &line, sizeof line);
    }
    check_line(s, shape);
}

void play_set_heights(fuzz_session *s) {
    enum { ROOM = 5 };
    thud_shape_id shape = pick_shape(s);
    int first = next_count(&s->bytes, 18), count = next_count(&s->bytes, ROOM);
    double heights[ROOM];
    count = count > ROOM ? -1 : count;
    for (int i = 0; i < ROOM; i++) {
        heights[i] = i < count ? pick_coordinate(s) : 0;
    }
    TRY(s, thud_shape_set_heights(s->world, shape, first, heights, count));
    check_line(s, shape);
}

void play_dig(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    thud_pos center = pick_place(s);
    double radius = (double)pick_size(s);
    TRY(s, thud_shape_dig(s->world, shape, center, radius));
    check_line(s, shape);
}

void play_raise(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    double x = pick_place(s).x, radius = (double)pick_size(s), height = pick_coordinate(s) / 4;
    TRY(s, thud_shape_raise(s->world, shape, x, radius, height));
    check_line(s, shape);
}

void play_replace(fuzz_session *s) {
    enum { ROOM = 4 };
    thud_shape_id shape = pick_shape(s);
    double x0 = pick_coordinate(s), x1 = x0 + 4 * (double)pick_size(s);
    int count = next_count(&s->bytes, ROOM);
    thud_pos points[ROOM];
    count = count > ROOM ? -1 : count;
    for (int i = 0; i < ROOM; i++) {
        double along = next_chance(&s->bytes, 32) ? 1.5 : (i + 0.5) / (count > 0 ? count : 1);
        points[i] = (thud_pos){x0 + (x1 - x0) * along, pick_coordinate(s) / 8};
    }
    TRY(s, thud_shape_replace_range(s->world, shape, x0, x1, points, count));
    check_line(s, shape);
}
