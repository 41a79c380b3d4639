/* api_query.c: what is where in a world: rays, casts, overlaps, the closest shape. A query's
 * own shape is its kind, half extents (a circle's radius is the first) and angle. */
#include "api.h"

enum { ROOM = 64 };

static api_buffer found, hits, rows;

static thud_query_filter query_filter(double category, double mask, int sensors) {
    return (thud_query_filter){api_to_u32(category), api_to_u32(mask), sensors != 0};
}

thud_shape_instance api_placed(int kind, double hx, double hy, double angle) {
    thud_shape_instance placed = {.kind = (thud_shape_kind)kind, .c = 1.0, .hx = hx, .hy = hy};
    switch (placed.kind) {
    case THUD_CIRCLE:
        placed.hy = 0.0;
        break;
    case THUD_OBB:
        api_sincos(angle, &placed.s, &placed.c);
        break;
    case THUD_AABB:
    case THUD_TERRAIN: /* which the engine refuses */
        break;
    }
    return placed;
}

static struct ray_hit row_of(const thud_ray_hit *hit) {
    return (struct ray_hit){.shape = {hit->shape.index1, hit->shape.generation},
                            .point = {hit->point.x, hit->point.y},
                            .normal = {hit->normal.x, hit->normal.y},
                            .fraction = hit->fraction,
                            .depth = hit->depth};
}

/* ---- rays and casts ---- */

/* Slots out: first_hit. */
int api_cast_ray(thud_world *world, double x, double y, double dx, double dy, double category,
                 double mask, int sensors) {
    thud_query_filter filter = query_filter(category, mask, sensors);
    bool hit = false;
    thud_ray_hit ray = {0};
    thud_result result = thud_world_cast_ray(world, (thud_pos){x, y}, dx, dy, &filter, &hit, &ray);
    api_slots.first_hit = (struct first_hit){hit, row_of(&ray)};
    return result;
}

/* Slots out: first_hit. */
int api_cast_shape(thud_world *world, int kind, double x, double y, double hx, double hy,
                   double angle, double dx, double dy, double category, double mask, int sensors) {
    thud_query_filter filter = query_filter(category, mask, sensors);
    thud_shape_instance shape = api_placed(kind, hx, hy, angle);
    bool hit = false;
    thud_ray_hit met = {0};
    thud_result result =
        thud_world_cast_shape(world, (thud_pos){x, y}, &shape, dx, dy, &filter, &hit, &met);
    api_slots.first_hit = (struct first_hit){hit, row_of(&met)};
    return result;
}

/* Every hit of a ray (kind -1) or a shape, nearest first. Slots out: list of ray_hit. */
int api_cast_all(thud_world *world, int kind, double x, double y, double hx, double hy,
                 double angle, double dx, double dy, double category, double mask, int sensors) {
    thud_query_filter filter = query_filter(category, mask, sensors);
    thud_shape_instance shape = api_placed(kind, hx, hy, angle);
    static const thud_ray_hit none = {0};
    int count = ROOM, room = 0;
    while (room < count) { /* once more where there are more hits than room for them */
        api_buffer_clear(&hits);
        for (room = 0; room < count; room++)
            api_buffer_push(&hits, &none, sizeof none);
        if (hits.failed)
            return THUD_ERROR_MEMORY;
        thud_ray_hit *out = (thud_ray_hit *)hits.data;
        thud_pos at = {x, y};
        thud_result result =
            kind < 0
                ? thud_world_cast_ray_all(world, at, dx, dy, &filter, out, room, &count)
                : thud_world_cast_shape_all(world, at, &shape, dx, dy, &filter, out, room, &count);
        if (result != THUD_OK)
            return result;
    }
    api_buffer_clear(&rows);
    for (int i = 0; i < count; i++) {
        struct ray_hit row = row_of((const thud_ray_hit *)hits.data + i);
        api_buffer_push(&rows, &row, sizeof row);
    }
    api_slots.list.address = (double)(uintptr_t)rows.data;
    api_slots.list.count = count;
    return api_buffer_result(&rows);
}

/* Slots out: closest_hit. */
int api_closest(thud_world *world, double x, double y, double max_distance, double category,
                double mask, int sensors) {
    thud_query_filter filter = query_filter(category, mask, sensors);
    bool any = false;
    thud_closest_hit hit = {0};
    thud_result result =
        thud_world_closest(world, (thud_pos){x, y}, max_distance, &filter, &any, &hit);
    struct closest_hit *s = &api_slots.closest_hit;
    s->found = any;
    s->shape[0] = hit.shape.index1;
    s->shape[1] = hit.shape.generation;
    s->point[0] = hit.point.x;
    s->point[1] = hit.point.y;
    s->normal[0] = hit.normal.x;
    s->normal[1] = hit.normal.y;
    s->distance = hit.distance;
    return result;
}

/* ---- overlaps ---- */

static bool collect(thud_shape_id shape, void *context) {
    api_buffer *buffer = context;
    api_buffer_push(buffer, &shape, sizeof shape);
    return !buffer->failed;
}

static int collected(thud_result result) {
    api_slots.list.address = (double)(uintptr_t)found.data;
    api_slots.list.count = (double)(found.bytes / sizeof(thud_shape_id));
    return result != THUD_OK ? result : api_buffer_result(&found);
}

/* Slots out: list of handles. */
int api_overlap_aabb(thud_world *world, double lower_x, double lower_y, double upper_x,
                     double upper_y, double category, double mask, int sensors) {
    thud_query_filter filter = query_filter(category, mask, sensors);
    api_buffer_clear(&found);
    return collected(thud_world_overlap_aabb(world, (thud_pos){lower_x, lower_y},
                                             (thud_pos){upper_x, upper_y}, &filter, collect,
                                             &found));
}

/* The same for a circle, AABB or OBB with its centre at (x, y). */
int api_overlap_shape(thud_world *world, int kind, double x, double y, double hx, double hy,
                      double angle, double category, double mask, int sensors) {
    thud_query_filter filter = query_filter(category, mask, sensors);
    thud_shape_instance shape = api_placed(kind, hx, hy, angle);
    api_buffer_clear(&found);
    return collected(
        thud_world_overlap_shape(world, (thud_pos){x, y}, &shape, &filter, collect, &found));
}
