/* api_query.c: exports for queries: rays, casts, overlaps, the closest shape (thud_queries.h,
 * thud_casts.h). The shape of a query is four numbers, see api_placed; its filter is in the slots
 * filter_options. api.h has the conventions. */
#include "api.h"

#include <thud/thud_casts.h>
#include <thud/thud_prediction.h>

/* Hits for which api_cast_all has room at first. Chosen: more hits only cost a second cast. */
enum { ROOM = 64 };

static api_buffer found, hits, rows;

thud_query_filter api_filter(const struct filter_options *s) {
    return (thud_query_filter){.category = api_to_u32(s->category),
                               .mask = api_to_u32(s->mask),
                               .sensors = s->sensors != 0.0,
                               .group = api_to_int(s->group),
                               .ignore = {api_to_u32(s->ignore.index1),
                                          api_to_u32(s->ignore.generation)}};
}

/* Slots in: filter_options. */
static thud_query_filter filter_now(void) {
    return api_filter(&api_slots.filter_options);
}

thud_geometry api_placed(int kind, double hx, double hy, double angle) {
    thud_geometry placed = {.kind = (thud_shape_kind)kind, .c = 1.0, .hx = hx, .hy = hy};
    switch (placed.kind) {
    case THUD_SHAPE_CIRCLE:
        placed.hy = 0.0;
        break;
    case THUD_SHAPE_OBB:
        api_sincos(angle, &placed.s, &placed.c);
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_TERRAIN: /* refused by the engine */
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
int api_cast_ray(thud_world *world, double x, double y, double dx, double dy) {
    thud_query_filter filter = filter_now();
    thud_ray ray = {{x, y}, dx, dy, &filter};
    bool hit = false;
    thud_ray_hit first = {0};
    thud_result result = thud_world_cast_ray(world, &ray, &hit, &first);
    api_slots.first_hit = (struct first_hit){hit, row_of(&first)};
    return result;
}

/* Slots out: first_hit. */
int api_cast_shape(thud_world *world, int kind, double x, double y, double hx, double hy,
                   double angle, double dx, double dy) {
    thud_query_filter filter = filter_now();
    thud_shape_cast cast = {{x, y}, api_placed(kind, hx, hy, angle), dx, dy, &filter};
    bool hit = false;
    thud_ray_hit first = {0};
    thud_result result = thud_world_cast_shape(world, &cast, &hit, &first);
    api_slots.first_hit = (struct first_hit){hit, row_of(&first)};
    return result;
}

/* All hits of a ray (kind -1) or a shape, the nearest first. Slots out: list of ray_hit. */
int api_cast_all(thud_world *world, int kind, double x, double y, double hx, double hy,
                 double angle, double dx, double dy) {
    thud_query_filter filter = filter_now();
    thud_ray ray = {{x, y}, dx, dy, &filter};
    thud_shape_cast cast = {{x, y}, api_placed(kind, hx, hy, angle), dx, dy, &filter};
    static const thud_ray_hit none = {0};
    int count = ROOM, room = 0;
    while (room < count) { /* a second time where there are more hits than ROOM */
        api_buffer_clear(&hits);
        for (room = 0; room < count; room++)
            api_buffer_push(&hits, &none, sizeof none);
        if (hits.failed)
            return THUD_ERROR_MEMORY;
        thud_ray_hit *out = (thud_ray_hit *)hits.data;
        thud_result result = kind < 0 ? thud_world_cast_ray_all(world, &ray, out, room, &count)
                                      : thud_world_cast_shape_all(world, &cast, out, room, &count);
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

/* Import of the module: calls the JavaScript listener of the cast with the hit in the slots
 * first_hit, and returns its limit, as a thud_cast_fn does. */
extern double thud_cast_hit(void);

static double met(const thud_ray_hit *hit, void *context) {
    (void)context;
    api_slots.first_hit = (struct first_hit){true, row_of(hit)};
    return thud_cast_hit();
}

/* Calls thud_cast_hit for each hit of a ray (kind -1) or a shape. */
int api_cast_each(thud_world *world, int kind, double x, double y, double hx, double hy,
                  double angle, double dx, double dy) {
    thud_query_filter filter = filter_now();
    thud_ray ray = {{x, y}, dx, dy, &filter};
    thud_shape_cast cast = {{x, y}, api_placed(kind, hx, hy, angle), dx, dy, &filter};
    return kind < 0 ? thud_world_cast_ray_each(world, &ray, met, NULL)
                    : thud_world_cast_shape_each(world, &cast, met, NULL);
}

/* The first hit of each of `count` rays, four doubles each: origin and displacement. All have the
 * same filter. Slots out: list of ray_hit, with the handle 0, 0 where a ray hit no shape. */
int api_cast_rays(thud_world *world, const double *numbers, int count) {
    thud_query_filter filter = filter_now();
    api_buffer_clear(&found);
    api_buffer_clear(&hits);
    api_buffer_clear(&rows);
    for (int i = 0; i < count; i++) {
        const double *n = numbers + 4 * i;
        thud_ray ray = {{n[0], n[1]}, n[2], n[3], &filter};
        api_buffer_push(&found, &ray, sizeof ray);
        api_buffer_push(&hits, &(thud_ray_hit){0}, sizeof(thud_ray_hit));
    }
    if (found.failed || hits.failed)
        return THUD_ERROR_MEMORY;
    thud_result result =
        thud_world_cast_rays(world, (const thud_ray *)found.data, count, (thud_ray_hit *)hits.data);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        struct ray_hit row = row_of((const thud_ray_hit *)hits.data + i);
        api_buffer_push(&rows, &row, sizeof row);
    }
    api_slots.list.address = (double)(uintptr_t)rows.data;
    api_slots.list.count = count;
    return result != THUD_OK ? result : api_buffer_result(&rows);
}

/* Slots out: closest_hit. */
static void tell_closest(bool any, const thud_closest_hit *hit) {
    api_slots.closest_hit =
        (struct closest_hit){.found = any,
                             .shape = {hit->shape.index1, hit->shape.generation},
                             .point = {hit->point.x, hit->point.y},
                             .normal = {hit->normal.x, hit->normal.y},
                             .distance = hit->distance};
}

/* Slots out: closest_hit. */
int api_closest(thud_world *world, double x, double y, double max_distance) {
    thud_query_filter filter = filter_now();
    bool any = false;
    thud_closest_hit hit = {0};
    thud_result result =
        thud_world_closest(world, (thud_pos){x, y}, max_distance, &filter, &any, &hit);
    tell_closest(any, &hit);
    return result;
}

/* ---- overlaps ---- */

/* A thud_overlap_fn that appends the shape to a list; false, to stop, where memory is short. */
static bool collect(thud_shape_id shape, void *context) {
    api_buffer *buffer = context;
    api_buffer_push(buffer, &shape, sizeof shape);
    return !buffer->failed;
}

/* Slots out: list, of `found`. */
static int collected(thud_result result) {
    api_slots.list.address = (double)(uintptr_t)found.data;
    api_slots.list.count = (double)(found.bytes / sizeof(thud_shape_id));
    return result != THUD_OK ? result : api_buffer_result(&found);
}

/* Slots out: list of handles. */
int api_overlap_aabb(thud_world *world, double lower_x, double lower_y, double upper_x,
                     double upper_y) {
    thud_query_filter filter = filter_now();
    api_buffer_clear(&found);
    return collected(thud_world_overlap_aabb(world, (thud_pos){lower_x, lower_y},
                                             (thud_pos){upper_x, upper_y}, &filter, collect,
                                             &found));
}

/* The same for a circle, AABB or OBB with its centre at (x, y). */
int api_overlap_shape(thud_world *world, int kind, double x, double y, double hx, double hy,
                      double angle) {
    thud_query_filter filter = filter_now();
    thud_geometry shape = api_placed(kind, hx, hy, angle);
    api_buffer_clear(&found);
    return collected(
        thud_world_overlap_shape(world, (thud_pos){x, y}, shape, &filter, collect, &found));
}

/* ---- one shape, whatever its filter ---- */

/* Slots out: first_hit. */
int api_shape_cast_ray(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                       double dx, double dy) {
    bool hit = false;
    thud_ray_hit ray = {0};
    thud_result result = thud_shape_cast_ray(world, api_shape(index1, generation), (thud_pos){x, y},
                                             dx, dy, &hit, &ray);
    api_slots.first_hit = (struct first_hit){hit, row_of(&ray)};
    return result;
}

/* Slots out: number. */
int api_shape_contains_point(thud_world *world, uint32_t index1, uint32_t generation, double x,
                             double y) {
    bool inside = false;
    thud_result result =
        thud_shape_contains_point(world, api_shape(index1, generation), (thud_pos){x, y}, &inside);
    api_slots.number.value = inside;
    return result;
}

/* Slots out: closest_hit. */
int api_shape_closest_point(thud_world *world, uint32_t index1, uint32_t generation, double x,
                            double y) {
    thud_closest_hit hit = {0};
    thud_result result =
        thud_shape_closest_point(world, api_shape(index1, generation), (thud_pos){x, y}, &hit);
    tell_closest(true, &hit);
    return result;
}

/* Slots out: bounds. */
int api_shape_bounds(thud_world *world, uint32_t index1, uint32_t generation) {
    thud_pos lower = {0}, upper = {0};
    thud_result result =
        thud_shape_get_bounds(world, api_shape(index1, generation), &lower, &upper);
    api_slots.bounds = (struct bounds){{lower.x, lower.y}, {upper.x, upper.y}};
    return result;
}

/* ---- poses to come ---- */

static api_buffer predictions, poses_ahead;

/* Slots out: prediction. Returns `result`. */
static int tell_prediction(thud_result result, const thud_prediction *p) {
    if (result == THUD_OK)
        api_slots.prediction = (struct prediction){.position = {p->position.x, p->position.y},
                                                   .angle = p->angle,
                                                   .velocity = {p->velocity.x, p->velocity.y},
                                                   .angular_velocity = p->angular_velocity,
                                                   .seconds = p->seconds,
                                                   .met = {p->met.index1, p->met.generation}};
    return result;
}

/* Slots out: prediction; also in the next. */
int api_body_extrapolate(const thud_world *world, uint32_t index1, uint32_t generation,
                         double seconds) {
    thud_prediction p;
    thud_body_id body = api_body(index1, generation);
    return tell_prediction(thud_world_extrapolate(world, &body, 1, seconds, &p), &p);
}

int api_body_predict(thud_world *world, uint32_t index1, uint32_t generation, double seconds) {
    thud_prediction p;
    thud_body_id body = api_body(index1, generation);
    return tell_prediction(thud_world_predict(world, &body, 1, seconds, &p), &p);
}

/* Slots out: list, with rows of pose_ahead. */
int api_world_extrapolate_awake(const thud_world *world, double seconds) {
    int count = 0;
    thud_result result = thud_world_extrapolate_awake(world, seconds, NULL, 0, &count);
    api_buffer_clear(&predictions);
    api_buffer_clear(&poses_ahead);
    for (int i = 0; i < count && result == THUD_OK; i++)
        api_buffer_push(&predictions, &(thud_prediction){0}, sizeof(thud_prediction));
    if (result == THUD_OK)
        result = api_buffer_result(&predictions);
    thud_prediction *list = (thud_prediction *)predictions.data;
    if (result == THUD_OK)
        result = thud_world_extrapolate_awake(world, seconds, list, count, &count);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        struct pose_ahead row = {.slot = list[i].body.index1 - 1,
                                 .position = {list[i].position.x, list[i].position.y},
                                 .angle = list[i].angle};
        api_buffer_push(&poses_ahead, &row, sizeof row);
    }
    api_slots.list.address = (double)(uintptr_t)poses_ahead.data;
    api_slots.list.count = count;
    return result != THUD_OK ? result : api_buffer_result(&poses_ahead);
}
