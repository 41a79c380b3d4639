/* limits.h: a table of every limit of thud_limits.h, by the field or argument that it bounds.
 * test_limits.c tests each row; tests/house/headers.py checks that the comment of that field or
 * argument names the row's constants.
 *
 *     FIELD(struct, field, member, low, high, how it is given to the engine)
 *     CALL(function, argument, low, high, call with the value x)
 *
 * OPEN(x): the low end itself is refused. LENGTHS(x): times the length scale. */
#ifndef LIMITS_H
#define LIMITS_H

#include <thud/thud_limits.h>

#define WORLD_LIMITS(FIELD, CALL)                                                                 \
    FIELD(thud_world_def, time_step, time_step, OPEN(0), THUD_TIME_STEP_MAX, world)               \
    FIELD(thud_world_def, length_scale, length_scale, THUD_LENGTH_SCALE_MIN,                      \
          THUD_LENGTH_SCALE_MAX, world)                                                           \
    FIELD(thud_world_def, substeps, substeps, 0, THUD_SUBSTEPS_MAX, world)                        \
    FIELD(thud_world_def, contact_stiffness, contact_stiffness, THUD_CONTACT_STIFFNESS_MIN,       \
          THUD_CONTACT_STIFFNESS_MAX, world)                                                      \
    FIELD(thud_world_def, contact_damping, contact_damping, 0, THUD_CONTACT_DAMPING_MAX, world)   \
    FIELD(thud_world_def, push_speed, push_speed, 0, THUD_SPEED_MAX, world)                       \
    FIELD(thud_world_def, restitution_threshold, restitution_threshold, 0, THUD_SPEED_MAX, world) \
    FIELD(thud_world_def, hit_speed, hit_speed, 0, THUD_SPEED_MAX, world)                         \
    FIELD(thud_world_def, maximum_speed, maximum_speed, OPEN(0), THUD_SPEED_MAX, world)           \
    FIELD(thud_world_def, max_error, max_error, 0, THUD_MAX_ERROR_MAX, world)                     \
    FIELD(thud_world_def, time_budget, time_budget, 0, THUD_TIME_BUDGET_MAX, world)               \
    FIELD(thud_world_def, cell_size, cell_size, 0, LENGTHS(THUD_SIZE_MAX), world)                 \
    FIELD(thud_job_system, workers, workers, 0, THUD_WORKERS_MAX, jobs)                           \
    FIELD(thud_quality, substeps, substeps, 1, THUD_SUBSTEPS_MAX, quality)                        \
    FIELD(thud_quality, contact_stiffness, contact_stiffness, THUD_CONTACT_STIFFNESS_MIN,         \
          THUD_CONTACT_STIFFNESS_MAX, quality)                                                    \
    FIELD(thud_quality, contact_damping, contact_damping, 0, THUD_CONTACT_DAMPING_MAX, quality)   \
    FIELD(thud_quality, island_limit, island_limit, 1, THUD_ISLAND_LIMIT_MAX, quality)            \
    FIELD(thud_quality, island_slow_steps, island_slow_steps, 0, THUD_ISLAND_SLOW_STEPS_MAX,      \
          quality)                                                                                \
    CALL(thud_world_set_time_step, time_step, OPEN(0), THUD_TIME_STEP_MAX,                        \
         thud_world_set_time_step(p->world, x))                                                   \
    CALL(thud_world_set_max_error, max_error, 0, THUD_MAX_ERROR_MAX,                              \
         thud_world_set_max_error(p->world, x))                                                   \
    CALL(thud_world_extrapolate, seconds, 0, THUD_AHEAD_MAX,                                      \
         thud_world_extrapolate(p->world, &p->ball, 1, x, &(thud_prediction){0}))                 \
    CALL(thud_world_extrapolate_awake, seconds, 0, THUD_AHEAD_MAX,                                \
         thud_world_extrapolate_awake(p->world, x, NULL, 0, &(int){0}))                           \
    CALL(thud_world_predict, seconds, 0, THUD_AHEAD_MAX,                                          \
         thud_world_predict(p->world, &p->ball, 1, x, &(thud_prediction){0}))                     \
    CALL(thud_world_advance, elapsed, 0, THUD_ADVANCE_MAX,                                        \
         thud_world_advance(p->world, x, 1, NULL, NULL))

