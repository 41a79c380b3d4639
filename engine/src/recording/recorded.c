/* recorded.c: the functions of thud_recorded.h: each makes its call within a frame
 * (recorder.h). Those that need more are in recorded_by_hand.c, queries in recorded_queries.c. */
/* Made by tools/recorded.py of the public headers: do not edit. */
#include "recording/recorder.h"

#include "thud/thud_all.h"

/* clang-format off */

THUD_API thud_result thud_recorded_shape_set_heights(thud_world *world, thud_shape_id shape, int first, const double *heights, int count) {
    const void *const args[] = {&shape, &first, &heights, &count};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_HEIGHTS, args);
    return td_record_close(&own, thud_shape_set_heights(world, shape, first, heights, count));
}

THUD_API thud_result thud_recorded_shape_dig(thud_world *world, thud_shape_id shape, thud_pos center, double radius) {
    const void *const args[] = {&shape, &center, &radius};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_DIG, args);
    return td_record_close(&own, thud_shape_dig(world, shape, center, radius));
}

THUD_API thud_result thud_recorded_shape_raise(thud_world *world, thud_shape_id shape, double x, double radius, double height) {
    const void *const args[] = {&shape, &x, &radius, &height};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_RAISE, args);
    return td_record_close(&own, thud_shape_raise(world, shape, x, radius, height));
}

THUD_API thud_result thud_recorded_shape_replace_range(thud_world *world, thud_shape_id shape, double x0, double x1, const thud_pos *points, int count) {
    const void *const args[] = {&shape, &x0, &x1, &points, &count};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_REPLACE_RANGE, args);
    return td_record_close(&own, thud_shape_replace_range(world, shape, x0, x1, points, count));
}

THUD_API thud_result thud_recorded_world_step(thud_world *world) {
    const void *const args[] = {NULL};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_STEP, args);
    return td_record_close(&own, thud_world_step(world));
}

THUD_API thud_result thud_recorded_world_advance(thud_world *world, double elapsed, int max_steps, int *out_steps, double *out_alpha) {
    const void *const args[] = {&elapsed, &max_steps, &out_steps, &out_alpha};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_ADVANCE, args);
    return td_record_close(&own, thud_world_advance(world, elapsed, max_steps, out_steps, out_alpha));
}

THUD_API thud_result thud_recorded_world_set_gravity(thud_world *world, thud_vec2 gravity) {
    const void *const args[] = {&gravity};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_GRAVITY, args);
    return td_record_close(&own, thud_world_set_gravity(world, gravity));
}

THUD_API thud_result thud_recorded_world_set_time_step(thud_world *world, double time_step) {
    const void *const args[] = {&time_step};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_TIME_STEP, args);
    return td_record_close(&own, thud_world_set_time_step(world, time_step));
}

THUD_API thud_result thud_recorded_world_set_max_error(thud_world *world, double max_error) {
    const void *const args[] = {&max_error};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_MAX_ERROR, args);
    return td_record_close(&own, thud_world_set_max_error(world, max_error));
}

THUD_API thud_result thud_recorded_world_set_quality(thud_world *world, const thud_quality *quality) {
    const void *const args[] = {&quality};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_QUALITY, args);
    return td_record_close(&own, thud_world_set_quality(world, quality));
}

THUD_API thud_result thud_recorded_world_set_sleeping(thud_world *world, bool sleeping) {
    const void *const args[] = {&sleeping};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_SLEEPING, args);
    return td_record_close(&own, thud_world_set_sleeping(world, sleeping));
}

THUD_API thud_result thud_recorded_body_create(thud_world *world, const thud_body_def *def, thud_body_id *out) {
    const void *const args[] = {&def, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_CREATE, args);
    return td_record_close(&own, thud_body_create(world, def, out));
}

THUD_API thud_result thud_recorded_body_destroy(thud_world *world, thud_body_id body) {
    const void *const args[] = {&body};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_DESTROY, args);
    return td_record_close(&own, thud_body_destroy(world, body));
}

THUD_API thud_result thud_recorded_body_set_transform(thud_world *world, thud_body_id body, thud_pos position, double angle) {
    const void *const args[] = {&body, &position, &angle};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_TRANSFORM, args);
    return td_record_close(&own, thud_body_set_transform(world, body, position, angle));
}

