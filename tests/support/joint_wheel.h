/* joint_wheel.h: an island of joints that takes the direct solver more work than its budget of a
 * step. */
#ifndef JOINT_WHEEL_H
#define JOINT_WHEEL_H

#include "joint_support.h"

/* Bodies around the hub. */
enum { RIM = 900 };

/* Bodies without collisions around a static hub, at random radii, each joined by rods to the hub
 * and to its two neighbours. As they begin to fall, every loop of rods is stretched at once. */
static inline void add_wheel(thud_world *world) {
    thud_body_id hub = add_body(world, THUD_BODY_STATIC, 0, 0, 0), rim[RIM];
    double radius[RIM];
    thud_shape_def alone = thud_default_shape_def();
    alone.filter.mask = 0;
    uint32_t random = 1;
    for (int i = 0; i < RIM; i++) {
        random = random * 1664525u + 1013904223u;
        radius[i] = 10 + 30 * ((random >> 8) / 16777216.0);
        rim[i] = add_body(world, THUD_BODY_DYNAMIC, radius[i] * cos(2 * PI * i / RIM),
                          radius[i] * sin(2 * PI * i / RIM), 0);
        add_shape(world, rim[i], 0.1f, 0, false, &alone);
        thud_joint_def spoke =
            between(THUD_JOINT_DISTANCE, hub, rim[i], (thud_vec2){0, 0}, (thud_vec2){0, 0});
        spoke.length = (float)radius[i];
        make(world, spoke);
    }
    for (int i = 0; i < RIM; i++) {
        thud_pos a = state_of(world, rim[i]).position;
        thud_pos b = state_of(world, rim[(i + 1) % RIM]).position;
        thud_joint_def next = between(THUD_JOINT_DISTANCE, rim[i], rim[(i + 1) % RIM],
                                      (thud_vec2){0, 0}, (thud_vec2){0, 0});
        next.length = (float)hypot(a.x - b.x, a.y - b.y);
        make(world, next);
    }
}

#endif