#define BODY_LIMITS(FIELD, CALL)                                                                  \
    FIELD(thud_body_def, position, position.x, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX), \
          body)                                                                                   \
    FIELD(thud_body_def, position, position.y, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX), \
          body)                                                                                   \
    FIELD(thud_body_def, angle, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX, body)                     \
    CALL(thud_body_set_transform, position, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),    \
         thud_body_set_transform(p->world, p->ball, (thud_pos){x, 0}, 0))                         \
    CALL(thud_body_set_transform, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX,                         \
         thud_body_set_transform(p->world, p->ball, (thud_pos){0, 0}, x))                         \
    CALL(thud_body_apply_impulse, point, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),       \
         thud_body_apply_impulse(p->world, p->ball, (thud_vec2){0, 0}, (thud_pos){0, x}))         \
    CALL(thud_world_get_poses, origin, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),         \
         thud_poses_of(p->world, (thud_pos){x, 0}, 1, NULL) ? THUD_OK : THUD_ERROR_INVALID)       \
    FIELD(thud_mass, mass, mass, THUD_MASS_MIN, THUD_MASS_MAX, mass)                              \
    FIELD(thud_mass, inertia, inertia, THUD_MASS_MIN, THUD_MASS_MAX, mass)                        \
    FIELD(thud_mass, center, center.x, LENGTHS(-THUD_SIZE_MAX), LENGTHS(THUD_SIZE_MAX), mass)

#define SHAPE_LIMITS(FIELD, CALL)                                                                  \
    FIELD(thud_shape_def, density, density, 0, THUD_DENSITY_MAX, shape)                            \
    FIELD(thud_shape_def, friction, friction, 0, THUD_FRICTION_MAX, shape)                         \
    FIELD(thud_shape_def, restitution, restitution, 0, THUD_RESTITUTION_MAX, shape)                \
    FIELD(thud_shape_def, surface_speed, surface_speed, LENGTHS(-THUD_SURFACE_SPEED_MAX),          \
          LENGTHS(THUD_SURFACE_SPEED_MAX), shape)                                                  \
    CALL(thud_shape_create_circle, radius, LENGTHS(THUD_SIZE_MIN), LENGTHS(THUD_SIZE_MAX),         \
         circle_of(p, p->ball, 0, (float)x))                                                       \
    CALL(thud_shape_create_circle, radius_of_static, LENGTHS(THUD_SIZE_MIN),                       \
         LENGTHS(THUD_STATIC_SIZE_MAX), circle_of(p, p->slab, 0, (float)x))                        \
    CALL(thud_shape_create_circle, offset, LENGTHS(-THUD_SIZE_MAX), LENGTHS(THUD_SIZE_MAX),        \
         circle_of(p, p->ball, (float)x, 1))                                                       \
    CALL(thud_shape_create_aabb, half_extents, LENGTHS(THUD_SIZE_MIN), LENGTHS(THUD_SIZE_MAX),     \
         thud_shape_create_aabb(p->world, p->ball, &p->shape, (thud_vec2){0, 0},                   \
                                (thud_vec2){(float)x, 1}, NULL))                                   \
    CALL(thud_shape_create_obb, half_extents, LENGTHS(THUD_SIZE_MIN), LENGTHS(THUD_SIZE_MAX),      \
         thud_shape_create_obb(p->world, p->ball, &p->shape, (thud_vec2){0, 0},                    \
                               (thud_vec2){1, (float)x}, 0, NULL))                                 \
    CALL(thud_shape_create_obb, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX,                            \
         thud_shape_create_obb(p->world, p->ball, &p->shape, (thud_vec2){0, 0}, (thud_vec2){1, 1}, \
                               x, NULL))                                                           \
    FIELD(thud_contact_settings, friction, friction, 0, THUD_FRICTION_MAX, settings)               \
    FIELD(thud_contact_settings, restitution, restitution, 0, THUD_PAIR_RESTITUTION_MAX, settings) \
    FIELD(thud_contact_settings, surface_speed, surface_speed, LENGTHS(-THUD_SURFACE_SPEED_MAX),   \
          LENGTHS(THUD_SURFACE_SPEED_MAX), settings)                                               \
    CALL(thud_shape_set_friction, friction, 0, THUD_FRICTION_MAX,                                  \
         thud_shape_set_friction(p->world, p->round, (float)x))                                    \
    CALL(thud_shape_set_restitution, restitution, 0, THUD_RESTITUTION_MAX,                         \
         thud_shape_set_restitution(p->world, p->round, (float)x))                                 \
    CALL(thud_shape_set_surface_speed, surface_speed, LENGTHS(-THUD_SURFACE_SPEED_MAX),            \
         LENGTHS(THUD_SURFACE_SPEED_MAX),                                                          \
         thud_shape_set_surface_speed(p->world, p->round, (float)x))                               \
    CALL(thud_shape_set_density, density, 0, THUD_DENSITY_MAX,                                     \
         thud_shape_set_density(p->world, p->round, (float)x))                                     \
    CALL(thud_shape_set_radius, radius, LENGTHS(THUD_SIZE_MIN), LENGTHS(THUD_SIZE_MAX),            \
         thud_shape_set_radius(p->world, p->round, (float)x))                                      \
    CALL(thud_shape_set_half_extents, half_extents, LENGTHS(THUD_SIZE_MIN),                        \
         LENGTHS(THUD_STATIC_SIZE_MAX),                                                            \
         thud_shape_set_half_extents(p->world, p->flat, (thud_vec2){(float)x, 1}))                 \
    CALL(thud_shape_dig, radius, LENGTHS(THUD_SIZE_MIN), LENGTHS(THUD_SIZE_MAX),                   \
         thud_shape_dig(p->world, p->line, (thud_pos){0, 1e7}, x))                                 \
    CALL(thud_shape_raise, height, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),              \
         thud_shape_raise(p->world, p->line, 1e7, 1, x))

