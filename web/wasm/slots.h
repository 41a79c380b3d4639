/* slots.h: the layout of the numbers that pass between this layer and JavaScript.
 *
 * A call takes and returns what does not fit into its arguments through the union `api_slots`,
 * whose structs are declared here; lists go through buffers of rows, declared in rows.h.
 * web/tools/slots.mjs reads both files and writes the same indices for TypeScript, so that no index
 * is written in two languages: a struct `body_state` becomes the enum `BodyStateAt`, its member
 * `gravity_scale` the entry `gravityScale`, and the entry `length` is the number of its numbers.
 * For structs whose name ends in `_options` it also writes the names of the options, without those
 * of structs in them.
 *
 * All members of a struct have the same type. Handles are two numbers, index1 and generation;
 * places and vectors are x and y. */
#ifndef SLOTS_H
#define SLOTS_H

#include "rows.h"

/* ---- parts of other structs ---- */

/* A list of rows, handles or bytes in wasm memory. */
struct list {
    double address, count;
};

struct handle {
    double index1, generation;
};

/* `ignore` is a body. */
struct filter_options {
    double category, mask, sensors, group;
    struct handle ignore;
};

/* Changes of a quality: 0, for the last two -1, keeps the value of the quality. `islands`: 0, the
 * soft solver solves all islands; 1, with an island solver, which has the limits of
 * thud_quality_default where the quality has none. */
struct quality_options {
    double substeps, contact_stiffness, contact_damping, detection, islands;
};

/* A shape without a place. The radius of a circle is its first half extent. */
struct solid {
    double kind, half_extents[2], angle;
};

/* A shape at a place. */
struct placed {
    struct solid solid;
    double center[2];
};

/* The drive of a direction of a joint. Infinite limits: no limits; a target of -infinity: the
 * length.
 */
struct drive_options {
    double lower, upper, frequency, damping, target, spring_force, motor_speed, motor_force;
};

struct frame_options {
    double position[2], angle;
};

/* Options of a joint that thud_joint_def has in another form. `rod`: the length of a distance.
 * Places are in the world, and so are `turned`, the angle of the joint's x axis, and `axis`, its
 * direction. `worked_out` is a sum of what api_joint_create is to compute: 1 frame a and 2 frame b
 * from the places and `turned`, 4 `rod` from the distance of both anchors, 8 `turned` from `axis`.
 */
struct joint_making {
    double kind, rod, ratio, worked_out, place_a[2], place_b[2], turned, axis[2];
};

/* A side of a pair of shapes; the body is 0, 0 where the shape was destroyed. */
struct pair_side {
    double body[2], body_data, shape_data, sensor;
};

/* ---- slots ---- */

struct world_options {
    double gravity[2], time_step, length_scale, quality, substeps, contact_stiffness;
    double contact_damping, push_speed, restitution_threshold, hit_speed, maximum_speed, sleeping;
    double detection, contact_events, timed, broadphase, time_budget, max_error;
    double cell_size;
    struct quality_options changes;
};

struct advance {
    double steps, alpha;
};

/* As thud_stats, without factorings and island_work. */
struct stats {
    double steps, bodies, shapes, awake_bodies, pairs, contacts, colours, blocks, bytes;
    double step_allocations, substeps, step_seconds, direct_islands, direct_bodies, soft_islands;
    double impacts, motion_pairs, motion_circles, motion_boxes, motion_exact, stage_seconds[9];
    double held_bodies, held_seconds, unbisectable;
};

struct step_error {
    double penetration_max, penetration_mean, residual, energy_change, overlaps, shortfall;
    double joint_gap_max, joint_gap_mean, joint_angle_max, energy_decided;
};

struct measure {
    double penetration_max, penetration_mean, kinetic_energy, potential_energy;
};

/* The upper and the lower 32 bits of a hash. */
struct hash {
    double upper, lower;
};

struct body_options {
    double kind, position[2], angle, velocity[2], angular_velocity, gravity_scale, linear_damping;
    double angular_damping, fixed_rotation, may_sleep, user_data, detection;
};

