/* api_read.c: what is read in bulk: events, the table of shapes, and debug drawing. */
#include "api.h"

static api_buffer hits, found, shape_rows, shape_ids, awake_flags;
static api_buffer draw_shapes, draw_lines, draw_points;

/* ---- events ---- */

/* Slots out, address and count of each: 0 begin  2 end  4 sensor begin  6 sensor end
 * (two handles, four 32-bit numbers each)  8 quarantined (a body handle each)  10 hits: nine
 * doubles each: shape a, shape b, point, normal, speed. */
int api_world_events(const thud_world *world) {
    thud_events events = thud_world_events(world);
    api_buffer_clear(&hits);
    for (int i = 0; i < events.hit_count; i++) {
        const thud_hit_event *hit = &events.hit[i];
        double row[9] = {hit->shape_a.index1, hit->shape_a.generation,
                         hit->shape_b.index1, hit->shape_b.generation,
                         hit->point.x,        hit->point.y,
                         hit->normal.x,       hit->normal.y,
                         hit->speed};
        api_buffer_push(&hits, row, sizeof row);
    }
    double *s = api_slots;
    s[0] = (double)(uintptr_t)events.begin;
    s[1] = events.begin_count;
    s[2] = (double)(uintptr_t)events.end;
    s[3] = events.end_count;
    s[4] = (double)(uintptr_t)events.sensor_begin;
    s[5] = events.sensor_begin_count;
    s[6] = (double)(uintptr_t)events.sensor_end;
    s[7] = events.sensor_end_count;
    s[8] = (double)(uintptr_t)events.quarantined;
    s[9] = events.quarantined_count;
    s[10] = (double)(uintptr_t)hits.data;
    s[11] = events.hit_count;
    return api_buffer_result(&hits);
}

/* ---- every shape at once, for drawing ---- */

static bool collect(thud_shape_id shape, void *context) {
    api_buffer *buffer = context;
    api_buffer_push(buffer, &shape, sizeof shape);
    return !buffer->failed;
}

/* Fills a table of every shape inside the bounds. A row is ten floats: body slot, shape kind,
 * body kind, sensor, offset x and y, half extents x and y, cosine and sine in the body's frame;
 * and four 32-bit numbers: the handles of the shape and of its body.
 * Slots out: 0 address of the floats  1 of the handles  2 count. */
int api_shape_table(thud_world *world, double lower_x, double lower_y, double upper_x,
                    double upper_y) {
    thud_query_filter filter = thud_default_query_filter();
    filter.sensors = true;
    api_buffer_clear(&found);
    thud_result result =
        thud_world_overlap_aabb(world, (thud_pos){lower_x, lower_y}, (thud_pos){upper_x, upper_y},
                                &filter, collect, &found);
    if (result != THUD_OK)
        return result;
    const thud_shape_id *ids = (const thud_shape_id *)found.data;
    size_t count = found.bytes / sizeof *ids;
    api_buffer_clear(&shape_rows);
    api_buffer_clear(&shape_ids);
    for (size_t i = 0; i < count; i++) {
        thud_shape_state shape;
        thud_body_state body;
        result = thud_shape_get(world, ids[i], &shape);
        if (result == THUD_OK)
            result = thud_body_get(world, shape.body, &body);
        if (result != THUD_OK)
            return result;
        double c, s;
        api_sincos(shape.angle, &s, &c);
        float row[10] = {(float)(shape.body.index1 - 1),
                         (float)shape.kind,
                         (float)body.kind,
                         (float)shape.sensor,
                         shape.offset.x,
                         shape.offset.y,
                         shape.half_extents.x,
                         shape.half_extents.y,
                         (float)c,
                         (float)s};
        uint32_t handles[4] = {ids[i].index1, ids[i].generation, shape.body.index1,
                               shape.body.generation};
        api_buffer_push(&shape_rows, row, sizeof row);
        api_buffer_push(&shape_ids, handles, sizeof handles);
    }
    api_slots[0] = (double)(uintptr_t)shape_rows.data;
    api_slots[1] = (double)(uintptr_t)shape_ids.data;
    api_slots[2] = (double)count;
    return shape_rows.failed ? THUD_ERROR_MEMORY : api_buffer_result(&shape_ids);
}

