/* mover_support.h: character movers with a box or a circle as shape, and ground for them to walk
 * on. */
#ifndef MOVER_SUPPORT_H
#define MOVER_SUPPORT_H

#include "engine_support.h"

#include <thud/thud_mover.h>

/* Time of a move in seconds. */
#define DT (1.0 / 60)
/* Where the scripted walk of test_mover.c ends, on every machine; recorded from a run. */
#define WALK_END_X 14.504182945844535
#define WALK_END_Y 3.036515603702544

static inline thud_mover box_mover(double x, double y) {
    return thud_default_mover(
        (thud_geometry){.kind = THUD_SHAPE_AABB, .x = x, .y = y, .c = 1, .hx = 0.3, .hy = 0.5});
}

static inline thud_mover circle_mover(double x, double y) {
    thud_geometry circle = {.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1, .hx = 0.5};
    return thud_default_mover(circle);
}

/* One move as a game makes it: the mover walks at `speed` and falls under gravity 20 m/s^2. */
static inline thud_mover_report go(thud_world *world, thud_mover *mover, thud_vec2 *velocity,
                                   float speed) {
    thud_mover_report report;
    velocity->x = speed;
    velocity->y -= 20.0f / 60;
    OK(thud_mover_move(world, mover, *velocity, DT, &report));
    *velocity = report.velocity;
    return report;
}

/* Makes that many moves, beginning at rest. */
static inline void go_on(thud_world *world, thud_mover *mover, float speed, int moves) {
    thud_vec2 velocity = {0, 0};
    for (int i = 0; i < moves; i++) {
        go(world, mover, &velocity, speed);
    }
}

/* A terrain that is flat up to x = 0, rises by `slope` up to x = 8, and is flat again. */
static inline thud_world *world_with_slope(double slope) {
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    const thud_pos points[] = {{-20, 0}, {0, 0}, {8, 8 * slope}, {30, 8 * slope}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 NULL));
    return world;
}

static inline thud_body_id add_block(thud_world *world, double x, double y, float hx, float hy) {
    thud_body_id body = add_body(world, THUD_BODY_STATIC, x, y, 0);
    add_shape(world, body, hx, hy, true, NULL);
    return body;
}

/* A mover with a box (kind 0) or a circle as shape, and a step height of 0.4. */
static inline thud_mover mover_of(int kind, double x, double y) {
    thud_mover mover = kind ? circle_mover(x, y) : box_mover(x, y);
    mover.step_height = mover.snap_distance = 0.4;
    return mover;
}

#endif