THUD_API thud_result thud_recorded_body_set_velocity(thud_world *world, thud_body_id body, thud_vec2 velocity, float angular_velocity) {
    const void *const args[] = {&body, &velocity, &angular_velocity};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_VELOCITY, args);
    return td_record_close(&own, thud_body_set_velocity(world, body, velocity, angular_velocity));
}

THUD_API thud_result thud_recorded_body_apply_impulse(thud_world *world, thud_body_id body, thud_vec2 impulse, thud_pos point) {
    const void *const args[] = {&body, &impulse, &point};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_IMPULSE, args);
    return td_record_close(&own, thud_body_apply_impulse(world, body, impulse, point));
}

THUD_API thud_result thud_recorded_body_apply_center_force(thud_world *world, thud_body_id body, thud_vec2 force) {
    const void *const args[] = {&body, &force};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_CENTER_FORCE, args);
    return td_record_close(&own, thud_body_apply_center_force(world, body, force));
}

THUD_API thud_result thud_recorded_body_apply_torque(thud_world *world, thud_body_id body, float torque) {
    const void *const args[] = {&body, &torque};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_TORQUE, args);
    return td_record_close(&own, thud_body_apply_torque(world, body, torque));
}

THUD_API thud_result thud_recorded_body_set_awake(thud_world *world, thud_body_id body, bool awake) {
    const void *const args[] = {&body, &awake};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_AWAKE, args);
    return td_record_close(&own, thud_body_set_awake(world, body, awake));
}

THUD_API thud_result thud_recorded_body_set_enabled(thud_world *world, thud_body_id body, bool enabled) {
    const void *const args[] = {&body, &enabled};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_ENABLED, args);
    return td_record_close(&own, thud_body_set_enabled(world, body, enabled));
}

THUD_API thud_result thud_recorded_body_set_user_data(thud_world *world, thud_body_id body, uint64_t user_data) {
    const void *const args[] = {&body, &user_data};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_USER_DATA, args);
    return td_record_close(&own, thud_body_set_user_data(world, body, user_data));
}

THUD_API thud_result thud_recorded_shape_create_circle(thud_world *world, thud_body_id body, const thud_shape_def *def, thud_vec2 offset, float radius, thud_shape_id *out) {
    const void *const args[] = {&body, &def, &offset, &radius, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_CREATE_CIRCLE, args);
    return td_record_close(&own, thud_shape_create_circle(world, body, def, offset, radius, out));
}

THUD_API thud_result thud_recorded_shape_create_aabb(thud_world *world, thud_body_id body, const thud_shape_def *def, thud_vec2 offset, thud_vec2 half_extents, thud_shape_id *out) {
    const void *const args[] = {&body, &def, &offset, &half_extents, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_CREATE_AABB, args);
    return td_record_close(&own, thud_shape_create_aabb(world, body, def, offset, half_extents, out));
}

THUD_API thud_result thud_recorded_shape_create_obb(thud_world *world, thud_body_id body, const thud_shape_def *def, thud_vec2 offset, thud_vec2 half_extents, double angle, thud_shape_id *out) {
    const void *const args[] = {&body, &def, &offset, &half_extents, &angle, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_CREATE_OBB, args);
    return td_record_close(&own, thud_shape_create_obb(world, body, def, offset, half_extents, angle, out));
}

THUD_API thud_result thud_recorded_shape_create_terrain(thud_world *world, thud_body_id body, const thud_shape_def *def, const thud_terrain *terrain, thud_shape_id *out) {
    const void *const args[] = {&body, &def, &terrain, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_CREATE_TERRAIN, args);
    return td_record_close(&own, thud_shape_create_terrain(world, body, def, terrain, out));
}

THUD_API thud_result thud_recorded_shape_destroy(thud_world *world, thud_shape_id shape) {
    const void *const args[] = {&shape};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_DESTROY, args);
    return td_record_close(&own, thud_shape_destroy(world, shape));
}

THUD_API thud_result thud_recorded_body_create_with_shapes(thud_world *world, const thud_body_def *def, const thud_body_shape *shapes, int count, thud_body_id *out_body, thud_shape_id *out_shape_ids) {
    const void *const args[] = {&def, &shapes, &count, &out_body, &out_shape_ids};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_CREATE_WITH_SHAPES, args);
    return td_record_close(&own, thud_body_create_with_shapes(world, def, shapes, count, out_body, out_shape_ids));
}

THUD_API thud_result thud_recorded_shape_set_filter(thud_world *world, thud_shape_id shape, thud_filter filter) {
    const void *const args[] = {&shape, &filter};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_FILTER, args);
    return td_record_close(&own, thud_shape_set_filter(world, shape, filter));
}