/* One byte for each row of the last api_shape_table: 1 when its body is awake. Rows whose body
 * has gone read 0. Slots out: 0 address  1 count. */
int api_shape_table_awake(const thud_world *world) {
    const uint32_t *handles = (const uint32_t *)shape_ids.data;
    size_t count = shape_ids.bytes / (4 * sizeof *handles);
    api_buffer_clear(&awake_flags);
    for (size_t i = 0; i < count; i++) {
        thud_body_id id = api_body(handles[4 * i + 2], handles[4 * i + 3]);
        thud_body_state body = {0};
        uint8_t awake = 0;
        if (thud_body_is_valid(world, id) && thud_body_get(world, id, &body) == THUD_OK)
            awake = body.awake;
        api_buffer_push(&awake_flags, &awake, 1);
    }
    api_slots[0] = (double)(uintptr_t)awake_flags.data;
    api_slots[1] = (double)count;
    return api_buffer_result(&awake_flags);
}

/* ---- debug drawing ---- */

static void push_shape(thud_vec2 center, thud_vec2 half, float c, float s, bool round, int style,
                       int island) {
    float row[9] = {center.x, center.y,     half.x,       half.y,       c,
                    s,        (float)round, (float)style, (float)island};
    api_buffer_push(&draw_shapes, row, sizeof row);
}

static void draw_circle(thud_vec2 center, float radius, float c, float s, thud_draw_style style,
                        int island, void *context) {
    (void)context;
    push_shape(center, (thud_vec2){radius, radius}, c, s, true, style, island);
}

static void draw_box(thud_vec2 center, thud_vec2 half, float c, float s, thud_draw_style style,
                     int island, void *context) {
    (void)context;
    push_shape(center, half, c, s, false, style, island);
}

static void draw_line(thud_vec2 a, thud_vec2 b, thud_draw_style style, void *context) {
    (void)context;
    float row[5] = {a.x, a.y, b.x, b.y, (float)style};
    api_buffer_push(&draw_lines, row, sizeof row);
}

static void draw_point(thud_vec2 p, thud_draw_style style, void *context) {
    (void)context;
    float row[3] = {p.x, p.y, (float)style};
    api_buffer_push(&draw_points, row, sizeof row);
}

/* Slots out, address and count of each: 0 shapes (nine floats: centre, half extents, cosine,
 * sine, 1 if a circle, style, island)  2 lines (five: both ends, style)  4 points (three: place,
 * style). Coordinates are relative to the origin given. */
int api_world_draw(thud_world *world, double flags, double origin_x, double origin_y,
                   double lower_x, double lower_y, double upper_x, double upper_y) {
    api_buffer_clear(&draw_shapes);
    api_buffer_clear(&draw_lines);
    api_buffer_clear(&draw_points);
    thud_debug_draw draw = {.flags = api_to_u32(flags),
                            .origin = {origin_x, origin_y},
                            .lower = {lower_x, lower_y},
                            .upper = {upper_x, upper_y},
                            .circle = draw_circle,
                            .box = draw_box,
                            .line = draw_line,
                            .point = draw_point};
    thud_result result = thud_world_draw(world, &draw);
    if (result != THUD_OK)
        return result;
    api_slots[0] = (double)(uintptr_t)draw_shapes.data;
    api_slots[1] = (double)(draw_shapes.bytes / (9 * sizeof(float)));
    api_slots[2] = (double)(uintptr_t)draw_lines.data;
    api_slots[3] = (double)(draw_lines.bytes / (5 * sizeof(float)));
    api_slots[4] = (double)(uintptr_t)draw_points.data;
    api_slots[5] = (double)(draw_points.bytes / (3 * sizeof(float)));
    if (draw_shapes.failed || draw_lines.failed)
        return THUD_ERROR_MEMORY;
    return api_buffer_result(&draw_points);
}