#define PUSH_LIMITS(FIELD, CALL)                                                                \
    CALL(thud_body_apply_force, force, -THUD_FORCE_MAX, THUD_FORCE_MAX,                         \
         thud_body_apply_force(p->world, p->ball, (thud_vec2){(float)x, 0}, (thud_pos){0, 0}))  \
    CALL(thud_body_apply_force, point, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),       \
         thud_body_apply_force(p->world, p->ball, (thud_vec2){0, 0}, (thud_pos){x, 0}))         \
    CALL(thud_body_set_target, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX,                          \
         thud_body_set_target(p->world, p->lift, (thud_pos){5, 5}, x))                          \
    CALL(thud_body_get_velocity_at, point, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),   \
         thud_body_get_velocity_at(p->world, p->ball, (thud_pos){x, 0}, &p->out))               \
    CALL(thud_body_apply_wind, wind, LENGTHS(-THUD_FLOW_MAX), LENGTHS(THUD_FLOW_MAX),           \
         thud_body_apply_wind(p->world, p->ball, (thud_vec2){(float)x, 0}, 1, 1, 0))            \
    CALL(thud_body_apply_wind, density, 0, THUD_FLUID_DENSITY_MAX,                              \
         thud_body_apply_wind(p->world, p->ball, (thud_vec2){0, 0}, (float)x, 1, 0))            \
    CALL(thud_body_apply_wind, drag, 0, THUD_DRAG_MAX,                                          \
         thud_body_apply_wind(p->world, p->ball, (thud_vec2){0, 0}, 1, (float)x, 0))            \
    CALL(thud_body_apply_wind, lift, 0, THUD_DRAG_MAX,                                          \
         thud_body_apply_wind(p->world, p->ball, (thud_vec2){0, 0}, 1, 0, (float)x))            \
    CALL(thud_body_apply_rolling_resistance, coefficient, 0, THUD_DRAG_MAX,                     \
         thud_body_apply_rolling_resistance(p->world, p->ball, (float)x))                       \
    CALL(thud_body_apply_grip, point, LENGTHS(-THUD_SIZE_MAX), LENGTHS(THUD_SIZE_MAX),          \
         thud_body_apply_grip(p->world, p->ball, (thud_vec2){(float)x, 0}, grip_axis, 0, 1))    \
    CALL(thud_body_apply_grip, speed, LENGTHS(-THUD_FLOW_MAX), LENGTHS(THUD_FLOW_MAX),          \
         thud_body_apply_grip(p->world, p->ball, (thud_vec2){0, 0}, grip_axis, (float)x, 1))    \
    CALL(thud_body_apply_grip, most, 0, THUD_FORCE_MAX,                                         \
         thud_body_apply_grip(p->world, p->ball, (thud_vec2){0, 0}, grip_axis, 0, (float)x))    \
    FIELD(thud_water, point, point.y, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX), water) \
    FIELD(thud_water, density, density, 0, THUD_FLUID_DENSITY_MAX, water)                       \
    FIELD(thud_water, flow, flow.x, LENGTHS(-THUD_FLOW_MAX), LENGTHS(THUD_FLOW_MAX), water)     \
    FIELD(thud_water, linear_drag, linear_drag, 0, THUD_DRAG_MAX, water)                        \
    FIELD(thud_water, angular_drag, angular_drag, 0, THUD_DRAG_MAX, water)                      \
    FIELD(thud_explosion, center, center.x, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),  \
          explosion)                                                                            \
    FIELD(thud_explosion, radius, radius, 0, LENGTHS(THUD_PLACE_MAX), explosion)                \
    FIELD(thud_explosion, falloff, falloff, 0, LENGTHS(THUD_PLACE_MAX), explosion)              \
    FIELD(thud_explosion, impulse, impulse, -THUD_EXPLOSION_MAX, THUD_EXPLOSION_MAX, explosion) \
    FIELD(thud_explosion, rays, rays, 1, THUD_EXPLOSION_RAYS_MAX, explosion)

