/* rows.h: the rows of lists that pass between this layer and JavaScript. slots.h says how their
 * members get names in TypeScript. Handles are two numbers, index1 and generation. Units are those
 * of the structs of thud with similar names. */
#ifndef ROWS_H
#define ROWS_H

#include <stdint.h>

struct ray_hit {
    double shape[2], point[2], normal[2], fraction, depth;
};

struct first_hit {
    double found;
    struct ray_hit hit;
};

struct hit_event {
    double shape_a[2], shape_b[2], point[2], normal[2], speed;
};

struct impulse_event {
    double shape_a[2], shape_b[2], point[2], normal[2], impulse;
};

/* A contact for a listener; the last four are what a prologue decides. */
struct listened_row {
    double shape_a[2], shape_b[2], body_a[2], body_b[2], normal[2], point[2], separation;
    double normal_impulse, tangent_impulse, point_count;
    double collide, friction, restitution, surface_speed;
};

struct event_pair {
    uint32_t shape_a[2], shape_b[2];
};

struct mover_hit {
    double shape[2], body[2], point[2], normal[2], depth;
};

struct contact_point {
    double place[2], separation, normal_impulse;
};

/* A touching pair; points beyond point_count are zeros. */
struct contact_row {
    double shape_a[2], shape_b[2], body_a[2], body_b[2], normal[2], point_count, tangent_impulse;
    double direct;
    struct contact_point points[2];
};

/* A shape for drawing. `slot` and `body`: slot and kind of its body; `shape`: its own kind. Offset,
 * half extents, cosine and sine are in the body's frame. */
struct shape_row {
    float slot, shape, body, sensor, offset[2], half_extents[2], cosine, sine;
};

struct shape_handles {
    uint32_t shape[2], body[2];
};

/* Where the body of a slot will be. */
struct pose_ahead {
    double slot, position[2], angle;
};

/* A joint for drawing. Slots are those of the bodies. Anchors are in the bodies' frames, the axis
 * (cosine and sine) in that of a; the places of the anchors, the direction of the axis and the
 * centres of mass are in the world. Arrays of three: along, across, turn. Limits are equal where a
 * direction is locked, infinite where it is free. */
struct joint_row {
    float kind, slot_a, slot_b, enabled, awake, anchor_a[2], anchor_b[2], axis[2], place_a[2];
    float place_b[2], direction[2], center_a[2], center_b[2], value[3], lower[3], upper[3];
    float gap, angle_gap, force[2], torque;
};

struct joint_handles {
    uint32_t joint[2], body_a[2], body_b[2];
};

struct joint_event {
    double joint[2], body_a[2], body_b[2], user_data, force, torque, broken;
};

struct draw_shape {
    float center[2], half_extents[2], cosine, sine, round, style, island;
};

struct draw_line {
    float from[2], to[2], style;
};

struct draw_point {
    float place[2], style;
};

#endif
