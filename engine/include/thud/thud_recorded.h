/* thud_recorded.h: records the calls of the source files that include it. Each function that
 * changes a world, and each query of one, is redirected to one that makes the same call, and adds
 * it to the recording of the world (thud_recording.h), if there is one; queries only where the
 * recorder is asked to. Include it last: it includes all headers of thud. Programs that do not
 * include it link nothing of it.
 *
 * Calls have the same arguments, results and errors as without it. thud_all.h does not include this
 * header. */
/* Made by tools/recorded.py of the public headers: do not edit. */
#ifndef THUD_RECORDED_H
#define THUD_RECORDED_H

#include "thud_all.h"

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
THUD_API thud_result thud_recorded_shape_set_heights(thud_world *world, thud_shape_id shape, int first, const double *heights, int count);
#define thud_shape_set_heights thud_recorded_shape_set_heights
THUD_API thud_result thud_recorded_shape_dig(thud_world *world, thud_shape_id shape, thud_pos center, double radius);
#define thud_shape_dig thud_recorded_shape_dig
THUD_API thud_result thud_recorded_shape_raise(thud_world *world, thud_shape_id shape, double x, double radius, double height);
#define thud_shape_raise thud_recorded_shape_raise
THUD_API thud_result thud_recorded_shape_replace_range(thud_world *world, thud_shape_id shape, double x0, double x1, const thud_pos *points, int count);
#define thud_shape_replace_range thud_recorded_shape_replace_range
THUD_API thud_result thud_recorded_world_step(thud_world *world);
#define thud_world_step thud_recorded_world_step
THUD_API thud_result thud_recorded_world_advance(thud_world *world, double elapsed, int max_steps, int *out_steps, double *out_alpha);
#define thud_world_advance thud_recorded_world_advance
THUD_API thud_result thud_recorded_world_advance_with(thud_world *world, double elapsed, int max_steps, const thud_step_calls *calls, int *out_steps, double *out_alpha);
#define thud_world_advance_with thud_recorded_world_advance_with
THUD_API thud_result thud_recorded_world_set_gravity(thud_world *world, thud_vec2 gravity);
#define thud_world_set_gravity thud_recorded_world_set_gravity
THUD_API thud_result thud_recorded_world_set_time_step(thud_world *world, double time_step);
#define thud_world_set_time_step thud_recorded_world_set_time_step
THUD_API thud_result thud_recorded_world_set_max_error(thud_world *world, double max_error);
#define thud_world_set_max_error thud_recorded_world_set_max_error
THUD_API thud_result thud_recorded_world_set_quality(thud_world *world, const thud_quality *quality);
#define thud_world_set_quality thud_recorded_world_set_quality
THUD_API thud_result thud_recorded_world_set_sleeping(thud_world *world, bool sleeping);
#define thud_world_set_sleeping thud_recorded_world_set_sleeping
THUD_API thud_result thud_recorded_body_create(thud_world *world, const thud_body_def *def, thud_body_id *out);
#define thud_body_create thud_recorded_body_create
THUD_API thud_result thud_recorded_body_destroy(thud_world *world, thud_body_id body);
#define thud_body_destroy thud_recorded_body_destroy
THUD_API thud_result thud_recorded_body_set_transform(thud_world *world, thud_body_id body, thud_pos position, double angle);
#define thud_body_set_transform thud_recorded_body_set_transform
THUD_API thud_result thud_recorded_body_set_velocity(thud_world *world, thud_body_id body, thud_vec2 velocity, float angular_velocity);
#define thud_body_set_velocity thud_recorded_body_set_velocity
THUD_API thud_result thud_recorded_body_apply_impulse(thud_world *world, thud_body_id body, thud_vec2 impulse, thud_pos point);
#define thud_body_apply_impulse thud_recorded_body_apply_impulse
THUD_API thud_result thud_recorded_body_apply_center_force(thud_world *world, thud_body_id body, thud_vec2 force);
#define thud_body_apply_center_force thud_recorded_body_apply_center_force
THUD_API thud_result thud_recorded_body_apply_torque(thud_world *world, thud_body_id body, float torque);
#define thud_body_apply_torque thud_recorded_body_apply_torque
THUD_API thud_result thud_recorded_body_set_awake(thud_world *world, thud_body_id body, bool awake);
#define thud_body_set_awake thud_recorded_body_set_awake
THUD_API thud_result thud_recorded_body_set_enabled(thud_world *world, thud_body_id body, bool enabled);
#define thud_body_set_enabled thud_recorded_body_set_enabled
THUD_API thud_result thud_recorded_body_set_user_data(thud_world *world, thud_body_id body, uint64_t user_data);
#define thud_body_set_user_data thud_recorded_body_set_user_data
THUD_API thud_result thud_recorded_shape_create_circle(thud_world *world, thud_body_id body, const thud_shape_def *def, thud_vec2 offset, float radius, thud_shape_id *out);
#define thud_shape_create_circle thud_recorded_shape_create_circle
THUD_API thud_result thud_recorded_shape_create_aabb(thud_world *world, thud_body_id body, const thud_shape_def *def, thud_vec2 offset, thud_vec2 half_extents, thud_shape_id *out);
#define thud_shape_create_aabb thud_recorded_shape_create_aabb
THUD_API thud_result thud_recorded_shape_create_obb(thud_world *world, thud_body_id body, const thud_shape_def *def, thud_vec2 offset, thud_vec2 half_extents, double angle, thud_shape_id *out);
#define thud_shape_create_obb thud_recorded_shape_create_obb
THUD_API thud_result thud_recorded_shape_create_terrain(thud_world *world, thud_body_id body, const thud_shape_def *def, const thud_terrain *terrain, thud_shape_id *out);
#define thud_shape_create_terrain thud_recorded_shape_create_terrain
THUD_API thud_result thud_recorded_shape_destroy(thud_world *world, thud_shape_id shape);
#define thud_shape_destroy thud_recorded_shape_destroy
THUD_API thud_result thud_recorded_body_create_with_shapes(thud_world *world, const thud_body_def *def, const thud_body_shape *shapes, int count, thud_body_id *out_body, thud_shape_id *out_shape_ids);
#define thud_body_create_with_shapes thud_recorded_body_create_with_shapes
THUD_API thud_result thud_recorded_shape_set_filter(thud_world *world, thud_shape_id shape, thud_filter filter);
#define thud_shape_set_filter thud_recorded_shape_set_filter
THUD_API thud_result thud_recorded_shape_set_friction(thud_world *world, thud_shape_id shape, float friction);
#define thud_shape_set_friction thud_recorded_shape_set_friction
THUD_API thud_result thud_recorded_shape_set_restitution(thud_world *world, thud_shape_id shape, float restitution);
#define thud_shape_set_restitution thud_recorded_shape_set_restitution
THUD_API thud_result thud_recorded_shape_set_surface_speed(thud_world *world, thud_shape_id shape, float surface_speed);
#define thud_shape_set_surface_speed thud_recorded_shape_set_surface_speed
THUD_API thud_result thud_recorded_shape_set_density(thud_world *world, thud_shape_id shape, float density);
#define thud_shape_set_density thud_recorded_shape_set_density
THUD_API thud_result thud_recorded_shape_set_sensor(thud_world *world, thud_shape_id shape, bool sensor);
#define thud_shape_set_sensor thud_recorded_shape_set_sensor
THUD_API thud_result thud_recorded_shape_set_radius(thud_world *world, thud_shape_id shape, float radius);
#define thud_shape_set_radius thud_recorded_shape_set_radius
THUD_API thud_result thud_recorded_shape_set_half_extents(thud_world *world, thud_shape_id shape, thud_vec2 half_extents);
#define thud_shape_set_half_extents thud_recorded_shape_set_half_extents
THUD_API thud_result thud_recorded_shape_set_events(thud_world *world, thud_shape_id shape, bool events);
#define thud_shape_set_events thud_recorded_shape_set_events
THUD_API thud_result thud_recorded_shape_set_user_data(thud_world *world, thud_shape_id shape, uint64_t user_data);
#define thud_shape_set_user_data thud_recorded_shape_set_user_data
THUD_API thud_result thud_recorded_body_set_kind(thud_world *world, thud_body_id body, thud_body_kind kind);
#define thud_body_set_kind thud_recorded_body_set_kind
THUD_API thud_result thud_recorded_body_set_damping(thud_world *world, thud_body_id body, float linear, float angular);
#define thud_body_set_damping thud_recorded_body_set_damping
THUD_API thud_result thud_recorded_body_set_gravity_scale(thud_world *world, thud_body_id body, float gravity_scale);
#define thud_body_set_gravity_scale thud_recorded_body_set_gravity_scale
THUD_API thud_result thud_recorded_body_set_fixed_rotation(thud_world *world, thud_body_id body, bool fixed);
#define thud_body_set_fixed_rotation thud_recorded_body_set_fixed_rotation
THUD_API thud_result thud_recorded_body_set_detection(thud_world *world, thud_body_id body, const thud_detection *detection);
#define thud_body_set_detection thud_recorded_body_set_detection
THUD_API thud_result thud_recorded_body_set_may_sleep(thud_world *world, thud_body_id body, bool may_sleep);
#define thud_body_set_may_sleep thud_recorded_body_set_may_sleep
THUD_API thud_result thud_recorded_body_set_mass(thud_world *world, thud_body_id body, const thud_mass *mass);
#define thud_body_set_mass thud_recorded_body_set_mass
THUD_API thud_result thud_recorded_body_apply_force(thud_world *world, thud_body_id body, thud_vec2 force, thud_pos point);
#define thud_body_apply_force thud_recorded_body_apply_force
THUD_API thud_result thud_recorded_body_apply_center_impulse(thud_world *world, thud_body_id body, thud_vec2 impulse);
#define thud_body_apply_center_impulse thud_recorded_body_apply_center_impulse
THUD_API thud_result thud_recorded_body_apply_angular_impulse(thud_world *world, thud_body_id body, float impulse);
#define thud_body_apply_angular_impulse thud_recorded_body_apply_angular_impulse
THUD_API thud_result thud_recorded_body_set_target(thud_world *world, thud_body_id body, thud_pos position, double angle);
#define thud_body_set_target thud_recorded_body_set_target
THUD_API thud_result thud_recorded_world_explode(thud_world *world, const thud_explosion *explosion, int *out_pushed);
#define thud_world_explode thud_recorded_world_explode
THUD_API thud_result thud_recorded_body_apply_wind(thud_world *world, thud_body_id body, thud_vec2 wind, float density, float drag, float lift);
#define thud_body_apply_wind thud_recorded_body_apply_wind
THUD_API thud_result thud_recorded_body_apply_buoyancy(thud_world *world, thud_body_id body, const thud_water *water);
#define thud_body_apply_buoyancy thud_recorded_body_apply_buoyancy
THUD_API thud_result thud_recorded_body_apply_rolling_resistance(thud_world *world, thud_body_id body, float coefficient);
#define thud_body_apply_rolling_resistance thud_recorded_body_apply_rolling_resistance
THUD_API thud_result thud_recorded_body_apply_grip(thud_world *world, thud_body_id body, thud_vec2 point, thud_vec2 axis, float speed, float max_force);
#define thud_body_apply_grip thud_recorded_body_apply_grip
THUD_API thud_result thud_recorded_joint_create(thud_world *world, const thud_joint_def *def, thud_joint_id *out);
#define thud_joint_create thud_recorded_joint_create
THUD_API thud_result thud_recorded_joint_destroy(thud_world *world, thud_joint_id joint);
#define thud_joint_destroy thud_recorded_joint_destroy
THUD_API thud_result thud_recorded_joint_set_drive(thud_world *world, thud_joint_id joint, thud_direction direction, const thud_drive *drive);
#define thud_joint_set_drive thud_recorded_joint_set_drive
THUD_API thud_result thud_recorded_joint_set_length(thud_world *world, thud_joint_id joint, float length);
#define thud_joint_set_length thud_recorded_joint_set_length
THUD_API thud_result thud_recorded_joint_set_enabled(thud_world *world, thud_joint_id joint, bool enabled);
#define thud_joint_set_enabled thud_recorded_joint_set_enabled
THUD_API thud_result thud_recorded_joint_set_frame(thud_world *world, thud_joint_id joint, int side, thud_joint_frame frame);
#define thud_joint_set_frame thud_recorded_joint_set_frame
THUD_API thud_result thud_recorded_joint_set_breaking(thud_world *world, thud_joint_id joint, float force, float torque, bool only_reports);
#define thud_joint_set_breaking thud_recorded_joint_set_breaking
THUD_API thud_result thud_recorded_joint_set_user_data(thud_world *world, thud_joint_id joint, uint64_t user_data);
#define thud_joint_set_user_data thud_recorded_joint_set_user_data
THUD_API thud_result thud_recorded_world_use_joints(thud_world *world);
#define thud_world_use_joints thud_recorded_world_use_joints
THUD_API thud_joint_id thud_recorded_joint_make(thud_world *world, thud_joint_def def);
#define thud_joint_make thud_recorded_joint_make
THUD_API thud_result thud_recorded_world_set_listeners(thud_world *world, const thud_listeners *listeners);
#define thud_world_set_listeners thud_recorded_world_set_listeners
THUD_API thud_result thud_recorded_contact_decide(thud_world *world, const thud_contact *contact, const thud_velocities *a, const thud_velocities *b);
#define thud_contact_decide thud_recorded_contact_decide
THUD_API thud_result thud_recorded_body_set_locks(thud_world *world, thud_body_id body, bool x, bool y);
#define thud_body_set_locks thud_recorded_body_set_locks
THUD_API thud_body_id thud_recorded_body_make(thud_world *world, thud_geometry shape, const thud_body_options *options);
#define thud_body_make thud_recorded_body_make
THUD_API thud_result thud_recorded_mover_move(thud_world *world, thud_mover *mover, thud_vec2 velocity, double dt, thud_mover_report *out_report);
#define thud_mover_move thud_recorded_mover_move
THUD_API thud_result thud_recorded_world_set_rule(thud_world *world, uint32_t first, uint32_t second, const thud_rule *rule);
#define thud_world_set_rule thud_recorded_world_set_rule
THUD_API thud_result thud_recorded_world_use_rules(thud_world *world);
#define thud_world_use_rules thud_recorded_world_use_rules
THUD_API thud_result thud_recorded_world_set_filter(thud_world *world, thud_filter_fn *filter, void *context);
#define thud_world_set_filter thud_recorded_world_set_filter
THUD_API thud_result thud_recorded_shape_set_texture(thud_world *world, thud_shape_id shape, const thud_texture *texture);
#define thud_shape_set_texture thud_recorded_shape_set_texture
THUD_API thud_result thud_recorded_world_use_textures(thud_world *world);
#define thud_world_use_textures thud_recorded_world_use_textures
THUD_API thud_result thud_recorded_world_use_step_error(thud_world *world);
#define thud_world_use_step_error thud_recorded_world_use_step_error
THUD_API thud_result thud_recorded_world_cast_ray(thud_world *world, const thud_ray *ray, _Bool *out_hit, thud_ray_hit *out);
#define thud_world_cast_ray thud_recorded_world_cast_ray
THUD_API thud_result thud_recorded_world_cast_ray_all(thud_world *world, const thud_ray *ray, thud_ray_hit *out, int capacity, int *out_count);
#define thud_world_cast_ray_all thud_recorded_world_cast_ray_all
THUD_API thud_result thud_recorded_world_cast_shape(thud_world *world, const thud_shape_cast *cast, _Bool *out_hit, thud_ray_hit *out);
#define thud_world_cast_shape thud_recorded_world_cast_shape
THUD_API thud_result thud_recorded_world_cast_shape_all(thud_world *world, const thud_shape_cast *cast, thud_ray_hit *out, int capacity, int *out_count);
#define thud_world_cast_shape_all thud_recorded_world_cast_shape_all
THUD_API thud_result thud_recorded_world_overlap_shape(thud_world *world, thud_pos center, thud_geometry shape, const thud_query_filter *filter, thud_overlap_fn *fn, void *context);
#define thud_world_overlap_shape thud_recorded_world_overlap_shape
THUD_API thud_result thud_recorded_world_overlap_aabb(thud_world *world, thud_pos lower, thud_pos upper, const thud_query_filter *filter, thud_overlap_fn *fn, void *context);
#define thud_world_overlap_aabb thud_recorded_world_overlap_aabb
THUD_API thud_result thud_recorded_world_closest(thud_world *world, thud_pos point, double max_distance, const thud_query_filter *filter, _Bool *out_found, thud_closest_hit *out);
#define thud_world_closest thud_recorded_world_closest
THUD_API thud_result thud_recorded_world_cast_ray_each(thud_world *world, const thud_ray *ray, thud_cast_fn *fn, void *context);
#define thud_world_cast_ray_each thud_recorded_world_cast_ray_each
THUD_API thud_result thud_recorded_world_cast_shape_each(thud_world *world, const thud_shape_cast *cast, thud_cast_fn *fn, void *context);
#define thud_world_cast_shape_each thud_recorded_world_cast_shape_each
THUD_API thud_result thud_recorded_world_cast_rays(thud_world *world, const thud_ray *rays, int count, thud_ray_hit *out_hits);
#define thud_world_cast_rays thud_recorded_world_cast_rays
THUD_API thud_result thud_recorded_world_cast_shapes(thud_world *world, const thud_shape_cast *casts, int count, thud_ray_hit *out_hits);
#define thud_world_cast_shapes thud_recorded_world_cast_shapes
THUD_API thud_result thud_recorded_world_restore(thud_world *world, const void *buffer, size_t bytes);
#define thud_world_restore thud_recorded_world_restore
THUD_API thud_result thud_recorded_world_load(thud_world *world, const char *path, void *out_own, size_t bytes);
#define thud_world_load thud_recorded_world_load
THUD_API void thud_recorded_world_destroy(thud_world *world);
#define thud_world_destroy thud_recorded_world_destroy
/* clang-format on */

#ifdef __cplusplus
}
#endif

#endif