struct body_state {
    double kind, position[2], center[2], angle, velocity[2], angular_velocity, mass, inertia;
    double gravity_scale, awake, quarantined, user_data, shape_count, enabled;
};

struct place {
    double at[2];
};

struct rotation {
    double angle, cosine, sine;
};

struct motion {
    double velocity[2], angular_velocity;
};

/* As thud_prediction; `met` is 0, 0 where nothing is met. */
struct prediction {
    double position[2], angle, velocity[2], angular_velocity, seconds, met[2];
};

struct pair {
    struct pair_side a, b;
};

struct bounds {
    double lower[2], upper[2];
};

struct explosion_options {
    double center[2], radius, falloff, impulse, cover, rays;
    struct filter_options filter;
};

struct water_options {
    double point[2], normal[2], density, flow[2], linear_drag, angular_drag;
};

struct tyre_options {
    double at[2], steer, thrust, brake, grip;
};

/* As thud_rule: friction, restitution or surface_speed NaN is that of the two shapes. */
struct rule_options {
    double kind, solid_side[2], friction, restitution, surface_speed, event_impulse;
};

struct rule_found {
    struct rule_options rule;
    double is_set, reversed;
};

struct number {
    double value;
};

/* As thud_step_settings. `base`: the number of the quality, whose values follow. */
struct step_settings {
    double gravity[2], time_step, max_error, substeps, sleeping, base;
    struct quality_options quality;
};

/* As thud_broadphase_counts. */
struct broadphase_counts {
    double moved, tested, found, sort_moves, cells, cell_shapes, cell_shapes_max;
};

struct shape_options {
    double density, friction, restitution, category, mask, group, sensor, user_data, surface_speed;
    double events;
};

struct shape_state {
    double kind, body[2], offset[2], half_extents[2], angle, density, friction, restitution;
    double category, mask, group, sensor, user_data, surface_speed, events;
};

/* pair_a and pair_b: the bodies of a joint, or the joints of a gear. */
struct joint_options {
    double collide_connected, break_force, break_torque, only_reports, enabled, user_data;
    struct handle pair_a, pair_b;
    struct frame_options frame_a, frame_b;
    struct drive_options along, across, turn;
    struct joint_making making;
};

/* As thud_joint_state; `drive` has the forces of limit, spring and motor for each direction. */
struct joint_state {
    double kind, body_a[2], body_b[2], enabled, value[3], gap, angle_gap, force[2], torque;
    double drive[9], user_data;
};

/* The rows are joint_row and joint_handles. */
struct joint_table {
    double rows, handles, count;
};

/* As thud_terrain; the points, pairs of doubles, are the world's own. */
struct terrain {
    double kind, slope, x0, spacing;
    struct list points;
};

/* As thud_texture; both lists are the world's own. */
struct texture {
    struct list vertices, table;
    double repeats;
};

/* The ground at one x; `weights` are those of the segment's two vertices. */
struct ground {
    double height, normal[2], segment, weights[2];
};

struct foot {
    double height, x, normal[2];
};

/* begin, end, sensor_begin, sensor_end: rows of event_pair; quarantined: handles of bodies; hits:
 * rows of hit_event; the times of sensor_begin and sensor_end: a float each. */
struct events {
    struct list begin, end, sensor_begin, sensor_end, quarantined, hits;
    struct list sensor_begin_time, sensor_end_time;
};

struct closest_hit {
    double found, shape[2], point[2], normal[2], distance;
};

/* The rows are shape_row and shape_handles. */
struct shape_table {
    double rows, handles, count;
};

struct draw_lists {
    struct list shapes, lines, points;
};

struct mover_options {
    double up[2], skin, max_slope, step_height, snap_distance, push_force, one_way;
    struct filter_options filter;
};

/* The state of a mover from one move to the next, see thud_mover. */
struct mover_state {
    double position[2], on_ground, normal[2], shape[2], body[2], point[2], place[2], cosine, sine;
};

