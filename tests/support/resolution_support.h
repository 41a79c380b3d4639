/* resolution_support.h: worlds and bodies that the tests of collision resolution share. */
#ifndef RESOLUTION_SUPPORT_H
#define RESOLUTION_SUPPORT_H

#include "engine_support.h"

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum { DETECTIONS = 4 };

static inline thud_world *make_world_with(const thud_detection *detection,
                                          thud_prologue_fn *prologue, void *context, bool weighs) {
    thud_world_def def = weighs ? thud_default_world_def() : weightless();
    def.detection = detection;
    thud_world *world = make_world(def);
    set_listeners(world, prologue, NULL, context);
    return world;
}

/* Adds a body of a form: 0 a circle of radius 0.5, 1 an AABB, 2 an OBB of half extents 0.5. */
static inline thud_body_id add_kind(thud_world *world, int kind, double x, double y,
                                    const thud_shape_def *def) {
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, x, y, 0);
    add_shape(world, body, 0.5f, kind ? 0.5f : 0, kind == 1, def);
    return body;
}

/* A shape def with this friction and surface speed. */
static inline thud_shape_def surface(float friction, float speed) {
    thud_shape_def def = thud_default_shape_def();
    def.friction = friction;
    def.surface_speed = speed;
    return def;
}

/* The gap in metres at which contacts rest: 0.004, the skin, under the detections `bisect` and
 * `swept`, which stop bodies there; 0 under the others. */
static inline double gap_at_rest(int detection) {
    return detections[detection] == &thud_detection_bisect ||
                   detections[detection] == &thud_detection_swept
               ? 0.004
               : 0.0;
}

#endif