#define JOINT_LIMITS(FIELD, CALL)                                                              \
    FIELD(thud_drive, lower, lower, LENGTHS(-THUD_JOINT_LENGTH_MAX),                           \
          LENGTHS(THUD_JOINT_LENGTH_MAX), drive_along)                                         \
    FIELD(thud_drive, upper, upper, LENGTHS(-THUD_JOINT_LENGTH_MAX),                           \
          LENGTHS(THUD_JOINT_LENGTH_MAX), drive_along)                                         \
    FIELD(thud_drive, target, target, LENGTHS(-THUD_JOINT_LENGTH_MAX),                         \
          LENGTHS(THUD_JOINT_LENGTH_MAX), drive_along)                                         \
    FIELD(thud_drive, motor_speed, motor_speed, LENGTHS(-THUD_JOINT_LENGTH_MAX),               \
          LENGTHS(THUD_JOINT_LENGTH_MAX), drive_along)                                         \
    FIELD(thud_drive, lower, lower, -THUD_JOINT_ANGLE_MAX, THUD_JOINT_ANGLE_MAX, drive_turn)   \
    FIELD(thud_drive, upper, upper, -THUD_JOINT_ANGLE_MAX, THUD_JOINT_ANGLE_MAX, drive_turn)   \
    FIELD(thud_drive, target, target, -THUD_JOINT_ANGLE_MAX, THUD_JOINT_ANGLE_MAX, drive_turn) \
    FIELD(thud_drive, motor_speed, motor_speed, -THUD_JOINT_ANGULAR_SPEED_MAX,                 \
          THUD_JOINT_ANGULAR_SPEED_MAX, drive_turn)                                            \
    FIELD(thud_drive, frequency, frequency, 0, THUD_JOINT_FREQUENCY_MAX, drive_turn)           \
    FIELD(thud_drive, damping, damping, 0, THUD_JOINT_DAMPING_MAX, drive_turn)                 \
    FIELD(thud_drive, spring_force, spring_force, 0, THUD_JOINT_FORCE_MAX, drive_turn)         \
    FIELD(thud_drive, motor_force, motor_force, 0, THUD_JOINT_FORCE_MAX, drive_turn)           \
    FIELD(thud_joint_frame, position, position.x, LENGTHS(-THUD_JOINT_LENGTH_MAX),             \
          LENGTHS(THUD_JOINT_LENGTH_MAX), frame)                                               \
    FIELD(thud_joint_frame, angle, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX, frame)              \
    FIELD(thud_joint_def, length, length, OPEN(0), LENGTHS(THUD_JOINT_LENGTH_MAX), rod)        \
    FIELD(thud_joint_def, break_force, break_force, 0, THUD_JOINT_FORCE_MAX, rod)              \
    FIELD(thud_joint_def, break_torque, break_torque, 0, THUD_JOINT_FORCE_MAX, rod)            \
    FIELD(thud_joint_def, ratio, ratio, THUD_GEAR_RATIO_MIN, THUD_GEAR_RATIO_MAX, gear)        \
    FIELD(thud_joint_def, ratio, ratio, -THUD_GEAR_RATIO_MAX, -THUD_GEAR_RATIO_MIN, gear)

