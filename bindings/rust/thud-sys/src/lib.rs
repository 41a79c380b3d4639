//! The C interface of thud, made from its headers by tools/bind_rust.py. What each item is for,
//! units, ranges and errors stand there. `thud` has it for safe code.
#![allow(non_camel_case_types, clippy::approx_constant)]
#![no_std]

use core::ffi::{c_char, c_int, c_uint, c_void};

pub const THUD_CAST_IGNORE: f64 = -1.0;
pub const THUD_CAST_END: f64 = 0.0;
pub const THUD_CAST_ON: f64 = 1.0;
pub const THUD_LENGTH_SCALE_MIN: f64 = 1e-06;
pub const THUD_LENGTH_SCALE_MAX: f64 = 1000000.0;
pub const THUD_TIME_STEP_MAX: f64 = 1.0;
pub const THUD_ADVANCE_MAX: f64 = 1000000000.0;
pub const THUD_AHEAD_MAX: f64 = 60.0;
pub const THUD_TIME_BUDGET_MAX: f64 = 1.0;
pub const THUD_MAX_ERROR_MAX: f64 = 1000000000.0;
pub const THUD_SPEED_MAX: f64 = 1000000.0;
pub const THUD_SUBSTEPS_MAX: i64 = 64;
pub const THUD_CONTACT_STIFFNESS_MIN: f64 = 0.01;
pub const THUD_CONTACT_STIFFNESS_MAX: f64 = 0.5;
pub const THUD_CONTACT_DAMPING_MAX: f64 = 100.0;
pub const THUD_ISLAND_LIMIT_MAX: i64 = 16384;
pub const THUD_ISLAND_SLOW_STEPS_MAX: i64 = 1000;
pub const THUD_WORKERS_MAX: i64 = 64;
pub const THUD_PLACE_MAX: f64 = 1000000000.0;
pub const THUD_ANGLE_MAX: f64 = 1000000.0;
pub const THUD_ANGULAR_SPEED_MAX: f64 = 100000000.0;
pub const THUD_SIZE_MIN: f64 = 0.0001;
pub const THUD_SIZE_MAX: f64 = 16384.0;
pub const THUD_STATIC_SIZE_MAX: f64 = 32000.0;
pub const THUD_DENSITY_MAX: f64 = 1000000000000.0;
pub const THUD_FRICTION_MAX: f64 = 1000000.0;
pub const THUD_RESTITUTION_MAX: f64 = 1.0;
pub const THUD_PAIR_RESTITUTION_MAX: f64 = 4.0;
pub const THUD_SURFACE_SPEED_MAX: f64 = 1000000.0;
pub const THUD_MASS_MIN: f64 = 1e-30;
pub const THUD_MASS_MAX: f64 = 1e+30;
pub const THUD_FORCE_MAX: f64 = 1e+30;
pub const THUD_DRAG_MAX: f64 = 1000000.0;
pub const THUD_FLOW_MAX: f64 = 1000000.0;
pub const THUD_FLUID_DENSITY_MAX: f64 = 1000000000000.0;
pub const THUD_EXPLOSION_MAX: f64 = 1000000000000000.0;
pub const THUD_EXPLOSION_RAYS_MAX: i64 = 16;
pub const THUD_JOINT_LENGTH_MAX: f64 = 1000000.0;
pub const THUD_JOINT_ANGLE_MAX: f64 = 3.1415927;
pub const THUD_JOINT_ANGULAR_SPEED_MAX: f64 = 1000000.0;
pub const THUD_JOINT_FREQUENCY_MAX: f64 = 10000.0;
pub const THUD_JOINT_DAMPING_MAX: f64 = 1000.0;
pub const THUD_JOINT_FORCE_MAX: f64 = 1e+30;
pub const THUD_GEAR_RATIO_MIN: f64 = 0.0001;
pub const THUD_GEAR_RATIO_MAX: f64 = 10000.0;
pub const THUD_MOVER_SLOPE_MAX: f64 = 1.55;
pub const THUD_MOVER_STEP_MAX: f64 = 1000000.0;
pub const THUD_MOVER_DISTANCE_MAX: f64 = 1000000.0;
pub const THUD_MOVER_FORCE_MAX: f64 = 1e+30;
pub const THUD_ROLLBACK_PLAYERS_MAX: i64 = 64;
pub const THUD_ROLLBACK_DEPTH_MAX: i64 = 1000;
pub const THUD_RECORDING_STEPS_MAX: i64 = 1000000000;
pub const THUD_COORDINATE_MAX: f64 = 2000000000000000.0;
pub const THUD_VOLUME_MAX: f64 = 1e+16;
pub const THUD_TOLERANCE_MIN: f64 = 1e-15;
pub const THUD_POLYGON_PLACE_MAX: f64 = 1000000000000.0;
pub const THUD_POLYGON_POINTS_MAX: i64 = 256;
pub const THUD_POLYGON_AREA_MIN: f64 = 0.001;
pub const THUD_APPROXIMATE_SHAPES_MAX: i64 = 64;
pub const THUD_UNIT_ERROR: f64 = 1e-05;
pub const THUD_NORMAL_ERROR: f64 = 0.001;
pub const THUD_TERRAIN_SLOPE_MAX: f64 = 100.0;
pub const THUD_TERRAIN_PLACE_MAX: f64 = 1000000000.0;
pub const THUD_TERRAIN_COUNT_MAX: i64 = 100000000;
pub const THUD_MINKOWSKI_VERTICES_MAX: i64 = 8;
pub const THUD_PREDICTION_CHORDS_MAX: i64 = 256;
pub const THUD_VERSION_MAJOR: i64 = 0;
pub const THUD_VERSION_MINOR: i64 = 2;
pub const THUD_VERSION_PATCH: i64 = 0;
pub const THUD_VERSION: i64 = 2000;
pub const THUD_DRAW_SHAPES: i64 = 1;
pub const THUD_DRAW_SHAPE_BOUNDS: i64 = 2;
pub const THUD_DRAW_CELLS: i64 = 4;
pub const THUD_DRAW_CONTACTS: i64 = 8;
pub const THUD_DRAW_ISLANDS: i64 = 16;
pub const THUD_DRAW_AXES: i64 = 32;
pub const THUD_DRAW_PAIRS: i64 = 64;
pub const THUD_DRAW_MOTIONS: i64 = 128;
pub const THUD_DRAW_STAGES: i64 = 256;
pub const THUD_DRAW_COLOURS: i64 = 512;
pub const THUD_DRAW_MANIFOLDS: i64 = 1024;
pub const THUD_DRAW_JOINTS: i64 = 2048;
pub const THUD_DRAW_JOINT_FORCES: i64 = 4096;
pub const THUD_SHAPE_KIND_COUNT: i64 = 4;
pub const THUD_MOVER_HITS: i64 = 8;
pub const THUD_MOVER_SENSORS: i64 = 16;
pub const THUD_RECORDED_FOUND_MAX: i64 = 64;
pub const THUD_RULE_KIND_COUNT: i64 = 3;
pub type thud_result = c_uint;
pub const THUD_OK: thud_result = 0;
pub const THUD_ERROR_NULL: thud_result = 1;
pub const THUD_ERROR_INVALID: thud_result = 2;
pub const THUD_ERROR_STALE: thud_result = 3;
pub const THUD_ERROR_MEMORY: thud_result = 4;
pub const THUD_ERROR_LOCKED: thud_result = 5;
pub type thud_style = c_uint;
pub const THUD_STYLE_STATIC: thud_style = 0;
pub const THUD_STYLE_KINEMATIC: thud_style = 1;
pub const THUD_STYLE_DYNAMIC: thud_style = 2;
pub const THUD_STYLE_SLEEPING: thud_style = 3;
pub const THUD_STYLE_SENSOR: thud_style = 4;
pub const THUD_STYLE_BOUNDS: thud_style = 5;
pub const THUD_STYLE_CELL: thud_style = 6;
pub const THUD_STYLE_CONTACT: thud_style = 7;
pub const THUD_STYLE_NORMAL: thud_style = 8;
pub const THUD_STYLE_INTERVAL: thud_style = 9;
pub const THUD_STYLE_INTERVAL_OVERLAPPING: thud_style = 10;
pub const THUD_STYLE_PAIR: thud_style = 11;
pub const THUD_STYLE_PAIR_TOUCHING: thud_style = 12;
pub const THUD_STYLE_MOTION: thud_style = 13;
pub const THUD_STYLE_PAIR_CANDIDATE: thud_style = 14;
pub const THUD_STYLE_DIRECT: thud_style = 15;
pub const THUD_STYLE_MANIFOLD: thud_style = 16;
pub const THUD_STYLE_DEPTH: thud_style = 17;
pub const THUD_STYLE_IMPULSE: thud_style = 18;
pub const THUD_STYLE_COLOUR: thud_style = 19;
pub const THUD_STYLE_COLOUR_LAST: thud_style = 34;
pub const THUD_STYLE_JOINT: thud_style = 35;
pub const THUD_STYLE_JOINT_AXIS: thud_style = 36;
pub const THUD_STYLE_JOINT_LIMIT: thud_style = 37;
pub const THUD_STYLE_JOINT_FORCE: thud_style = 38;
pub const THUD_STYLE_COUNT: thud_style = 39;
pub type thud_shape_kind = c_uint;
pub const THUD_SHAPE_CIRCLE: thud_shape_kind = 0;
pub const THUD_SHAPE_AABB: thud_shape_kind = 1;
pub const THUD_SHAPE_OBB: thud_shape_kind = 2;
pub const THUD_SHAPE_TERRAIN: thud_shape_kind = 3;
pub type thud_terrain_kind = c_uint;
pub const THUD_TERRAIN_FLAT: thud_terrain_kind = 0;
pub const THUD_TERRAIN_UNIFORM: thud_terrain_kind = 1;
pub const THUD_TERRAIN_IRREGULAR: thud_terrain_kind = 2;
pub type thud_body_kind = c_uint;
pub const THUD_BODY_STATIC: thud_body_kind = 0;
pub const THUD_BODY_KINEMATIC: thud_body_kind = 1;
pub const THUD_BODY_DYNAMIC: thud_body_kind = 2;
pub const THUD_BODY_KIND_COUNT: thud_body_kind = 3;
pub type thud_stage = c_uint;
pub const THUD_STAGE_CHANGES: thud_stage = 0;
pub const THUD_STAGE_BROADPHASE: thud_stage = 1;
pub const THUD_STAGE_NARROWPHASE: thud_stage = 2;
pub const THUD_STAGE_CONTACTS: thud_stage = 3;
pub const THUD_STAGE_SOLVE: thud_stage = 4;
pub const THUD_STAGE_FINALIZE: thud_stage = 5;
pub const THUD_STAGE_CONTINUOUS: thud_stage = 6;
pub const THUD_STAGE_EVENTS: thud_stage = 7;
pub const THUD_STAGE_SLEEP: thud_stage = 8;
pub const THUD_STAGE_COUNT: thud_stage = 9;
pub type thud_approximate_kind = c_uint;
pub const THUD_APPROXIMATE_BOTH: thud_approximate_kind = 0;
pub const THUD_APPROXIMATE_CIRCLES: thud_approximate_kind = 1;
pub const THUD_APPROXIMATE_BOXES: thud_approximate_kind = 2;
pub type thud_cover = c_uint;
pub const THUD_COVER_NONE: thud_cover = 0;
pub const THUD_COVER_STATIC: thud_cover = 1;
pub const THUD_COVER_ALL: thud_cover = 2;
pub type thud_joint_kind = c_uint;
pub const THUD_JOINT_DISTANCE: thud_joint_kind = 0;
pub const THUD_JOINT_HINGE: thud_joint_kind = 1;
pub const THUD_JOINT_SLIDER: thud_joint_kind = 2;
pub const THUD_JOINT_WELD: thud_joint_kind = 3;
pub const THUD_JOINT_WHEEL: thud_joint_kind = 4;
pub const THUD_JOINT_TARGET: thud_joint_kind = 5;
pub const THUD_JOINT_FILTER: thud_joint_kind = 6;
pub const THUD_JOINT_GEAR: thud_joint_kind = 7;
pub const THUD_JOINT_KIND_COUNT: thud_joint_kind = 8;
pub type thud_direction = c_uint;
pub const THUD_DIRECTION_ALONG: thud_direction = 0;
pub const THUD_DIRECTION_ACROSS: thud_direction = 1;
pub const THUD_DIRECTION_TURN: thud_direction = 2;
pub const THUD_DIRECTION_COUNT: thud_direction = 3;
pub type thud_contact_part = c_uint;
pub const THUD_CONTACT_BODIES: thud_contact_part = 1;
pub const THUD_CONTACT_POINT: thud_contact_part = 2;
pub type thud_rule_kind = c_uint;
pub const THUD_RULE_COLLIDE: thud_rule_kind = 0;
pub const THUD_RULE_IGNORE: thud_rule_kind = 1;
pub const THUD_RULE_ONE_WAY: thud_rule_kind = 2;
pub type thud_log_fn = unsafe extern "C" fn(thud_result, *const c_char, *mut c_void);
pub type thud_clock_fn = unsafe extern "C" fn(*mut c_void) -> f64;
pub type thud_task_fn = unsafe extern "C" fn(*mut c_void);
pub type thud_parallel_fn = unsafe extern "C" fn(Option<thud_task_fn>, *mut c_void, c_int, *mut c_void);
pub type thud_overlap_fn = unsafe extern "C" fn(thud_shape_id, *mut c_void) -> bool;
pub type thud_step_fn = unsafe extern "C" fn(*mut thud_world, *mut c_void);
pub type thud_cast_fn = unsafe extern "C" fn(*const thud_ray_hit, *mut c_void) -> f64;
pub type thud_prologue_fn = unsafe extern "C" fn(*mut thud_world, *const thud_contact, *mut thud_contact_settings, *mut c_void) -> bool;
pub type thud_epilogue_fn = unsafe extern "C" fn(*mut thud_world, *const thud_contact, *mut c_void);
pub type thud_prologue_all_fn = unsafe extern "C" fn(*mut thud_world, *const thud_contact, *mut thud_contact_answer, c_int, *mut c_void);
pub type thud_epilogue_all_fn = unsafe extern "C" fn(*mut thud_world, *const thud_contact, c_int, *mut c_void);
pub type thud_object_epilogue_fn = unsafe extern "C" fn(*mut thud_world, *const thud_contact, c_int, *mut c_void);
pub type thud_mover_pass_fn = unsafe extern "C" fn(*const thud_mover, *const thud_mover_hit, thud_vec2, *mut c_void) -> bool;
pub type thud_recording_sink_fn = unsafe extern "C" fn(*const c_void, usize, *mut c_void) -> bool;
pub type thud_chunk_fn = unsafe extern "C" fn(*const c_char, thud_bytes, *mut c_void);
pub type thud_played_call_fn = unsafe extern "C" fn(*const thud_played_call, *mut c_void);
pub type thud_rollback_step_fn = unsafe extern "C" fn(*mut thud_world, *const u64, *mut c_void) -> thud_result;
pub type thud_filter_fn = unsafe extern "C" fn(*const thud_world, thud_shape_id, thud_shape_id, *mut c_void) -> bool;
pub type thud_volume = thud_geometry;

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct thud_vec2 {
    pub x: f32,
    pub y: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct thud_pos {
    pub x: f64,
    pub y: f64,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_broadphase {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_detection {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_world {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct thud_body_id {
    pub index1: u32,
    pub generation: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct thud_shape_id {
    pub index1: u32,
    pub generation: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_debug_draw {
    pub flags: c_uint,
    pub origin: thud_pos,
    pub lower: thud_pos,
    pub upper: thud_pos,
    pub context: *mut c_void,
    pub circle: Option<unsafe extern "C" fn(thud_vec2, f32, f32, f32, thud_style, c_int, *mut c_void)>,
    pub r#box: Option<unsafe extern "C" fn(thud_vec2, thud_vec2, f32, f32, thud_style, c_int, *mut c_void)>,
    pub line: Option<unsafe extern "C" fn(thud_vec2, thud_vec2, thud_style, *mut c_void)>,
    pub point: Option<unsafe extern "C" fn(thud_vec2, thud_style, *mut c_void)>,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_contact_event {
    pub shape_a: thud_shape_id,
    pub shape_b: thud_shape_id,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_hit_event {
    pub shape_a: thud_shape_id,
    pub shape_b: thud_shape_id,
    pub point: thud_pos,
    pub normal: thud_vec2,
    pub speed: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_events {
    pub begin: *const thud_contact_event,
    pub end: *const thud_contact_event,
    pub sensor_begin: *const thud_contact_event,
    pub sensor_end: *const thud_contact_event,
    pub sensor_begin_time: *const f32,
    pub sensor_end_time: *const f32,
    pub hit: *const thud_hit_event,
    pub quarantined: *const thud_body_id,
    pub begin_count: c_int,
    pub end_count: c_int,
    pub sensor_begin_count: c_int,
    pub sensor_end_count: c_int,
    pub hit_count: c_int,
    pub quarantined_count: c_int,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_allocator {
    pub allocate: Option<unsafe extern "C" fn(usize, *mut c_void) -> *mut c_void>,
    pub release: Option<unsafe extern "C" fn(*mut c_void, usize, *mut c_void)>,
    pub context: *mut c_void,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_shared_stages {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_job_system {
    pub run: Option<thud_parallel_fn>,
    pub context: *mut c_void,
    pub workers: c_int,
    pub stages: Option<&'static thud_shared_stages>,
    pub share_from: u32,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_island_solver {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_quality {
    pub name: *const c_char,
    pub substeps: c_int,
    pub contact_stiffness: f32,
    pub contact_damping: f32,
    pub detection: Option<&'static thud_detection>,
    pub islands: Option<&'static thud_island_solver>,
    pub overlap_limit: f32,
    pub island_limit: c_int,
    pub island_work: i64,
    pub island_slow_steps: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_geometry {
    pub kind: thud_shape_kind,
    pub x: f64,
    pub y: f64,
    pub c: f64,
    pub s: f64,
    pub hx: f64,
    pub hy: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_segment {
    pub x: f64,
    pub y: f64,
    pub dx: f64,
    pub dy: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_motion {
    pub dx: f64,
    pub dy: f64,
    pub turn: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_closest {
    pub distance: f64,
    pub nx: f64,
    pub ny: f64,
    pub ax: f64,
    pub ay: f64,
    pub bx: f64,
    pub by: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_contacts {
    pub count: c_int,
    pub point: [thud_closest; 2],
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_approach {
    pub hit: bool,
    pub time: f64,
    pub min_distance: f64,
    pub min_distance_time: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_terrain {
    pub kind: thud_terrain_kind,
    pub slope: f64,
    pub x0: f64,
    pub spacing: f64,
    pub points: *const thud_pos,
    pub count: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_terrain_sample {
    pub height: f64,
    pub nx: f64,
    pub ny: f64,
    pub segment: c_int,
    pub weight: [f64; 2],
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_query_filter {
    pub category: u32,
    pub mask: u32,
    pub sensors: bool,
    pub group: i32,
    pub ignore: thud_body_id,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_ray {
    pub origin: thud_pos,
    pub dx: f64,
    pub dy: f64,
    pub filter: *const thud_query_filter,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_shape_cast {
    pub center: thud_pos,
    pub shape: thud_geometry,
    pub dx: f64,
    pub dy: f64,
    pub filter: *const thud_query_filter,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_ray_hit {
    pub shape: thud_shape_id,
    pub point: thud_pos,
    pub normal: thud_vec2,
    pub fraction: f64,
    pub depth: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_closest_hit {
    pub shape: thud_shape_id,
    pub point: thud_pos,
    pub normal: thud_vec2,
    pub distance: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_manifold {
    pub shape_a: thud_shape_id,
    pub shape_b: thud_shape_id,
    pub body_a: thud_body_id,
    pub body_b: thud_body_id,
    pub normal: thud_vec2,
    pub point_count: c_int,
    pub point: [thud_pos; 2],
    pub separation: [f32; 2],
    pub normal_impulse: [f32; 2],
    pub tangent_impulse: f32,
    pub direct: bool,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_uv {
    pub u: f64,
    pub v: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_foot {
    pub height: f64,
    pub x: f64,
    pub nx: f64,
    pub ny: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_contact {
    pub shape_a: thud_shape_id,
    pub shape_b: thud_shape_id,
    pub body_a: thud_body_id,
    pub body_b: thud_body_id,
    pub normal: thud_vec2,
    pub point: thud_pos,
    pub separation: f32,
    pub normal_impulse: f32,
    pub tangent_impulse: f32,
    pub point_count: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_contact_settings {
    pub friction: f32,
    pub restitution: f32,
    pub surface_speed: f32,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_parts {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_world_def {
    pub gravity: thud_vec2,
    pub time_step: f64,
    pub length_scale: f32,
    pub quality: *const thud_quality,
    pub substeps: c_int,
    pub contact_stiffness: f32,
    pub contact_damping: f32,
    pub push_speed: f32,
    pub restitution_threshold: f32,
    pub hit_speed: f32,
    pub maximum_speed: f32,
    pub sleeping: bool,
    pub contact_events: bool,
    pub allocator: thud_allocator,
    pub log: Option<thud_log_fn>,
    pub log_context: *mut c_void,
    pub clock: Option<thud_clock_fn>,
    pub clock_context: *mut c_void,
    pub max_error: f64,
    pub time_budget: f64,
    pub detection: Option<&'static thud_detection>,
    pub broadphase: Option<&'static thud_broadphase>,
    pub cell_size: f32,
    pub job_system: thud_job_system,
    pub parts: *const thud_parts,
    pub cookie: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_step_calls {
    pub before: Option<thud_step_fn>,
    pub after: Option<thud_step_fn>,
    pub context: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_body_def {
    pub kind: thud_body_kind,
    pub position: thud_pos,
    pub angle: f64,
    pub velocity: thud_vec2,
    pub angular_velocity: f32,
    pub gravity_scale: f32,
    pub linear_damping: f32,
    pub angular_damping: f32,
    pub fixed_rotation: bool,
    pub may_sleep: bool,
    pub detection: Option<&'static thud_detection>,
    pub user_data: u64,
    pub cookie: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_body_state {
    pub kind: thud_body_kind,
    pub position: thud_pos,
    pub center: thud_pos,
    pub angle: f64,
    pub cosine: f32,
    pub sine: f32,
    pub velocity: thud_vec2,
    pub angular_velocity: f32,
    pub mass: f32,
    pub inertia: f32,
    pub gravity_scale: f32,
    pub awake: bool,
    pub enabled: bool,
    pub quarantined: bool,
    pub user_data: u64,
    pub shape_count: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_filter {
    pub category: u32,
    pub mask: u32,
    pub group: i32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_shape_def {
    pub density: f32,
    pub friction: f32,
    pub restitution: f32,
    pub surface_speed: f32,
    pub filter: thud_filter,
    pub sensor: bool,
    pub events: bool,
    pub user_data: u64,
    pub cookie: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_shape_state {
    pub kind: thud_shape_kind,
    pub body: thud_body_id,
    pub offset: thud_vec2,
    pub half_extents: thud_vec2,
    pub angle: f64,
    pub density: f32,
    pub friction: f32,
    pub restitution: f32,
    pub surface_speed: f32,
    pub filter: thud_filter,
    pub sensor: bool,
    pub events: bool,
    pub user_data: u64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_pose {
    pub x: f32,
    pub y: f32,
    pub c: f32,
    pub s: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_stats {
    pub steps: u64,
    pub bodies: c_int,
    pub shapes: c_int,
    pub awake_bodies: c_int,
    pub pairs: c_int,
    pub contacts: c_int,
    pub colours: c_int,
    pub blocks: c_int,
    pub substeps: c_int,
    pub bytes: u64,
    pub step_allocations: u64,
    pub stage_seconds: [f64; 9],
    pub step_seconds: f64,
    pub direct_islands: c_int,
    pub direct_bodies: c_int,
    pub soft_islands: c_int,
    pub factorings: c_int,
    pub island_work: i64,
    pub impacts: c_int,
    pub held_bodies: c_int,
    pub held_seconds: f64,
    pub unbisectable: c_int,
    pub motion_pairs: c_int,
    pub motion_circles: c_int,
    pub motion_boxes: c_int,
    pub motion_exact: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_step_error {
    pub penetration_max: f64,
    pub penetration_mean: f64,
    pub residual: f64,
    pub energy_change: f64,
    pub energy_decided: f64,
    pub overlaps: c_int,
    pub shortfall: f64,
    pub joint_gap_max: f64,
    pub joint_gap_mean: f64,
    pub joint_angle_max: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_measure {
    pub penetration_max: f64,
    pub penetration_mean: f64,
    pub kinetic_energy: f64,
    pub potential_energy: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_approximate_options {
    pub shapes_max: c_int,
    pub kinds: thud_approximate_kind,
    pub distance: f64,
    pub allocator: thud_allocator,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_approximation {
    pub count: c_int,
    pub missed: f64,
    pub extra: f64,
    pub overlap: f64,
    pub distance: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_capsule {
    pub x1: f64,
    pub y1: f64,
    pub x2: f64,
    pub y2: f64,
    pub radius: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_body_shape {
    pub shape: thud_geometry,
    pub def: *const thud_shape_def,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_mass {
    pub mass: f32,
    pub inertia: f32,
    pub center: thud_vec2,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_explosion {
    pub center: thud_pos,
    pub radius: f64,
    pub falloff: f64,
    pub impulse: f32,
    pub cover: thud_cover,
    pub rays: c_int,
    pub filter: thud_query_filter,
    pub cookie: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_water {
    pub point: thud_pos,
    pub normal: thud_vec2,
    pub density: f32,
    pub flow: thud_vec2,
    pub linear_drag: f32,
    pub angular_drag: f32,
    pub cookie: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_half_plane {
    pub x: f64,
    pub y: f64,
    pub nx: f64,
    pub ny: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct thud_joint_id {
    pub index1: u32,
    pub generation: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_drive {
    pub limited: bool,
    pub lower: f32,
    pub upper: f32,
    pub frequency: f32,
    pub damping: f32,
    pub target: f32,
    pub spring_force: f32,
    pub motor_speed: f32,
    pub motor_force: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_joint_frame {
    pub position: thud_vec2,
    pub angle: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_joint_def {
    pub kind: thud_joint_kind,
    pub body_a: thud_body_id,
    pub body_b: thud_body_id,
    pub frame_a: thud_joint_frame,
    pub frame_b: thud_joint_frame,
    pub drive: [thud_drive; 3],
    pub length: f32,
    pub gear: [thud_joint_id; 2],
    pub ratio: f32,
    pub collide_connected: bool,
    pub break_force: f32,
    pub break_torque: f32,
    pub only_reports: bool,
    pub enabled: bool,
    pub user_data: u64,
    pub cookie: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_drive_forces {
    pub limit: f32,
    pub spring: f32,
    pub motor: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_joint_state {
    pub kind: thud_joint_kind,
    pub body_a: thud_body_id,
    pub body_b: thud_body_id,
    pub enabled: bool,
    pub value: [f64; 3],
    pub gap: f64,
    pub angle_gap: f64,
    pub force: thud_vec2,
    pub torque: f32,
    pub drive: [thud_drive_forces; 3],
    pub user_data: u64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_joint_event {
    pub joint: thud_joint_id,
    pub body_a: thud_body_id,
    pub body_b: thud_body_id,
    pub user_data: u64,
    pub force: f32,
    pub torque: f32,
    pub broken: bool,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_contact_answer {
    pub settings: thud_contact_settings,
    pub collide: bool,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_listeners {
    pub prologue: Option<thud_prologue_fn>,
    pub epilogue: Option<thud_epilogue_fn>,
    pub prologue_all: Option<thud_prologue_all_fn>,
    pub epilogue_all: Option<thud_epilogue_all_fn>,
    pub context: *mut c_void,
    pub without: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_velocities {
    pub velocity: thud_vec2,
    pub angular_velocity: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_body_seen {
    pub body: thud_body_id,
    pub x: i64,
    pub y: i64,
    pub angle: i64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_pair_side {
    pub body: thud_body_id,
    pub body_data: u64,
    pub shape_data: u64,
    pub sensor: bool,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_pair {
    pub a: thud_pair_side,
    pub b: thud_pair_side,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_event_pair {
    pub shape_a: thud_shape_id,
    pub shape_b: thud_shape_id,
    pub a: thud_pair_side,
    pub b: thud_pair_side,
    pub next: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_body_options {
    pub kind: thud_body_kind,
    pub velocity: thud_vec2,
    pub angular_velocity: f32,
    pub linear_damping: f32,
    pub angular_damping: f32,
    pub weightless: bool,
    pub fixed_rotation: bool,
    pub detection: Option<&'static thud_detection>,
    pub density: f32,
    pub friction: f32,
    pub frictionless: bool,
    pub restitution: f32,
    pub surface_speed: f32,
    pub category: u32,
    pub mask: u32,
    pub group: i32,
    pub sensor: bool,
    pub user_data: u64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_minkowski {
    pub count: c_int,
    pub vertices: [thud_pos; 8],
    pub normals: [thud_pos; 4],
    pub offsets: [f64; 4],
    pub radius: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_mover_hit {
    pub shape: thud_shape_id,
    pub body: thud_body_id,
    pub point: thud_pos,
    pub normal: thud_vec2,
    pub depth: f64,
    pub category: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_one_way {
    pub categories: u32,
    pub drop: bool,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_mover {
    pub shape: thud_geometry,
    pub up: thud_vec2,
    pub skin: f64,
    pub max_slope: f64,
    pub step_height: f64,
    pub snap_distance: f64,
    pub push_force: f64,
    pub body: thud_body_id,
    pub filter: thud_query_filter,
    pub pass: Option<thud_mover_pass_fn>,
    pub context: *mut c_void,
    pub on_ground: bool,
    pub ground_normal: thud_vec2,
    pub ground_shape: thud_shape_id,
    pub ground_body: thud_body_id,
    pub ground_point: thud_pos,
    pub ground_place: thud_pos,
    pub ground_cosine: f32,
    pub ground_sine: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_mover_report {
    pub velocity: thud_vec2,
    pub ground_velocity: thud_vec2,
    pub depth: f64,
    pub hit_count: c_int,
    pub hits: [thud_mover_hit; 8],
    pub sensor_count: c_int,
    pub sensors: [thud_shape_id; 16],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_bytes {
    pub data: *const c_void,
    pub count: usize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_prediction {
    pub body: thud_body_id,
    pub position: thud_pos,
    pub angle: f64,
    pub velocity: thud_vec2,
    pub angular_velocity: f32,
    pub seconds: f64,
    pub met: thud_shape_id,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_step_settings {
    pub gravity: thud_vec2,
    pub time_step: f64,
    pub max_error: f64,
    pub substeps: c_int,
    pub sleeping: bool,
    pub quality: thud_quality,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_broadphase_counts {
    pub moved: c_int,
    pub tested: i64,
    pub found: i64,
    pub sort_moves: i64,
    pub cells: c_int,
    pub cell_shapes: c_int,
    pub cell_shapes_max: c_int,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_recorder {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_recorder_options {
    pub hash_steps: c_int,
    pub body_hashes: bool,
    pub keyframe_steps: c_int,
    pub ring_steps: c_int,
    pub sink: Option<thud_recording_sink_fn>,
    pub context: *mut c_void,
    pub queries: bool,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_player {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_call_value {
    pub number: f64,
    pub handle: bool,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_played_call {
    pub name: *const c_char,
    pub result: thud_result,
    pub values: *const thud_call_value,
    pub value_count: c_int,
    pub returned: u32,
    pub query: bool,
    pub hits: *const thud_ray_hit,
    pub hit_count: c_int,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_player_options {
    pub allocator: thud_allocator,
    pub log: Option<thud_log_fn>,
    pub log_context: *mut c_void,
    pub job_system: thud_job_system,
    pub chunk: Option<thud_chunk_fn>,
    pub call: Option<thud_played_call_fn>,
    pub context: *mut c_void,
    pub clock: Option<thud_clock_fn>,
    pub clock_context: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_player_progress {
    pub first: i64,
    pub end: i64,
    pub steps: i64,
    pub hashes: i64,
    pub differs: bool,
    pub differs_after: i64,
    pub differs_at: i64,
    pub body: thud_body_id,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_rollback {
    _private: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_rollback_options {
    pub players: c_int,
    pub depth: c_int,
    pub budget: c_int,
    pub idle: u64,
    pub step: Option<thud_rollback_step_fn>,
    pub state: *mut c_void,
    pub state_bytes: usize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_rollback_progress {
    pub steps: i64,
    pub confirmed: i64,
    pub replayed: i64,
    pub settled: i64,
    pub ahead: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_rollback_difference {
    pub step: i64,
    pub is_detailed: bool,
    pub body: thud_body_id,
    pub body_slot: c_int,
    pub bodies: c_int,
    pub player: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_rule {
    pub kind: thud_rule_kind,
    pub solid_side: thud_vec2,
    pub friction: f32,
    pub restitution: f32,
    pub surface_speed: f32,
    pub event_impulse: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct thud_impulse_event {
    pub shape_a: thud_shape_id,
    pub shape_b: thud_shape_id,
    pub point: thud_pos,
    pub normal: thud_vec2,
    pub impulse: f32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct thud_texture {
    pub vertices: *const f64,
    pub count: c_int,
    pub table: *const f32,
    pub table_count: c_int,
    pub repeats: bool,
}

#[repr(C)]
#[derive(Debug)]
pub struct thud_threads {
    _private: [u8; 0],
}

// Objects that never change.
unsafe impl Sync for thud_quality {}

impl From<(f32, f32)> for thud_vec2 {
    fn from((x, y): (f32, f32)) -> Self {
        Self { x, y }
    }
}

impl From<(f64, f64)> for thud_pos {
    fn from((x, y): (f64, f64)) -> Self {
        Self { x, y }
    }
}

impl Default for thud_query_filter {
    fn default() -> Self {
        unsafe { thud_default_query_filter() }
    }
}

impl Default for thud_world_def {
    fn default() -> Self {
        unsafe { thud_default_world_def() }
    }
}

impl Default for thud_body_def {
    fn default() -> Self {
        unsafe { thud_default_body_def() }
    }
}

impl Default for thud_shape_def {
    fn default() -> Self {
        unsafe { thud_default_shape_def() }
    }
}

impl Default for thud_explosion {
    fn default() -> Self {
        unsafe { thud_default_explosion() }
    }
}

impl Default for thud_water {
    fn default() -> Self {
        unsafe { thud_default_water() }
    }
}

impl Default for thud_rule {
    fn default() -> Self {
        unsafe { thud_default_rule() }
    }
}

extern "C" {
    pub static thud_broadphase_grid: thud_broadphase;
    pub static thud_broadphase_sweep: thud_broadphase;
    pub static thud_broadphase_sweep_y: thud_broadphase;
    pub static thud_broadphase_sweep_widest: thud_broadphase;
    pub static thud_broadphase_sweep_both: thud_broadphase;
    pub static thud_broadphase_all: thud_broadphase;
    pub static thud_detection_overlap: thud_detection;
    pub static thud_detection_continuous: thud_detection;
    pub static thud_detection_bisect: thud_detection;
    pub static thud_detection_swept: thud_detection;
    pub static thud_shared_stages_all: thud_shared_stages;
    pub static thud_islands_direct: thud_island_solver;
    pub static thud_quality_draft: thud_quality;
    pub static thud_quality_default: thud_quality;
    pub static thud_quality_high: thud_quality;
    pub static thud_quality_exact: thud_quality;
    pub fn thud_result_text(result: thud_result) -> *const c_char;
    pub fn thud_sincos(angle: f64, out_sine: *mut f64, out_cosine: *mut f64) -> thud_result;
    pub fn thud_angle_of(sine: f64, cosine: f64, out_angle: *mut f64) -> thud_result;
    pub fn thud_broadphase_name(broadphase: Option<&'static thud_broadphase>) -> *const c_char;
    pub fn thud_detection_name(detection: Option<&'static thud_detection>) -> *const c_char;
    pub fn thud_world_draw(world: *mut thud_world, draw: *const thud_debug_draw) -> thud_result;
    pub fn thud_world_get_events(world: *const thud_world, out: *mut thud_events) -> thud_result;
    pub fn thud_log_to_stderr(result: thud_result, message: *const c_char, context: *mut c_void);
    pub fn thud_geometry_check(shape: *const thud_geometry) -> thud_result;
    pub fn thud_geometry_overlap(a: *const thud_geometry, b: *const thud_geometry) -> bool;
    pub fn thud_geometry_closest(a: *const thud_geometry, b: *const thud_geometry, out: *mut thud_closest) -> thud_result;
    pub fn thud_geometry_contacts(a: *const thud_geometry, b: *const thud_geometry, margin: f64, out: *mut thud_contacts) -> thud_result;
    pub fn thud_geometry_cast_ray(shape: *const thud_geometry, ray: thud_segment, out_fraction: *mut f64, out_nx: *mut f64, out_ny: *mut f64) -> bool;
    pub fn thud_geometry_time_of_impact(a: *const thud_geometry, motion_a: thud_motion, b: *const thud_geometry, motion_b: thud_motion, target: f64, out_hit: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_geometry_approach(a: *const thud_geometry, motion_a: thud_motion, b: *const thud_geometry, motion_b: thud_motion, out: *mut thud_approach) -> thud_result;
    pub fn thud_geometry_time_of_collision(a: *const thud_geometry, motion_a: thud_motion, b: *const thud_geometry, motion_b: thud_motion, tolerance: f64, out_collided: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_geometry_is_bisectable(a: *const thud_geometry, motion_a: thud_motion, b: *const thud_geometry, motion_b: thud_motion) -> bool;
    pub fn thud_terrain_check(terrain: *const thud_terrain) -> thud_result;
    pub fn thud_terrain_sample_at(terrain: *const thud_terrain, x: f64, out: *mut thud_terrain_sample) -> thud_result;
    pub fn thud_terrain_segments(terrain: *const thud_terrain, x_min: f64, x_max: f64, out_first: *mut c_int, out_last: *mut c_int);
    pub fn thud_terrain_cast_ray(terrain: *const thud_terrain, ray: thud_segment, out_fraction: *mut f64, out_nx: *mut f64, out_ny: *mut f64) -> bool;
    pub fn thud_terrain_overlap(terrain: *const thud_terrain, shape: *const thud_geometry) -> bool;
    pub fn thud_terrain_closest(terrain: *const thud_terrain, shape: *const thud_geometry, out: *mut thud_closest) -> thud_result;
    pub fn thud_terrain_contacts(terrain: *const thud_terrain, shape: *const thud_geometry, margin: f64, out: *mut thud_contacts) -> thud_result;
    pub fn thud_terrain_time_of_impact(terrain: *const thud_terrain, shape: *const thud_geometry, motion: thud_motion, target: f64, out_hit: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_terrain_time_of_collision(terrain: *const thud_terrain, shape: *const thud_geometry, motion: thud_motion, tolerance: f64, out_collided: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_volume_check(volume: *const thud_volume) -> thud_result;
    pub fn thud_volume_around_shape(kind: thud_shape_kind, shape: *const thud_geometry, out: *mut thud_volume) -> thud_result;
    pub fn thud_volume_around_motion(kind: thud_shape_kind, shape: *const thud_geometry, motion: thud_motion, out: *mut thud_volume) -> thud_result;
    pub fn thud_volume_around_points(kind: thud_shape_kind, points: *const thud_pos, count: c_int, out: *mut thud_volume) -> thud_result;
    pub fn thud_volume_around_terrain(kind: thud_shape_kind, terrain: *const thud_terrain, x_min: f64, x_max: f64, out: *mut thud_volume) -> thud_result;
    pub fn thud_volume_merge(kind: thud_shape_kind, a: *const thud_volume, b: *const thud_volume, out: *mut thud_volume) -> thud_result;
    pub fn thud_volumes_overlap(a: *const thud_volume, b: *const thud_volume, out_overlap: *mut bool) -> thud_result;
    pub fn thud_volume_contains_point(volume: *const thud_volume, x: f64, y: f64, out_inside: *mut bool) -> thud_result;
    pub fn thud_volume_contains(outer: *const thud_volume, inner: *const thud_volume, out_inside: *mut bool) -> thud_result;
    pub fn thud_default_query_filter() -> thud_query_filter;
    pub fn thud_world_cast_ray(world: *mut thud_world, ray: *const thud_ray, out_hit: *mut bool, out: *mut thud_ray_hit) -> thud_result;
    pub fn thud_world_cast_ray_all(world: *mut thud_world, ray: *const thud_ray, out: *mut thud_ray_hit, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_cast_shape(world: *mut thud_world, cast: *const thud_shape_cast, out_hit: *mut bool, out: *mut thud_ray_hit) -> thud_result;
    pub fn thud_world_cast_shape_all(world: *mut thud_world, cast: *const thud_shape_cast, out: *mut thud_ray_hit, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_overlap_shape(world: *mut thud_world, center: thud_pos, shape: thud_geometry, filter: *const thud_query_filter, r#fn: Option<thud_overlap_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_overlap_aabb(world: *mut thud_world, lower: thud_pos, upper: thud_pos, filter: *const thud_query_filter, r#fn: Option<thud_overlap_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_closest(world: *mut thud_world, point: thud_pos, max_distance: f64, filter: *const thud_query_filter, out_found: *mut bool, out: *mut thud_closest_hit) -> thud_result;
    pub fn thud_body_get_volume(world: *mut thud_world, body: thud_body_id, kind: thud_shape_kind, origin: thud_pos, out: *mut thud_volume) -> thud_result;
    pub fn thud_body_get_contacts(world: *mut thud_world, body: thud_body_id, out: *mut thud_manifold, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_terrain_texture_at(sample: *const thud_terrain_sample, vertices: *const thud_uv, count: c_int, out: *mut thud_uv) -> thud_result;
    pub fn thud_terrain_place_foot(terrain: *const thud_terrain, x: f64, width: f64, out: *mut thud_foot) -> thud_result;
    pub fn thud_shape_set_heights(world: *mut thud_world, shape: thud_shape_id, first: c_int, heights: *const f64, count: c_int) -> thud_result;
    pub fn thud_shape_dig(world: *mut thud_world, shape: thud_shape_id, center: thud_pos, radius: f64) -> thud_result;
    pub fn thud_shape_raise(world: *mut thud_world, shape: thud_shape_id, x: f64, radius: f64, height: f64) -> thud_result;
    pub fn thud_shape_replace_range(world: *mut thud_world, shape: thud_shape_id, x0: f64, x1: f64, points: *const thud_pos, count: c_int) -> thud_result;
    pub fn thud_default_world_def() -> thud_world_def;
    pub fn thud_default_world_def_of(quality: *const thud_quality) -> thud_world_def;
    pub fn thud_default_small_world_def(quality: *const thud_quality) -> thud_world_def;
    pub fn thud_world_create(def: *const thud_world_def, out: *mut *mut thud_world) -> thud_result;
    pub fn thud_world_destroy(world: *mut thud_world);
    pub fn thud_world_step(world: *mut thud_world) -> thud_result;
    pub fn thud_world_advance(world: *mut thud_world, elapsed: f64, max_steps: c_int, out_steps: *mut c_int, out_alpha: *mut f64) -> thud_result;
    pub fn thud_world_advance_with(world: *mut thud_world, elapsed: f64, max_steps: c_int, calls: *const thud_step_calls, out_steps: *mut c_int, out_alpha: *mut f64) -> thud_result;
    pub fn thud_world_set_log(world: *mut thud_world, log: Option<thud_log_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_set_gravity(world: *mut thud_world, gravity: thud_vec2) -> thud_result;
    pub fn thud_world_set_time_step(world: *mut thud_world, time_step: f64) -> thud_result;
    pub fn thud_world_set_max_error(world: *mut thud_world, max_error: f64) -> thud_result;
    pub fn thud_world_set_quality(world: *mut thud_world, quality: *const thud_quality) -> thud_result;
    pub fn thud_world_set_sleeping(world: *mut thud_world, sleeping: bool) -> thud_result;
    pub fn thud_default_body_def() -> thud_body_def;
    pub fn thud_body_create(world: *mut thud_world, def: *const thud_body_def, out: *mut thud_body_id) -> thud_result;
    pub fn thud_body_destroy(world: *mut thud_world, body: thud_body_id) -> thud_result;
    pub fn thud_body_is_valid(world: *const thud_world, body: thud_body_id) -> bool;
    pub fn thud_body_get_state(world: *const thud_world, body: thud_body_id, out: *mut thud_body_state) -> thud_result;
    pub fn thud_body_set_transform(world: *mut thud_world, body: thud_body_id, position: thud_pos, angle: f64) -> thud_result;
    pub fn thud_body_set_velocity(world: *mut thud_world, body: thud_body_id, velocity: thud_vec2, angular_velocity: f32) -> thud_result;
    pub fn thud_body_apply_impulse(world: *mut thud_world, body: thud_body_id, impulse: thud_vec2, point: thud_pos) -> thud_result;
    pub fn thud_body_apply_center_force(world: *mut thud_world, body: thud_body_id, force: thud_vec2) -> thud_result;
    pub fn thud_body_apply_torque(world: *mut thud_world, body: thud_body_id, torque: f32) -> thud_result;
    pub fn thud_body_set_awake(world: *mut thud_world, body: thud_body_id, awake: bool) -> thud_result;
    pub fn thud_body_set_enabled(world: *mut thud_world, body: thud_body_id, enabled: bool) -> thud_result;
    pub fn thud_body_set_user_data(world: *mut thud_world, body: thud_body_id, user_data: u64) -> thud_result;
    pub fn thud_body_get_shapes(world: *const thud_world, body: thud_body_id, out: *mut thud_shape_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_default_shape_def() -> thud_shape_def;
    pub fn thud_shape_create_circle(world: *mut thud_world, body: thud_body_id, def: *const thud_shape_def, offset: thud_vec2, radius: f32, out: *mut thud_shape_id) -> thud_result;
    pub fn thud_shape_create_aabb(world: *mut thud_world, body: thud_body_id, def: *const thud_shape_def, offset: thud_vec2, half_extents: thud_vec2, out: *mut thud_shape_id) -> thud_result;
    pub fn thud_shape_create_obb(world: *mut thud_world, body: thud_body_id, def: *const thud_shape_def, offset: thud_vec2, half_extents: thud_vec2, angle: f64, out: *mut thud_shape_id) -> thud_result;
    pub fn thud_shape_create_terrain(world: *mut thud_world, body: thud_body_id, def: *const thud_shape_def, terrain: *const thud_terrain, out: *mut thud_shape_id) -> thud_result;
    pub fn thud_shape_destroy(world: *mut thud_world, shape: thud_shape_id) -> thud_result;
    pub fn thud_shape_is_valid(world: *const thud_world, shape: thud_shape_id) -> bool;
    pub fn thud_shape_get_state(world: *const thud_world, shape: thud_shape_id, out: *mut thud_shape_state) -> thud_result;
    pub fn thud_shape_get_terrain(world: *const thud_world, shape: thud_shape_id, out: *mut thud_terrain) -> thud_result;
    pub fn thud_world_get_poses(world: *mut thud_world, origin: thud_pos, alpha: f64, out: *mut *const thud_pose, out_count: *mut c_int) -> thud_result;
    pub fn thud_stage_name(stage: thud_stage) -> *const c_char;
    pub fn thud_world_get_stats(world: *const thud_world, out: *mut thud_stats) -> thud_result;
    pub fn thud_world_get_bisection_limit(world: *mut thud_world, out_speed: *mut f64) -> thud_result;
    pub fn thud_world_use_step_error(world: *mut thud_world) -> thud_result;
    pub fn thud_world_get_step_error(world: *const thud_world, out: *mut thud_step_error) -> thud_result;
    pub fn thud_world_get_measure(world: *const thud_world, out: *mut thud_measure) -> thud_result;
    pub fn thud_world_get_hash(world: *const thud_world, out: *mut u64) -> thud_result;
    pub fn thud_polygon_check(points: *const thud_pos, count: c_int, out_reason: *mut *const c_char) -> thud_result;
    pub fn thud_approximate(points: *const thud_pos, count: c_int, options: *const thud_approximate_options, out_shapes: *mut thud_geometry, out: *mut thud_approximation) -> thud_result;
    pub fn thud_capsule_check(capsule: *const thud_capsule) -> thud_result;
    pub fn thud_capsule_of_motion(circle: *const thud_geometry, motion: thud_motion, out: *mut thud_capsule) -> thud_result;
    pub fn thud_capsule_closest(a: *const thud_capsule, b: *const thud_geometry, out: *mut thud_closest) -> thud_result;
    pub fn thud_capsules_closest(a: *const thud_capsule, b: *const thud_capsule, out: *mut thud_closest) -> thud_result;
    pub fn thud_terrain_capsule_closest(terrain: *const thud_terrain, capsule: *const thud_capsule, out: *mut thud_closest) -> thud_result;
    pub fn thud_capsule_time_of_impact(a: *const thud_capsule, motion_a: thud_motion, b: *const thud_geometry, motion_b: thud_motion, target: f64, out_hit: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_capsules_time_of_impact(a: *const thud_capsule, motion_a: thud_motion, b: *const thud_capsule, motion_b: thud_motion, target: f64, out_hit: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_terrain_capsule_time_of_impact(terrain: *const thud_terrain, capsule: *const thud_capsule, motion: thud_motion, target: f64, out_hit: *mut bool, out_time: *mut f64) -> thud_result;
    pub fn thud_world_cast_ray_each(world: *mut thud_world, ray: *const thud_ray, r#fn: Option<thud_cast_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_cast_shape_each(world: *mut thud_world, cast: *const thud_shape_cast, r#fn: Option<thud_cast_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_cast_rays(world: *mut thud_world, rays: *const thud_ray, count: c_int, out_hits: *mut thud_ray_hit) -> thud_result;
    pub fn thud_world_cast_shapes(world: *mut thud_world, casts: *const thud_shape_cast, count: c_int, out_hits: *mut thud_ray_hit) -> thud_result;
    pub fn thud_shape_cast_ray(world: *mut thud_world, shape: thud_shape_id, origin: thud_pos, dx: f64, dy: f64, out_hit: *mut bool, out: *mut thud_ray_hit) -> thud_result;
    pub fn thud_shape_contains_point(world: *mut thud_world, shape: thud_shape_id, point: thud_pos, out_inside: *mut bool) -> thud_result;
    pub fn thud_shape_closest_point(world: *mut thud_world, shape: thud_shape_id, point: thud_pos, out: *mut thud_closest_hit) -> thud_result;
    pub fn thud_shape_get_bounds(world: *mut thud_world, shape: thud_shape_id, out_lower: *mut thud_pos, out_upper: *mut thud_pos) -> thud_result;
    pub fn thud_body_create_with_shapes(world: *mut thud_world, def: *const thud_body_def, shapes: *const thud_body_shape, count: c_int, out_body: *mut thud_body_id, out_shape_ids: *mut thud_shape_id) -> thud_result;
    pub fn thud_shape_set_filter(world: *mut thud_world, shape: thud_shape_id, filter: thud_filter) -> thud_result;
    pub fn thud_shape_set_friction(world: *mut thud_world, shape: thud_shape_id, friction: f32) -> thud_result;
    pub fn thud_shape_set_restitution(world: *mut thud_world, shape: thud_shape_id, restitution: f32) -> thud_result;
    pub fn thud_shape_set_surface_speed(world: *mut thud_world, shape: thud_shape_id, surface_speed: f32) -> thud_result;
    pub fn thud_shape_set_density(world: *mut thud_world, shape: thud_shape_id, density: f32) -> thud_result;
    pub fn thud_shape_set_sensor(world: *mut thud_world, shape: thud_shape_id, sensor: bool) -> thud_result;
    pub fn thud_shape_set_radius(world: *mut thud_world, shape: thud_shape_id, radius: f32) -> thud_result;
    pub fn thud_shape_set_half_extents(world: *mut thud_world, shape: thud_shape_id, half_extents: thud_vec2) -> thud_result;
    pub fn thud_shape_set_events(world: *mut thud_world, shape: thud_shape_id, events: bool) -> thud_result;
    pub fn thud_shape_set_user_data(world: *mut thud_world, shape: thud_shape_id, user_data: u64) -> thud_result;
    pub fn thud_body_set_kind(world: *mut thud_world, body: thud_body_id, kind: thud_body_kind) -> thud_result;
    pub fn thud_body_set_damping(world: *mut thud_world, body: thud_body_id, linear: f32, angular: f32) -> thud_result;
    pub fn thud_body_set_gravity_scale(world: *mut thud_world, body: thud_body_id, gravity_scale: f32) -> thud_result;
    pub fn thud_body_set_fixed_rotation(world: *mut thud_world, body: thud_body_id, fixed: bool) -> thud_result;
    pub fn thud_body_set_detection(world: *mut thud_world, body: thud_body_id, detection: Option<&'static thud_detection>) -> thud_result;
    pub fn thud_body_set_may_sleep(world: *mut thud_world, body: thud_body_id, may_sleep: bool) -> thud_result;
    pub fn thud_body_set_mass(world: *mut thud_world, body: thud_body_id, mass: *const thud_mass) -> thud_result;
    pub fn thud_body_apply_force(world: *mut thud_world, body: thud_body_id, force: thud_vec2, point: thud_pos) -> thud_result;
    pub fn thud_body_apply_center_impulse(world: *mut thud_world, body: thud_body_id, impulse: thud_vec2) -> thud_result;
    pub fn thud_body_apply_angular_impulse(world: *mut thud_world, body: thud_body_id, impulse: f32) -> thud_result;
    pub fn thud_body_set_target(world: *mut thud_world, body: thud_body_id, position: thud_pos, angle: f64) -> thud_result;
    pub fn thud_body_get_velocity_at(world: *const thud_world, body: thud_body_id, point: thud_pos, out: *mut thud_vec2) -> thud_result;
    pub fn thud_body_get_world_point(world: *const thud_world, body: thud_body_id, point: thud_vec2, out: *mut thud_pos) -> thud_result;
    pub fn thud_body_get_local_point(world: *const thud_world, body: thud_body_id, point: thud_pos, out: *mut thud_vec2) -> thud_result;
    pub fn thud_body_get_world_vector(world: *const thud_world, body: thud_body_id, vector: thud_vec2, out: *mut thud_vec2) -> thud_result;
    pub fn thud_body_get_local_vector(world: *const thud_world, body: thud_body_id, vector: thud_vec2, out: *mut thud_vec2) -> thud_result;
    pub fn thud_default_explosion() -> thud_explosion;
    pub fn thud_world_explode(world: *mut thud_world, explosion: *const thud_explosion, out_pushed: *mut c_int) -> thud_result;
    pub fn thud_body_apply_wind(world: *mut thud_world, body: thud_body_id, wind: thud_vec2, density: f32, drag: f32, lift: f32) -> thud_result;
    pub fn thud_default_water() -> thud_water;
    pub fn thud_body_apply_buoyancy(world: *mut thud_world, body: thud_body_id, water: *const thud_water) -> thud_result;
    pub fn thud_geometry_area_below(shape: *const thud_geometry, below: thud_half_plane, out_area: *mut f64, out_center_x: *mut f64, out_center_y: *mut f64) -> thud_result;
    pub fn thud_body_apply_rolling_resistance(world: *mut thud_world, body: thud_body_id, coefficient: f32) -> thud_result;
    pub fn thud_body_apply_grip(world: *mut thud_world, body: thud_body_id, point: thud_vec2, axis: thud_vec2, speed: f32, max_force: f32) -> thud_result;
    pub fn thud_default_joint_def(kind: thud_joint_kind) -> thud_joint_def;
    pub fn thud_joint_create(world: *mut thud_world, def: *const thud_joint_def, out: *mut thud_joint_id) -> thud_result;
    pub fn thud_joint_destroy(world: *mut thud_world, joint: thud_joint_id) -> thud_result;
    pub fn thud_joint_is_valid(world: *const thud_world, joint: thud_joint_id) -> bool;
    pub fn thud_joint_get_state(world: *const thud_world, joint: thud_joint_id, out: *mut thud_joint_state) -> thud_result;
    pub fn thud_joint_get_def(world: *const thud_world, joint: thud_joint_id, out: *mut thud_joint_def) -> thud_result;
    pub fn thud_joint_set_drive(world: *mut thud_world, joint: thud_joint_id, direction: thud_direction, drive: *const thud_drive) -> thud_result;
    pub fn thud_joint_set_length(world: *mut thud_world, joint: thud_joint_id, length: f32) -> thud_result;
    pub fn thud_joint_set_enabled(world: *mut thud_world, joint: thud_joint_id, enabled: bool) -> thud_result;
    pub fn thud_joint_set_frame(world: *mut thud_world, joint: thud_joint_id, side: c_int, frame: thud_joint_frame) -> thud_result;
    pub fn thud_joint_set_breaking(world: *mut thud_world, joint: thud_joint_id, force: f32, torque: f32, only_reports: bool) -> thud_result;
    pub fn thud_joint_set_user_data(world: *mut thud_world, joint: thud_joint_id, user_data: u64) -> thud_result;
    pub fn thud_world_get_joint_events(world: *const thud_world, out: *mut *const thud_joint_event, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_get_joints(world: *const thud_world, out: *mut thud_joint_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_body_get_joints(world: *const thud_world, body: thud_body_id, out: *mut thud_joint_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_use_joints(world: *mut thud_world) -> thud_result;
    pub fn thud_hinge_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, point: thud_pos) -> thud_joint_def;
    pub fn thud_weld_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, point: thud_pos) -> thud_joint_def;
    pub fn thud_slider_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, point: thud_pos, axis: thud_vec2) -> thud_joint_def;
    pub fn thud_wheel_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, point: thud_pos, axis: thud_vec2) -> thud_joint_def;
    pub fn thud_target_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, point: thud_pos) -> thud_joint_def;
    pub fn thud_rod_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, from: thud_pos, to: thud_pos) -> thud_joint_def;
    pub fn thud_rope_at(world: *const thud_world, body_a: thud_body_id, body_b: thud_body_id, from: thud_pos, to: thud_pos, length: f32) -> thud_joint_def;
    pub fn thud_joint_make(world: *mut thud_world, def: thud_joint_def) -> thud_joint_id;
    pub fn thud_world_set_listeners(world: *mut thud_world, listeners: *const thud_listeners) -> thud_result;
    pub fn thud_body_set_epilogue(world: *mut thud_world, body: thud_body_id, epilogue: Option<thud_object_epilogue_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_set_category_epilogue(world: *mut thud_world, categories: u32, epilogue: Option<thud_object_epilogue_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_contact_decide(world: *mut thud_world, contact: *const thud_contact, a: *const thud_velocities, b: *const thud_velocities) -> thud_result;
    pub fn thud_world_get_bodies(world: *const thud_world, out: *mut thud_body_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_get_awake_bodies(world: *const thud_world, out: *mut thud_body_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_get_shapes(world: *const thud_world, out: *mut thud_shape_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_get_slot_counts(world: *const thud_world, out_bodies: *mut c_int, out_shapes: *mut c_int) -> thud_result;
    pub fn thud_world_get_body_at(world: *const thud_world, slot: c_int, out: *mut thud_body_id) -> thud_result;
    pub fn thud_world_get_shape_at(world: *const thud_world, slot: c_int, out: *mut thud_shape_id) -> thud_result;
    pub fn thud_world_get_moved_bodies(world: *const thud_world, seen: *mut thud_body_seen, slots: c_int, out: *mut thud_body_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_shape_get_sensor_overlaps(world: *const thud_world, sensor: thud_shape_id, out: *mut thud_shape_id, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_get_pair(world: *const thud_world, shape_a: thud_shape_id, shape_b: thud_shape_id, out: *mut thud_pair) -> thud_result;
    pub fn thud_world_next_event_pair(world: *const thud_world, first: u32, second: u32, pair: *mut thud_event_pair) -> bool;
    pub fn thud_body_set_locks(world: *mut thud_world, body: thud_body_id, x: bool, y: bool) -> thud_result;
    pub fn thud_body_get_locks(world: *const thud_world, body: thud_body_id, out_x: *mut bool, out_y: *mut bool) -> thud_result;
    pub fn thud_world_make(gravity: thud_vec2, quality: *const thud_quality) -> *mut thud_world;
    pub fn thud_body_make(world: *mut thud_world, shape: thud_geometry, options: *const thud_body_options) -> thud_body_id;
    pub fn thud_minkowski_sum(a: *const thud_geometry, b: *const thud_geometry, out: *mut thud_minkowski) -> thud_result;
    pub fn thud_minkowski_contains(sum: *const thud_minkowski, x: f64, y: f64, out_inside: *mut bool) -> thud_result;
    pub fn thud_minkowski_distance(sum: *const thud_minkowski, x: f64, y: f64, out_distance: *mut f64, out_nx: *mut f64, out_ny: *mut f64) -> thud_result;
    pub fn thud_minkowski_cast(sum: *const thud_minkowski, path: thud_segment, out_hit: *mut bool, out_fraction: *mut f64, out_nx: *mut f64, out_ny: *mut f64) -> thud_result;
    pub fn thud_mover_passes_one_way(mover: *const thud_mover, hit: *const thud_mover_hit, velocity: thud_vec2, context: *mut c_void) -> bool;
    pub fn thud_default_mover(shape: thud_geometry) -> thud_mover;
    pub fn thud_mover_move(world: *mut thud_world, mover: *mut thud_mover, velocity: thud_vec2, dt: f64, out_report: *mut thud_mover_report) -> thud_result;
    pub fn thud_world_pack(world: *const thud_world, base: thud_bytes, snapshot: thud_bytes, buffer: *mut c_void, capacity: usize, out_bytes: *mut usize) -> thud_result;
    pub fn thud_world_unpack(world: *const thud_world, base: thud_bytes, packed: thud_bytes, buffer: *mut c_void, capacity: usize, out_bytes: *mut usize) -> thud_result;
    pub fn thud_world_extrapolate(world: *const thud_world, bodies: *const thud_body_id, count: c_int, seconds: f64, out: *mut thud_prediction) -> thud_result;
    pub fn thud_world_extrapolate_awake(world: *const thud_world, seconds: f64, out: *mut thud_prediction, capacity: c_int, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_predict(world: *mut thud_world, bodies: *const thud_body_id, count: c_int, seconds: f64, out: *mut thud_prediction) -> thud_result;
    pub fn thud_body_get_position(world: *const thud_world, body: thud_body_id, out_position: *mut thud_pos) -> thud_result;
    pub fn thud_body_get_rotation(world: *const thud_world, body: thud_body_id, out_angle: *mut f64, out_cosine: *mut f32, out_sine: *mut f32) -> thud_result;
    pub fn thud_body_get_velocity(world: *const thud_world, body: thud_body_id, out_velocity: *mut thud_vec2, out_angular_velocity: *mut f32) -> thud_result;
    pub fn thud_body_get_user_data(world: *const thud_world, body: thud_body_id, out_user_data: *mut u64) -> thud_result;
    pub fn thud_shape_get_user_data(world: *const thud_world, shape: thud_shape_id, out_user_data: *mut u64) -> thud_result;
    pub fn thud_shape_get_body(world: *const thud_world, shape: thud_shape_id, out_body: *mut thud_body_id) -> thud_result;
    pub fn thud_world_get_step_settings(world: *const thud_world, out: *mut thud_step_settings) -> thud_result;
    pub fn thud_world_get_broadphase_counts(world: *const thud_world, out: *mut thud_broadphase_counts) -> thud_result;
    pub fn thud_recorder_begin(world: *mut thud_world, options: *const thud_recorder_options, out: *mut *mut thud_recorder) -> thud_result;
    pub fn thud_recorder_end(recorder: *mut thud_recorder);
    pub fn thud_recorder_get_bytes(recorder: *mut thud_recorder, out: *mut thud_bytes) -> thud_result;
    pub fn thud_recorder_salvage(recorder: *mut thud_recorder, out: *mut thud_bytes) -> thud_result;
    pub fn thud_recorder_add_chunk(recorder: *mut thud_recorder, name: *const c_char, bytes: thud_bytes) -> thud_result;
    pub fn thud_player_create(recording: thud_bytes, options: *const thud_player_options, out: *mut *mut thud_player) -> thud_result;
    pub fn thud_player_destroy(player: *mut thud_player);
    pub fn thud_player_step(player: *mut thud_player, out_stepped: *mut bool) -> thud_result;
    pub fn thud_player_seek(player: *mut thud_player, step: i64) -> thud_result;
    pub fn thud_player_get_keyframe(player: *const thud_player, step: i64, out_step: *mut i64) -> thud_result;
    pub fn thud_player_get_world(player: *mut thud_player, out: *mut *mut thud_world) -> thud_result;
    pub fn thud_player_get_progress(player: *const thud_player, out: *mut thud_player_progress) -> thud_result;
    pub fn thud_rollback_create(world: *mut thud_world, options: *const thud_rollback_options, out: *mut *mut thud_rollback) -> thud_result;
    pub fn thud_rollback_destroy(rollback: *mut thud_rollback);
    pub fn thud_rollback_input(rollback: *mut thud_rollback, player: c_int, step: i64, input: u64) -> thud_result;
    pub fn thud_rollback_advance(rollback: *mut thud_rollback, out_made: *mut bool) -> thud_result;
    pub fn thud_rollback_settle(rollback: *mut thud_rollback) -> thud_result;
    pub fn thud_rollback_get_progress(rollback: *const thud_rollback, out: *mut thud_rollback_progress) -> thud_result;
    pub fn thud_rollback_get_state(rollback: *mut thud_rollback, step: i64, out_hash: *mut u64, out_state: *mut c_void) -> thud_result;
    pub fn thud_rollback_report(rollback: *mut thud_rollback, step: i64, buffer: *mut c_void, capacity: usize, out_bytes: *mut usize) -> thud_result;
    pub fn thud_rollback_compare(rollback: *mut thud_rollback, report: *const c_void, bytes: usize, out: *mut thud_rollback_difference) -> thud_result;
    pub fn thud_rollback_get_lead(rollback: *const thud_rollback, player: c_int, out_lead: *mut i64) -> thud_result;
    pub fn thud_rollback_set_lead(rollback: *mut thud_rollback, player: c_int, lead: i64) -> thud_result;
    pub fn thud_rollback_leave(rollback: *mut thud_rollback, player: c_int, step: i64) -> thud_result;
    pub fn thud_rollback_enter(rollback: *mut thud_rollback, player: c_int, step: i64) -> thud_result;
    pub fn thud_rollback_snapshot(rollback: *mut thud_rollback, buffer: *mut c_void, capacity: usize, out_bytes: *mut usize) -> thud_result;
    pub fn thud_rollback_restore(rollback: *mut thud_rollback, buffer: *const c_void, bytes: usize) -> thud_result;
    pub fn thud_default_rule() -> thud_rule;
    pub fn thud_world_set_rule(world: *mut thud_world, first: u32, second: u32, rule: *const thud_rule) -> thud_result;
    pub fn thud_world_get_rule(world: *const thud_world, first: u32, second: u32, out: *mut thud_rule, out_is_set: *mut bool, out_reversed: *mut bool) -> thud_result;
    pub fn thud_world_use_rules(world: *mut thud_world) -> thud_result;
    pub fn thud_world_set_filter(world: *mut thud_world, filter: Option<thud_filter_fn>, context: *mut c_void) -> thud_result;
    pub fn thud_world_get_impulse_events(world: *const thud_world, out: *mut *const thud_impulse_event, out_count: *mut c_int) -> thud_result;
    pub fn thud_world_get_snapshot_size(world: *const thud_world, out_bytes: *mut usize) -> thud_result;
    pub fn thud_world_snapshot(world: *const thud_world, buffer: *mut c_void, capacity: usize, out_bytes: *mut usize) -> thud_result;
    pub fn thud_world_restore(world: *mut thud_world, buffer: *const c_void, bytes: usize) -> thud_result;
    pub fn thud_world_save(world: *mut thud_world, path: *const c_char, own: *const c_void, bytes: usize) -> thud_result;
    pub fn thud_world_load(world: *mut thud_world, path: *const c_char, out_own: *mut c_void, bytes: usize) -> thud_result;
    pub fn thud_world_def_set_baseline_simd(def: *mut thud_world_def, baseline_simd: bool) -> thud_result;
    pub fn thud_texture_friction_at(texture: *const thud_texture, sample: *const thud_terrain_sample, out: *mut f32) -> thud_result;
    pub fn thud_shape_set_texture(world: *mut thud_world, shape: thud_shape_id, texture: *const thud_texture) -> thud_result;
    pub fn thud_shape_get_texture(world: *const thud_world, shape: thud_shape_id, out: *mut thud_texture) -> thud_result;
    pub fn thud_shape_get_friction_at(world: *const thud_world, shape: thud_shape_id, x: f64, out: *mut f32) -> thud_result;
    pub fn thud_world_use_textures(world: *mut thud_world) -> thud_result;
    pub fn thud_threads_create(workers: c_int, allocator: *const thud_allocator, out: *mut *mut thud_threads) -> thud_result;
    pub fn thud_threads_destroy(threads: *mut thud_threads) -> thud_result;
    pub fn thud_threads_get_job_system(threads: *mut thud_threads, out: *mut thud_job_system) -> thud_result;
    pub fn thud_version() -> c_int;
}