/* The handles of the sensors, two doubles each, follow the hits in memory. */
struct mover_report {
    double position[2], on_ground, normal[2], shape[2], body[2], velocity[2], ground_velocity[2];
    double depth;
    struct list hits;
    double sensor_count;
};

/* `offset`: from the first shape's centre to the second's. */
struct minkowski_pair {
    struct solid a, b;
    double offset[2];
};

/* Places are relative to the first shape's centre. `edge`: the point of the sum's edge that is
 * nearest to the offset; `radius`: of the rounded corners; `vertices`: x and y of `count` of them,
 * counter-clockwise. */
struct minkowski_sum {
    double overlaps, edge[2], radius, count, vertices[16];
};

/* Motions: x, y and the rotation in radians. */
struct geometry_pair {
    struct placed a, b;
    double motion_a[3], motion_b[3];
};

struct closest_features {
    double overlaps, distance, normal[2], point_a[2], point_b[2];
};

/* One of the points at which two shapes touch or nearly do. */
struct touching_point {
    double distance, normal[2], point_a[2], point_b[2];
};

/* The first `count` of both are set. */
struct touching_points {
    double count;
    struct touching_point first, second;
};

/* Segments of a line; first > last: none. */
struct segments {
    double first, last;
};

/* `bisectable`: the motions are so short that bisection cannot have missed a collision. */
struct meeting {
    double found, time, min_distance, min_distance_time, bisectable;
};

struct crossing {
    double found, fraction, normal[2];
};

/* A bounding volume; `turn`: cosine and sine of its angle. */
struct volume {
    double kind, center[2], half_extents[2], turn[2];
};

/* The ends of the segment, and the radius. */
struct capsule {
    double from[2], to[2], radius;
};

/* A capsule against a shape, or against another capsule. */
struct capsule_pair {
    struct capsule a, capsule_b;
    struct placed shape_b;
    double is_capsule, motion_a[2], motion_b[2];
};

/* The shapes are rows of `placed`. `reason`: the address of a text that says why the points are no
 * polygon; 0: they are one. */
struct approximation {
    struct list shapes;
    double missed, extra, overlap, distance, reason;
};

union api_slots {
    double all[64];
    struct list list;
    struct handle handle;
    struct world_options world_options;
    struct advance advance;
    struct stats stats;
    struct step_error step_error;
    struct measure measure;
    struct hash hash;
    struct body_options body_options;
    struct body_state body_state;
    struct place place;
    struct rotation rotation;
    struct motion motion;
    struct prediction prediction;
    struct pair pair;
    struct explosion_options explosion_options;
    struct water_options water_options;
    struct tyre_options tyre_options;
    struct rule_options rule_options;
    struct rule_found rule_found;
    struct bounds bounds;
    struct filter_options filter_options;
    struct number number;
    struct step_settings step_settings;
    struct broadphase_counts broadphase_counts;
    struct shape_options shape_options;
    struct shape_state shape_state;
    struct joint_options joint_options;
    struct joint_state joint_state;
    struct joint_table joint_table;
    struct terrain terrain;
    struct texture texture;
    struct ground ground;
    struct foot foot;
    struct events events;
    struct first_hit first_hit;
    struct closest_hit closest_hit;
    struct shape_table shape_table;
    struct draw_lists draw_lists;
    struct mover_options mover_options;
    struct mover_state mover_state;
    struct mover_report mover_report;
    struct minkowski_pair minkowski_pair;
    struct minkowski_sum minkowski_sum;
    struct geometry_pair geometry_pair;
    struct closest_features closest_features;
    struct touching_points touching_points;
    struct segments segments;
    struct meeting meeting;
    struct crossing crossing;
    struct volume volume;
    struct capsule_pair capsule_pair;
    struct approximation approximation;
};
_Static_assert(sizeof(union api_slots) == 64 * sizeof(double), "JavaScript sees 64 slots");

#endif