THUD_API thud_result thud_recorded_shape_set_friction(thud_world *world, thud_shape_id shape, float friction) {
    const void *const args[] = {&shape, &friction};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_FRICTION, args);
    return td_record_close(&own, thud_shape_set_friction(world, shape, friction));
}

THUD_API thud_result thud_recorded_shape_set_restitution(thud_world *world, thud_shape_id shape, float restitution) {
    const void *const args[] = {&shape, &restitution};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_RESTITUTION, args);
    return td_record_close(&own, thud_shape_set_restitution(world, shape, restitution));
}

THUD_API thud_result thud_recorded_shape_set_surface_speed(thud_world *world, thud_shape_id shape, float surface_speed) {
    const void *const args[] = {&shape, &surface_speed};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_SURFACE_SPEED, args);
    return td_record_close(&own, thud_shape_set_surface_speed(world, shape, surface_speed));
}

THUD_API thud_result thud_recorded_shape_set_density(thud_world *world, thud_shape_id shape, float density) {
    const void *const args[] = {&shape, &density};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_DENSITY, args);
    return td_record_close(&own, thud_shape_set_density(world, shape, density));
}

THUD_API thud_result thud_recorded_shape_set_sensor(thud_world *world, thud_shape_id shape, bool sensor) {
    const void *const args[] = {&shape, &sensor};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_SENSOR, args);
    return td_record_close(&own, thud_shape_set_sensor(world, shape, sensor));
}

THUD_API thud_result thud_recorded_shape_set_radius(thud_world *world, thud_shape_id shape, float radius) {
    const void *const args[] = {&shape, &radius};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_RADIUS, args);
    return td_record_close(&own, thud_shape_set_radius(world, shape, radius));
}

THUD_API thud_result thud_recorded_shape_set_half_extents(thud_world *world, thud_shape_id shape, thud_vec2 half_extents) {
    const void *const args[] = {&shape, &half_extents};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_HALF_EXTENTS, args);
    return td_record_close(&own, thud_shape_set_half_extents(world, shape, half_extents));
}

THUD_API thud_result thud_recorded_shape_set_events(thud_world *world, thud_shape_id shape, bool events) {
    const void *const args[] = {&shape, &events};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_EVENTS, args);
    return td_record_close(&own, thud_shape_set_events(world, shape, events));
}

THUD_API thud_result thud_recorded_shape_set_user_data(thud_world *world, thud_shape_id shape, uint64_t user_data) {
    const void *const args[] = {&shape, &user_data};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_USER_DATA, args);
    return td_record_close(&own, thud_shape_set_user_data(world, shape, user_data));
}

THUD_API thud_result thud_recorded_body_set_kind(thud_world *world, thud_body_id body, thud_body_kind kind) {
    const void *const args[] = {&body, &kind};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_KIND, args);
    return td_record_close(&own, thud_body_set_kind(world, body, kind));
}

THUD_API thud_result thud_recorded_body_set_damping(thud_world *world, thud_body_id body, float linear, float angular) {
    const void *const args[] = {&body, &linear, &angular};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_DAMPING, args);
    return td_record_close(&own, thud_body_set_damping(world, body, linear, angular));
}

THUD_API thud_result thud_recorded_body_set_gravity_scale(thud_world *world, thud_body_id body, float gravity_scale) {
    const void *const args[] = {&body, &gravity_scale};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_GRAVITY_SCALE, args);
    return td_record_close(&own, thud_body_set_gravity_scale(world, body, gravity_scale));
}

THUD_API thud_result thud_recorded_body_set_fixed_rotation(thud_world *world, thud_body_id body, bool fixed) {
    const void *const args[] = {&body, &fixed};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_FIXED_ROTATION, args);
    return td_record_close(&own, thud_body_set_fixed_rotation(world, body, fixed));
}

THUD_API thud_result thud_recorded_body_set_detection(thud_world *world, thud_body_id body, const thud_detection *detection) {
    const void *const args[] = {&body, &detection};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_DETECTION, args);
    return td_record_close(&own, thud_body_set_detection(world, body, detection));
}

THUD_API thud_result thud_recorded_body_set_may_sleep(thud_world *world, thud_body_id body, bool may_sleep) {
    const void *const args[] = {&body, &may_sleep};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_MAY_SLEEP, args);
    return td_record_close(&own, thud_body_set_may_sleep(world, body, may_sleep));
}