#define QUERY_LIMITS(FIELD, CALL)                                                               \
    CALL(thud_world_cast_ray, origin, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),        \
         thud_world_cast_ray(p->world, &(thud_ray){(thud_pos){x, 0}, 0, 1, NULL}, NULL, NULL))  \
    CALL(thud_world_cast_ray, dy, LENGTHS(-THUD_PLACE_MAX), LENGTHS(THUD_PLACE_MAX),            \
         thud_world_cast_ray(p->world, &(thud_ray){(thud_pos){0, 0}, 0, x, NULL}, NULL, NULL))  \
    CALL(thud_world_closest, max_distance, 0, LENGTHS(THUD_PLACE_MAX),                          \
         thud_world_closest(p->world, (thud_pos){0, 0}, x, NULL, NULL, NULL))                   \
    FIELD(thud_rollback_options, players, players, 0, THUD_ROLLBACK_PLAYERS_MAX, rollback)      \
    FIELD(thud_rollback_options, depth, depth, 0, THUD_ROLLBACK_DEPTH_MAX, rollback)            \
    FIELD(thud_rollback_options, budget, budget, 0, THUD_ROLLBACK_DEPTH_MAX, rollback)          \
    FIELD(thud_recorder_options, hash_steps, hash_steps, 0, THUD_RECORDING_STEPS_MAX, recorder) \
    FIELD(thud_recorder_options, keyframe_steps, keyframe_steps, 0, THUD_RECORDING_STEPS_MAX,   \
          recorder)                                                                             \
    FIELD(thud_recorder_options, ring_steps, ring_steps, 0, THUD_RECORDING_STEPS_MAX, recorder) \
    FIELD(thud_mover, max_slope, max_slope, 0, THUD_MOVER_SLOPE_MAX, mover)                     \
    FIELD(thud_mover, step_height, step_height, 0, THUD_MOVER_STEP_MAX, mover)                  \
    FIELD(thud_mover, snap_distance, snap_distance, 0, THUD_MOVER_STEP_MAX, mover)              \
    FIELD(thud_mover, push_force, push_force, 0, THUD_MOVER_FORCE_MAX, mover)                   \
    CALL(thud_mover_move, dt, OPEN(0), THUD_TIME_STEP_MAX,                                      \
         thud_mover_move(p->world, &p->mover, (thud_vec2){0, 0}, x, NULL))                      \
    CALL(thud_mover_move, velocity, -THUD_MOVER_DISTANCE_MAX, THUD_MOVER_DISTANCE_MAX,          \
         thud_mover_move(p->world, &p->mover, (thud_vec2){(float)x, 0}, 1, NULL))

