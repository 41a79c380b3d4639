/* rapier.h: the C interface of rapier/src/lib.rs. A shape is added to the body that was added last.
 * The program ends if memory runs out, as in Rust. */
#ifndef THUD_ADAPTERS_RAPIER_H
#define THUD_ADAPTERS_RAPIER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct rapier_world rapier_world;

typedef struct rapier_body {
    int32_t kind; /* 0 static, 1 kinematic, 2 dynamic */
    float x, y, angle;
    float vx, vy, angular_velocity;
    float gravity_scale, linear_damping, angular_damping;
    bool fixed_rotation, may_sleep;
} rapier_body;

typedef struct rapier_shape {
    float x, y, angle; /* in the body's frame */
    float density, friction, restitution;
    uint32_t category, mask;
    bool sensor;
} rapier_shape;

typedef struct rapier_state {
    float x, y, cosine, sine; /* of the body's origin */
    float vx, vy;             /* of the centre of mass */
    float angular_velocity;
    float mass, inertia;
    bool awake;
} rapier_state;

rapier_world *rapier_create(float gravity_x, float gravity_y, float time_step, float length_scale);
void rapier_destroy(rapier_world *world);

void rapier_add_body(rapier_world *world, const rapier_body *body);
void rapier_add_circle(rapier_world *world, const rapier_shape *shape, float radius);
void rapier_add_box(rapier_world *world, const rapier_shape *shape, float hx, float hy);
/* A one-sided line of `count` points, given as x and y by turns; solid to the left of its
 * direction. */
void rapier_add_line(rapier_world *world, const rapier_shape *shape, const float *xy, size_t count);

void rapier_step(rapier_world *world);
void rapier_read(const rapier_world *world, rapier_state *out); /* writes all bodies in the order of
                                                                   creation */
size_t rapier_bytes(void);                                      /* memory held by all worlds */

#endif
