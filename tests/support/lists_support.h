/* lists_support.h: helpers that ask a world for its lists of bodies and shapes, and search them. */
#ifndef LISTS_SUPPORT_H
#define LISTS_SUPPORT_H

#include "engine_support.h"

#include <thud/thud_lists.h>

/* Length of every list. */
enum { ROOM = 32 };

static inline bool same_body(thud_body_id a, thud_body_id b) {
    return a.index1 == b.index1 && a.generation == b.generation;
}

static inline bool same_shape(thud_shape_id a, thud_shape_id b) {
    return a.index1 == b.index1 && a.generation == b.generation;
}

static inline bool body_listed(const thud_body_id *list, int count, thud_body_id body) {
    int i = 0;
    while (i < count && !same_body(list[i], body)) {
        i++;
    }
    return i < count;
}

static inline bool is_among_bodies(const thud_world *world, thud_body_id body) {
    thud_body_id list[ROOM];
    int count;
    OK(thud_world_get_bodies(world, list, ROOM, &count));
    return body_listed(list, count, body);
}

static inline bool is_among_awake(const thud_world *world, thud_body_id body) {
    thud_body_id list[ROOM];
    int count;
    OK(thud_world_get_awake_bodies(world, list, ROOM, &count));
    return body_listed(list, count, body);
}

static inline bool is_among_shapes(const thud_world *world, thud_shape_id shape) {
    thud_shape_id list[ROOM];
    int count, i = 0;
    OK(thud_world_get_shapes(world, list, ROOM, &count));
    while (i < count && !same_shape(list[i], shape)) {
        i++;
    }
    return i < count;
}

/* How many shapes overlap the sensor. */
static inline int sensed_by(const thud_world *world, thud_shape_id sensor) {
    int count;
    OK(thud_shape_get_sensor_overlaps(world, sensor, NULL, 0, &count));
    return count;
}

/* Which bodies have moved since the last `look` at this world. */
typedef struct watch {
    thud_body_seen seen[ROOM];
    thud_body_id list[ROOM];
    int count;
} watch;

/* Updates the watch; returns how many bodies moved. */
static inline int look(watch *w, const thud_world *world) {
    OK(thud_world_get_moved_bodies(world, w->seen, ROOM, w->list, ROOM, &w->count));
    return w->count;
}

/* Whether the last `look` listed the body as moved. */
static inline bool told(const watch *w, thud_body_id body) {
    return body_listed(w->list, w->count, body);
}

#endif