THUD_API thud_result thud_recorded_body_set_mass(thud_world *world, thud_body_id body, const thud_mass *mass) {
    const void *const args[] = {&body, &mass};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_MASS, args);
    return td_record_close(&own, thud_body_set_mass(world, body, mass));
}

THUD_API thud_result thud_recorded_body_apply_force(thud_world *world, thud_body_id body, thud_vec2 force, thud_pos point) {
    const void *const args[] = {&body, &force, &point};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_FORCE, args);
    return td_record_close(&own, thud_body_apply_force(world, body, force, point));
}

THUD_API thud_result thud_recorded_body_apply_center_impulse(thud_world *world, thud_body_id body, thud_vec2 impulse) {
    const void *const args[] = {&body, &impulse};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_CENTER_IMPULSE, args);
    return td_record_close(&own, thud_body_apply_center_impulse(world, body, impulse));
}

THUD_API thud_result thud_recorded_body_apply_angular_impulse(thud_world *world, thud_body_id body, float impulse) {
    const void *const args[] = {&body, &impulse};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_ANGULAR_IMPULSE, args);
    return td_record_close(&own, thud_body_apply_angular_impulse(world, body, impulse));
}

THUD_API thud_result thud_recorded_body_set_target(thud_world *world, thud_body_id body, thud_pos position, double angle) {
    const void *const args[] = {&body, &position, &angle};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_TARGET, args);
    return td_record_close(&own, thud_body_set_target(world, body, position, angle));
}

THUD_API thud_result thud_recorded_world_explode(thud_world *world, const thud_explosion *explosion, int *out_pushed) {
    const void *const args[] = {&explosion, &out_pushed};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_EXPLODE, args);
    return td_record_close(&own, thud_world_explode(world, explosion, out_pushed));
}

THUD_API thud_result thud_recorded_body_apply_wind(thud_world *world, thud_body_id body, thud_vec2 wind, float density, float drag, float lift) {
    const void *const args[] = {&body, &wind, &density, &drag, &lift};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_WIND, args);
    return td_record_close(&own, thud_body_apply_wind(world, body, wind, density, drag, lift));
}

THUD_API thud_result thud_recorded_body_apply_buoyancy(thud_world *world, thud_body_id body, const thud_water *water) {
    const void *const args[] = {&body, &water};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_BUOYANCY, args);
    return td_record_close(&own, thud_body_apply_buoyancy(world, body, water));
}

THUD_API thud_result thud_recorded_body_apply_rolling_resistance(thud_world *world, thud_body_id body, float coefficient) {
    const void *const args[] = {&body, &coefficient};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_ROLLING_RESISTANCE, args);
    return td_record_close(&own, thud_body_apply_rolling_resistance(world, body, coefficient));
}

THUD_API thud_result thud_recorded_body_apply_grip(thud_world *world, thud_body_id body, thud_vec2 point, thud_vec2 axis, float speed, float max_force) {
    const void *const args[] = {&body, &point, &axis, &speed, &max_force};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_APPLY_GRIP, args);
    return td_record_close(&own, thud_body_apply_grip(world, body, point, axis, speed, max_force));
}

THUD_API thud_result thud_recorded_joint_create(thud_world *world, const thud_joint_def *def, thud_joint_id *out) {
    const void *const args[] = {&def, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_CREATE, args);
    return td_record_close(&own, thud_joint_create(world, def, out));
}

THUD_API thud_result thud_recorded_joint_destroy(thud_world *world, thud_joint_id joint) {
    const void *const args[] = {&joint};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_DESTROY, args);
    return td_record_close(&own, thud_joint_destroy(world, joint));
}

THUD_API thud_result thud_recorded_joint_set_drive(thud_world *world, thud_joint_id joint, thud_direction direction, const thud_drive *drive) {
    const void *const args[] = {&joint, &direction, &drive};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_SET_DRIVE, args);
    return td_record_close(&own, thud_joint_set_drive(world, joint, direction, drive));
}

THUD_API thud_result thud_recorded_joint_set_length(thud_world *world, thud_joint_id joint, float length) {
    const void *const args[] = {&joint, &length};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_SET_LENGTH, args);
    return td_record_close(&own, thud_joint_set_length(world, joint, length));
}

