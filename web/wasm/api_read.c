/* api_read.c: exports that read a whole world: events, a table of all shapes, and debug drawing.
 * api.h has the conventions. */
#include "api.h"

#include <thud/thud_lists.h>

static api_buffer hits, shape_rows, shape_ids, awake_flags;
static api_buffer draw_shapes, draw_lines, draw_points;

/* ---- events ---- */

/* Slots out: events, with rows of event_pair, handles of bodies and rows of hit_event. */
int api_world_events(const thud_world *world) {
    thud_events events = thud_events_of(world);
    api_buffer_clear(&hits);
    for (int i = 0; i < events.hit_count; i++) {
        const thud_hit_event *hit = &events.hit[i];
        struct hit_event row = {.shape_a = {hit->shape_a.index1, hit->shape_a.generation},
                                .shape_b = {hit->shape_b.index1, hit->shape_b.generation},
                                .point = {hit->point.x, hit->point.y},
                                .normal = {hit->normal.x, hit->normal.y},
                                .speed = hit->speed};
        api_buffer_push(&hits, &row, sizeof row);
    }
    struct events *s = &api_slots.events;
    s->begin.address = (double)(uintptr_t)events.begin;
    s->begin.count = events.begin_count;
    s->end.address = (double)(uintptr_t)events.end;
    s->end.count = events.end_count;
    s->sensor_begin.address = (double)(uintptr_t)events.sensor_begin;
    s->sensor_begin.count = events.sensor_begin_count;
    s->sensor_end.address = (double)(uintptr_t)events.sensor_end;
    s->sensor_end.count = events.sensor_end_count;
    s->sensor_begin_time.address = (double)(uintptr_t)events.sensor_begin_time;
    s->sensor_begin_time.count = events.sensor_begin_count;
    s->sensor_end_time.address = (double)(uintptr_t)events.sensor_end_time;
    s->sensor_end_time.count = events.sensor_end_count;
    s->quarantined.address = (double)(uintptr_t)events.quarantined;
    s->quarantined.count = events.quarantined_count;
    s->hits.address = (double)(uintptr_t)hits.data;
    s->hits.count = events.hit_count;
    return api_buffer_result(&hits);
}

/* ---- all shapes at once, for drawing ---- */

/* Fills a table of all shapes but those of disabled bodies. Slots out: shape_table, with a
 * shape_row and a shape_handles for each shape. */
int api_shape_table(const thud_world *world) {
    int slots = 0;
    thud_result result = thud_world_get_slot_counts(world, NULL, &slots);
    if (result != THUD_OK)
        return result;
    api_buffer_clear(&shape_rows);
    api_buffer_clear(&shape_ids);
    for (int slot = 0; slot < slots; slot++) {
        thud_shape_id id;
        thud_shape_state shape;
        thud_body_state body;
        if (thud_world_get_shape_at(world, slot, &id) != THUD_OK || id.index1 == 0)
            continue;
        result = thud_shape_get_state(world, id, &shape);
        if (result == THUD_OK)
            result = thud_body_get_state(world, shape.body, &body);
        if (result != THUD_OK)
            return result;
        if (!body.enabled)
            continue;
        double c, s;
        api_sincos(shape.angle, &s, &c);
        struct shape_row row = {.slot = (float)(shape.body.index1 - 1),
                                .shape = (float)shape.kind,
                                .body = (float)body.kind,
                                .sensor = (float)shape.sensor,
                                .offset = {shape.offset.x, shape.offset.y},
                                .half_extents = {shape.half_extents.x, shape.half_extents.y},
                                .cosine = (float)c,
                                .sine = (float)s};
        struct shape_handles handles = {{id.index1, id.generation},
                                        {shape.body.index1, shape.body.generation}};
        api_buffer_push(&shape_rows, &row, sizeof row);
        api_buffer_push(&shape_ids, &handles, sizeof handles);
    }
    api_slots.shape_table.rows = (double)(uintptr_t)shape_rows.data;
    api_slots.shape_table.handles = (double)(uintptr_t)shape_ids.data;
    api_slots.shape_table.count = (double)(shape_ids.bytes / sizeof(struct shape_handles));
    return shape_rows.failed ? THUD_ERROR_MEMORY : api_buffer_result(&shape_ids);
}

/* For each row of the last api_shape_table a byte: 1 where its body is awake, 0 where it sleeps or
 * was destroyed. Slots out: list of bytes. */
int api_shape_table_awake(const thud_world *world) {
    const struct shape_handles *handles = (const struct shape_handles *)shape_ids.data;
    size_t count = shape_ids.bytes / sizeof *handles;
    api_buffer_clear(&awake_flags);
    for (size_t i = 0; i < count; i++) {
        thud_body_id id = api_body(handles[i].body[0], handles[i].body[1]);
        thud_body_state body = {0};
        uint8_t awake = 0;
        if (thud_body_is_valid(world, id) && thud_body_get_state(world, id, &body) == THUD_OK)
            awake = body.awake;
        api_buffer_push(&awake_flags, &awake, 1);
    }
    api_slots.list.address = (double)(uintptr_t)awake_flags.data;
    api_slots.list.count = (double)count;
    return api_buffer_result(&awake_flags);
}

/* ---- debug drawing ---- */

/* The callbacks of thud_debug_draw append a row each. */
static void push_shape(thud_vec2 center, thud_vec2 half, float c, float s, bool round, int style,
                       int island) {
    struct draw_shape row = {.center = {center.x, center.y},
                             .half_extents = {half.x, half.y},
                             .cosine = c,
                             .sine = s,
                             .round = (float)round,
                             .style = (float)style,
                             .island = (float)island};
    api_buffer_push(&draw_shapes, &row, sizeof row);
}

static void draw_circle(thud_vec2 center, float radius, float c, float s, thud_style style,
                        int island, void *context) {
    (void)context;
    push_shape(center, (thud_vec2){radius, radius}, c, s, true, style, island);
}

static void draw_box(thud_vec2 center, thud_vec2 half, float c, float s, thud_style style,
                     int island, void *context) {
    (void)context;
    push_shape(center, half, c, s, false, style, island);
}

static void draw_line(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    (void)context;
    struct draw_line row = {.from = {a.x, a.y}, .to = {b.x, b.y}, .style = (float)style};
    api_buffer_push(&draw_lines, &row, sizeof row);
}

static void draw_point(thud_vec2 p, thud_style style, void *context) {
    (void)context;
    struct draw_point row = {.place = {p.x, p.y}, .style = (float)style};
    api_buffer_push(&draw_points, &row, sizeof row);
}

/* Draws the region from `lower` to `upper`; `flags` are those of thud_debug_draw. Coordinates are
 * relative to the origin. Slots out: draw_lists, with rows of draw_shape, draw_line and draw_point.
 */
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
    api_slots.draw_lists.shapes.address = (double)(uintptr_t)draw_shapes.data;
    api_slots.draw_lists.shapes.count = (double)(draw_shapes.bytes / sizeof(struct draw_shape));
    api_slots.draw_lists.lines.address = (double)(uintptr_t)draw_lines.data;
    api_slots.draw_lists.lines.count = (double)(draw_lines.bytes / sizeof(struct draw_line));
    api_slots.draw_lists.points.address = (double)(uintptr_t)draw_points.data;
    api_slots.draw_lists.points.count = (double)(draw_points.bytes / sizeof(struct draw_point));
    if (draw_shapes.failed || draw_lines.failed)
        return THUD_ERROR_MEMORY;
    return api_buffer_result(&draw_points);
}
