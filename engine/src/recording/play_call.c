/* play_call.c: makes a recorded call. */
/* Made by tools/recorded.py of the public headers: do not edit. */
#include "recording/play_call.h"

#include "recording/recorded_calls.h"
#include "thud/thud_all.h"

/* clang-format off */
#define ARGUMENT(type, i) (*(type const *)d->args[i])
thud_result td_play_call(td_play *p, thud_world *w, int call, td_decoded *d) {
    switch (call) {
    case TD_CALL_SHAPE_SET_HEIGHTS:
        return thud_shape_set_heights(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(int, 1), ARGUMENT(const double *, 2), ARGUMENT(int, 3));
    case TD_CALL_SHAPE_DIG:
        return thud_shape_dig(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(thud_pos, 1), ARGUMENT(double, 2));
    case TD_CALL_SHAPE_RAISE:
        return thud_shape_raise(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(double, 1), ARGUMENT(double, 2), ARGUMENT(double, 3));
    case TD_CALL_SHAPE_REPLACE_RANGE:
        return thud_shape_replace_range(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(double, 1), ARGUMENT(double, 2), ARGUMENT(const thud_pos *, 3), ARGUMENT(int, 4));
    case TD_CALL_WORLD_STEP:
        return thud_world_step(w);
    case TD_CALL_WORLD_ADVANCE:
        return thud_world_advance(w, ARGUMENT(double, 0), ARGUMENT(int, 1), ARGUMENT(int *, 2), ARGUMENT(double *, 3));
    case TD_CALL_WORLD_ADVANCE_WITH:
        return td_play_world_advance_with(p, w, d);
    case TD_CALL_WORLD_SET_GRAVITY:
        return thud_world_set_gravity(w, ARGUMENT(thud_vec2, 0));
    case TD_CALL_WORLD_SET_TIME_STEP:
        return thud_world_set_time_step(w, ARGUMENT(double, 0));
    case TD_CALL_WORLD_SET_MAX_ERROR:
        return thud_world_set_max_error(w, ARGUMENT(double, 0));
    case TD_CALL_WORLD_SET_QUALITY:
        return thud_world_set_quality(w, ARGUMENT(const thud_quality *, 0));
    case TD_CALL_WORLD_SET_SLEEPING:
        return thud_world_set_sleeping(w, ARGUMENT(bool, 0));
    case TD_CALL_BODY_CREATE:
        return thud_body_create(w, ARGUMENT(const thud_body_def *, 0), ARGUMENT(thud_body_id *, 1));
    case TD_CALL_BODY_DESTROY:
        return thud_body_destroy(w, ARGUMENT(thud_body_id, 0));
    case TD_CALL_BODY_SET_TRANSFORM:
        return thud_body_set_transform(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_pos, 1), ARGUMENT(double, 2));
    case TD_CALL_BODY_SET_VELOCITY:
        return thud_body_set_velocity(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1), ARGUMENT(float, 2));
    case TD_CALL_BODY_APPLY_IMPULSE:
        return thud_body_apply_impulse(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1), ARGUMENT(thud_pos, 2));
    case TD_CALL_BODY_APPLY_CENTER_FORCE:
        return thud_body_apply_center_force(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1));
    case TD_CALL_BODY_APPLY_TORQUE:
        return thud_body_apply_torque(w, ARGUMENT(thud_body_id, 0), ARGUMENT(float, 1));
    case TD_CALL_BODY_SET_AWAKE:
        return thud_body_set_awake(w, ARGUMENT(thud_body_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_BODY_SET_ENABLED:
        return thud_body_set_enabled(w, ARGUMENT(thud_body_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_BODY_SET_USER_DATA:
        return thud_body_set_user_data(w, ARGUMENT(thud_body_id, 0), ARGUMENT(uint64_t, 1));
    case TD_CALL_SHAPE_CREATE_CIRCLE:
        return thud_shape_create_circle(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_shape_def *, 1), ARGUMENT(thud_vec2, 2), ARGUMENT(float, 3), ARGUMENT(thud_shape_id *, 4));
    case TD_CALL_SHAPE_CREATE_AABB:
        return thud_shape_create_aabb(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_shape_def *, 1), ARGUMENT(thud_vec2, 2), ARGUMENT(thud_vec2, 3), ARGUMENT(thud_shape_id *, 4));
    case TD_CALL_SHAPE_CREATE_OBB:
        return thud_shape_create_obb(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_shape_def *, 1), ARGUMENT(thud_vec2, 2), ARGUMENT(thud_vec2, 3), ARGUMENT(double, 4), ARGUMENT(thud_shape_id *, 5));
    case TD_CALL_SHAPE_CREATE_TERRAIN:
        return thud_shape_create_terrain(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_shape_def *, 1), ARGUMENT(const thud_terrain *, 2), ARGUMENT(thud_shape_id *, 3));
    case TD_CALL_SHAPE_DESTROY:
        return thud_shape_destroy(w, ARGUMENT(thud_shape_id, 0));
    case TD_CALL_BODY_CREATE_WITH_SHAPES:
        return thud_body_create_with_shapes(w, ARGUMENT(const thud_body_def *, 0), ARGUMENT(const thud_body_shape *, 1), ARGUMENT(int, 2), ARGUMENT(thud_body_id *, 3), ARGUMENT(thud_shape_id *, 4));
    case TD_CALL_SHAPE_SET_FILTER:
        return thud_shape_set_filter(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(thud_filter, 1));
    case TD_CALL_SHAPE_SET_FRICTION:
        return thud_shape_set_friction(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(float, 1));
    case TD_CALL_SHAPE_SET_RESTITUTION:
        return thud_shape_set_restitution(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(float, 1));
    case TD_CALL_SHAPE_SET_SURFACE_SPEED:
        return thud_shape_set_surface_speed(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(float, 1));
    case TD_CALL_SHAPE_SET_DENSITY:
        return thud_shape_set_density(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(float, 1));
    case TD_CALL_SHAPE_SET_SENSOR:
        return thud_shape_set_sensor(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_SHAPE_SET_RADIUS:
        return thud_shape_set_radius(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(float, 1));
    case TD_CALL_SHAPE_SET_HALF_EXTENTS:
        return thud_shape_set_half_extents(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(thud_vec2, 1));
    case TD_CALL_SHAPE_SET_EVENTS:
        return thud_shape_set_events(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_SHAPE_SET_USER_DATA:
        return thud_shape_set_user_data(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(uint64_t, 1));
    case TD_CALL_BODY_SET_KIND:
        return thud_body_set_kind(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_body_kind, 1));
    case TD_CALL_BODY_SET_DAMPING:
        return thud_body_set_damping(w, ARGUMENT(thud_body_id, 0), ARGUMENT(float, 1), ARGUMENT(float, 2));
    case TD_CALL_BODY_SET_GRAVITY_SCALE:
        return thud_body_set_gravity_scale(w, ARGUMENT(thud_body_id, 0), ARGUMENT(float, 1));
    case TD_CALL_BODY_SET_FIXED_ROTATION:
        return thud_body_set_fixed_rotation(w, ARGUMENT(thud_body_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_BODY_SET_DETECTION:
        return thud_body_set_detection(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_detection *, 1));
    case TD_CALL_BODY_SET_MAY_SLEEP:
        return thud_body_set_may_sleep(w, ARGUMENT(thud_body_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_BODY_SET_MASS:
        return thud_body_set_mass(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_mass *, 1));
    case TD_CALL_BODY_APPLY_FORCE:
        return thud_body_apply_force(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1), ARGUMENT(thud_pos, 2));
    case TD_CALL_BODY_APPLY_CENTER_IMPULSE:
        return thud_body_apply_center_impulse(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1));
    case TD_CALL_BODY_APPLY_ANGULAR_IMPULSE:
        return thud_body_apply_angular_impulse(w, ARGUMENT(thud_body_id, 0), ARGUMENT(float, 1));
    case TD_CALL_BODY_SET_TARGET:
        return thud_body_set_target(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_pos, 1), ARGUMENT(double, 2));
    case TD_CALL_WORLD_EXPLODE:
        return thud_world_explode(w, ARGUMENT(const thud_explosion *, 0), ARGUMENT(int *, 1));
    case TD_CALL_BODY_APPLY_WIND:
        return thud_body_apply_wind(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1), ARGUMENT(float, 2), ARGUMENT(float, 3), ARGUMENT(float, 4));
    case TD_CALL_BODY_APPLY_BUOYANCY:
        return thud_body_apply_buoyancy(w, ARGUMENT(thud_body_id, 0), ARGUMENT(const thud_water *, 1));
    case TD_CALL_BODY_APPLY_ROLLING_RESISTANCE:
        return thud_body_apply_rolling_resistance(w, ARGUMENT(thud_body_id, 0), ARGUMENT(float, 1));
    case TD_CALL_BODY_APPLY_GRIP:
        return thud_body_apply_grip(w, ARGUMENT(thud_body_id, 0), ARGUMENT(thud_vec2, 1), ARGUMENT(thud_vec2, 2), ARGUMENT(float, 3), ARGUMENT(float, 4));
    case TD_CALL_JOINT_CREATE:
        return thud_joint_create(w, ARGUMENT(const thud_joint_def *, 0), ARGUMENT(thud_joint_id *, 1));
    case TD_CALL_JOINT_DESTROY:
        return thud_joint_destroy(w, ARGUMENT(thud_joint_id, 0));
    case TD_CALL_JOINT_SET_DRIVE:
        return thud_joint_set_drive(w, ARGUMENT(thud_joint_id, 0), ARGUMENT(thud_direction, 1), ARGUMENT(const thud_drive *, 2));
    case TD_CALL_JOINT_SET_LENGTH:
        return thud_joint_set_length(w, ARGUMENT(thud_joint_id, 0), ARGUMENT(float, 1));
    case TD_CALL_JOINT_SET_ENABLED:
        return thud_joint_set_enabled(w, ARGUMENT(thud_joint_id, 0), ARGUMENT(bool, 1));
    case TD_CALL_JOINT_SET_FRAME:
        return thud_joint_set_frame(w, ARGUMENT(thud_joint_id, 0), ARGUMENT(int, 1), ARGUMENT(thud_joint_frame, 2));
    case TD_CALL_JOINT_SET_BREAKING:
        return thud_joint_set_breaking(w, ARGUMENT(thud_joint_id, 0), ARGUMENT(float, 1), ARGUMENT(float, 2), ARGUMENT(bool, 3));
    case TD_CALL_JOINT_SET_USER_DATA:
        return thud_joint_set_user_data(w, ARGUMENT(thud_joint_id, 0), ARGUMENT(uint64_t, 1));
    case TD_CALL_WORLD_USE_JOINTS:
        return thud_world_use_joints(w);
    case TD_CALL_JOINT_MAKE:
        *ARGUMENT(thud_joint_id *, 1) = thud_joint_make(w, ARGUMENT(thud_joint_def, 0));
        return ARGUMENT(thud_joint_id *, 1)->index1 ? THUD_OK : THUD_ERROR_INVALID;
    case TD_CALL_WORLD_SET_LISTENERS:
        return td_play_world_set_listeners(p, w, d);
    case TD_CALL_CONTACT_DECIDE:
        return thud_contact_decide(w, ARGUMENT(const thud_contact *, 0), ARGUMENT(const thud_velocities *, 1), ARGUMENT(const thud_velocities *, 2));
    case TD_CALL_BODY_SET_LOCKS:
        return thud_body_set_locks(w, ARGUMENT(thud_body_id, 0), ARGUMENT(bool, 1), ARGUMENT(bool, 2));
    case TD_CALL_BODY_MAKE:
        *ARGUMENT(thud_body_id *, 2) = thud_body_make(w, ARGUMENT(thud_geometry, 0), ARGUMENT(const thud_body_options *, 1));
        return ARGUMENT(thud_body_id *, 2)->index1 ? THUD_OK : THUD_ERROR_INVALID;
    case TD_CALL_MOVER_MOVE:
        return td_play_mover_move(p, w, d);
    case TD_CALL_WORLD_SET_RULE:
        return thud_world_set_rule(w, ARGUMENT(uint32_t, 0), ARGUMENT(uint32_t, 1), ARGUMENT(const thud_rule *, 2));
    case TD_CALL_WORLD_USE_RULES:
        return thud_world_use_rules(w);
    case TD_CALL_WORLD_SET_FILTER:
        return td_play_world_set_filter(p, w, d);
    case TD_CALL_SHAPE_SET_TEXTURE:
        return thud_shape_set_texture(w, ARGUMENT(thud_shape_id, 0), ARGUMENT(const thud_texture *, 1));
    case TD_CALL_WORLD_USE_TEXTURES:
        return thud_world_use_textures(w);
    case TD_CALL_WORLD_USE_STEP_ERROR:
        return thud_world_use_step_error(w);
    }
    return THUD_ERROR_INVALID;
}
/* clang-format on */