THUD_API thud_result thud_recorded_joint_set_enabled(thud_world *world, thud_joint_id joint, bool enabled) {
    const void *const args[] = {&joint, &enabled};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_SET_ENABLED, args);
    return td_record_close(&own, thud_joint_set_enabled(world, joint, enabled));
}

THUD_API thud_result thud_recorded_joint_set_frame(thud_world *world, thud_joint_id joint, int side, thud_joint_frame frame) {
    const void *const args[] = {&joint, &side, &frame};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_SET_FRAME, args);
    return td_record_close(&own, thud_joint_set_frame(world, joint, side, frame));
}

THUD_API thud_result thud_recorded_joint_set_breaking(thud_world *world, thud_joint_id joint, float force, float torque, bool only_reports) {
    const void *const args[] = {&joint, &force, &torque, &only_reports};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_SET_BREAKING, args);
    return td_record_close(&own, thud_joint_set_breaking(world, joint, force, torque, only_reports));
}

THUD_API thud_result thud_recorded_joint_set_user_data(thud_world *world, thud_joint_id joint, uint64_t user_data) {
    const void *const args[] = {&joint, &user_data};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_SET_USER_DATA, args);
    return td_record_close(&own, thud_joint_set_user_data(world, joint, user_data));
}

THUD_API thud_result thud_recorded_world_use_joints(thud_world *world) {
    const void *const args[] = {NULL};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_USE_JOINTS, args);
    return td_record_close(&own, thud_world_use_joints(world));
}

THUD_API thud_joint_id thud_recorded_joint_make(thud_world *world, thud_joint_def def) {
    thud_joint_id made, *out = &made;
    const void *const args[] = {&def, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_JOINT_MAKE, args);
    made = thud_joint_make(world, def);
    td_record_close(&own, made.index1 ? THUD_OK : THUD_ERROR_INVALID);
    return made;
}

THUD_API thud_result thud_recorded_world_set_listeners(thud_world *world, const thud_listeners *listeners) {
    const void *const args[] = {&listeners};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_LISTENERS, args);
    return td_record_close(&own, thud_world_set_listeners(world, listeners));
}

THUD_API thud_result thud_recorded_contact_decide(thud_world *world, const thud_contact *contact, const thud_velocities *a, const thud_velocities *b) {
    const void *const args[] = {&contact, &a, &b};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_CONTACT_DECIDE, args);
    return td_record_close(&own, thud_contact_decide(world, contact, a, b));
}

THUD_API thud_result thud_recorded_body_set_locks(thud_world *world, thud_body_id body, bool x, bool y) {
    const void *const args[] = {&body, &x, &y};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_SET_LOCKS, args);
    return td_record_close(&own, thud_body_set_locks(world, body, x, y));
}

THUD_API thud_body_id thud_recorded_body_make(thud_world *world, thud_geometry shape, const thud_body_options *options) {
    thud_body_id made, *out = &made;
    const void *const args[] = {&shape, &options, &out};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_BODY_MAKE, args);
    made = thud_body_make(world, shape, options);
    td_record_close(&own, made.index1 ? THUD_OK : THUD_ERROR_INVALID);
    return made;
}

THUD_API thud_result thud_recorded_world_set_rule(thud_world *world, uint32_t first, uint32_t second, const thud_rule *rule) {
    const void *const args[] = {&first, &second, &rule};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_SET_RULE, args);
    return td_record_close(&own, thud_world_set_rule(world, first, second, rule));
}

THUD_API thud_result thud_recorded_world_use_rules(thud_world *world) {
    const void *const args[] = {NULL};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_USE_RULES, args);
    return td_record_close(&own, thud_world_use_rules(world));
}

THUD_API thud_result thud_recorded_shape_set_texture(thud_world *world, thud_shape_id shape, const thud_texture *texture) {
    const void *const args[] = {&shape, &texture};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_SHAPE_SET_TEXTURE, args);
    return td_record_close(&own, thud_shape_set_texture(world, shape, texture));
}

THUD_API thud_result thud_recorded_world_use_textures(thud_world *world) {
    const void *const args[] = {NULL};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_USE_TEXTURES, args);
    return td_record_close(&own, thud_world_use_textures(world));
}

THUD_API thud_result thud_recorded_world_use_step_error(thud_world *world) {
    const void *const args[] = {NULL};
    td_record_frame own;
    td_record_open(&own, world, TD_CALL_WORLD_USE_STEP_ERROR, args);
    return td_record_close(&own, thud_world_use_step_error(world));
}
/* clang-format on */