#define GEOMETRY_LIMITS(FIELD, CALL)                                                               \
    CALL(thud_threads_create, workers, 1, THUD_WORKERS_MAX,                                        \
         threads(x > -1e6 && x < 1e6 ? (int)x : -1))                                               \
    FIELD(thud_geometry, x, x, -THUD_COORDINATE_MAX, THUD_COORDINATE_MAX, instance)                \
    FIELD(thud_geometry, hx, hx, OPEN(0), THUD_COORDINATE_MAX, instance)                           \
    FIELD(thud_geometry, hy, hy, OPEN(0), THUD_COORDINATE_MAX, instance)                           \
    FIELD(thud_motion, turn, turn, -THUD_ANGLE_MAX, THUD_ANGLE_MAX, motion)                        \
    CALL(thud_sincos, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX, thud_sincos(x, &p->x, &p->y))        \
    CALL(thud_geometry_contacts, margin, 0, THUD_COORDINATE_MAX,                                   \
         thud_geometry_contacts(&p->box, &p->box, x, &p->contacts))                                \
    CALL(thud_geometry_time_of_impact, target, 0, THUD_COORDINATE_MAX,                             \
         thud_geometry_time_of_impact(&p->box, p->rest, &p->box, p->rest, x, &p->hit, &p->x))      \
    CALL(thud_geometry_time_of_collision, tolerance, THUD_TOLERANCE_MIN, 1,                        \
         thud_geometry_time_of_collision(&p->box, p->rest, &p->box, p->rest, x, &p->hit, &p->x))   \
    CALL(thud_geometry_area_below, x, -THUD_COORDINATE_MAX, THUD_COORDINATE_MAX, below(p, x, 1.0)) \
    CALL(thud_volume_check, x, -THUD_VOLUME_MAX, THUD_VOLUME_MAX,                                  \
         thud_volume_check(&(thud_volume){THUD_SHAPE_AABB, x, 0, 1, 0, 1, 1}))                     \
    CALL(thud_volume_check, hx, 0, THUD_VOLUME_MAX,                                                \
         thud_volume_check(&(thud_volume){THUD_SHAPE_AABB, 0, 0, 1, 0, x, 1}))                     \
    CALL(thud_volume_contains_point, x, -THUD_VOLUME_MAX, THUD_VOLUME_MAX,                         \
         thud_volume_contains_point(&p->box, x, 0, &p->hit))                                       \
    CALL(thud_volume_around_points, points, -THUD_COORDINATE_MAX, THUD_COORDINATE_MAX,             \
         thud_volume_around_points(THUD_SHAPE_CIRCLE, &(thud_pos){x, 0}, 1, &p->volume))           \
    FIELD(thud_minkowski, radius, radius, 0, THUD_VOLUME_MAX, sum)                                 \
    CALL(thud_minkowski_contains, x, -THUD_VOLUME_MAX, THUD_VOLUME_MAX,                            \
         thud_minkowski_contains(&p->sum, x, 0, &p->hit))                                          \
    CALL(thud_minkowski_cast, dx, -THUD_VOLUME_MAX, THUD_VOLUME_MAX,                               \
         thud_minkowski_cast(&p->sum, (thud_segment){0, 0, x, 0}, &p->hit, &p->x, &p->y, &p->z))   \
    FIELD(thud_capsule, y2, y2, -THUD_COORDINATE_MAX, THUD_COORDINATE_MAX, capsule)                \
    FIELD(thud_capsule, radius, radius, OPEN(0), THUD_COORDINATE_MAX, capsule)                     \
    CALL(thud_capsule_time_of_impact, target, 0, THUD_COORDINATE_MAX,                              \
         thud_capsule_time_of_impact(&(thud_capsule){0, 0, 1, 1, 1}, p->rest, &p->box, p->rest, x, \
                                     &p->hit, &p->x))                                              \
    CALL(thud_polygon_check, points, -THUD_POLYGON_PLACE_MAX, THUD_POLYGON_PLACE_MAX,              \
         polygon_at(x))                                                                            \
    FIELD(thud_approximate_options, shapes_max, shapes_max, 1, THUD_APPROXIMATE_SHAPES_MAX,        \
          approximation)                                                                           \
    FIELD(thud_approximate_options, distance, distance, 0, THUD_COORDINATE_MAX, approximation)     \
    FIELD(thud_terrain, slope, slope, -THUD_TERRAIN_SLOPE_MAX, THUD_TERRAIN_SLOPE_MAX, plane)      \
    FIELD(thud_terrain, x0, x0, -THUD_TERRAIN_PLACE_MAX, THUD_TERRAIN_PLACE_MAX, grid)             \
    FIELD(thud_terrain, spacing, spacing, OPEN(0), THUD_TERRAIN_PLACE_MAX, grid)                   \
    CALL(thud_terrain_check, points, -THUD_TERRAIN_PLACE_MAX, THUD_TERRAIN_PLACE_MAX,              \
         vertex_at(x))                                                                             \
    FIELD(thud_terrain, count, count, 2, THUD_TERRAIN_COUNT_MAX, vertices)                         \
    CALL(thud_texture_friction_at, vertices, 0, THUD_FRICTION_MAX, textured(x, NULL))              \
    CALL(thud_texture_friction_at, coordinates, -THUD_TERRAIN_PLACE_MAX, THUD_TERRAIN_PLACE_MAX,   \
         textured(x, even))

#endif
