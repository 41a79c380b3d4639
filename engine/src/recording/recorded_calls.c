/* recorded_calls.c: how the arguments of calls, and what queries found, become bytes: tables
 * of codec.h. */
/* Made by tools/recorded.py of the public headers: do not edit. */
#include "recording/recorded_calls.h"

#include "thud/thud_all.h"

/* clang-format off */
#define FIELD(type, code, repeat, field, count, codec) \
    {TD_CODE_##code, repeat, offsetof(type, field), offsetof(type, count), codec}
#define CODEC(type, fields) {fields, sizeof fields / sizeof *fields, sizeof(type)}
static const td_codec_field FIELDS_float[] = {{TD_CODE_FLOAT, 1, 0, 0, NULL}};
static const td_codec CODEC_float = CODEC(float, FIELDS_float);
static const td_codec_field FIELDS_double[] = {{TD_CODE_DOUBLE, 1, 0, 0, NULL}};
static const td_codec CODEC_double = CODEC(double, FIELDS_double);
static const td_codec_field FIELDS_thud_pos[] = {
    FIELD(thud_pos, DOUBLE, 1, x, x, NULL),
    FIELD(thud_pos, DOUBLE, 1, y, y, NULL),
};
static const td_codec CODEC_thud_pos = CODEC(thud_pos, FIELDS_thud_pos);
static const td_codec_field FIELDS_thud_vec2[] = {
    FIELD(thud_vec2, FLOAT, 1, x, x, NULL),
    FIELD(thud_vec2, FLOAT, 1, y, y, NULL),
};
static const td_codec CODEC_thud_vec2 = CODEC(thud_vec2, FIELDS_thud_vec2);
static const td_codec_field FIELDS_thud_quality[] = {
    FIELD(thud_quality, NAME, 1, name, name, NULL),
    FIELD(thud_quality, INT32, 1, substeps, substeps, NULL),
    FIELD(thud_quality, FLOAT, 1, contact_stiffness, contact_stiffness, NULL),
    FIELD(thud_quality, FLOAT, 1, contact_damping, contact_damping, NULL),
    FIELD(thud_quality, DETECTION, 1, detection, detection, NULL),
    FIELD(thud_quality, ISLANDS, 1, islands, islands, NULL),
    FIELD(thud_quality, FLOAT, 1, overlap_limit, overlap_limit, NULL),
    FIELD(thud_quality, INT32, 1, island_limit, island_limit, NULL),
    FIELD(thud_quality, INT64, 1, island_work, island_work, NULL),
    FIELD(thud_quality, INT32, 1, island_slow_steps, island_slow_steps, NULL),
};
static const td_codec CODEC_thud_quality = CODEC(thud_quality, FIELDS_thud_quality);
static const td_codec_field FIELDS_thud_body_def[] = {
    FIELD(thud_body_def, INT32, 1, kind, kind, NULL),
    FIELD(thud_body_def, STRUCT, 1, position, position, &CODEC_thud_pos),
    FIELD(thud_body_def, DOUBLE, 1, angle, angle, NULL),
    FIELD(thud_body_def, STRUCT, 1, velocity, velocity, &CODEC_thud_vec2),
    FIELD(thud_body_def, FLOAT, 1, angular_velocity, angular_velocity, NULL),
    FIELD(thud_body_def, FLOAT, 1, gravity_scale, gravity_scale, NULL),
    FIELD(thud_body_def, FLOAT, 1, linear_damping, linear_damping, NULL),
    FIELD(thud_body_def, FLOAT, 1, angular_damping, angular_damping, NULL),
    FIELD(thud_body_def, BOOL, 1, fixed_rotation, fixed_rotation, NULL),
    FIELD(thud_body_def, BOOL, 1, may_sleep, may_sleep, NULL),
    FIELD(thud_body_def, DETECTION, 1, detection, detection, NULL),
    FIELD(thud_body_def, UINT64, 1, user_data, user_data, NULL),
    FIELD(thud_body_def, COOKIE, 1, cookie, cookie, NULL),
};
static const td_codec CODEC_thud_body_def = CODEC(thud_body_def, FIELDS_thud_body_def);
static const td_codec_field FIELDS_thud_filter[] = {
    FIELD(thud_filter, UINT32, 1, category, category, NULL),
    FIELD(thud_filter, UINT32, 1, mask, mask, NULL),
    FIELD(thud_filter, INT32, 1, group, group, NULL),
};
static const td_codec CODEC_thud_filter = CODEC(thud_filter, FIELDS_thud_filter);
static const td_codec_field FIELDS_thud_shape_def[] = {
    FIELD(thud_shape_def, FLOAT, 1, density, density, NULL),
    FIELD(thud_shape_def, FLOAT, 1, friction, friction, NULL),
    FIELD(thud_shape_def, FLOAT, 1, restitution, restitution, NULL),
    FIELD(thud_shape_def, FLOAT, 1, surface_speed, surface_speed, NULL),
    FIELD(thud_shape_def, STRUCT, 1, filter, filter, &CODEC_thud_filter),
    FIELD(thud_shape_def, BOOL, 1, sensor, sensor, NULL),
    FIELD(thud_shape_def, BOOL, 1, events, events, NULL),
    FIELD(thud_shape_def, UINT64, 1, user_data, user_data, NULL),
    FIELD(thud_shape_def, COOKIE, 1, cookie, cookie, NULL),
};
static const td_codec CODEC_thud_shape_def = CODEC(thud_shape_def, FIELDS_thud_shape_def);
static const td_codec_field FIELDS_thud_terrain[] = {
    FIELD(thud_terrain, INT32, 1, kind, kind, NULL),
    FIELD(thud_terrain, DOUBLE, 1, slope, slope, NULL),
    FIELD(thud_terrain, DOUBLE, 1, x0, x0, NULL),
    FIELD(thud_terrain, DOUBLE, 1, spacing, spacing, NULL),
    FIELD(thud_terrain, POINTS, 1, points, count, &CODEC_thud_pos),
    FIELD(thud_terrain, INT32, 1, count, count, NULL),
};
static const td_codec CODEC_thud_terrain = CODEC(thud_terrain, FIELDS_thud_terrain);
static const td_codec_field FIELDS_thud_geometry[] = {
    FIELD(thud_geometry, INT32, 1, kind, kind, NULL),
    FIELD(thud_geometry, DOUBLE, 1, x, x, NULL),
    FIELD(thud_geometry, DOUBLE, 1, y, y, NULL),
    FIELD(thud_geometry, DOUBLE, 1, c, c, NULL),
    FIELD(thud_geometry, DOUBLE, 1, s, s, NULL),
    FIELD(thud_geometry, DOUBLE, 1, hx, hx, NULL),
    FIELD(thud_geometry, DOUBLE, 1, hy, hy, NULL),
};
static const td_codec CODEC_thud_geometry = CODEC(thud_geometry, FIELDS_thud_geometry);
static const td_codec_field FIELDS_thud_body_shape[] = {
    FIELD(thud_body_shape, STRUCT, 1, shape, shape, &CODEC_thud_geometry),
    FIELD(thud_body_shape, POINTER, 1, def, def, &CODEC_thud_shape_def),
};
static const td_codec CODEC_thud_body_shape = CODEC(thud_body_shape, FIELDS_thud_body_shape);
static const td_codec_field FIELDS_thud_mass[] = {
    FIELD(thud_mass, FLOAT, 1, mass, mass, NULL),
    FIELD(thud_mass, FLOAT, 1, inertia, inertia, NULL),
    FIELD(thud_mass, STRUCT, 1, center, center, &CODEC_thud_vec2),
};
static const td_codec CODEC_thud_mass = CODEC(thud_mass, FIELDS_thud_mass);
static const td_codec_field FIELDS_thud_query_filter[] = {
    FIELD(thud_query_filter, UINT32, 1, category, category, NULL),
    FIELD(thud_query_filter, UINT32, 1, mask, mask, NULL),
    FIELD(thud_query_filter, BOOL, 1, sensors, sensors, NULL),
    FIELD(thud_query_filter, INT32, 1, group, group, NULL),
    FIELD(thud_query_filter, HANDLE, 1, ignore, ignore, NULL),
};
static const td_codec CODEC_thud_query_filter = CODEC(thud_query_filter, FIELDS_thud_query_filter);
static const td_codec_field FIELDS_thud_explosion[] = {
    FIELD(thud_explosion, STRUCT, 1, center, center, &CODEC_thud_pos),
    FIELD(thud_explosion, DOUBLE, 1, radius, radius, NULL),
    FIELD(thud_explosion, DOUBLE, 1, falloff, falloff, NULL),
    FIELD(thud_explosion, FLOAT, 1, impulse, impulse, NULL),
    FIELD(thud_explosion, INT32, 1, cover, cover, NULL),
    FIELD(thud_explosion, INT32, 1, rays, rays, NULL),
    FIELD(thud_explosion, STRUCT, 1, filter, filter, &CODEC_thud_query_filter),
    FIELD(thud_explosion, COOKIE, 1, cookie, cookie, NULL),
};
static const td_codec CODEC_thud_explosion = CODEC(thud_explosion, FIELDS_thud_explosion);
static const td_codec_field FIELDS_thud_water[] = {
    FIELD(thud_water, STRUCT, 1, point, point, &CODEC_thud_pos),
    FIELD(thud_water, STRUCT, 1, normal, normal, &CODEC_thud_vec2),
    FIELD(thud_water, FLOAT, 1, density, density, NULL),
    FIELD(thud_water, STRUCT, 1, flow, flow, &CODEC_thud_vec2),
    FIELD(thud_water, FLOAT, 1, linear_drag, linear_drag, NULL),
    FIELD(thud_water, FLOAT, 1, angular_drag, angular_drag, NULL),
    FIELD(thud_water, COOKIE, 1, cookie, cookie, NULL),
};
static const td_codec CODEC_thud_water = CODEC(thud_water, FIELDS_thud_water);
static const td_codec_field FIELDS_thud_joint_frame[] = {
    FIELD(thud_joint_frame, STRUCT, 1, position, position, &CODEC_thud_vec2),
    FIELD(thud_joint_frame, DOUBLE, 1, angle, angle, NULL),
};
static const td_codec CODEC_thud_joint_frame = CODEC(thud_joint_frame, FIELDS_thud_joint_frame);
static const td_codec_field FIELDS_thud_drive[] = {
    FIELD(thud_drive, BOOL, 1, limited, limited, NULL),
    FIELD(thud_drive, FLOAT, 1, lower, lower, NULL),
    FIELD(thud_drive, FLOAT, 1, upper, upper, NULL),
    FIELD(thud_drive, FLOAT, 1, frequency, frequency, NULL),
    FIELD(thud_drive, FLOAT, 1, damping, damping, NULL),
    FIELD(thud_drive, FLOAT, 1, target, target, NULL),
    FIELD(thud_drive, FLOAT, 1, spring_force, spring_force, NULL),
    FIELD(thud_drive, FLOAT, 1, motor_speed, motor_speed, NULL),
    FIELD(thud_drive, FLOAT, 1, motor_force, motor_force, NULL),
};
static const td_codec CODEC_thud_drive = CODEC(thud_drive, FIELDS_thud_drive);
static const td_codec_field FIELDS_thud_joint_def[] = {
    FIELD(thud_joint_def, INT32, 1, kind, kind, NULL),
    FIELD(thud_joint_def, HANDLE, 1, body_a, body_a, NULL),
    FIELD(thud_joint_def, HANDLE, 1, body_b, body_b, NULL),
    FIELD(thud_joint_def, STRUCT, 1, frame_a, frame_a, &CODEC_thud_joint_frame),
    FIELD(thud_joint_def, STRUCT, 1, frame_b, frame_b, &CODEC_thud_joint_frame),
    FIELD(thud_joint_def, STRUCT, 3, drive, drive, &CODEC_thud_drive),
    FIELD(thud_joint_def, FLOAT, 1, length, length, NULL),
    FIELD(thud_joint_def, HANDLE, 2, gear, gear, NULL),
    FIELD(thud_joint_def, FLOAT, 1, ratio, ratio, NULL),
    FIELD(thud_joint_def, BOOL, 1, collide_connected, collide_connected, NULL),
    FIELD(thud_joint_def, FLOAT, 1, break_force, break_force, NULL),
    FIELD(thud_joint_def, FLOAT, 1, break_torque, break_torque, NULL),
    FIELD(thud_joint_def, BOOL, 1, only_reports, only_reports, NULL),
    FIELD(thud_joint_def, BOOL, 1, enabled, enabled, NULL),
    FIELD(thud_joint_def, UINT64, 1, user_data, user_data, NULL),
    FIELD(thud_joint_def, COOKIE, 1, cookie, cookie, NULL),
};
static const td_codec CODEC_thud_joint_def = CODEC(thud_joint_def, FIELDS_thud_joint_def);
static const td_codec_field FIELDS_thud_velocities[] = {
    FIELD(thud_velocities, STRUCT, 1, velocity, velocity, &CODEC_thud_vec2),
    FIELD(thud_velocities, FLOAT, 1, angular_velocity, angular_velocity, NULL),
};
static const td_codec CODEC_thud_velocities = CODEC(thud_velocities, FIELDS_thud_velocities);
static const td_codec_field FIELDS_thud_body_options[] = {
    FIELD(thud_body_options, INT32, 1, kind, kind, NULL),
    FIELD(thud_body_options, STRUCT, 1, velocity, velocity, &CODEC_thud_vec2),
    FIELD(thud_body_options, FLOAT, 1, angular_velocity, angular_velocity, NULL),
    FIELD(thud_body_options, FLOAT, 1, linear_damping, linear_damping, NULL),
    FIELD(thud_body_options, FLOAT, 1, angular_damping, angular_damping, NULL),
    FIELD(thud_body_options, BOOL, 1, weightless, weightless, NULL),
    FIELD(thud_body_options, BOOL, 1, fixed_rotation, fixed_rotation, NULL),
    FIELD(thud_body_options, DETECTION, 1, detection, detection, NULL),
    FIELD(thud_body_options, FLOAT, 1, density, density, NULL),
    FIELD(thud_body_options, FLOAT, 1, friction, friction, NULL),
    FIELD(thud_body_options, BOOL, 1, frictionless, frictionless, NULL),
    FIELD(thud_body_options, FLOAT, 1, restitution, restitution, NULL),
    FIELD(thud_body_options, FLOAT, 1, surface_speed, surface_speed, NULL),
    FIELD(thud_body_options, UINT32, 1, category, category, NULL),
    FIELD(thud_body_options, UINT32, 1, mask, mask, NULL),
    FIELD(thud_body_options, INT32, 1, group, group, NULL),
    FIELD(thud_body_options, BOOL, 1, sensor, sensor, NULL),
    FIELD(thud_body_options, UINT64, 1, user_data, user_data, NULL),
};
static const td_codec CODEC_thud_body_options = CODEC(thud_body_options, FIELDS_thud_body_options);
static const td_codec_field FIELDS_thud_mover[] = {
    FIELD(thud_mover, STRUCT, 1, shape, shape, &CODEC_thud_geometry),
    FIELD(thud_mover, STRUCT, 1, up, up, &CODEC_thud_vec2),
    FIELD(thud_mover, DOUBLE, 1, skin, skin, NULL),
    FIELD(thud_mover, DOUBLE, 1, max_slope, max_slope, NULL),
    FIELD(thud_mover, DOUBLE, 1, step_height, step_height, NULL),
    FIELD(thud_mover, DOUBLE, 1, snap_distance, snap_distance, NULL),
    FIELD(thud_mover, DOUBLE, 1, push_force, push_force, NULL),
    FIELD(thud_mover, HANDLE, 1, body, body, NULL),
    FIELD(thud_mover, STRUCT, 1, filter, filter, &CODEC_thud_query_filter),
    FIELD(thud_mover, PASS, 1, pass, pass, NULL),
    FIELD(thud_mover, NOTHING, 1, context, context, NULL),
    FIELD(thud_mover, BOOL, 1, on_ground, on_ground, NULL),
    FIELD(thud_mover, STRUCT, 1, ground_normal, ground_normal, &CODEC_thud_vec2),
    FIELD(thud_mover, HANDLE, 1, ground_shape, ground_shape, NULL),
    FIELD(thud_mover, HANDLE, 1, ground_body, ground_body, NULL),
    FIELD(thud_mover, STRUCT, 1, ground_point, ground_point, &CODEC_thud_pos),
    FIELD(thud_mover, STRUCT, 1, ground_place, ground_place, &CODEC_thud_pos),
    FIELD(thud_mover, FLOAT, 1, ground_cosine, ground_cosine, NULL),
    FIELD(thud_mover, FLOAT, 1, ground_sine, ground_sine, NULL),
};
static const td_codec CODEC_thud_mover = CODEC(thud_mover, FIELDS_thud_mover);
static const td_codec_field FIELDS_thud_rule[] = {
    FIELD(thud_rule, INT32, 1, kind, kind, NULL),
    FIELD(thud_rule, STRUCT, 1, solid_side, solid_side, &CODEC_thud_vec2),
    FIELD(thud_rule, FLOAT, 1, friction, friction, NULL),
    FIELD(thud_rule, FLOAT, 1, restitution, restitution, NULL),
    FIELD(thud_rule, FLOAT, 1, surface_speed, surface_speed, NULL),
    FIELD(thud_rule, FLOAT, 1, event_impulse, event_impulse, NULL),
};
static const td_codec CODEC_thud_rule = CODEC(thud_rule, FIELDS_thud_rule);
static const td_codec_field FIELDS_thud_texture[] = {
    FIELD(thud_texture, ARRAY, 1, vertices, count, &CODEC_double),
    FIELD(thud_texture, INT32, 1, count, count, NULL),
    FIELD(thud_texture, ARRAY, 1, table, table_count, &CODEC_float),
    FIELD(thud_texture, INT32, 1, table_count, table_count, NULL),
    FIELD(thud_texture, BOOL, 1, repeats, repeats, NULL),
};
static const td_codec CODEC_thud_texture = CODEC(thud_texture, FIELDS_thud_texture);
static const td_codec_field FIELDS_thud_ray[] = {
    FIELD(thud_ray, STRUCT, 1, origin, origin, &CODEC_thud_pos),
    FIELD(thud_ray, DOUBLE, 1, dx, dx, NULL),
    FIELD(thud_ray, DOUBLE, 1, dy, dy, NULL),
    FIELD(thud_ray, POINTER, 1, filter, filter, &CODEC_thud_query_filter),
};
static const td_codec CODEC_thud_ray = CODEC(thud_ray, FIELDS_thud_ray);
static const td_codec_field FIELDS_thud_shape_cast[] = {
    FIELD(thud_shape_cast, STRUCT, 1, center, center, &CODEC_thud_pos),
    FIELD(thud_shape_cast, STRUCT, 1, shape, shape, &CODEC_thud_geometry),
    FIELD(thud_shape_cast, DOUBLE, 1, dx, dx, NULL),
    FIELD(thud_shape_cast, DOUBLE, 1, dy, dy, NULL),
    FIELD(thud_shape_cast, POINTER, 1, filter, filter, &CODEC_thud_query_filter),
};
static const td_codec CODEC_thud_shape_cast = CODEC(thud_shape_cast, FIELDS_thud_shape_cast);
static const td_codec_field FIELDS_thud_ray_hit[] = {
    FIELD(thud_ray_hit, HANDLE, 1, shape, shape, NULL),
    FIELD(thud_ray_hit, STRUCT, 1, point, point, &CODEC_thud_pos),
    FIELD(thud_ray_hit, STRUCT, 1, normal, normal, &CODEC_thud_vec2),
    FIELD(thud_ray_hit, DOUBLE, 1, fraction, fraction, NULL),
    FIELD(thud_ray_hit, DOUBLE, 1, depth, depth, NULL),
};
static const td_codec CODEC_thud_ray_hit = CODEC(thud_ray_hit, FIELDS_thud_ray_hit);
static const td_codec_field ARGUMENTS_thud_shape_set_heights[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_ARRAY, 1, 2, 3, &CODEC_double}, {TD_CODE_INT32, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_dig[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_pos}, {TD_CODE_DOUBLE, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_raise[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_DOUBLE, 1, 1, 0, NULL}, {TD_CODE_DOUBLE, 1, 2, 0, NULL}, {TD_CODE_DOUBLE, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_replace_range[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_DOUBLE, 1, 1, 0, NULL}, {TD_CODE_DOUBLE, 1, 2, 0, NULL}, {TD_CODE_ARRAY, 1, 3, 4, &CODEC_thud_pos}, {TD_CODE_INT32, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_advance[] = {{TD_CODE_DOUBLE, 1, 0, 0, NULL}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_OUT, 1, 2, 0, NULL}, {TD_CODE_OUT, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_advance_with[] = {{TD_CODE_DOUBLE, 1, 0, 0, NULL}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_STEP_CALLS, 1, 2, 0, NULL}, {TD_CODE_OUT, 1, 3, 0, NULL}, {TD_CODE_OUT, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_set_gravity[] = {{TD_CODE_STRUCT, 1, 0, 0, &CODEC_thud_vec2}};
static const td_codec_field ARGUMENTS_thud_world_set_time_step[] = {{TD_CODE_DOUBLE, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_set_max_error[] = {{TD_CODE_DOUBLE, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_set_quality[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_quality}};
static const td_codec_field ARGUMENTS_thud_world_set_sleeping[] = {{TD_CODE_BOOL, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_create[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_body_def}, {TD_CODE_OUT_HANDLE, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_destroy[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_transform[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_pos}, {TD_CODE_DOUBLE, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_velocity[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}, {TD_CODE_FLOAT, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_apply_impulse[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_pos}};
static const td_codec_field ARGUMENTS_thud_body_apply_center_force[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}};
static const td_codec_field ARGUMENTS_thud_body_apply_torque[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_awake[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_enabled[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_user_data[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_UINT64, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_create_circle[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_shape_def}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_vec2}, {TD_CODE_FLOAT, 1, 3, 0, NULL}, {TD_CODE_OUT_HANDLE, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_create_aabb[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_shape_def}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_vec2}, {TD_CODE_STRUCT, 1, 3, 0, &CODEC_thud_vec2}, {TD_CODE_OUT_HANDLE, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_create_obb[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_shape_def}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_vec2}, {TD_CODE_STRUCT, 1, 3, 0, &CODEC_thud_vec2}, {TD_CODE_DOUBLE, 1, 4, 0, NULL}, {TD_CODE_OUT_HANDLE, 1, 5, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_create_terrain[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_shape_def}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_terrain}, {TD_CODE_OUT_HANDLE, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_destroy[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_create_with_shapes[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_body_def}, {TD_CODE_ARRAY, 1, 1, 2, &CODEC_thud_body_shape}, {TD_CODE_INT32, 1, 2, 0, NULL}, {TD_CODE_OUT_HANDLE, 1, 3, 0, NULL}, {TD_CODE_OUT_HANDLES, 1, 4, 2, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_filter[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_filter}};
static const td_codec_field ARGUMENTS_thud_shape_set_friction[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_restitution[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_surface_speed[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_density[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_sensor[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_radius[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_half_extents[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}};
static const td_codec_field ARGUMENTS_thud_shape_set_events[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_user_data[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_UINT64, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_kind[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_INT32, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_damping[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}, {TD_CODE_FLOAT, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_gravity_scale[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_fixed_rotation[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_detection[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_DETECTION, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_may_sleep[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_mass[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_mass}};
static const td_codec_field ARGUMENTS_thud_body_apply_force[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_pos}};
static const td_codec_field ARGUMENTS_thud_body_apply_center_impulse[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}};
static const td_codec_field ARGUMENTS_thud_body_apply_angular_impulse[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_set_target[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_pos}, {TD_CODE_DOUBLE, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_explode[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_explosion}, {TD_CODE_OUT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_apply_wind[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}, {TD_CODE_FLOAT, 1, 2, 0, NULL}, {TD_CODE_FLOAT, 1, 3, 0, NULL}, {TD_CODE_FLOAT, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_apply_buoyancy[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_water}};
static const td_codec_field ARGUMENTS_thud_body_apply_rolling_resistance[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_apply_grip[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_vec2}, {TD_CODE_FLOAT, 1, 3, 0, NULL}, {TD_CODE_FLOAT, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_create[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_joint_def}, {TD_CODE_OUT_HANDLE, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_destroy[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_set_drive[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_drive}};
static const td_codec_field ARGUMENTS_thud_joint_set_length[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_set_enabled[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_set_frame[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_STRUCT, 1, 2, 0, &CODEC_thud_joint_frame}};
static const td_codec_field ARGUMENTS_thud_joint_set_breaking[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_FLOAT, 1, 1, 0, NULL}, {TD_CODE_FLOAT, 1, 2, 0, NULL}, {TD_CODE_BOOL, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_set_user_data[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_UINT64, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_joint_make[] = {{TD_CODE_STRUCT, 1, 0, 0, &CODEC_thud_joint_def}, {TD_CODE_OUT_HANDLE, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_set_listeners[] = {{TD_CODE_LISTENERS, 1, 0, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_contact_decide[] = {{TD_CODE_CONTACT, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_velocities}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_velocities}};
static const td_codec_field ARGUMENTS_thud_body_set_locks[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_BOOL, 1, 1, 0, NULL}, {TD_CODE_BOOL, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_body_make[] = {{TD_CODE_STRUCT, 1, 0, 0, &CODEC_thud_geometry}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_body_options}, {TD_CODE_OUT_HANDLE, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_mover_move[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_mover}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_vec2}, {TD_CODE_DOUBLE, 1, 2, 0, NULL}, {TD_CODE_OUT, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_set_rule[] = {{TD_CODE_UINT32, 1, 0, 0, NULL}, {TD_CODE_UINT32, 1, 1, 0, NULL}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_rule}};
static const td_codec_field ARGUMENTS_thud_world_set_filter[] = {{TD_CODE_FILTER, 1, 0, 0, NULL}, {TD_CODE_NOTHING, 1, 1, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_shape_set_texture[] = {{TD_CODE_HANDLE, 1, 0, 0, NULL}, {TD_CODE_POINTER, 1, 1, 0, &CODEC_thud_texture}};
static const td_codec_field ARGUMENTS_thud_world_cast_ray[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_ray}, {TD_CODE_OUT, 1, 1, 0, NULL}, {TD_CODE_OUT, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_ray_all[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_ray}, {TD_CODE_OUT, 1, 1, 0, NULL}, {TD_CODE_INT32, 1, 2, 0, NULL}, {TD_CODE_OUT, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_shape[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_shape_cast}, {TD_CODE_OUT, 1, 1, 0, NULL}, {TD_CODE_OUT, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_shape_all[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_shape_cast}, {TD_CODE_OUT, 1, 1, 0, NULL}, {TD_CODE_INT32, 1, 2, 0, NULL}, {TD_CODE_OUT, 1, 3, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_overlap_shape[] = {{TD_CODE_STRUCT, 1, 0, 0, &CODEC_thud_pos}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_geometry}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_query_filter}, {TD_CODE_NOTHING, 1, 3, 0, NULL}, {TD_CODE_NOTHING, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_overlap_aabb[] = {{TD_CODE_STRUCT, 1, 0, 0, &CODEC_thud_pos}, {TD_CODE_STRUCT, 1, 1, 0, &CODEC_thud_pos}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_query_filter}, {TD_CODE_NOTHING, 1, 3, 0, NULL}, {TD_CODE_NOTHING, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_closest[] = {{TD_CODE_STRUCT, 1, 0, 0, &CODEC_thud_pos}, {TD_CODE_DOUBLE, 1, 1, 0, NULL}, {TD_CODE_POINTER, 1, 2, 0, &CODEC_thud_query_filter}, {TD_CODE_OUT, 1, 3, 0, NULL}, {TD_CODE_OUT, 1, 4, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_ray_each[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_ray}, {TD_CODE_NOTHING, 1, 1, 0, NULL}, {TD_CODE_NOTHING, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_shape_each[] = {{TD_CODE_POINTER, 1, 0, 0, &CODEC_thud_shape_cast}, {TD_CODE_NOTHING, 1, 1, 0, NULL}, {TD_CODE_NOTHING, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_rays[] = {{TD_CODE_ARRAY, 1, 0, 1, &CODEC_thud_ray}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_OUT, 1, 2, 0, NULL}};
static const td_codec_field ARGUMENTS_thud_world_cast_shapes[] = {{TD_CODE_ARRAY, 1, 0, 1, &CODEC_thud_shape_cast}, {TD_CODE_INT32, 1, 1, 0, NULL}, {TD_CODE_OUT, 1, 2, 0, NULL}};
const td_recorded_call td_recorded_calls[TD_CALL_COUNT] = {
    [TD_CALL_SHAPE_SET_HEIGHTS] = {"thud_shape_set_heights", ARGUMENTS_thud_shape_set_heights, 4, false},
    [TD_CALL_SHAPE_DIG] = {"thud_shape_dig", ARGUMENTS_thud_shape_dig, 3, false},
    [TD_CALL_SHAPE_RAISE] = {"thud_shape_raise", ARGUMENTS_thud_shape_raise, 4, false},
    [TD_CALL_SHAPE_REPLACE_RANGE] = {"thud_shape_replace_range", ARGUMENTS_thud_shape_replace_range, 5, false},
    [TD_CALL_WORLD_STEP] = {"thud_world_step", NULL, 0, false},
    [TD_CALL_WORLD_ADVANCE] = {"thud_world_advance", ARGUMENTS_thud_world_advance, 4, false},
    [TD_CALL_WORLD_ADVANCE_WITH] = {"thud_world_advance_with", ARGUMENTS_thud_world_advance_with, 5, false},
    [TD_CALL_WORLD_SET_GRAVITY] = {"thud_world_set_gravity", ARGUMENTS_thud_world_set_gravity, 1, false},
    [TD_CALL_WORLD_SET_TIME_STEP] = {"thud_world_set_time_step", ARGUMENTS_thud_world_set_time_step, 1, false},
    [TD_CALL_WORLD_SET_MAX_ERROR] = {"thud_world_set_max_error", ARGUMENTS_thud_world_set_max_error, 1, false},
    [TD_CALL_WORLD_SET_QUALITY] = {"thud_world_set_quality", ARGUMENTS_thud_world_set_quality, 1, false},
    [TD_CALL_WORLD_SET_SLEEPING] = {"thud_world_set_sleeping", ARGUMENTS_thud_world_set_sleeping, 1, false},
    [TD_CALL_BODY_CREATE] = {"thud_body_create", ARGUMENTS_thud_body_create, 2, false},
    [TD_CALL_BODY_DESTROY] = {"thud_body_destroy", ARGUMENTS_thud_body_destroy, 1, false},
    [TD_CALL_BODY_SET_TRANSFORM] = {"thud_body_set_transform", ARGUMENTS_thud_body_set_transform, 3, false},
    [TD_CALL_BODY_SET_VELOCITY] = {"thud_body_set_velocity", ARGUMENTS_thud_body_set_velocity, 3, false},
    [TD_CALL_BODY_APPLY_IMPULSE] = {"thud_body_apply_impulse", ARGUMENTS_thud_body_apply_impulse, 3, false},
    [TD_CALL_BODY_APPLY_CENTER_FORCE] = {"thud_body_apply_center_force", ARGUMENTS_thud_body_apply_center_force, 2, false},
    [TD_CALL_BODY_APPLY_TORQUE] = {"thud_body_apply_torque", ARGUMENTS_thud_body_apply_torque, 2, false},
    [TD_CALL_BODY_SET_AWAKE] = {"thud_body_set_awake", ARGUMENTS_thud_body_set_awake, 2, false},
    [TD_CALL_BODY_SET_ENABLED] = {"thud_body_set_enabled", ARGUMENTS_thud_body_set_enabled, 2, false},
    [TD_CALL_BODY_SET_USER_DATA] = {"thud_body_set_user_data", ARGUMENTS_thud_body_set_user_data, 2, false},
    [TD_CALL_SHAPE_CREATE_CIRCLE] = {"thud_shape_create_circle", ARGUMENTS_thud_shape_create_circle, 5, false},
    [TD_CALL_SHAPE_CREATE_AABB] = {"thud_shape_create_aabb", ARGUMENTS_thud_shape_create_aabb, 5, false},
    [TD_CALL_SHAPE_CREATE_OBB] = {"thud_shape_create_obb", ARGUMENTS_thud_shape_create_obb, 6, false},
    [TD_CALL_SHAPE_CREATE_TERRAIN] = {"thud_shape_create_terrain", ARGUMENTS_thud_shape_create_terrain, 4, false},
    [TD_CALL_SHAPE_DESTROY] = {"thud_shape_destroy", ARGUMENTS_thud_shape_destroy, 1, false},
    [TD_CALL_BODY_CREATE_WITH_SHAPES] = {"thud_body_create_with_shapes", ARGUMENTS_thud_body_create_with_shapes, 5, false},
    [TD_CALL_SHAPE_SET_FILTER] = {"thud_shape_set_filter", ARGUMENTS_thud_shape_set_filter, 2, false},
    [TD_CALL_SHAPE_SET_FRICTION] = {"thud_shape_set_friction", ARGUMENTS_thud_shape_set_friction, 2, false},
    [TD_CALL_SHAPE_SET_RESTITUTION] = {"thud_shape_set_restitution", ARGUMENTS_thud_shape_set_restitution, 2, false},
    [TD_CALL_SHAPE_SET_SURFACE_SPEED] = {"thud_shape_set_surface_speed", ARGUMENTS_thud_shape_set_surface_speed, 2, false},
    [TD_CALL_SHAPE_SET_DENSITY] = {"thud_shape_set_density", ARGUMENTS_thud_shape_set_density, 2, false},
    [TD_CALL_SHAPE_SET_SENSOR] = {"thud_shape_set_sensor", ARGUMENTS_thud_shape_set_sensor, 2, false},
    [TD_CALL_SHAPE_SET_RADIUS] = {"thud_shape_set_radius", ARGUMENTS_thud_shape_set_radius, 2, false},
    [TD_CALL_SHAPE_SET_HALF_EXTENTS] = {"thud_shape_set_half_extents", ARGUMENTS_thud_shape_set_half_extents, 2, false},
    [TD_CALL_SHAPE_SET_EVENTS] = {"thud_shape_set_events", ARGUMENTS_thud_shape_set_events, 2, false},
    [TD_CALL_SHAPE_SET_USER_DATA] = {"thud_shape_set_user_data", ARGUMENTS_thud_shape_set_user_data, 2, false},
    [TD_CALL_BODY_SET_KIND] = {"thud_body_set_kind", ARGUMENTS_thud_body_set_kind, 2, false},
    [TD_CALL_BODY_SET_DAMPING] = {"thud_body_set_damping", ARGUMENTS_thud_body_set_damping, 3, false},
    [TD_CALL_BODY_SET_GRAVITY_SCALE] = {"thud_body_set_gravity_scale", ARGUMENTS_thud_body_set_gravity_scale, 2, false},
    [TD_CALL_BODY_SET_FIXED_ROTATION] = {"thud_body_set_fixed_rotation", ARGUMENTS_thud_body_set_fixed_rotation, 2, false},
    [TD_CALL_BODY_SET_DETECTION] = {"thud_body_set_detection", ARGUMENTS_thud_body_set_detection, 2, false},
    [TD_CALL_BODY_SET_MAY_SLEEP] = {"thud_body_set_may_sleep", ARGUMENTS_thud_body_set_may_sleep, 2, false},
    [TD_CALL_BODY_SET_MASS] = {"thud_body_set_mass", ARGUMENTS_thud_body_set_mass, 2, false},
    [TD_CALL_BODY_APPLY_FORCE] = {"thud_body_apply_force", ARGUMENTS_thud_body_apply_force, 3, false},
    [TD_CALL_BODY_APPLY_CENTER_IMPULSE] = {"thud_body_apply_center_impulse", ARGUMENTS_thud_body_apply_center_impulse, 2, false},
    [TD_CALL_BODY_APPLY_ANGULAR_IMPULSE] = {"thud_body_apply_angular_impulse", ARGUMENTS_thud_body_apply_angular_impulse, 2, false},
    [TD_CALL_BODY_SET_TARGET] = {"thud_body_set_target", ARGUMENTS_thud_body_set_target, 3, false},
    [TD_CALL_WORLD_EXPLODE] = {"thud_world_explode", ARGUMENTS_thud_world_explode, 2, false},
    [TD_CALL_BODY_APPLY_WIND] = {"thud_body_apply_wind", ARGUMENTS_thud_body_apply_wind, 5, false},
    [TD_CALL_BODY_APPLY_BUOYANCY] = {"thud_body_apply_buoyancy", ARGUMENTS_thud_body_apply_buoyancy, 2, false},
    [TD_CALL_BODY_APPLY_ROLLING_RESISTANCE] = {"thud_body_apply_rolling_resistance", ARGUMENTS_thud_body_apply_rolling_resistance, 2, false},
    [TD_CALL_BODY_APPLY_GRIP] = {"thud_body_apply_grip", ARGUMENTS_thud_body_apply_grip, 5, false},
    [TD_CALL_JOINT_CREATE] = {"thud_joint_create", ARGUMENTS_thud_joint_create, 2, false},
    [TD_CALL_JOINT_DESTROY] = {"thud_joint_destroy", ARGUMENTS_thud_joint_destroy, 1, false},
    [TD_CALL_JOINT_SET_DRIVE] = {"thud_joint_set_drive", ARGUMENTS_thud_joint_set_drive, 3, false},
    [TD_CALL_JOINT_SET_LENGTH] = {"thud_joint_set_length", ARGUMENTS_thud_joint_set_length, 2, false},
    [TD_CALL_JOINT_SET_ENABLED] = {"thud_joint_set_enabled", ARGUMENTS_thud_joint_set_enabled, 2, false},
    [TD_CALL_JOINT_SET_FRAME] = {"thud_joint_set_frame", ARGUMENTS_thud_joint_set_frame, 3, false},
    [TD_CALL_JOINT_SET_BREAKING] = {"thud_joint_set_breaking", ARGUMENTS_thud_joint_set_breaking, 4, false},
    [TD_CALL_JOINT_SET_USER_DATA] = {"thud_joint_set_user_data", ARGUMENTS_thud_joint_set_user_data, 2, false},
    [TD_CALL_WORLD_USE_JOINTS] = {"thud_world_use_joints", NULL, 0, false},
    [TD_CALL_JOINT_MAKE] = {"thud_joint_make", ARGUMENTS_thud_joint_make, 2, false},
    [TD_CALL_WORLD_SET_LISTENERS] = {"thud_world_set_listeners", ARGUMENTS_thud_world_set_listeners, 1, false},
    [TD_CALL_CONTACT_DECIDE] = {"thud_contact_decide", ARGUMENTS_thud_contact_decide, 3, false},
    [TD_CALL_BODY_SET_LOCKS] = {"thud_body_set_locks", ARGUMENTS_thud_body_set_locks, 3, false},
    [TD_CALL_BODY_MAKE] = {"thud_body_make", ARGUMENTS_thud_body_make, 3, false},
    [TD_CALL_MOVER_MOVE] = {"thud_mover_move", ARGUMENTS_thud_mover_move, 4, false},
    [TD_CALL_WORLD_SET_RULE] = {"thud_world_set_rule", ARGUMENTS_thud_world_set_rule, 3, false},
    [TD_CALL_WORLD_USE_RULES] = {"thud_world_use_rules", NULL, 0, false},
    [TD_CALL_WORLD_SET_FILTER] = {"thud_world_set_filter", ARGUMENTS_thud_world_set_filter, 2, false},
    [TD_CALL_SHAPE_SET_TEXTURE] = {"thud_shape_set_texture", ARGUMENTS_thud_shape_set_texture, 2, false},
    [TD_CALL_WORLD_USE_TEXTURES] = {"thud_world_use_textures", NULL, 0, false},
    [TD_CALL_WORLD_USE_STEP_ERROR] = {"thud_world_use_step_error", NULL, 0, false},
    [TD_CALL_WORLD_CAST_RAY] = {"thud_world_cast_ray", ARGUMENTS_thud_world_cast_ray, 3, true},
    [TD_CALL_WORLD_CAST_RAY_ALL] = {"thud_world_cast_ray_all", ARGUMENTS_thud_world_cast_ray_all, 4, true},
    [TD_CALL_WORLD_CAST_SHAPE] = {"thud_world_cast_shape", ARGUMENTS_thud_world_cast_shape, 3, true},
    [TD_CALL_WORLD_CAST_SHAPE_ALL] = {"thud_world_cast_shape_all", ARGUMENTS_thud_world_cast_shape_all, 4, true},
    [TD_CALL_WORLD_OVERLAP_SHAPE] = {"thud_world_overlap_shape", ARGUMENTS_thud_world_overlap_shape, 5, true},
    [TD_CALL_WORLD_OVERLAP_AABB] = {"thud_world_overlap_aabb", ARGUMENTS_thud_world_overlap_aabb, 5, true},
    [TD_CALL_WORLD_CLOSEST] = {"thud_world_closest", ARGUMENTS_thud_world_closest, 5, true},
    [TD_CALL_WORLD_CAST_RAY_EACH] = {"thud_world_cast_ray_each", ARGUMENTS_thud_world_cast_ray_each, 3, true},
    [TD_CALL_WORLD_CAST_SHAPE_EACH] = {"thud_world_cast_shape_each", ARGUMENTS_thud_world_cast_shape_each, 3, true},
    [TD_CALL_WORLD_CAST_RAYS] = {"thud_world_cast_rays", ARGUMENTS_thud_world_cast_rays, 3, true},
    [TD_CALL_WORLD_CAST_SHAPES] = {"thud_world_cast_shapes", ARGUMENTS_thud_world_cast_shapes, 3, true},
};
static const td_codec_field HITS[] = {
    {TD_CODE_INT32, 1, 0, 0, NULL}, {TD_CODE_ARRAY, 1, 1, 0, &CODEC_thud_ray_hit}};
const td_recorded_call td_recorded_hits = {"", HITS, 2, false};
/* clang-format on */
