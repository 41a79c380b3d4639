/* island_support.h: small worlds for tests of islands and of the direct solver, without
 * sleeping. */
#ifndef ISLAND_SUPPORT_H
#define ISLAND_SUPPORT_H

#include "engine_support.h"

/* Gravity in m/s^2 and time step in s of the default world. */
#define G 10.0
#define STEP (1.0 / 60)

static inline thud_world_def def_of(const thud_quality *quality) {
    thud_world_def def = thud_default_world_def();
    def.quality = quality;
    return def;
}

/* A world with a floor (top at y = 0). */
static inline thud_world *world_of(const thud_quality *quality) {
    thud_world_def def = def_of(quality);
    def.sleeping = false;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    return world;
}

/* A square box with this half extent and density. */
static inline thud_body_id add_heavy(thud_world *world, double x, double y, float half,
                                     float density) {
    thud_shape_def def = thud_default_shape_def();
    thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, x, y, 0);
    def.density = density;
    add_shape(world, id, half, half, false, &def);
    return id;
}

/* Stacks boxes of edge 1 from the floor up. `ids` gets their handles, the lowest box first; it may
 * be null. */
static inline void add_column(thud_world *world, double x, int boxes, thud_body_id *ids) {
    for (int i = 0; i < boxes; i++) {
        thud_body_id id = add_box(world, x, i + 0.5, 0.5f, 0.5f);
        if (ids) {
            ids[i] = id;
        }
    }
}

/* By how far a body is below `height`, in metres: for the top of a stack, the sum of all
 * penetrations below it. */
static inline double lost_by(const thud_world *world, thud_body_id id, double height) {
    return height - state_of(world, id).position.y;
}

#endif
