--- thud.lua: rigid bodies in two dimensions for LuaJIT, by its ffi: the C engine, with the same bits.
--
-- The library is ffi.load(THUD_LIBRARY or "thud"), where THUD_LIBRARY is a global or a variable of the
-- environment: the path of libthud.so, libthud.dylib or thud.dll.
--
-- Names: thud_body_set_velocity(world, body, ...) is body:set_velocity(...), a getter loses its get_
-- (world:stats()), thud_body_create is world:create_body(), and a function without a world is thud.NAME.
-- What each does, units, ranges and errors stand in the headers of C.
--
-- Inputs: a struct is a table, {1, 2} or {x = 1, y = 2}, or a struct of the ffi; a def is a table of the
-- fields that are not at their default, and may be left out, as the last argument. Enumerators and
-- objects of the engine are words: kind = "dynamic", quality = "high". An array is a list, or an array
-- of the ffi. A wrong field, word or type is an error.
--
-- Outputs: structs of the ffi, numbers, lists of handles. Poses and events are the world's own memory,
-- from 0, until its next call and as long as it lives. What may find nothing returns false for that.
--
-- A call that the engine refuses returns nil and the reason, and has changed nothing.
--
-- Callbacks: functions, called from the interpreter; an error in one is raised by the call that called
-- it. The ffi has no callbacks with structs by value: overlap queries, filters and debug drawing are not
-- offered. The calls of this module are never compiled by the JIT, so that callbacks may run in them;
-- what reads poses and events is.
local ffi = require("ffi")
if jit then
    jit.off(true, true)
end

local thud = {}

---- made from bindings/api.json by tools/bind_lua.py: declarations ----

ffi.cdef [[
typedef enum thud_result { THUD_OK = 0, THUD_ERROR_NULL = 1, THUD_ERROR_INVALID = 2, THUD_ERROR_STALE = 3, THUD_ERROR_MEMORY = 4, THUD_ERROR_LOCKED = 5 } thud_result;
typedef enum thud_style { THUD_STYLE_STATIC = 0, THUD_STYLE_KINEMATIC = 1, THUD_STYLE_DYNAMIC = 2, THUD_STYLE_SLEEPING = 3, THUD_STYLE_SENSOR = 4, THUD_STYLE_BOUNDS = 5, THUD_STYLE_CELL = 6, THUD_STYLE_CONTACT = 7, THUD_STYLE_NORMAL = 8, THUD_STYLE_INTERVAL = 9, THUD_STYLE_INTERVAL_OVERLAPPING = 10, THUD_STYLE_PAIR = 11, THUD_STYLE_PAIR_TOUCHING = 12, THUD_STYLE_MOTION = 13, THUD_STYLE_PAIR_CANDIDATE = 14, THUD_STYLE_DIRECT = 15, THUD_STYLE_MANIFOLD = 16, THUD_STYLE_DEPTH = 17, THUD_STYLE_IMPULSE = 18, THUD_STYLE_COLOUR = 19, THUD_STYLE_COLOUR_LAST = 34, THUD_STYLE_JOINT = 35, THUD_STYLE_JOINT_AXIS = 36, THUD_STYLE_JOINT_LIMIT = 37, THUD_STYLE_JOINT_FORCE = 38, THUD_STYLE_COUNT = 39 } thud_style;
typedef enum thud_shape_kind { THUD_SHAPE_CIRCLE = 0, THUD_SHAPE_AABB = 1, THUD_SHAPE_OBB = 2, THUD_SHAPE_TERRAIN = 3 } thud_shape_kind;
typedef enum thud_terrain_kind { THUD_TERRAIN_FLAT = 0, THUD_TERRAIN_UNIFORM = 1, THUD_TERRAIN_IRREGULAR = 2 } thud_terrain_kind;
typedef enum thud_body_kind { THUD_BODY_STATIC = 0, THUD_BODY_KINEMATIC = 1, THUD_BODY_DYNAMIC = 2, THUD_BODY_KIND_COUNT = 3 } thud_body_kind;
typedef enum thud_stage { THUD_STAGE_CHANGES = 0, THUD_STAGE_BROADPHASE = 1, THUD_STAGE_NARROWPHASE = 2, THUD_STAGE_CONTACTS = 3, THUD_STAGE_SOLVE = 4, THUD_STAGE_FINALIZE = 5, THUD_STAGE_CONTINUOUS = 6, THUD_STAGE_EVENTS = 7, THUD_STAGE_SLEEP = 8, THUD_STAGE_COUNT = 9 } thud_stage;
typedef enum thud_approximate_kind { THUD_APPROXIMATE_BOTH = 0, THUD_APPROXIMATE_CIRCLES = 1, THUD_APPROXIMATE_BOXES = 2 } thud_approximate_kind;
typedef enum thud_cover { THUD_COVER_NONE = 0, THUD_COVER_STATIC = 1, THUD_COVER_ALL = 2 } thud_cover;
typedef enum thud_joint_kind { THUD_JOINT_DISTANCE = 0, THUD_JOINT_HINGE = 1, THUD_JOINT_SLIDER = 2, THUD_JOINT_WELD = 3, THUD_JOINT_WHEEL = 4, THUD_JOINT_TARGET = 5, THUD_JOINT_FILTER = 6, THUD_JOINT_GEAR = 7, THUD_JOINT_KIND_COUNT = 8 } thud_joint_kind;
typedef enum thud_direction { THUD_DIRECTION_ALONG = 0, THUD_DIRECTION_ACROSS = 1, THUD_DIRECTION_TURN = 2, THUD_DIRECTION_COUNT = 3 } thud_direction;
typedef enum thud_contact_part { THUD_CONTACT_BODIES = 1, THUD_CONTACT_POINT = 2 } thud_contact_part;
typedef enum thud_rule_kind { THUD_RULE_COLLIDE = 0, THUD_RULE_IGNORE = 1, THUD_RULE_ONE_WAY = 2 } thud_rule_kind;
typedef struct thud_vec2 thud_vec2;
typedef struct thud_pos thud_pos;
typedef struct thud_broadphase thud_broadphase;
typedef struct thud_detection thud_detection;
typedef struct thud_world thud_world;
typedef struct thud_body_id thud_body_id;
typedef struct thud_shape_id thud_shape_id;
typedef struct thud_debug_draw thud_debug_draw;
typedef struct thud_contact_event thud_contact_event;
typedef struct thud_hit_event thud_hit_event;
typedef struct thud_events thud_events;
typedef struct thud_allocator thud_allocator;
typedef struct thud_shared_stages thud_shared_stages;
typedef struct thud_job_system thud_job_system;
typedef struct thud_island_solver thud_island_solver;
typedef struct thud_quality thud_quality;
typedef struct thud_geometry thud_geometry;
typedef struct thud_segment thud_segment;
typedef struct thud_motion thud_motion;
typedef struct thud_closest thud_closest;
typedef struct thud_contacts thud_contacts;
typedef struct thud_approach thud_approach;
typedef struct thud_terrain thud_terrain;
typedef struct thud_terrain_sample thud_terrain_sample;
typedef struct thud_query_filter thud_query_filter;
typedef struct thud_ray thud_ray;
typedef struct thud_shape_cast thud_shape_cast;
typedef struct thud_ray_hit thud_ray_hit;
typedef struct thud_closest_hit thud_closest_hit;
typedef struct thud_manifold thud_manifold;
typedef struct thud_uv thud_uv;
typedef struct thud_foot thud_foot;
typedef struct thud_contact thud_contact;
typedef struct thud_contact_settings thud_contact_settings;
typedef struct thud_parts thud_parts;
typedef struct thud_world_def thud_world_def;
typedef struct thud_step_calls thud_step_calls;
typedef struct thud_body_def thud_body_def;
typedef struct thud_body_state thud_body_state;
typedef struct thud_filter thud_filter;
typedef struct thud_shape_def thud_shape_def;
typedef struct thud_shape_state thud_shape_state;
typedef struct thud_pose thud_pose;
typedef struct thud_stats thud_stats;
typedef struct thud_step_error thud_step_error;
typedef struct thud_measure thud_measure;
typedef struct thud_approximate_options thud_approximate_options;
typedef struct thud_approximation thud_approximation;
typedef struct thud_capsule thud_capsule;
typedef struct thud_body_shape thud_body_shape;
typedef struct thud_mass thud_mass;
typedef struct thud_explosion thud_explosion;
typedef struct thud_water thud_water;
typedef struct thud_half_plane thud_half_plane;
typedef struct thud_joint_id thud_joint_id;
typedef struct thud_drive thud_drive;
typedef struct thud_joint_frame thud_joint_frame;
typedef struct thud_joint_def thud_joint_def;
typedef struct thud_drive_forces thud_drive_forces;
typedef struct thud_joint_state thud_joint_state;
typedef struct thud_joint_event thud_joint_event;
typedef struct thud_contact_answer thud_contact_answer;
typedef struct thud_listeners thud_listeners;
typedef struct thud_velocities thud_velocities;
typedef struct thud_body_seen thud_body_seen;
typedef struct thud_pair_side thud_pair_side;
typedef struct thud_pair thud_pair;
typedef struct thud_event_pair thud_event_pair;
typedef struct thud_body_options thud_body_options;
typedef struct thud_minkowski thud_minkowski;
typedef struct thud_mover_hit thud_mover_hit;
typedef struct thud_one_way thud_one_way;
typedef struct thud_mover thud_mover;
typedef struct thud_mover_report thud_mover_report;
typedef struct thud_bytes thud_bytes;
typedef struct thud_prediction thud_prediction;
typedef struct thud_step_settings thud_step_settings;
typedef struct thud_broadphase_counts thud_broadphase_counts;
typedef struct thud_recorder thud_recorder;
typedef struct thud_recorder_options thud_recorder_options;
typedef struct thud_player thud_player;
typedef struct thud_call_value thud_call_value;
typedef struct thud_played_call thud_played_call;
typedef struct thud_player_options thud_player_options;
typedef struct thud_player_progress thud_player_progress;
typedef struct thud_rollback thud_rollback;
typedef struct thud_rollback_options thud_rollback_options;
typedef struct thud_rollback_progress thud_rollback_progress;
typedef struct thud_rollback_difference thud_rollback_difference;
typedef struct thud_rule thud_rule;
typedef struct thud_impulse_event thud_impulse_event;
typedef struct thud_texture thud_texture;
typedef struct thud_threads thud_threads;
typedef thud_geometry thud_volume;
typedef void thud_log_fn(thud_result result, const char * message, void * context);
typedef double thud_clock_fn(void * context);
typedef void thud_task_fn(void * argument);
typedef void thud_parallel_fn(thud_task_fn * task, void * argument, int workers, void * context);
typedef _Bool thud_overlap_fn(thud_shape_id shape, void * context);
typedef void thud_step_fn(thud_world * world, void * context);
typedef double thud_cast_fn(const thud_ray_hit * hit, void * context);
typedef _Bool thud_prologue_fn(thud_world * world, const thud_contact * contact, thud_contact_settings * settings, void * context);
typedef void thud_epilogue_fn(thud_world * world, const thud_contact * contact, void * context);
typedef void thud_prologue_all_fn(thud_world * world, const thud_contact * contacts, thud_contact_answer * answers, int count, void * context);
typedef void thud_epilogue_all_fn(thud_world * world, const thud_contact * contacts, int count, void * context);
typedef void thud_object_epilogue_fn(thud_world * world, const thud_contact * contact, int side, void * context);
typedef _Bool thud_mover_pass_fn(const thud_mover * mover, const thud_mover_hit * hit, thud_vec2 velocity, void * context);
typedef _Bool thud_recording_sink_fn(const void * bytes, size_t count, void * context);
typedef void thud_chunk_fn(const char * name, thud_bytes bytes, void * context);
typedef void thud_played_call_fn(const thud_played_call * call, void * context);
typedef thud_result thud_rollback_step_fn(thud_world * world, const uint64_t * inputs, void * state);
typedef _Bool thud_filter_fn(const thud_world * world, thud_shape_id shape_a, thud_shape_id shape_b, void * context);
struct thud_vec2 { float x; float y; };
struct thud_pos { double x; double y; };
struct thud_body_id { uint32_t index1; uint32_t generation; };
struct thud_shape_id { uint32_t index1; uint32_t generation; };
struct thud_debug_draw { unsigned int flags; thud_pos origin; thud_pos lower; thud_pos upper; void * context; void (*circle)(thud_vec2, float, float, float, thud_style, int, void *); void (*box)(thud_vec2, thud_vec2, float, float, thud_style, int, void *); void (*line)(thud_vec2, thud_vec2, thud_style, void *); void (*point)(thud_vec2, thud_style, void *); };
struct thud_contact_event { thud_shape_id shape_a; thud_shape_id shape_b; };
struct thud_hit_event { thud_shape_id shape_a; thud_shape_id shape_b; thud_pos point; thud_vec2 normal; float speed; };
struct thud_events { const thud_contact_event * begin; const thud_contact_event * end; const thud_contact_event * sensor_begin; const thud_contact_event * sensor_end; const float * sensor_begin_time; const float * sensor_end_time; const thud_hit_event * hit; const thud_body_id * quarantined; int begin_count; int end_count; int sensor_begin_count; int sensor_end_count; int hit_count; int quarantined_count; };
struct thud_allocator { void *(*allocate)(size_t, void *); void (*release)(void *, size_t, void *); void * context; };
struct thud_job_system { thud_parallel_fn * run; void * context; int workers; const thud_shared_stages * stages; uint32_t share_from; };
struct thud_quality { const char * name; int substeps; float contact_stiffness; float contact_damping; const thud_detection * detection; const thud_island_solver * islands; float overlap_limit; int island_limit; int64_t island_work; int island_slow_steps; };
struct thud_geometry { thud_shape_kind kind; double x; double y; double c; double s; double hx; double hy; };
struct thud_segment { double x; double y; double dx; double dy; };
struct thud_motion { double dx; double dy; double turn; };
struct thud_closest { double distance; double nx; double ny; double ax; double ay; double bx; double by; };
struct thud_contacts { int count; thud_closest point[2]; };
struct thud_approach { _Bool hit; double time; double min_distance; double min_distance_time; };
struct thud_terrain { thud_terrain_kind kind; double slope; double x0; double spacing; const thud_pos * points; int count; };
struct thud_terrain_sample { double height; double nx; double ny; int segment; double weight[2]; };
struct thud_query_filter { uint32_t category; uint32_t mask; _Bool sensors; int32_t group; thud_body_id ignore; };
struct thud_ray { thud_pos origin; double dx; double dy; const thud_query_filter * filter; };
struct thud_shape_cast { thud_pos center; thud_geometry shape; double dx; double dy; const thud_query_filter * filter; };
struct thud_ray_hit { thud_shape_id shape; thud_pos point; thud_vec2 normal; double fraction; double depth; };
struct thud_closest_hit { thud_shape_id shape; thud_pos point; thud_vec2 normal; double distance; };
struct thud_manifold { thud_shape_id shape_a; thud_shape_id shape_b; thud_body_id body_a; thud_body_id body_b; thud_vec2 normal; int point_count; thud_pos point[2]; float separation[2]; float normal_impulse[2]; float tangent_impulse; _Bool direct; };
struct thud_uv { double u; double v; };
struct thud_foot { double height; double x; double nx; double ny; };
struct thud_contact { thud_shape_id shape_a; thud_shape_id shape_b; thud_body_id body_a; thud_body_id body_b; thud_vec2 normal; thud_pos point; float separation; float normal_impulse; float tangent_impulse; int point_count; };
struct thud_contact_settings { float friction; float restitution; float surface_speed; };
struct thud_world_def { thud_vec2 gravity; double time_step; float length_scale; const thud_quality * quality; int substeps; float contact_stiffness; float contact_damping; float push_speed; float restitution_threshold; float hit_speed; float maximum_speed; _Bool sleeping; _Bool contact_events; thud_allocator allocator; thud_log_fn * log; void * log_context; thud_clock_fn * clock; void * clock_context; double max_error; double time_budget; const thud_detection * detection; const thud_broadphase * broadphase; float cell_size; thud_job_system job_system; const thud_parts * parts; uint32_t cookie; };
struct thud_step_calls { thud_step_fn * before; thud_step_fn * after; void * context; };
struct thud_body_def { thud_body_kind kind; thud_pos position; double angle; thud_vec2 velocity; float angular_velocity; float gravity_scale; float linear_damping; float angular_damping; _Bool fixed_rotation; _Bool may_sleep; const thud_detection * detection; uint64_t user_data; uint32_t cookie; };
struct thud_body_state { thud_body_kind kind; thud_pos position; thud_pos center; double angle; float cosine; float sine; thud_vec2 velocity; float angular_velocity; float mass; float inertia; float gravity_scale; _Bool awake; _Bool enabled; _Bool quarantined; uint64_t user_data; int shape_count; };
struct thud_filter { uint32_t category; uint32_t mask; int32_t group; };
struct thud_shape_def { float density; float friction; float restitution; float surface_speed; thud_filter filter; _Bool sensor; _Bool events; uint64_t user_data; uint32_t cookie; };
struct thud_shape_state { thud_shape_kind kind; thud_body_id body; thud_vec2 offset; thud_vec2 half_extents; double angle; float density; float friction; float restitution; float surface_speed; thud_filter filter; _Bool sensor; _Bool events; uint64_t user_data; };
struct thud_pose { float x; float y; float c; float s; };
struct thud_stats { uint64_t steps; int bodies; int shapes; int awake_bodies; int pairs; int contacts; int colours; int blocks; int substeps; uint64_t bytes; uint64_t step_allocations; double stage_seconds[9]; double step_seconds; int direct_islands; int direct_bodies; int soft_islands; int factorings; int64_t island_work; int impacts; int held_bodies; double held_seconds; int unbisectable; int motion_pairs; int motion_circles; int motion_boxes; int motion_exact; };
struct thud_step_error { double penetration_max; double penetration_mean; double residual; double energy_change; double energy_decided; int overlaps; double shortfall; double joint_gap_max; double joint_gap_mean; double joint_angle_max; };
struct thud_measure { double penetration_max; double penetration_mean; double kinetic_energy; double potential_energy; };
struct thud_approximate_options { int shapes_max; thud_approximate_kind kinds; double distance; thud_allocator allocator; };
struct thud_approximation { int count; double missed; double extra; double overlap; double distance; };
struct thud_capsule { double x1; double y1; double x2; double y2; double radius; };
struct thud_body_shape { thud_geometry shape; const thud_shape_def * def; };
struct thud_mass { float mass; float inertia; thud_vec2 center; };
struct thud_explosion { thud_pos center; double radius; double falloff; float impulse; thud_cover cover; int rays; thud_query_filter filter; uint32_t cookie; };
struct thud_water { thud_pos point; thud_vec2 normal; float density; thud_vec2 flow; float linear_drag; float angular_drag; uint32_t cookie; };
struct thud_half_plane { double x; double y; double nx; double ny; };
struct thud_joint_id { uint32_t index1; uint32_t generation; };
struct thud_drive { _Bool limited; float lower; float upper; float frequency; float damping; float target; float spring_force; float motor_speed; float motor_force; };
struct thud_joint_frame { thud_vec2 position; double angle; };
struct thud_joint_def { thud_joint_kind kind; thud_body_id body_a; thud_body_id body_b; thud_joint_frame frame_a; thud_joint_frame frame_b; thud_drive drive[3]; float length; thud_joint_id gear[2]; float ratio; _Bool collide_connected; float break_force; float break_torque; _Bool only_reports; _Bool enabled; uint64_t user_data; uint32_t cookie; };
struct thud_drive_forces { float limit; float spring; float motor; };
struct thud_joint_state { thud_joint_kind kind; thud_body_id body_a; thud_body_id body_b; _Bool enabled; double value[3]; double gap; double angle_gap; thud_vec2 force; float torque; thud_drive_forces drive[3]; uint64_t user_data; };
struct thud_joint_event { thud_joint_id joint; thud_body_id body_a; thud_body_id body_b; uint64_t user_data; float force; float torque; _Bool broken; };
struct thud_contact_answer { thud_contact_settings settings; _Bool collide; };
struct thud_listeners { thud_prologue_fn * prologue; thud_epilogue_fn * epilogue; thud_prologue_all_fn * prologue_all; thud_epilogue_all_fn * epilogue_all; void * context; uint32_t without; };
struct thud_velocities { thud_vec2 velocity; float angular_velocity; };
struct thud_body_seen { thud_body_id body; int64_t x; int64_t y; int64_t angle; };
struct thud_pair_side { thud_body_id body; uint64_t body_data; uint64_t shape_data; _Bool sensor; };
struct thud_pair { thud_pair_side a; thud_pair_side b; };
struct thud_event_pair { thud_shape_id shape_a; thud_shape_id shape_b; thud_pair_side a; thud_pair_side b; int next; };
struct thud_body_options { thud_body_kind kind; thud_vec2 velocity; float angular_velocity; float linear_damping; float angular_damping; _Bool weightless; _Bool fixed_rotation; const thud_detection * detection; float density; float friction; _Bool frictionless; float restitution; float surface_speed; uint32_t category; uint32_t mask; int32_t group; _Bool sensor; uint64_t user_data; };
struct thud_minkowski { int count; thud_pos vertices[8]; thud_pos normals[4]; double offsets[4]; double radius; };
struct thud_mover_hit { thud_shape_id shape; thud_body_id body; thud_pos point; thud_vec2 normal; double depth; uint32_t category; };
struct thud_one_way { uint32_t categories; _Bool drop; };
struct thud_mover { thud_geometry shape; thud_vec2 up; double skin; double max_slope; double step_height; double snap_distance; double push_force; thud_body_id body; thud_query_filter filter; thud_mover_pass_fn * pass; void * context; _Bool on_ground; thud_vec2 ground_normal; thud_shape_id ground_shape; thud_body_id ground_body; thud_pos ground_point; thud_pos ground_place; float ground_cosine; float ground_sine; };
struct thud_mover_report { thud_vec2 velocity; thud_vec2 ground_velocity; double depth; int hit_count; thud_mover_hit hits[8]; int sensor_count; thud_shape_id sensors[16]; };
struct thud_bytes { const void * data; size_t count; };
struct thud_prediction { thud_body_id body; thud_pos position; double angle; thud_vec2 velocity; float angular_velocity; double seconds; thud_shape_id met; };
struct thud_step_settings { thud_vec2 gravity; double time_step; double max_error; int substeps; _Bool sleeping; thud_quality quality; };
struct thud_broadphase_counts { int moved; int64_t tested; int64_t found; int64_t sort_moves; int cells; int cell_shapes; int cell_shapes_max; };
struct thud_recorder_options { int hash_steps; _Bool body_hashes; int keyframe_steps; int ring_steps; thud_recording_sink_fn * sink; void * context; _Bool queries; };
struct thud_call_value { double number; _Bool handle; };
struct thud_played_call { const char * name; thud_result result; const thud_call_value * values; int value_count; uint32_t returned; _Bool query; const thud_ray_hit * hits; int hit_count; };
struct thud_player_options { thud_allocator allocator; thud_log_fn * log; void * log_context; thud_job_system job_system; thud_chunk_fn * chunk; thud_played_call_fn * call; void * context; thud_clock_fn * clock; void * clock_context; };
struct thud_player_progress { int64_t first; int64_t end; int64_t steps; int64_t hashes; _Bool differs; int64_t differs_after; int64_t differs_at; thud_body_id body; };
struct thud_rollback_options { int players; int depth; int budget; uint64_t idle; thud_rollback_step_fn * step; void * state; size_t state_bytes; };
struct thud_rollback_progress { int64_t steps; int64_t confirmed; int64_t replayed; int64_t settled; double ahead; };
struct thud_rollback_difference { int64_t step; _Bool is_detailed; thud_body_id body; int body_slot; int bodies; int player; };
struct thud_rule { thud_rule_kind kind; thud_vec2 solid_side; float friction; float restitution; float surface_speed; float event_impulse; };
struct thud_impulse_event { thud_shape_id shape_a; thud_shape_id shape_b; thud_pos point; thud_vec2 normal; float impulse; };
struct thud_texture { const double * vertices; int count; const float * table; int table_count; _Bool repeats; };
extern const thud_broadphase thud_broadphase_grid;
extern const thud_broadphase thud_broadphase_sweep;
extern const thud_broadphase thud_broadphase_sweep_y;
extern const thud_broadphase thud_broadphase_sweep_widest;
extern const thud_broadphase thud_broadphase_sweep_both;
extern const thud_broadphase thud_broadphase_all;
extern const thud_detection thud_detection_overlap;
extern const thud_detection thud_detection_continuous;
extern const thud_detection thud_detection_bisect;
extern const thud_detection thud_detection_swept;
extern const thud_shared_stages thud_shared_stages_all;
extern const thud_island_solver thud_islands_direct;
extern const thud_quality thud_quality_draft;
extern const thud_quality thud_quality_default;
extern const thud_quality thud_quality_high;
extern const thud_quality thud_quality_exact;
const char * thud_result_text(thud_result result);
thud_result thud_sincos(double angle, double * out_sine, double * out_cosine);
thud_result thud_angle_of(double sine, double cosine, double * out_angle);
const char * thud_broadphase_name(const thud_broadphase * broadphase);
const char * thud_detection_name(const thud_detection * detection);
thud_result thud_world_draw(thud_world * world, const thud_debug_draw * draw);
thud_result thud_world_get_events(const thud_world * world, thud_events * out);
void thud_log_to_stderr(thud_result result, const char * message, void * context);
thud_result thud_geometry_check(const thud_geometry * shape);
_Bool thud_geometry_overlap(const thud_geometry * a, const thud_geometry * b);
thud_result thud_geometry_closest(const thud_geometry * a, const thud_geometry * b, thud_closest * out);
thud_result thud_geometry_contacts(const thud_geometry * a, const thud_geometry * b, double margin, thud_contacts * out);
_Bool thud_geometry_cast_ray(const thud_geometry * shape, thud_segment ray, double * out_fraction, double * out_nx, double * out_ny);
thud_result thud_geometry_time_of_impact(const thud_geometry * a, thud_motion motion_a, const thud_geometry * b, thud_motion motion_b, double target, _Bool * out_hit, double * out_time);
thud_result thud_geometry_approach(const thud_geometry * a, thud_motion motion_a, const thud_geometry * b, thud_motion motion_b, thud_approach * out);
thud_result thud_geometry_time_of_collision(const thud_geometry * a, thud_motion motion_a, const thud_geometry * b, thud_motion motion_b, double tolerance, _Bool * out_collided, double * out_time);
_Bool thud_geometry_is_bisectable(const thud_geometry * a, thud_motion motion_a, const thud_geometry * b, thud_motion motion_b);
thud_result thud_terrain_check(const thud_terrain * terrain);
thud_result thud_terrain_sample_at(const thud_terrain * terrain, double x, thud_terrain_sample * out);
void thud_terrain_segments(const thud_terrain * terrain, double x_min, double x_max, int * out_first, int * out_last);
_Bool thud_terrain_cast_ray(const thud_terrain * terrain, thud_segment ray, double * out_fraction, double * out_nx, double * out_ny);
_Bool thud_terrain_overlap(const thud_terrain * terrain, const thud_geometry * shape);
thud_result thud_terrain_closest(const thud_terrain * terrain, const thud_geometry * shape, thud_closest * out);
thud_result thud_terrain_contacts(const thud_terrain * terrain, const thud_geometry * shape, double margin, thud_contacts * out);
thud_result thud_terrain_time_of_impact(const thud_terrain * terrain, const thud_geometry * shape, thud_motion motion, double target, _Bool * out_hit, double * out_time);
thud_result thud_terrain_time_of_collision(const thud_terrain * terrain, const thud_geometry * shape, thud_motion motion, double tolerance, _Bool * out_collided, double * out_time);
thud_result thud_volume_check(const thud_volume * volume);
thud_result thud_volume_around_shape(thud_shape_kind kind, const thud_geometry * shape, thud_volume * out);
thud_result thud_volume_around_motion(thud_shape_kind kind, const thud_geometry * shape, thud_motion motion, thud_volume * out);
thud_result thud_volume_around_points(thud_shape_kind kind, const thud_pos * points, int count, thud_volume * out);
thud_result thud_volume_around_terrain(thud_shape_kind kind, const thud_terrain * terrain, double x_min, double x_max, thud_volume * out);
thud_result thud_volume_merge(thud_shape_kind kind, const thud_volume * a, const thud_volume * b, thud_volume * out);
thud_result thud_volumes_overlap(const thud_volume * a, const thud_volume * b, _Bool * out_overlap);
thud_result thud_volume_contains_point(const thud_volume * volume, double x, double y, _Bool * out_inside);
thud_result thud_volume_contains(const thud_volume * outer, const thud_volume * inner, _Bool * out_inside);
thud_query_filter thud_default_query_filter(void);
thud_result thud_world_cast_ray(thud_world * world, const thud_ray * ray, _Bool * out_hit, thud_ray_hit * out);
thud_result thud_world_cast_ray_all(thud_world * world, const thud_ray * ray, thud_ray_hit * out, int capacity, int * out_count);
thud_result thud_world_cast_shape(thud_world * world, const thud_shape_cast * cast, _Bool * out_hit, thud_ray_hit * out);
thud_result thud_world_cast_shape_all(thud_world * world, const thud_shape_cast * cast, thud_ray_hit * out, int capacity, int * out_count);
thud_result thud_world_overlap_shape(thud_world * world, thud_pos center, thud_geometry shape, const thud_query_filter * filter, thud_overlap_fn * fn, void * context);
thud_result thud_world_overlap_aabb(thud_world * world, thud_pos lower, thud_pos upper, const thud_query_filter * filter, thud_overlap_fn * fn, void * context);
thud_result thud_world_closest(thud_world * world, thud_pos point, double max_distance, const thud_query_filter * filter, _Bool * out_found, thud_closest_hit * out);
thud_result thud_body_get_volume(thud_world * world, thud_body_id body, thud_shape_kind kind, thud_pos origin, thud_volume * out);
thud_result thud_body_get_contacts(thud_world * world, thud_body_id body, thud_manifold * out, int capacity, int * out_count);
thud_result thud_terrain_texture_at(const thud_terrain_sample * sample, const thud_uv * vertices, int count, thud_uv * out);
thud_result thud_terrain_place_foot(const thud_terrain * terrain, double x, double width, thud_foot * out);
thud_result thud_shape_set_heights(thud_world * world, thud_shape_id shape, int first, const double * heights, int count);
thud_result thud_shape_dig(thud_world * world, thud_shape_id shape, thud_pos center, double radius);
thud_result thud_shape_raise(thud_world * world, thud_shape_id shape, double x, double radius, double height);
thud_result thud_shape_replace_range(thud_world * world, thud_shape_id shape, double x0, double x1, const thud_pos * points, int count);
thud_world_def thud_default_world_def(void);
thud_world_def thud_default_world_def_of(const thud_quality * quality);
thud_world_def thud_default_small_world_def(const thud_quality * quality);
thud_result thud_world_create(const thud_world_def * def, thud_world ** out);
void thud_world_destroy(thud_world * world);
thud_result thud_world_step(thud_world * world);
thud_result thud_world_advance(thud_world * world, double elapsed, int max_steps, int * out_steps, double * out_alpha);
thud_result thud_world_advance_with(thud_world * world, double elapsed, int max_steps, const thud_step_calls * calls, int * out_steps, double * out_alpha);
thud_result thud_world_set_log(thud_world * world, thud_log_fn * log, void * context);
thud_result thud_world_set_gravity(thud_world * world, thud_vec2 gravity);
thud_result thud_world_set_time_step(thud_world * world, double time_step);
thud_result thud_world_set_max_error(thud_world * world, double max_error);
thud_result thud_world_set_quality(thud_world * world, const thud_quality * quality);
thud_result thud_world_set_sleeping(thud_world * world, _Bool sleeping);
thud_body_def thud_default_body_def(void);
thud_result thud_body_create(thud_world * world, const thud_body_def * def, thud_body_id * out);
thud_result thud_body_destroy(thud_world * world, thud_body_id body);
_Bool thud_body_is_valid(const thud_world * world, thud_body_id body);
thud_result thud_body_get_state(const thud_world * world, thud_body_id body, thud_body_state * out);
thud_result thud_body_set_transform(thud_world * world, thud_body_id body, thud_pos position, double angle);
thud_result thud_body_set_velocity(thud_world * world, thud_body_id body, thud_vec2 velocity, float angular_velocity);
thud_result thud_body_apply_impulse(thud_world * world, thud_body_id body, thud_vec2 impulse, thud_pos point);
thud_result thud_body_apply_center_force(thud_world * world, thud_body_id body, thud_vec2 force);
thud_result thud_body_apply_torque(thud_world * world, thud_body_id body, float torque);
thud_result thud_body_set_awake(thud_world * world, thud_body_id body, _Bool awake);
thud_result thud_body_set_enabled(thud_world * world, thud_body_id body, _Bool enabled);
thud_result thud_body_set_user_data(thud_world * world, thud_body_id body, uint64_t user_data);
thud_result thud_body_get_shapes(const thud_world * world, thud_body_id body, thud_shape_id * out, int capacity, int * out_count);
thud_shape_def thud_default_shape_def(void);
thud_result thud_shape_create_circle(thud_world * world, thud_body_id body, const thud_shape_def * def, thud_vec2 offset, float radius, thud_shape_id * out);
thud_result thud_shape_create_aabb(thud_world * world, thud_body_id body, const thud_shape_def * def, thud_vec2 offset, thud_vec2 half_extents, thud_shape_id * out);
thud_result thud_shape_create_obb(thud_world * world, thud_body_id body, const thud_shape_def * def, thud_vec2 offset, thud_vec2 half_extents, double angle, thud_shape_id * out);
thud_result thud_shape_create_terrain(thud_world * world, thud_body_id body, const thud_shape_def * def, const thud_terrain * terrain, thud_shape_id * out);
thud_result thud_shape_destroy(thud_world * world, thud_shape_id shape);
_Bool thud_shape_is_valid(const thud_world * world, thud_shape_id shape);
thud_result thud_shape_get_state(const thud_world * world, thud_shape_id shape, thud_shape_state * out);
thud_result thud_shape_get_terrain(const thud_world * world, thud_shape_id shape, thud_terrain * out);
thud_result thud_world_get_poses(thud_world * world, thud_pos origin, double alpha, const thud_pose ** out, int * out_count);
const char * thud_stage_name(thud_stage stage);
thud_result thud_world_get_stats(const thud_world * world, thud_stats * out);
thud_result thud_world_get_bisection_limit(thud_world * world, double * out_speed);
thud_result thud_world_use_step_error(thud_world * world);
thud_result thud_world_get_step_error(const thud_world * world, thud_step_error * out);
thud_result thud_world_get_measure(const thud_world * world, thud_measure * out);
thud_result thud_world_get_hash(const thud_world * world, uint64_t * out);
thud_result thud_polygon_check(const thud_pos * points, int count, const char ** out_reason);
thud_result thud_approximate(const thud_pos * points, int count, const thud_approximate_options * options, thud_geometry * out_shapes, thud_approximation * out);
thud_result thud_capsule_check(const thud_capsule * capsule);
thud_result thud_capsule_of_motion(const thud_geometry * circle, thud_motion motion, thud_capsule * out);
thud_result thud_capsule_closest(const thud_capsule * a, const thud_geometry * b, thud_closest * out);
thud_result thud_capsules_closest(const thud_capsule * a, const thud_capsule * b, thud_closest * out);
thud_result thud_terrain_capsule_closest(const thud_terrain * terrain, const thud_capsule * capsule, thud_closest * out);
thud_result thud_capsule_time_of_impact(const thud_capsule * a, thud_motion motion_a, const thud_geometry * b, thud_motion motion_b, double target, _Bool * out_hit, double * out_time);
thud_result thud_capsules_time_of_impact(const thud_capsule * a, thud_motion motion_a, const thud_capsule * b, thud_motion motion_b, double target, _Bool * out_hit, double * out_time);
thud_result thud_terrain_capsule_time_of_impact(const thud_terrain * terrain, const thud_capsule * capsule, thud_motion motion, double target, _Bool * out_hit, double * out_time);
thud_result thud_world_cast_ray_each(thud_world * world, const thud_ray * ray, thud_cast_fn * fn, void * context);
thud_result thud_world_cast_shape_each(thud_world * world, const thud_shape_cast * cast, thud_cast_fn * fn, void * context);
thud_result thud_world_cast_rays(thud_world * world, const thud_ray * rays, int count, thud_ray_hit * out_hits);
thud_result thud_world_cast_shapes(thud_world * world, const thud_shape_cast * casts, int count, thud_ray_hit * out_hits);
thud_result thud_shape_cast_ray(thud_world * world, thud_shape_id shape, thud_pos origin, double dx, double dy, _Bool * out_hit, thud_ray_hit * out);
thud_result thud_shape_contains_point(thud_world * world, thud_shape_id shape, thud_pos point, _Bool * out_inside);
thud_result thud_shape_closest_point(thud_world * world, thud_shape_id shape, thud_pos point, thud_closest_hit * out);
thud_result thud_shape_get_bounds(thud_world * world, thud_shape_id shape, thud_pos * out_lower, thud_pos * out_upper);
thud_result thud_body_create_with_shapes(thud_world * world, const thud_body_def * def, const thud_body_shape * shapes, int count, thud_body_id * out_body, thud_shape_id * out_shape_ids);
thud_result thud_shape_set_filter(thud_world * world, thud_shape_id shape, thud_filter filter);
thud_result thud_shape_set_friction(thud_world * world, thud_shape_id shape, float friction);
thud_result thud_shape_set_restitution(thud_world * world, thud_shape_id shape, float restitution);
thud_result thud_shape_set_surface_speed(thud_world * world, thud_shape_id shape, float surface_speed);
thud_result thud_shape_set_density(thud_world * world, thud_shape_id shape, float density);
thud_result thud_shape_set_sensor(thud_world * world, thud_shape_id shape, _Bool sensor);
thud_result thud_shape_set_radius(thud_world * world, thud_shape_id shape, float radius);
thud_result thud_shape_set_half_extents(thud_world * world, thud_shape_id shape, thud_vec2 half_extents);
thud_result thud_shape_set_events(thud_world * world, thud_shape_id shape, _Bool events);
thud_result thud_shape_set_user_data(thud_world * world, thud_shape_id shape, uint64_t user_data);
thud_result thud_body_set_kind(thud_world * world, thud_body_id body, thud_body_kind kind);
thud_result thud_body_set_damping(thud_world * world, thud_body_id body, float linear, float angular);
thud_result thud_body_set_gravity_scale(thud_world * world, thud_body_id body, float gravity_scale);
thud_result thud_body_set_fixed_rotation(thud_world * world, thud_body_id body, _Bool fixed);
thud_result thud_body_set_detection(thud_world * world, thud_body_id body, const thud_detection * detection);
thud_result thud_body_set_may_sleep(thud_world * world, thud_body_id body, _Bool may_sleep);
thud_result thud_body_set_mass(thud_world * world, thud_body_id body, const thud_mass * mass);
thud_result thud_body_apply_force(thud_world * world, thud_body_id body, thud_vec2 force, thud_pos point);
thud_result thud_body_apply_center_impulse(thud_world * world, thud_body_id body, thud_vec2 impulse);
thud_result thud_body_apply_angular_impulse(thud_world * world, thud_body_id body, float impulse);
thud_result thud_body_set_target(thud_world * world, thud_body_id body, thud_pos position, double angle);
thud_result thud_body_get_velocity_at(const thud_world * world, thud_body_id body, thud_pos point, thud_vec2 * out);
thud_result thud_body_get_world_point(const thud_world * world, thud_body_id body, thud_vec2 point, thud_pos * out);
thud_result thud_body_get_local_point(const thud_world * world, thud_body_id body, thud_pos point, thud_vec2 * out);
thud_result thud_body_get_world_vector(const thud_world * world, thud_body_id body, thud_vec2 vector, thud_vec2 * out);
thud_result thud_body_get_local_vector(const thud_world * world, thud_body_id body, thud_vec2 vector, thud_vec2 * out);
thud_explosion thud_default_explosion(void);
thud_result thud_world_explode(thud_world * world, const thud_explosion * explosion, int * out_pushed);
thud_result thud_body_apply_wind(thud_world * world, thud_body_id body, thud_vec2 wind, float density, float drag, float lift);
thud_water thud_default_water(void);
thud_result thud_body_apply_buoyancy(thud_world * world, thud_body_id body, const thud_water * water);
thud_result thud_geometry_area_below(const thud_geometry * shape, thud_half_plane below, double * out_area, double * out_center_x, double * out_center_y);
thud_result thud_body_apply_rolling_resistance(thud_world * world, thud_body_id body, float coefficient);
thud_result thud_body_apply_grip(thud_world * world, thud_body_id body, thud_vec2 point, thud_vec2 axis, float speed, float max_force);
thud_joint_def thud_default_joint_def(thud_joint_kind kind);
thud_result thud_joint_create(thud_world * world, const thud_joint_def * def, thud_joint_id * out);
thud_result thud_joint_destroy(thud_world * world, thud_joint_id joint);
_Bool thud_joint_is_valid(const thud_world * world, thud_joint_id joint);
thud_result thud_joint_get_state(const thud_world * world, thud_joint_id joint, thud_joint_state * out);
thud_result thud_joint_get_def(const thud_world * world, thud_joint_id joint, thud_joint_def * out);
thud_result thud_joint_set_drive(thud_world * world, thud_joint_id joint, thud_direction direction, const thud_drive * drive);
thud_result thud_joint_set_length(thud_world * world, thud_joint_id joint, float length);
thud_result thud_joint_set_enabled(thud_world * world, thud_joint_id joint, _Bool enabled);
thud_result thud_joint_set_frame(thud_world * world, thud_joint_id joint, int side, thud_joint_frame frame);
thud_result thud_joint_set_breaking(thud_world * world, thud_joint_id joint, float force, float torque, _Bool only_reports);
thud_result thud_joint_set_user_data(thud_world * world, thud_joint_id joint, uint64_t user_data);
thud_result thud_world_get_joint_events(const thud_world * world, const thud_joint_event ** out, int * out_count);
thud_result thud_world_get_joints(const thud_world * world, thud_joint_id * out, int capacity, int * out_count);
thud_result thud_body_get_joints(const thud_world * world, thud_body_id body, thud_joint_id * out, int capacity, int * out_count);
thud_result thud_world_use_joints(thud_world * world);
thud_joint_def thud_hinge_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos point);
thud_joint_def thud_weld_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos point);
thud_joint_def thud_slider_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos point, thud_vec2 axis);
thud_joint_def thud_wheel_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos point, thud_vec2 axis);
thud_joint_def thud_target_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos point);
thud_joint_def thud_rod_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos from, thud_pos to);
thud_joint_def thud_rope_at(const thud_world * world, thud_body_id body_a, thud_body_id body_b, thud_pos from, thud_pos to, float length);
thud_joint_id thud_joint_make(thud_world * world, thud_joint_def def);
thud_result thud_world_set_listeners(thud_world * world, const thud_listeners * listeners);
thud_result thud_body_set_epilogue(thud_world * world, thud_body_id body, thud_object_epilogue_fn * epilogue, void * context);
thud_result thud_world_set_category_epilogue(thud_world * world, uint32_t categories, thud_object_epilogue_fn * epilogue, void * context);
thud_result thud_contact_decide(thud_world * world, const thud_contact * contact, const thud_velocities * a, const thud_velocities * b);
thud_result thud_world_get_bodies(const thud_world * world, thud_body_id * out, int capacity, int * out_count);
thud_result thud_world_get_awake_bodies(const thud_world * world, thud_body_id * out, int capacity, int * out_count);
thud_result thud_world_get_shapes(const thud_world * world, thud_shape_id * out, int capacity, int * out_count);
thud_result thud_world_get_slot_counts(const thud_world * world, int * out_bodies, int * out_shapes);
thud_result thud_world_get_body_at(const thud_world * world, int slot, thud_body_id * out);
thud_result thud_world_get_shape_at(const thud_world * world, int slot, thud_shape_id * out);
thud_result thud_world_get_moved_bodies(const thud_world * world, thud_body_seen * seen, int slots, thud_body_id * out, int capacity, int * out_count);
thud_result thud_shape_get_sensor_overlaps(const thud_world * world, thud_shape_id sensor, thud_shape_id * out, int capacity, int * out_count);
thud_result thud_world_get_pair(const thud_world * world, thud_shape_id shape_a, thud_shape_id shape_b, thud_pair * out);
_Bool thud_world_next_event_pair(const thud_world * world, uint32_t first, uint32_t second, thud_event_pair * pair);
thud_result thud_body_set_locks(thud_world * world, thud_body_id body, _Bool x, _Bool y);
thud_result thud_body_get_locks(const thud_world * world, thud_body_id body, _Bool * out_x, _Bool * out_y);
thud_world * thud_world_make(thud_vec2 gravity, const thud_quality * quality);
thud_body_id thud_body_make(thud_world * world, thud_geometry shape, const thud_body_options * options);
thud_result thud_minkowski_sum(const thud_geometry * a, const thud_geometry * b, thud_minkowski * out);
thud_result thud_minkowski_contains(const thud_minkowski * sum, double x, double y, _Bool * out_inside);
thud_result thud_minkowski_distance(const thud_minkowski * sum, double x, double y, double * out_distance, double * out_nx, double * out_ny);
thud_result thud_minkowski_cast(const thud_minkowski * sum, thud_segment path, _Bool * out_hit, double * out_fraction, double * out_nx, double * out_ny);
_Bool thud_mover_passes_one_way(const thud_mover * mover, const thud_mover_hit * hit, thud_vec2 velocity, void * context);
thud_mover thud_default_mover(thud_geometry shape);
thud_result thud_mover_move(thud_world * world, thud_mover * mover, thud_vec2 velocity, double dt, thud_mover_report * out_report);
thud_result thud_world_pack(const thud_world * world, thud_bytes base, thud_bytes snapshot, void * buffer, size_t capacity, size_t * out_bytes);
thud_result thud_world_unpack(const thud_world * world, thud_bytes base, thud_bytes packed, void * buffer, size_t capacity, size_t * out_bytes);
thud_result thud_world_extrapolate(const thud_world * world, const thud_body_id * bodies, int count, double seconds, thud_prediction * out);
thud_result thud_world_extrapolate_awake(const thud_world * world, double seconds, thud_prediction * out, int capacity, int * out_count);
thud_result thud_world_predict(thud_world * world, const thud_body_id * bodies, int count, double seconds, thud_prediction * out);
thud_result thud_body_get_position(const thud_world * world, thud_body_id body, thud_pos * out_position);
thud_result thud_body_get_rotation(const thud_world * world, thud_body_id body, double * out_angle, float * out_cosine, float * out_sine);
thud_result thud_body_get_velocity(const thud_world * world, thud_body_id body, thud_vec2 * out_velocity, float * out_angular_velocity);
thud_result thud_body_get_user_data(const thud_world * world, thud_body_id body, uint64_t * out_user_data);
thud_result thud_shape_get_user_data(const thud_world * world, thud_shape_id shape, uint64_t * out_user_data);
thud_result thud_shape_get_body(const thud_world * world, thud_shape_id shape, thud_body_id * out_body);
thud_result thud_world_get_step_settings(const thud_world * world, thud_step_settings * out);
thud_result thud_world_get_broadphase_counts(const thud_world * world, thud_broadphase_counts * out);
thud_result thud_recorder_begin(thud_world * world, const thud_recorder_options * options, thud_recorder ** out);
void thud_recorder_end(thud_recorder * recorder);
thud_result thud_recorder_get_bytes(thud_recorder * recorder, thud_bytes * out);
thud_result thud_recorder_salvage(thud_recorder * recorder, thud_bytes * out);
thud_result thud_recorder_add_chunk(thud_recorder * recorder, const char * name, thud_bytes bytes);
thud_result thud_player_create(thud_bytes recording, const thud_player_options * options, thud_player ** out);
void thud_player_destroy(thud_player * player);
thud_result thud_player_step(thud_player * player, _Bool * out_stepped);
thud_result thud_player_seek(thud_player * player, int64_t step);
thud_result thud_player_get_keyframe(const thud_player * player, int64_t step, int64_t * out_step);
thud_result thud_player_get_world(thud_player * player, thud_world ** out);
thud_result thud_player_get_progress(const thud_player * player, thud_player_progress * out);
thud_result thud_rollback_create(thud_world * world, const thud_rollback_options * options, thud_rollback ** out);
void thud_rollback_destroy(thud_rollback * rollback);
thud_result thud_rollback_input(thud_rollback * rollback, int player, int64_t step, uint64_t input);
thud_result thud_rollback_advance(thud_rollback * rollback, _Bool * out_made);
thud_result thud_rollback_settle(thud_rollback * rollback);
thud_result thud_rollback_get_progress(const thud_rollback * rollback, thud_rollback_progress * out);
thud_result thud_rollback_get_state(thud_rollback * rollback, int64_t step, uint64_t * out_hash, void * out_state);
thud_result thud_rollback_report(thud_rollback * rollback, int64_t step, void * buffer, size_t capacity, size_t * out_bytes);
thud_result thud_rollback_compare(thud_rollback * rollback, const void * report, size_t bytes, thud_rollback_difference * out);
thud_result thud_rollback_get_lead(const thud_rollback * rollback, int player, int64_t * out_lead);
thud_result thud_rollback_set_lead(thud_rollback * rollback, int player, int64_t lead);
thud_result thud_rollback_leave(thud_rollback * rollback, int player, int64_t step);
thud_result thud_rollback_enter(thud_rollback * rollback, int player, int64_t step);
thud_result thud_rollback_snapshot(thud_rollback * rollback, void * buffer, size_t capacity, size_t * out_bytes);
thud_result thud_rollback_restore(thud_rollback * rollback, const void * buffer, size_t bytes);
thud_rule thud_default_rule(void);
thud_result thud_world_set_rule(thud_world * world, uint32_t first, uint32_t second, const thud_rule * rule);
thud_result thud_world_get_rule(const thud_world * world, uint32_t first, uint32_t second, thud_rule * out, _Bool * out_is_set, _Bool * out_reversed);
thud_result thud_world_use_rules(thud_world * world);
thud_result thud_world_set_filter(thud_world * world, thud_filter_fn * filter, void * context);
thud_result thud_world_get_impulse_events(const thud_world * world, const thud_impulse_event ** out, int * out_count);
thud_result thud_world_get_snapshot_size(const thud_world * world, size_t * out_bytes);
thud_result thud_world_snapshot(const thud_world * world, void * buffer, size_t capacity, size_t * out_bytes);
thud_result thud_world_restore(thud_world * world, const void * buffer, size_t bytes);
thud_result thud_world_save(thud_world * world, const char * path, const void * own, size_t bytes);
thud_result thud_world_load(thud_world * world, const char * path, void * out_own, size_t bytes);
thud_result thud_world_def_set_baseline_simd(thud_world_def * def, _Bool baseline_simd);
thud_result thud_texture_friction_at(const thud_texture * texture, const thud_terrain_sample * sample, float * out);
thud_result thud_shape_set_texture(thud_world * world, thud_shape_id shape, const thud_texture * texture);
thud_result thud_shape_get_texture(const thud_world * world, thud_shape_id shape, thud_texture * out);
thud_result thud_shape_get_friction_at(const thud_world * world, thud_shape_id shape, double x, float * out);
thud_result thud_world_use_textures(thud_world * world);
thud_result thud_threads_create(int workers, const thud_allocator * allocator, thud_threads ** out);
thud_result thud_threads_destroy(thud_threads * threads);
thud_result thud_threads_get_job_system(thud_threads * threads, thud_job_system * out);
int thud_version(void);
]]
thud.constants = {
    CAST_IGNORE = -1.0,
    CAST_END = 0.0,
    CAST_ON = 1.0,
    LENGTH_SCALE_MIN = 1e-06,
    LENGTH_SCALE_MAX = 1000000.0,
    TIME_STEP_MAX = 1.0,
    ADVANCE_MAX = 1000000000.0,
    AHEAD_MAX = 60.0,
    TIME_BUDGET_MAX = 1.0,
    MAX_ERROR_MAX = 1000000000.0,
    SPEED_MAX = 1000000.0,
    SUBSTEPS_MAX = 64,
    CONTACT_STIFFNESS_MIN = 0.01,
    CONTACT_STIFFNESS_MAX = 0.5,
    CONTACT_DAMPING_MAX = 100.0,
    ISLAND_LIMIT_MAX = 16384,
    ISLAND_SLOW_STEPS_MAX = 1000,
    WORKERS_MAX = 64,
    PLACE_MAX = 1000000000.0,
    ANGLE_MAX = 1000000.0,
    ANGULAR_SPEED_MAX = 100000000.0,
    SIZE_MIN = 0.0001,
    SIZE_MAX = 16384.0,
    STATIC_SIZE_MAX = 32000.0,
    DENSITY_MAX = 1000000000000.0,
    FRICTION_MAX = 1000000.0,
    RESTITUTION_MAX = 1.0,
    PAIR_RESTITUTION_MAX = 4.0,
    SURFACE_SPEED_MAX = 1000000.0,
    MASS_MIN = 1e-30,
    MASS_MAX = 1e+30,
    FORCE_MAX = 1e+30,
    DRAG_MAX = 1000000.0,
    FLOW_MAX = 1000000.0,
    FLUID_DENSITY_MAX = 1000000000000.0,
    EXPLOSION_MAX = 1000000000000000.0,
    EXPLOSION_RAYS_MAX = 16,
    JOINT_LENGTH_MAX = 1000000.0,
    JOINT_ANGLE_MAX = 3.1415927,
    JOINT_ANGULAR_SPEED_MAX = 1000000.0,
    JOINT_FREQUENCY_MAX = 10000.0,
    JOINT_DAMPING_MAX = 1000.0,
    JOINT_FORCE_MAX = 1e+30,
    GEAR_RATIO_MIN = 0.0001,
    GEAR_RATIO_MAX = 10000.0,
    MOVER_SLOPE_MAX = 1.55,
    MOVER_STEP_MAX = 1000000.0,
    MOVER_DISTANCE_MAX = 1000000.0,
    MOVER_FORCE_MAX = 1e+30,
    ROLLBACK_PLAYERS_MAX = 64,
    ROLLBACK_DEPTH_MAX = 1000,
    RECORDING_STEPS_MAX = 1000000000,
    COORDINATE_MAX = 2000000000000000.0,
    VOLUME_MAX = 1e+16,
    TOLERANCE_MIN = 1e-15,
    POLYGON_PLACE_MAX = 1000000000000.0,
    POLYGON_POINTS_MAX = 256,
    POLYGON_AREA_MIN = 0.001,
    APPROXIMATE_SHAPES_MAX = 64,
    UNIT_ERROR = 1e-05,
    NORMAL_ERROR = 0.001,
    TERRAIN_SLOPE_MAX = 100.0,
    TERRAIN_PLACE_MAX = 1000000000.0,
    TERRAIN_COUNT_MAX = 100000000,
    MINKOWSKI_VERTICES_MAX = 8,
    PREDICTION_CHORDS_MAX = 256,
    VERSION_MAJOR = 0,
    VERSION_MINOR = 2,
    VERSION_PATCH = 0,
    VERSION = 2000,
    DRAW_SHAPES = 1,
    DRAW_SHAPE_BOUNDS = 2,
    DRAW_CELLS = 4,
    DRAW_CONTACTS = 8,
    DRAW_ISLANDS = 16,
    DRAW_AXES = 32,
    DRAW_PAIRS = 64,
    DRAW_MOTIONS = 128,
    DRAW_STAGES = 256,
    DRAW_COLOURS = 512,
    DRAW_MANIFOLDS = 1024,
    DRAW_JOINTS = 2048,
    DRAW_JOINT_FORCES = 4096,
    SHAPE_KIND_COUNT = 4,
    MOVER_HITS = 8,
    MOVER_SENSORS = 16,
    RECORDED_FOUND_MAX = 64,
    RULE_KIND_COUNT = 3,
}
local ENUMS = {
    thud_result = { ok = 0, error_null = 1, error_invalid = 2, error_stale = 3, error_memory = 4, error_locked = 5 },
    thud_style = { static = 0, kinematic = 1, dynamic = 2, sleeping = 3, sensor = 4, bounds = 5, cell = 6, contact = 7, normal = 8, interval = 9, interval_overlapping = 10, pair = 11, pair_touching = 12, motion = 13, pair_candidate = 14, direct = 15, manifold = 16, depth = 17, impulse = 18, colour = 19, colour_last = 34, joint = 35, joint_axis = 36, joint_limit = 37, joint_force = 38 },
    thud_shape_kind = { circle = 0, aabb = 1, obb = 2, terrain = 3 },
    thud_terrain_kind = { flat = 0, uniform = 1, irregular = 2 },
    thud_body_kind = { static = 0, kinematic = 1, dynamic = 2 },
    thud_stage = { changes = 0, broadphase = 1, narrowphase = 2, contacts = 3, solve = 4, finalize = 5, continuous = 6, events = 7, sleep = 8 },
    thud_approximate_kind = { both = 0, circles = 1, boxes = 2 },
    thud_cover = { none = 0, static = 1, all = 2 },
    thud_joint_kind = { distance = 0, hinge = 1, slider = 2, weld = 3, wheel = 4, target = 5, filter = 6, gear = 7 },
    thud_direction = { along = 0, across = 1, turn = 2 },
    thud_contact_part = { bodies = 1, point = 2 },
    thud_rule_kind = { collide = 0, ignore = 1, one_way = 2 },
}
thud.enums = ENUMS
local HANDLES = {
    thud_body_id = true, thud_shape_id = true, thud_joint_id = true
}
local DEFAULTS = {
    thud_query_filter = "thud_default_query_filter", thud_world_def = "thud_default_world_def",
    thud_body_def = "thud_default_body_def", thud_shape_def = "thud_default_shape_def", thud_explosion =
    "thud_default_explosion", thud_water = "thud_default_water", thud_rule = "thud_default_rule"
}
local OBJECTS = {
    thud_broadphase = { grid = "thud_broadphase_grid", sweep = "thud_broadphase_sweep", sweep_y = "thud_broadphase_sweep_y", sweep_widest = "thud_broadphase_sweep_widest", sweep_both = "thud_broadphase_sweep_both", all = "thud_broadphase_all" },
    thud_detection = { overlap = "thud_detection_overlap", continuous = "thud_detection_continuous", bisect = "thud_detection_bisect", swept = "thud_detection_swept" },
    thud_shared_stages = { stages_all = "thud_shared_stages_all" },
    thud_island_solver = { direct = "thud_islands_direct" },
    thud_quality = { draft = "thud_quality_draft", default = "thud_quality_default", high = "thud_quality_high", exact = "thud_quality_exact" },
}
local CALLBACKS = {
    thud_log_fn = "void", thud_clock_fn = "double", thud_task_fn = "void", thud_parallel_fn = "void",
    thud_overlap_fn = "_Bool", thud_step_fn = "void", thud_cast_fn = "double", thud_prologue_fn = "_Bool",
    thud_epilogue_fn = "void", thud_prologue_all_fn = "void", thud_epilogue_all_fn = "void",
    thud_object_epilogue_fn = "void", thud_mover_pass_fn = "_Bool", thud_recording_sink_fn = "_Bool",
    thud_chunk_fn = "void", thud_played_call_fn = "void", thud_rollback_step_fn = "thud_result",
    thud_filter_fn = "_Bool"
}
local FIELDS = {
    thud_vec2 = { x = "float", y = "float" },
    thud_pos = { x = "double", y = "double" },
    thud_body_id = { index1 = "uint32_t", generation = "uint32_t" },
    thud_shape_id = { index1 = "uint32_t", generation = "uint32_t" },
    thud_debug_draw = { flags = "unsigned int", origin = "thud_pos", lower = "thud_pos", upper = "thud_pos", context = "void *", circle = "void (*)(thud_vec2, float, float, float, thud_style, int, void *)", box = "void (*)(thud_vec2, thud_vec2, float, float, thud_style, int, void *)", line = "void (*)(thud_vec2, thud_vec2, thud_style, void *)", point = "void (*)(thud_vec2, thud_style, void *)" },
    thud_contact_event = { shape_a = "thud_shape_id", shape_b = "thud_shape_id" },
    thud_hit_event = { shape_a = "thud_shape_id", shape_b = "thud_shape_id", point = "thud_pos", normal = "thud_vec2", speed = "float" },
    thud_events = { begin = "const thud_contact_event *", ["end"] = "const thud_contact_event *", sensor_begin = "const thud_contact_event *", sensor_end = "const thud_contact_event *", sensor_begin_time = "const float *", sensor_end_time = "const float *", hit = "const thud_hit_event *", quarantined = "const thud_body_id *", begin_count = "int", end_count = "int", sensor_begin_count = "int", sensor_end_count = "int", hit_count = "int", quarantined_count = "int" },
    thud_allocator = { allocate = "void *(*)(size_t, void *)", release = "void (*)(void *, size_t, void *)", context = "void *" },
    thud_job_system = { run = "thud_parallel_fn *", context = "void *", workers = "int", stages = "const thud_shared_stages *", share_from = "uint32_t" },
    thud_quality = { name = "const char *", substeps = "int", contact_stiffness = "float", contact_damping = "float", detection = "const thud_detection *", islands = "const thud_island_solver *", overlap_limit = "float", island_limit = "int", island_work = "int64_t", island_slow_steps = "int" },
    thud_geometry = { kind = "thud_shape_kind", x = "double", y = "double", c = "double", s = "double", hx = "double", hy = "double" },
    thud_segment = { x = "double", y = "double", dx = "double", dy = "double" },
    thud_motion = { dx = "double", dy = "double", turn = "double" },
    thud_closest = { distance = "double", nx = "double", ny = "double", ax = "double", ay = "double", bx = "double", by = "double" },
    thud_contacts = { count = "int", point = "thud_closest[2]" },
    thud_approach = { hit = "_Bool", time = "double", min_distance = "double", min_distance_time = "double" },
    thud_terrain = { kind = "thud_terrain_kind", slope = "double", x0 = "double", spacing = "double", points = "const thud_pos *", count = "int" },
    thud_terrain_sample = { height = "double", nx = "double", ny = "double", segment = "int", weight = "double[2]" },
    thud_query_filter = { category = "uint32_t", mask = "uint32_t", sensors = "_Bool", group = "int32_t", ignore = "thud_body_id" },
    thud_ray = { origin = "thud_pos", dx = "double", dy = "double", filter = "const thud_query_filter *" },
    thud_shape_cast = { center = "thud_pos", shape = "thud_geometry", dx = "double", dy = "double", filter = "const thud_query_filter *" },
    thud_ray_hit = { shape = "thud_shape_id", point = "thud_pos", normal = "thud_vec2", fraction = "double", depth = "double" },
    thud_closest_hit = { shape = "thud_shape_id", point = "thud_pos", normal = "thud_vec2", distance = "double" },
    thud_manifold = { shape_a = "thud_shape_id", shape_b = "thud_shape_id", body_a = "thud_body_id", body_b = "thud_body_id", normal = "thud_vec2", point_count = "int", point = "thud_pos[2]", separation = "float[2]", normal_impulse = "float[2]", tangent_impulse = "float", direct = "_Bool" },
    thud_uv = { u = "double", v = "double" },
    thud_foot = { height = "double", x = "double", nx = "double", ny = "double" },
    thud_contact = { shape_a = "thud_shape_id", shape_b = "thud_shape_id", body_a = "thud_body_id", body_b = "thud_body_id", normal = "thud_vec2", point = "thud_pos", separation = "float", normal_impulse = "float", tangent_impulse = "float", point_count = "int" },
    thud_contact_settings = { friction = "float", restitution = "float", surface_speed = "float" },
    thud_world_def = { gravity = "thud_vec2", time_step = "double", length_scale = "float", quality = "const thud_quality *", substeps = "int", contact_stiffness = "float", contact_damping = "float", push_speed = "float", restitution_threshold = "float", hit_speed = "float", maximum_speed = "float", sleeping = "_Bool", contact_events = "_Bool", allocator = "thud_allocator", log = "thud_log_fn *", log_context = "void *", clock = "thud_clock_fn *", clock_context = "void *", max_error = "double", time_budget = "double", detection = "const thud_detection *", broadphase = "const thud_broadphase *", cell_size = "float", job_system = "thud_job_system", parts = "const thud_parts *", cookie = "uint32_t" },
    thud_step_calls = { before = "thud_step_fn *", after = "thud_step_fn *", context = "void *" },
    thud_body_def = { kind = "thud_body_kind", position = "thud_pos", angle = "double", velocity = "thud_vec2", angular_velocity = "float", gravity_scale = "float", linear_damping = "float", angular_damping = "float", fixed_rotation = "_Bool", may_sleep = "_Bool", detection = "const thud_detection *", user_data = "uint64_t", cookie = "uint32_t" },
    thud_body_state = { kind = "thud_body_kind", position = "thud_pos", center = "thud_pos", angle = "double", cosine = "float", sine = "float", velocity = "thud_vec2", angular_velocity = "float", mass = "float", inertia = "float", gravity_scale = "float", awake = "_Bool", enabled = "_Bool", quarantined = "_Bool", user_data = "uint64_t", shape_count = "int" },
    thud_filter = { category = "uint32_t", mask = "uint32_t", group = "int32_t" },
    thud_shape_def = { density = "float", friction = "float", restitution = "float", surface_speed = "float", filter = "thud_filter", sensor = "_Bool", events = "_Bool", user_data = "uint64_t", cookie = "uint32_t" },
    thud_shape_state = { kind = "thud_shape_kind", body = "thud_body_id", offset = "thud_vec2", half_extents = "thud_vec2", angle = "double", density = "float", friction = "float", restitution = "float", surface_speed = "float", filter = "thud_filter", sensor = "_Bool", events = "_Bool", user_data = "uint64_t" },
    thud_pose = { x = "float", y = "float", c = "float", s = "float" },
    thud_stats = { steps = "uint64_t", bodies = "int", shapes = "int", awake_bodies = "int", pairs = "int", contacts = "int", colours = "int", blocks = "int", substeps = "int", bytes = "uint64_t", step_allocations = "uint64_t", stage_seconds = "double[9]", step_seconds = "double", direct_islands = "int", direct_bodies = "int", soft_islands = "int", factorings = "int", island_work = "int64_t", impacts = "int", held_bodies = "int", held_seconds = "double", unbisectable = "int", motion_pairs = "int", motion_circles = "int", motion_boxes = "int", motion_exact = "int" },
    thud_step_error = { penetration_max = "double", penetration_mean = "double", residual = "double", energy_change = "double", energy_decided = "double", overlaps = "int", shortfall = "double", joint_gap_max = "double", joint_gap_mean = "double", joint_angle_max = "double" },
    thud_measure = { penetration_max = "double", penetration_mean = "double", kinetic_energy = "double", potential_energy = "double" },
    thud_approximate_options = { shapes_max = "int", kinds = "thud_approximate_kind", distance = "double", allocator = "thud_allocator" },
    thud_approximation = { count = "int", missed = "double", extra = "double", overlap = "double", distance = "double" },
    thud_capsule = { x1 = "double", y1 = "double", x2 = "double", y2 = "double", radius = "double" },
    thud_body_shape = { shape = "thud_geometry", def = "const thud_shape_def *" },
    thud_mass = { mass = "float", inertia = "float", center = "thud_vec2" },
    thud_explosion = { center = "thud_pos", radius = "double", falloff = "double", impulse = "float", cover = "thud_cover", rays = "int", filter = "thud_query_filter", cookie = "uint32_t" },
    thud_water = { point = "thud_pos", normal = "thud_vec2", density = "float", flow = "thud_vec2", linear_drag = "float", angular_drag = "float", cookie = "uint32_t" },
    thud_half_plane = { x = "double", y = "double", nx = "double", ny = "double" },
    thud_joint_id = { index1 = "uint32_t", generation = "uint32_t" },
    thud_drive = { limited = "_Bool", lower = "float", upper = "float", frequency = "float", damping = "float", target = "float", spring_force = "float", motor_speed = "float", motor_force = "float" },
    thud_joint_frame = { position = "thud_vec2", angle = "double" },
    thud_joint_def = { kind = "thud_joint_kind", body_a = "thud_body_id", body_b = "thud_body_id", frame_a = "thud_joint_frame", frame_b = "thud_joint_frame", drive = "thud_drive[3]", length = "float", gear = "thud_joint_id[2]", ratio = "float", collide_connected = "_Bool", break_force = "float", break_torque = "float", only_reports = "_Bool", enabled = "_Bool", user_data = "uint64_t", cookie = "uint32_t" },
    thud_drive_forces = { limit = "float", spring = "float", motor = "float" },
    thud_joint_state = { kind = "thud_joint_kind", body_a = "thud_body_id", body_b = "thud_body_id", enabled = "_Bool", value = "double[3]", gap = "double", angle_gap = "double", force = "thud_vec2", torque = "float", drive = "thud_drive_forces[3]", user_data = "uint64_t" },
    thud_joint_event = { joint = "thud_joint_id", body_a = "thud_body_id", body_b = "thud_body_id", user_data = "uint64_t", force = "float", torque = "float", broken = "_Bool" },
    thud_contact_answer = { settings = "thud_contact_settings", collide = "_Bool" },
    thud_listeners = { prologue = "thud_prologue_fn *", epilogue = "thud_epilogue_fn *", prologue_all = "thud_prologue_all_fn *", epilogue_all = "thud_epilogue_all_fn *", context = "void *", without = "uint32_t" },
    thud_velocities = { velocity = "thud_vec2", angular_velocity = "float" },
    thud_body_seen = { body = "thud_body_id", x = "int64_t", y = "int64_t", angle = "int64_t" },
    thud_pair_side = { body = "thud_body_id", body_data = "uint64_t", shape_data = "uint64_t", sensor = "_Bool" },
    thud_pair = { a = "thud_pair_side", b = "thud_pair_side" },
    thud_event_pair = { shape_a = "thud_shape_id", shape_b = "thud_shape_id", a = "thud_pair_side", b = "thud_pair_side", next = "int" },
    thud_body_options = { kind = "thud_body_kind", velocity = "thud_vec2", angular_velocity = "float", linear_damping = "float", angular_damping = "float", weightless = "_Bool", fixed_rotation = "_Bool", detection = "const thud_detection *", density = "float", friction = "float", frictionless = "_Bool", restitution = "float", surface_speed = "float", category = "uint32_t", mask = "uint32_t", group = "int32_t", sensor = "_Bool", user_data = "uint64_t" },
    thud_minkowski = { count = "int", vertices = "thud_pos[8]", normals = "thud_pos[4]", offsets = "double[4]", radius = "double" },
    thud_mover_hit = { shape = "thud_shape_id", body = "thud_body_id", point = "thud_pos", normal = "thud_vec2", depth = "double", category = "uint32_t" },
    thud_one_way = { categories = "uint32_t", drop = "_Bool" },
    thud_mover = { shape = "thud_geometry", up = "thud_vec2", skin = "double", max_slope = "double", step_height = "double", snap_distance = "double", push_force = "double", body = "thud_body_id", filter = "thud_query_filter", pass = "thud_mover_pass_fn *", context = "void *", on_ground = "_Bool", ground_normal = "thud_vec2", ground_shape = "thud_shape_id", ground_body = "thud_body_id", ground_point = "thud_pos", ground_place = "thud_pos", ground_cosine = "float", ground_sine = "float" },
    thud_mover_report = { velocity = "thud_vec2", ground_velocity = "thud_vec2", depth = "double", hit_count = "int", hits = "thud_mover_hit[8]", sensor_count = "int", sensors = "thud_shape_id[16]" },
    thud_bytes = { data = "const void *", count = "size_t" },
    thud_prediction = { body = "thud_body_id", position = "thud_pos", angle = "double", velocity = "thud_vec2", angular_velocity = "float", seconds = "double", met = "thud_shape_id" },
    thud_step_settings = { gravity = "thud_vec2", time_step = "double", max_error = "double", substeps = "int", sleeping = "_Bool", quality = "thud_quality" },
    thud_broadphase_counts = { moved = "int", tested = "int64_t", found = "int64_t", sort_moves = "int64_t", cells = "int", cell_shapes = "int", cell_shapes_max = "int" },
    thud_recorder_options = { hash_steps = "int", body_hashes = "_Bool", keyframe_steps = "int", ring_steps = "int", sink = "thud_recording_sink_fn *", context = "void *", queries = "_Bool" },
    thud_call_value = { number = "double", handle = "_Bool" },
    thud_played_call = { name = "const char *", result = "thud_result", values = "const thud_call_value *", value_count = "int", returned = "uint32_t", query = "_Bool", hits = "const thud_ray_hit *", hit_count = "int" },
    thud_player_options = { allocator = "thud_allocator", log = "thud_log_fn *", log_context = "void *", job_system = "thud_job_system", chunk = "thud_chunk_fn *", call = "thud_played_call_fn *", context = "void *", clock = "thud_clock_fn *", clock_context = "void *" },
    thud_player_progress = { first = "int64_t", ["end"] = "int64_t", steps = "int64_t", hashes = "int64_t", differs = "_Bool", differs_after = "int64_t", differs_at = "int64_t", body = "thud_body_id" },
    thud_rollback_options = { players = "int", depth = "int", budget = "int", idle = "uint64_t", step = "thud_rollback_step_fn *", state = "void *", state_bytes = "size_t" },
    thud_rollback_progress = { steps = "int64_t", confirmed = "int64_t", replayed = "int64_t", settled = "int64_t", ahead = "double" },
    thud_rollback_difference = { step = "int64_t", is_detailed = "_Bool", body = "thud_body_id", body_slot = "int", bodies = "int", player = "int" },
    thud_rule = { kind = "thud_rule_kind", solid_side = "thud_vec2", friction = "float", restitution = "float", surface_speed = "float", event_impulse = "float" },
    thud_impulse_event = { shape_a = "thud_shape_id", shape_b = "thud_shape_id", point = "thud_pos", normal = "thud_vec2", impulse = "float" },
    thud_texture = { vertices = "const double *", count = "int", table = "const float *", table_count = "int", repeats = "_Bool" },
}
FIELDS.thud_volume = FIELDS.thud_geometry
---- end ----

local C = ffi.load(rawget(_G, "THUD_LIBRARY") or os.getenv("THUD_LIBRARY") or "thud")
thud.C = C
if C.thud_version() ~= thud.constants.VERSION then
    error("thud.lua and the library are of different versions: make both from the same sources")
end

---- from Lua to C ----

local function words(of)
    local list = {}
    for word in pairs(of) do
        list[#list + 1] = word
    end
    table.sort(list)
    return table.concat(list, ", ")
end

local function enum(kind, value)
    if type(value) ~= "string" then
        return value
    end
    return ENUMS[kind][value] or error(("no %s %q: it has %s"):format(kind, value, words(ENUMS[kind])), 0)
end

local fill

-- A struct before the fields that are given are set.
local function blank(kind, given)
    if kind == "thud_joint_def" then
        return C.thud_default_joint_def(enum("thud_joint_kind", given.kind) or 0)
    end
    if DEFAULTS[kind] then
        return C[DEFAULTS[kind]]()
    end
    local made = ffi.new(kind)
    if kind == "thud_geometry" or kind == "thud_volume" then
        made.c = 1 -- not turned
    end
    return made
end

-- A value for a parameter or field of this type. Whatever it points to is kept in `hold`.
local function value(kind, given, hold)
    if ENUMS[kind] then
        return enum(kind, given)
    end
    if type(given) ~= "table" then
        return given
    end
    if HANDLES[kind] then
        return given.id or given
    end
    if FIELDS[kind] and #given == 0 then
        return fill(blank(kind, given), kind, given, hold)
    end
    return given
end

-- An array of this type, and its length: of a list, or of an array of the ffi.
local function array(kind, given, hold)
    if type(given) == "cdata" then
        return given, ffi.sizeof(given) / ffi.sizeof(kind)
    end
    local made = ffi.new(kind .. "[?]", #given)
    hold[#hold + 1] = made
    for i = 1, #given do
        made[i - 1] = value(kind, given[i], hold)
    end
    return made, #given
end

-- What a `const T *` points to: null, an object of the engine by its name, or a struct, which begins with
-- its defaults.
local function input(kind, given, hold)
    if type(given) == "string" then
        local names = OBJECTS[kind] or error(kind .. " is no word", 0)
        return C[names[given] or error(("no %s %q: it has %s"):format(kind, given, words(names)), 0)]
    end
    if type(given) ~= "table" then
        return given
    end
    local made = #given > 0 and ffi.new(kind, given) or blank(kind, given)
    hold[#hold + 1] = made
    return #given > 0 and made or fill(made, kind, given, hold)
end

-- The error of a callback, in a table, which the call that called it raises: none may pass through C.
local pending

-- Whether C takes this as the result of a callback that returns `failed` where it fails.
local function fits(result, failed)
    local kind = type(result)
    return failed == nil or kind == type(failed) or kind == "number" and type(failed) == "boolean"
end

local function callback(kind, fn, failed)
    return ffi.cast(kind .. " *", function(...)
        local done, result = pcall(fn, ...)
        if done and not fits(result, failed) then
            done, result = false, ("a callback returned a %s, not a %s"):format(type(result), type(failed))
        end
        if not done then
            pending = pending or { result }
            return failed
        end
        return result
    end)
end

local FAILED = { ["_Bool"] = false, ["double"] = 0, ["thud_result"] = 2 }
local kept = {} -- callbacks of structs, which nothing tells when they are no longer called

function fill(object, kind, values, hold)
    local fields = FIELDS[kind]
    for name, given in pairs(values) do
        local of = fields[name]
        if not of then
            error(("%s has no field %q: it has %s"):format(kind, tostring(name), words(fields)), 0)
        end
        local pointed = of:match("^const (.-) %*$")
        local called = of:match("^(thud_%w+_fn) %*$")
        local element = of:match("^(.-)%[%d+%]$")
        if called and type(given) == "function" then
            kept[#kept + 1] = callback(called, given, FAILED[CALLBACKS[called]])
            object[name] = kept[#kept]
        elseif element and FIELDS[element] and type(given) == "table" then
            local indices = name == "drive" and ENUMS.thud_direction or {}
            for place, one in pairs(given) do
                local at = indices[place] or type(place) == "number" and place - 1
                    or error(("%s of %s has no element %q"):format(name, kind, tostring(place)), 0)
                if type(one) == "table" and FIELDS[element] and not HANDLES[element] then
                    fill(object[name][at], element, one, hold)
                else
                    object[name][at] = value(element, one, hold)
                end
            end
        elseif pointed and type(given) == "table" and (fields[name .. "_count"] or fields.count) then
            local made, count = array(pointed, given, hold)
            object[name] = made
            object[fields[name .. "_count"] and name .. "_count" or "count"] = count
        elseif pointed then
            object[name] = input(pointed, given, hold)
        elseif FIELDS[of] and type(given) == "table" and #given == 0 and not HANDLES[of] then
            fill(object[name], of, given, hold)
        else
            object[name] = value(of, given, hold)
        end
    end
    hold[#hold + 1] = object
    return object
end

local function to_read(given)
    if type(given) == "string" then
        return ffi.cast("const char *", given), #given
    end
    return given, given ~= nil and ffi.sizeof(given) or 0
end

local function thud_bytes(given, hold)
    local made = ffi.new("thud_bytes")
    made.data, made.count = to_read(given)
    hold[#hold + 1] = given
    return made
end

local function to_write(given)
    return given, given ~= nil and ffi.sizeof(given) or 0
end

---- from C to Lua ----

local message

-- One for all worlds; LuaJIT has room for few callbacks.
local log = ffi.cast("thud_log_fn *", function(result, text)
    if result ~= 0 then -- or else it is a warning
        message = ffi.string(text)
    end
end)

-- Of a call that failed, or called a callback that did.
local function refused(code)
    local reason, raised = message, pending
    message, pending = nil, nil
    if raised then
        error(raised[1], 0)
    end
    return nil, reason or ffi.string(C.thud_result_text(code))
end

-- `call` writes to an array with room for so many, and to the number of all.
local function list(kind, room, call)
    local count = ffi.new("int[1]")
    local out = ffi.new(kind .. "[?]", room)
    local code = call(out, room, count)
    if code == 0 and count[0] > room then
        room = count[0]
        out = ffi.new(kind .. "[?]", room)
        code = call(out, room, count)
    end
    return code, out, count[0]
end

-- Keeps the callback of a setter as long as it may be called, in place of the one before.
local function keep_callback(object, call, made, code)
    local all = (object.world or object).node.callbacks
    local key = object.id and ("%s %d %d"):format(call, object.id.index1, object.id.generation) or call
    if code ~= 0 then
        if made then
            made:free()
        end
        return
    end
    if all[key] then
        all[key]:free()
    end
    all[key] = made
end

local World, Body, Shape, Joint = {}, {}, {}, {}
local Rollback, Threads = {}, {}

local function pointer(owner)
    return owner.pointer or error("it is closed", 3)
end

local function handle(class)
    class.__index = class
    class.__eq = function(a, b)
        return a.world == b.world and a.id.index1 == b.id.index1 and a.id.generation == b.id.generation
    end
    --- The index of its slot in arrays of the world.
    function class:slot()
        return self.id.index1 - 1
    end
    return function(world, id)
        return setmetatable({ world = world, id = id }, class)
    end
end

local body, shape, joint = handle(Body), handle(Shape), handle(Joint)

-- The handles of an array, as objects.
local function handles(make, world, out, count)
    local made = {}
    for i = 1, count do
        made[i] = make(world, ffi.new(ffi.typeof(out[i - 1]), out[i - 1]))
    end
    return made
end

---- made from bindings/api.json by tools/bind_lua.py: calls ----

function thud.result_text(result)
    local hold = {}
    return ffi.string(C.thud_result_text(value("thud_result", result, hold)))
end

function thud.sincos(angle)
    local sine = ffi.new("double[1]")
    local cosine = ffi.new("double[1]")
    local code = C.thud_sincos(angle, sine, cosine)
    if code ~= 0 or pending then
        return refused(code)
    end
    return sine[0], cosine[0]
end

function thud.angle_of(sine, cosine)
    local angle = ffi.new("double[1]")
    local code = C.thud_angle_of(sine, cosine, angle)
    if code ~= 0 or pending then
        return refused(code)
    end
    return angle[0]
end

function thud.broadphase_name(broadphase)
    local hold = {}
    return ffi.string(C.thud_broadphase_name(input("thud_broadphase", broadphase, hold)))
end

function thud.detection_name(detection)
    local hold = {}
    return ffi.string(C.thud_detection_name(input("thud_detection", detection, hold)))
end

function World:draw(draw)
    local hold = {}
    local code = C.thud_world_draw(pointer(self), input("thud_debug_draw", draw, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:events()
    local out = ffi.new("thud_events")
    local code = C.thud_world_get_events(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.geometry_check(shape_)
    local hold = {}
    local code = C.thud_geometry_check(input("thud_geometry", shape_, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.geometry_overlap(a, b)
    local hold = {}
    return C.thud_geometry_overlap(input("thud_geometry", a, hold), input("thud_geometry", b, hold))
end

function thud.geometry_closest(a, b)
    local hold = {}
    local out = ffi.new("thud_closest")
    local code = C.thud_geometry_closest(input("thud_geometry", a, hold), input("thud_geometry", b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.geometry_contacts(a, b, margin)
    local hold = {}
    local out = ffi.new("thud_contacts")
    local code = C.thud_geometry_contacts(input("thud_geometry", a, hold), input("thud_geometry", b, hold), margin, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.geometry_cast_ray(shape_, ray)
    local hold = {}
    local fraction = ffi.new("double[1]")
    local nx = ffi.new("double[1]")
    local ny = ffi.new("double[1]")
    if not C.thud_geometry_cast_ray(input("thud_geometry", shape_, hold), value("thud_segment", ray, hold), fraction, nx, ny) then
        return false
    end
    return fraction[0], nx[0], ny[0]
end

function thud.geometry_time_of_impact(a, motion_a, b, motion_b, target)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_geometry_time_of_impact(input("thud_geometry", a, hold), value("thud_motion", motion_a, hold), input("thud_geometry", b, hold), value("thud_motion", motion_b, hold), target, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function thud.geometry_approach(a, motion_a, b, motion_b)
    local hold = {}
    local out = ffi.new("thud_approach")
    local code = C.thud_geometry_approach(input("thud_geometry", a, hold), value("thud_motion", motion_a, hold), input("thud_geometry", b, hold), value("thud_motion", motion_b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.geometry_time_of_collision(a, motion_a, b, motion_b, tolerance)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_geometry_time_of_collision(input("thud_geometry", a, hold), value("thud_motion", motion_a, hold), input("thud_geometry", b, hold), value("thud_motion", motion_b, hold), tolerance, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function thud.geometry_is_bisectable(a, motion_a, b, motion_b)
    local hold = {}
    return C.thud_geometry_is_bisectable(input("thud_geometry", a, hold), value("thud_motion", motion_a, hold), input("thud_geometry", b, hold), value("thud_motion", motion_b, hold))
end

function thud.terrain_check(terrain)
    local hold = {}
    local code = C.thud_terrain_check(input("thud_terrain", terrain, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.terrain_sample_at(terrain, x)
    local hold = {}
    local out = ffi.new("thud_terrain_sample")
    local code = C.thud_terrain_sample_at(input("thud_terrain", terrain, hold), x, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.terrain_segments(terrain, x_min, x_max)
    local hold = {}
    local first = ffi.new("int[1]")
    local last = ffi.new("int[1]")
    C.thud_terrain_segments(input("thud_terrain", terrain, hold), x_min, x_max, first, last)
    return first[0], last[0]
end

function thud.terrain_cast_ray(terrain, ray)
    local hold = {}
    local fraction = ffi.new("double[1]")
    local nx = ffi.new("double[1]")
    local ny = ffi.new("double[1]")
    if not C.thud_terrain_cast_ray(input("thud_terrain", terrain, hold), value("thud_segment", ray, hold), fraction, nx, ny) then
        return false
    end
    return fraction[0], nx[0], ny[0]
end

function thud.terrain_overlap(terrain, shape_)
    local hold = {}
    return C.thud_terrain_overlap(input("thud_terrain", terrain, hold), input("thud_geometry", shape_, hold))
end

function thud.terrain_closest(terrain, shape_)
    local hold = {}
    local out = ffi.new("thud_closest")
    local code = C.thud_terrain_closest(input("thud_terrain", terrain, hold), input("thud_geometry", shape_, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.terrain_contacts(terrain, shape_, margin)
    local hold = {}
    local out = ffi.new("thud_contacts")
    local code = C.thud_terrain_contacts(input("thud_terrain", terrain, hold), input("thud_geometry", shape_, hold), margin, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.terrain_time_of_impact(terrain, shape_, motion, target)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_terrain_time_of_impact(input("thud_terrain", terrain, hold), input("thud_geometry", shape_, hold), value("thud_motion", motion, hold), target, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function thud.terrain_time_of_collision(terrain, shape_, motion, tolerance)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_terrain_time_of_collision(input("thud_terrain", terrain, hold), input("thud_geometry", shape_, hold), value("thud_motion", motion, hold), tolerance, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function thud.volume_check(volume)
    local hold = {}
    local code = C.thud_volume_check(input("thud_volume", volume, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.volume_around_shape(kind, shape_)
    local hold = {}
    local out = ffi.new("thud_volume")
    local code = C.thud_volume_around_shape(value("thud_shape_kind", kind, hold), input("thud_geometry", shape_, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.volume_around_motion(kind, shape_, motion)
    local hold = {}
    local out = ffi.new("thud_volume")
    local code = C.thud_volume_around_motion(value("thud_shape_kind", kind, hold), input("thud_geometry", shape_, hold), value("thud_motion", motion, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.volume_around_points(kind, points)
    local hold = {}
    local points_array, count = array("thud_pos", points, hold)
    local out = ffi.new("thud_volume")
    local code = C.thud_volume_around_points(value("thud_shape_kind", kind, hold), points_array, count, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.volume_around_terrain(kind, terrain, x_min, x_max)
    local hold = {}
    local out = ffi.new("thud_volume")
    local code = C.thud_volume_around_terrain(value("thud_shape_kind", kind, hold), input("thud_terrain", terrain, hold), x_min, x_max, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.volume_merge(kind, a, b)
    local hold = {}
    local out = ffi.new("thud_volume")
    local code = C.thud_volume_merge(value("thud_shape_kind", kind, hold), input("thud_volume", a, hold), input("thud_volume", b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.volumes_overlap(a, b)
    local hold = {}
    local overlap = ffi.new("_Bool[1]")
    local code = C.thud_volumes_overlap(input("thud_volume", a, hold), input("thud_volume", b, hold), overlap)
    if code ~= 0 or pending then
        return refused(code)
    end
    return overlap[0]
end

function thud.volume_contains_point(volume, x, y)
    local hold = {}
    local inside = ffi.new("_Bool[1]")
    local code = C.thud_volume_contains_point(input("thud_volume", volume, hold), x, y, inside)
    if code ~= 0 or pending then
        return refused(code)
    end
    return inside[0]
end

function thud.volume_contains(outer, inner)
    local hold = {}
    local inside = ffi.new("_Bool[1]")
    local code = C.thud_volume_contains(input("thud_volume", outer, hold), input("thud_volume", inner, hold), inside)
    if code ~= 0 or pending then
        return refused(code)
    end
    return inside[0]
end

function thud.default_query_filter()
    return C.thud_default_query_filter()
end

function World:cast_ray(ray)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local out = ffi.new("thud_ray_hit")
    local code = C.thud_world_cast_ray(pointer(self), input("thud_ray", ray, hold), found, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return out
end

function World:cast_ray_all(ray)
    local hold = {}
    local code, out, found_count = list("thud_ray_hit", 16, function(out, room, number)
        return C.thud_world_cast_ray_all(pointer(self), input("thud_ray", ray, hold), out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out, found_count
end

function World:cast_shape(cast)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local out = ffi.new("thud_ray_hit")
    local code = C.thud_world_cast_shape(pointer(self), input("thud_shape_cast", cast, hold), found, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return out
end

function World:cast_shape_all(cast)
    local hold = {}
    local code, out, found_count = list("thud_ray_hit", 16, function(out, room, number)
        return C.thud_world_cast_shape_all(pointer(self), input("thud_shape_cast", cast, hold), out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out, found_count
end

function World:closest(point, max_distance, filter)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local out = ffi.new("thud_closest_hit")
    local code = C.thud_world_closest(pointer(self), value("thud_pos", point, hold), max_distance, input("thud_query_filter", filter, hold), found, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return out
end

function Body:volume(kind, origin)
    local hold = {}
    local out = ffi.new("thud_volume")
    local code = C.thud_body_get_volume(pointer(self.world), self.id, value("thud_shape_kind", kind, hold), value("thud_pos", origin, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Body:contacts()
    local code, out, found_count = list("thud_manifold", 16, function(out, room, number)
        return C.thud_body_get_contacts(pointer(self.world), self.id, out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out, found_count
end

function thud.terrain_texture_at(sample, vertices)
    local hold = {}
    local vertices_array, count = array("thud_uv", vertices, hold)
    local out = ffi.new("thud_uv")
    local code = C.thud_terrain_texture_at(input("thud_terrain_sample", sample, hold), vertices_array, count, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.terrain_place_foot(terrain, x, width)
    local hold = {}
    local out = ffi.new("thud_foot")
    local code = C.thud_terrain_place_foot(input("thud_terrain", terrain, hold), x, width, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Shape:set_heights(first, heights)
    local hold = {}
    local heights_array, count = array("double", heights, hold)
    local code = C.thud_shape_set_heights(pointer(self.world), self.id, first, heights_array, count)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:dig(center, radius)
    local hold = {}
    local code = C.thud_shape_dig(pointer(self.world), self.id, value("thud_pos", center, hold), radius)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:raise(x, radius, height)
    local code = C.thud_shape_raise(pointer(self.world), self.id, x, radius, height)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:replace_range(x0, x1, points)
    local hold = {}
    local points_array, count = array("thud_pos", points, hold)
    local code = C.thud_shape_replace_range(pointer(self.world), self.id, x0, x1, points_array, count)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.default_world_def()
    return C.thud_default_world_def()
end

function thud.default_world_def_of(quality)
    local hold = {}
    return C.thud_default_world_def_of(input("thud_quality", quality, hold))
end

function thud.default_small_world_def(quality)
    local hold = {}
    return C.thud_default_small_world_def(input("thud_quality", quality, hold))
end

function World:step()
    local code = C.thud_world_step(pointer(self))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:advance(elapsed, max_steps)
    local steps = ffi.new("int[1]")
    local alpha = ffi.new("double[1]")
    local code = C.thud_world_advance(pointer(self), elapsed, max_steps, steps, alpha)
    if code ~= 0 or pending then
        return refused(code)
    end
    return steps[0], alpha[0]
end

function World:advance_with(elapsed, max_steps, calls)
    local hold = {}
    local steps = ffi.new("int[1]")
    local alpha = ffi.new("double[1]")
    local code = C.thud_world_advance_with(pointer(self), elapsed, max_steps, input("thud_step_calls", calls, hold), steps, alpha)
    if code ~= 0 or pending then
        return refused(code)
    end
    return steps[0], alpha[0]
end

function World:set_gravity(gravity)
    local hold = {}
    local code = C.thud_world_set_gravity(pointer(self), value("thud_vec2", gravity, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:set_time_step(time_step)
    local code = C.thud_world_set_time_step(pointer(self), time_step)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:set_max_error(max_error)
    local code = C.thud_world_set_max_error(pointer(self), max_error)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:set_quality(quality)
    local hold = {}
    local code = C.thud_world_set_quality(pointer(self), input("thud_quality", quality, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:set_sleeping(sleeping)
    local code = C.thud_world_set_sleeping(pointer(self), sleeping)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.default_body_def()
    return C.thud_default_body_def()
end

function World:create_body(def)
    local hold = {}
    local out = ffi.new("thud_body_id")
    local code = C.thud_body_create(pointer(self), input("thud_body_def", def or {}, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return body(self, out)
end

function Body:destroy()
    local code = C.thud_body_destroy(pointer(self.world), self.id)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:is_valid()
    return C.thud_body_is_valid(pointer(self.world), self.id)
end

function Body:state()
    local out = ffi.new("thud_body_state")
    local code = C.thud_body_get_state(pointer(self.world), self.id, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Body:set_transform(position, angle)
    local hold = {}
    local code = C.thud_body_set_transform(pointer(self.world), self.id, value("thud_pos", position, hold), angle)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_velocity(velocity, angular_velocity)
    local hold = {}
    local code = C.thud_body_set_velocity(pointer(self.world), self.id, value("thud_vec2", velocity, hold), angular_velocity)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_impulse(impulse, point)
    local hold = {}
    local code = C.thud_body_apply_impulse(pointer(self.world), self.id, value("thud_vec2", impulse, hold), value("thud_pos", point, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_center_force(force)
    local hold = {}
    local code = C.thud_body_apply_center_force(pointer(self.world), self.id, value("thud_vec2", force, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_torque(torque)
    local code = C.thud_body_apply_torque(pointer(self.world), self.id, torque)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_awake(awake)
    local code = C.thud_body_set_awake(pointer(self.world), self.id, awake)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_enabled(enabled)
    local code = C.thud_body_set_enabled(pointer(self.world), self.id, enabled)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_user_data(user_data)
    local code = C.thud_body_set_user_data(pointer(self.world), self.id, user_data)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:shapes()
    local code, out, found_count = list("thud_shape_id", 16, function(out, room, number)
        return C.thud_body_get_shapes(pointer(self.world), self.id, out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(shape, self.world, out, found_count)
end

function thud.default_shape_def()
    return C.thud_default_shape_def()
end

function Body:create_circle(offset, radius, def)
    local hold = {}
    local out = ffi.new("thud_shape_id")
    local code = C.thud_shape_create_circle(pointer(self.world), self.id, input("thud_shape_def", def or {}, hold), value("thud_vec2", offset, hold), radius, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return shape(self.world, out)
end

function Body:create_aabb(offset, half_extents, def)
    local hold = {}
    local out = ffi.new("thud_shape_id")
    local code = C.thud_shape_create_aabb(pointer(self.world), self.id, input("thud_shape_def", def or {}, hold), value("thud_vec2", offset, hold), value("thud_vec2", half_extents, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return shape(self.world, out)
end

function Body:create_obb(offset, half_extents, angle, def)
    local hold = {}
    local out = ffi.new("thud_shape_id")
    local code = C.thud_shape_create_obb(pointer(self.world), self.id, input("thud_shape_def", def or {}, hold), value("thud_vec2", offset, hold), value("thud_vec2", half_extents, hold), angle, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return shape(self.world, out)
end

function Body:create_terrain(terrain, def)
    local hold = {}
    local out = ffi.new("thud_shape_id")
    local code = C.thud_shape_create_terrain(pointer(self.world), self.id, input("thud_shape_def", def or {}, hold), input("thud_terrain", terrain, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return shape(self.world, out)
end

function Shape:destroy()
    local code = C.thud_shape_destroy(pointer(self.world), self.id)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:is_valid()
    return C.thud_shape_is_valid(pointer(self.world), self.id)
end

function Shape:state()
    local out = ffi.new("thud_shape_state")
    local code = C.thud_shape_get_state(pointer(self.world), self.id, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Shape:terrain()
    local out = ffi.new("thud_terrain")
    local code = C.thud_shape_get_terrain(pointer(self.world), self.id, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function World:poses(origin, alpha)
    local hold = {}
    local view, view_count = ffi.new("const thud_pose *[1]"), ffi.new("int[1]")
    local code = C.thud_world_get_poses(pointer(self), value("thud_pos", origin, hold), alpha, view, view_count)
    if code ~= 0 or pending then
        return refused(code)
    end
    return view[0], view_count[0]
end

function thud.stage_name(stage)
    local hold = {}
    return ffi.string(C.thud_stage_name(value("thud_stage", stage, hold)))
end

function World:stats()
    local out = ffi.new("thud_stats")
    local code = C.thud_world_get_stats(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function World:bisection_limit()
    local speed = ffi.new("double[1]")
    local code = C.thud_world_get_bisection_limit(pointer(self), speed)
    if code ~= 0 or pending then
        return refused(code)
    end
    return speed[0]
end

function World:use_step_error()
    local code = C.thud_world_use_step_error(pointer(self))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:step_error()
    local out = ffi.new("thud_step_error")
    local code = C.thud_world_get_step_error(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function World:measure()
    local out = ffi.new("thud_measure")
    local code = C.thud_world_get_measure(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function World:hash()
    local out = ffi.new("uint64_t[1]")
    local code = C.thud_world_get_hash(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out[0]
end

function thud.polygon_check(points)
    local hold = {}
    local points_array, count = array("thud_pos", points, hold)
    local reason = ffi.new("const char *[1]")
    local code = C.thud_polygon_check(points_array, count, reason)
    if code ~= 0 or pending then
        return refused(code)
    end
    return reason[0] ~= nil and ffi.string(reason[0]) or nil
end

function thud.approximate(points, options, out_shapes)
    local hold = {}
    local points_array, count = array("thud_pos", points, hold)
    local out = ffi.new("thud_approximation")
    local code = C.thud_approximate(points_array, count, input("thud_approximate_options", options, hold), out_shapes, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.capsule_check(capsule)
    local hold = {}
    local code = C.thud_capsule_check(input("thud_capsule", capsule, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.capsule_of_motion(circle, motion)
    local hold = {}
    local out = ffi.new("thud_capsule")
    local code = C.thud_capsule_of_motion(input("thud_geometry", circle, hold), value("thud_motion", motion, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.capsule_closest(a, b)
    local hold = {}
    local out = ffi.new("thud_closest")
    local code = C.thud_capsule_closest(input("thud_capsule", a, hold), input("thud_geometry", b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.capsules_closest(a, b)
    local hold = {}
    local out = ffi.new("thud_closest")
    local code = C.thud_capsules_closest(input("thud_capsule", a, hold), input("thud_capsule", b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.terrain_capsule_closest(terrain, capsule)
    local hold = {}
    local out = ffi.new("thud_closest")
    local code = C.thud_terrain_capsule_closest(input("thud_terrain", terrain, hold), input("thud_capsule", capsule, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.capsule_time_of_impact(a, motion_a, b, motion_b, target)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_capsule_time_of_impact(input("thud_capsule", a, hold), value("thud_motion", motion_a, hold), input("thud_geometry", b, hold), value("thud_motion", motion_b, hold), target, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function thud.capsules_time_of_impact(a, motion_a, b, motion_b, target)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_capsules_time_of_impact(input("thud_capsule", a, hold), value("thud_motion", motion_a, hold), input("thud_capsule", b, hold), value("thud_motion", motion_b, hold), target, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function thud.terrain_capsule_time_of_impact(terrain, capsule, motion, target)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local time = ffi.new("double[1]")
    local code = C.thud_terrain_capsule_time_of_impact(input("thud_terrain", terrain, hold), input("thud_capsule", capsule, hold), value("thud_motion", motion, hold), target, found, time)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return time[0]
end

function World:cast_ray_each(ray, fn)
    local hold = {}
    local given_0 = pointer(self)
    local given_1 = input("thud_ray", ray, hold)
    local called = fn and callback("thud_cast_fn", fn, FAILED["double"])
    local code = C.thud_world_cast_ray_each(given_0, given_1, called, nil)
    if called then
        called:free()
    end
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:cast_shape_each(cast, fn)
    local hold = {}
    local given_0 = pointer(self)
    local given_1 = input("thud_shape_cast", cast, hold)
    local called = fn and callback("thud_cast_fn", fn, FAILED["double"])
    local code = C.thud_world_cast_shape_each(given_0, given_1, called, nil)
    if called then
        called:free()
    end
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:cast_rays(rays)
    local hold = {}
    local rays_array, count = array("thud_ray", rays, hold)
    local hits = ffi.new("thud_ray_hit[?]", count)
    local code = C.thud_world_cast_rays(pointer(self), rays_array, count, hits)
    if code ~= 0 or pending then
        return refused(code)
    end
    return hits
end

function World:cast_shapes(casts)
    local hold = {}
    local casts_array, count = array("thud_shape_cast", casts, hold)
    local hits = ffi.new("thud_ray_hit[?]", count)
    local code = C.thud_world_cast_shapes(pointer(self), casts_array, count, hits)
    if code ~= 0 or pending then
        return refused(code)
    end
    return hits
end

function Shape:cast_ray(origin, dx, dy)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local out = ffi.new("thud_ray_hit")
    local code = C.thud_shape_cast_ray(pointer(self.world), self.id, value("thud_pos", origin, hold), dx, dy, found, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return out
end

function Shape:contains_point(point)
    local hold = {}
    local inside = ffi.new("_Bool[1]")
    local code = C.thud_shape_contains_point(pointer(self.world), self.id, value("thud_pos", point, hold), inside)
    if code ~= 0 or pending then
        return refused(code)
    end
    return inside[0]
end

function Shape:closest_point(point)
    local hold = {}
    local out = ffi.new("thud_closest_hit")
    local code = C.thud_shape_closest_point(pointer(self.world), self.id, value("thud_pos", point, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Shape:bounds()
    local lower = ffi.new("thud_pos")
    local upper = ffi.new("thud_pos")
    local code = C.thud_shape_get_bounds(pointer(self.world), self.id, lower, upper)
    if code ~= 0 or pending then
        return refused(code)
    end
    return lower, upper
end

function World:create_body_with_shapes(shapes, def)
    local hold = {}
    local shapes_array, count = array("thud_body_shape", shapes, hold)
    local body_ = ffi.new("thud_body_id")
    local shape_ids = ffi.new("thud_shape_id[?]", count)
    local code = C.thud_body_create_with_shapes(pointer(self), input("thud_body_def", def or {}, hold), shapes_array, count, body_, shape_ids)
    if code ~= 0 or pending then
        return refused(code)
    end
    return body(self, body_), shape_ids
end

function Shape:set_filter(filter)
    local hold = {}
    local code = C.thud_shape_set_filter(pointer(self.world), self.id, value("thud_filter", filter, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_friction(friction)
    local code = C.thud_shape_set_friction(pointer(self.world), self.id, friction)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_restitution(restitution)
    local code = C.thud_shape_set_restitution(pointer(self.world), self.id, restitution)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_surface_speed(surface_speed)
    local code = C.thud_shape_set_surface_speed(pointer(self.world), self.id, surface_speed)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_density(density)
    local code = C.thud_shape_set_density(pointer(self.world), self.id, density)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_sensor(sensor)
    local code = C.thud_shape_set_sensor(pointer(self.world), self.id, sensor)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_radius(radius)
    local code = C.thud_shape_set_radius(pointer(self.world), self.id, radius)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_half_extents(half_extents)
    local hold = {}
    local code = C.thud_shape_set_half_extents(pointer(self.world), self.id, value("thud_vec2", half_extents, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_events(events)
    local code = C.thud_shape_set_events(pointer(self.world), self.id, events)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:set_user_data(user_data)
    local code = C.thud_shape_set_user_data(pointer(self.world), self.id, user_data)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_kind(kind)
    local hold = {}
    local code = C.thud_body_set_kind(pointer(self.world), self.id, value("thud_body_kind", kind, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_damping(linear, angular)
    local code = C.thud_body_set_damping(pointer(self.world), self.id, linear, angular)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_gravity_scale(gravity_scale)
    local code = C.thud_body_set_gravity_scale(pointer(self.world), self.id, gravity_scale)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_fixed_rotation(fixed)
    local code = C.thud_body_set_fixed_rotation(pointer(self.world), self.id, fixed)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_detection(detection)
    local hold = {}
    local code = C.thud_body_set_detection(pointer(self.world), self.id, input("thud_detection", detection, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_may_sleep(may_sleep)
    local code = C.thud_body_set_may_sleep(pointer(self.world), self.id, may_sleep)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_mass(mass)
    local hold = {}
    local code = C.thud_body_set_mass(pointer(self.world), self.id, input("thud_mass", mass, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_force(force, point)
    local hold = {}
    local code = C.thud_body_apply_force(pointer(self.world), self.id, value("thud_vec2", force, hold), value("thud_pos", point, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_center_impulse(impulse)
    local hold = {}
    local code = C.thud_body_apply_center_impulse(pointer(self.world), self.id, value("thud_vec2", impulse, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_angular_impulse(impulse)
    local code = C.thud_body_apply_angular_impulse(pointer(self.world), self.id, impulse)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_target(position, angle)
    local hold = {}
    local code = C.thud_body_set_target(pointer(self.world), self.id, value("thud_pos", position, hold), angle)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:velocity_at(point)
    local hold = {}
    local out = ffi.new("thud_vec2")
    local code = C.thud_body_get_velocity_at(pointer(self.world), self.id, value("thud_pos", point, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Body:world_point(point)
    local hold = {}
    local out = ffi.new("thud_pos")
    local code = C.thud_body_get_world_point(pointer(self.world), self.id, value("thud_vec2", point, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Body:local_point(point)
    local hold = {}
    local out = ffi.new("thud_vec2")
    local code = C.thud_body_get_local_point(pointer(self.world), self.id, value("thud_pos", point, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Body:world_vector(vector)
    local hold = {}
    local out = ffi.new("thud_vec2")
    local code = C.thud_body_get_world_vector(pointer(self.world), self.id, value("thud_vec2", vector, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Body:local_vector(vector)
    local hold = {}
    local out = ffi.new("thud_vec2")
    local code = C.thud_body_get_local_vector(pointer(self.world), self.id, value("thud_vec2", vector, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.default_explosion()
    return C.thud_default_explosion()
end

function World:explode(explosion)
    local hold = {}
    local pushed = ffi.new("int[1]")
    local code = C.thud_world_explode(pointer(self), input("thud_explosion", explosion, hold), pushed)
    if code ~= 0 or pending then
        return refused(code)
    end
    return pushed[0]
end

function Body:apply_wind(wind, density, drag, lift)
    local hold = {}
    local code = C.thud_body_apply_wind(pointer(self.world), self.id, value("thud_vec2", wind, hold), density, drag, lift)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.default_water()
    return C.thud_default_water()
end

function Body:apply_buoyancy(water)
    local hold = {}
    local code = C.thud_body_apply_buoyancy(pointer(self.world), self.id, input("thud_water", water, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.geometry_area_below(shape_, below)
    local hold = {}
    local area = ffi.new("double[1]")
    local center_x = ffi.new("double[1]")
    local center_y = ffi.new("double[1]")
    local code = C.thud_geometry_area_below(input("thud_geometry", shape_, hold), value("thud_half_plane", below, hold), area, center_x, center_y)
    if code ~= 0 or pending then
        return refused(code)
    end
    return area[0], center_x[0], center_y[0]
end

function Body:apply_rolling_resistance(coefficient)
    local code = C.thud_body_apply_rolling_resistance(pointer(self.world), self.id, coefficient)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:apply_grip(point, axis, speed, max_force)
    local hold = {}
    local code = C.thud_body_apply_grip(pointer(self.world), self.id, value("thud_vec2", point, hold), value("thud_vec2", axis, hold), speed, max_force)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.default_joint_def(kind)
    local hold = {}
    return C.thud_default_joint_def(value("thud_joint_kind", kind, hold))
end

function World:create_joint(def)
    local hold = {}
    local out = ffi.new("thud_joint_id")
    local code = C.thud_joint_create(pointer(self), input("thud_joint_def", def, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return joint(self, out)
end

function Joint:destroy()
    local code = C.thud_joint_destroy(pointer(self.world), self.id)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Joint:is_valid()
    return C.thud_joint_is_valid(pointer(self.world), self.id)
end

function Joint:state()
    local out = ffi.new("thud_joint_state")
    local code = C.thud_joint_get_state(pointer(self.world), self.id, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Joint:def()
    local out = ffi.new("thud_joint_def")
    local code = C.thud_joint_get_def(pointer(self.world), self.id, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Joint:set_drive(direction, drive)
    local hold = {}
    local code = C.thud_joint_set_drive(pointer(self.world), self.id, value("thud_direction", direction, hold), input("thud_drive", drive, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Joint:set_length(length)
    local code = C.thud_joint_set_length(pointer(self.world), self.id, length)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Joint:set_enabled(enabled)
    local code = C.thud_joint_set_enabled(pointer(self.world), self.id, enabled)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Joint:set_frame(side, frame)
    local hold = {}
    local code = C.thud_joint_set_frame(pointer(self.world), self.id, side, value("thud_joint_frame", frame, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Joint:set_breaking(force, torque, only_reports)
    local code = C.thud_joint_set_breaking(pointer(self.world), self.id, force, torque, only_reports)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Joint:set_user_data(user_data)
    local code = C.thud_joint_set_user_data(pointer(self.world), self.id, user_data)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:joint_events()
    local view, view_count = ffi.new("const thud_joint_event *[1]"), ffi.new("int[1]")
    local code = C.thud_world_get_joint_events(pointer(self), view, view_count)
    if code ~= 0 or pending then
        return refused(code)
    end
    return view[0], view_count[0]
end

function World:joints()
    local code, out, found_count = list("thud_joint_id", 16, function(out, room, number)
        return C.thud_world_get_joints(pointer(self), out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(joint, self, out, found_count)
end

function Body:joints()
    local code, out, found_count = list("thud_joint_id", 16, function(out, room, number)
        return C.thud_body_get_joints(pointer(self.world), self.id, out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(joint, self.world, out, found_count)
end

function World:use_joints()
    local code = C.thud_world_use_joints(pointer(self))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:hinge_at(body_a, body_b, point)
    local hold = {}
    return C.thud_hinge_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", point, hold))
end

function World:weld_at(body_a, body_b, point)
    local hold = {}
    return C.thud_weld_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", point, hold))
end

function World:slider_at(body_a, body_b, point, axis)
    local hold = {}
    return C.thud_slider_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", point, hold), value("thud_vec2", axis, hold))
end

function World:wheel_at(body_a, body_b, point, axis)
    local hold = {}
    return C.thud_wheel_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", point, hold), value("thud_vec2", axis, hold))
end

function World:target_at(body_a, body_b, point)
    local hold = {}
    return C.thud_target_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", point, hold))
end

function World:rod_at(body_a, body_b, from, to)
    local hold = {}
    return C.thud_rod_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", from, hold), value("thud_pos", to, hold))
end

function World:rope_at(body_a, body_b, from, to, length)
    local hold = {}
    return C.thud_rope_at(pointer(self), value("thud_body_id", body_a, hold), value("thud_body_id", body_b, hold), value("thud_pos", from, hold), value("thud_pos", to, hold), length)
end

function World:make_joint(def)
    local hold = {}
    return joint(self, C.thud_joint_make(pointer(self), value("thud_joint_def", def, hold)))
end

function World:set_listeners(listeners)
    local hold = {}
    local code = C.thud_world_set_listeners(pointer(self), input("thud_listeners", listeners, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:set_epilogue(epilogue)
    local given_0 = pointer(self.world)
    local called = epilogue and callback("thud_object_epilogue_fn", epilogue, FAILED["void"])
    local code = C.thud_body_set_epilogue(given_0, self.id, called, nil)
    keep_callback(self, "thud_body_set_epilogue", called, code)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:set_category_epilogue(categories, epilogue)
    local given_0 = pointer(self)
    local called = epilogue and callback("thud_object_epilogue_fn", epilogue, FAILED["void"])
    local code = C.thud_world_set_category_epilogue(given_0, categories, called, nil)
    keep_callback(self, "thud_world_set_category_epilogue", called, code)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:decide_contact(contact, a, b)
    local hold = {}
    local code = C.thud_contact_decide(pointer(self), input("thud_contact", contact, hold), input("thud_velocities", a, hold), input("thud_velocities", b, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:bodies()
    local code, out, found_count = list("thud_body_id", 16, function(out, room, number)
        return C.thud_world_get_bodies(pointer(self), out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(body, self, out, found_count)
end

function World:awake_bodies()
    local code, out, found_count = list("thud_body_id", 16, function(out, room, number)
        return C.thud_world_get_awake_bodies(pointer(self), out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(body, self, out, found_count)
end

function World:shapes()
    local code, out, found_count = list("thud_shape_id", 16, function(out, room, number)
        return C.thud_world_get_shapes(pointer(self), out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(shape, self, out, found_count)
end

function World:slot_counts()
    local bodies = ffi.new("int[1]")
    local shapes = ffi.new("int[1]")
    local code = C.thud_world_get_slot_counts(pointer(self), bodies, shapes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return bodies[0], shapes[0]
end

function World:body_at(slot)
    local out = ffi.new("thud_body_id")
    local code = C.thud_world_get_body_at(pointer(self), slot, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return body(self, out)
end

function World:shape_at(slot)
    local out = ffi.new("thud_shape_id")
    local code = C.thud_world_get_shape_at(pointer(self), slot, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return shape(self, out)
end

function World:moved_bodies(seen)
    local hold = {}
    local seen_array, count = array("thud_body_seen", seen, hold)
    local code, out, found_count = list("thud_body_id", count, function(out, room, number)
        return C.thud_world_get_moved_bodies(pointer(self), seen_array, count, out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(body, self, out, found_count)
end

function Shape:sensor_overlaps()
    local code, out, found_count = list("thud_shape_id", 16, function(out, room, number)
        return C.thud_shape_get_sensor_overlaps(pointer(self.world), self.id, out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return handles(shape, self.world, out, found_count)
end

function World:pair(shape_a, shape_b)
    local hold = {}
    local out = ffi.new("thud_pair")
    local code = C.thud_world_get_pair(pointer(self), value("thud_shape_id", shape_a, hold), value("thud_shape_id", shape_b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function World:next_event_pair(first, second, pair)
    return C.thud_world_next_event_pair(pointer(self), first, second, pair)
end

function Body:set_locks(x, y)
    local code = C.thud_body_set_locks(pointer(self.world), self.id, x, y)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Body:locks()
    local x = ffi.new("_Bool[1]")
    local y = ffi.new("_Bool[1]")
    local code = C.thud_body_get_locks(pointer(self.world), self.id, x, y)
    if code ~= 0 or pending then
        return refused(code)
    end
    return x[0], y[0]
end

function World:make_body(shape_, options)
    local hold = {}
    return body(self, C.thud_body_make(pointer(self), value("thud_geometry", shape_, hold), input("thud_body_options", options, hold)))
end

function thud.minkowski_sum(a, b)
    local hold = {}
    local out = ffi.new("thud_minkowski")
    local code = C.thud_minkowski_sum(input("thud_geometry", a, hold), input("thud_geometry", b, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.minkowski_contains(sum, x, y)
    local hold = {}
    local inside = ffi.new("_Bool[1]")
    local code = C.thud_minkowski_contains(input("thud_minkowski", sum, hold), x, y, inside)
    if code ~= 0 or pending then
        return refused(code)
    end
    return inside[0]
end

function thud.minkowski_distance(sum, x, y)
    local hold = {}
    local distance = ffi.new("double[1]")
    local nx = ffi.new("double[1]")
    local ny = ffi.new("double[1]")
    local code = C.thud_minkowski_distance(input("thud_minkowski", sum, hold), x, y, distance, nx, ny)
    if code ~= 0 or pending then
        return refused(code)
    end
    return distance[0], nx[0], ny[0]
end

function thud.minkowski_cast(sum, path)
    local hold = {}
    local found = ffi.new("_Bool[1]")
    local fraction = ffi.new("double[1]")
    local nx = ffi.new("double[1]")
    local ny = ffi.new("double[1]")
    local code = C.thud_minkowski_cast(input("thud_minkowski", sum, hold), value("thud_segment", path, hold), found, fraction, nx, ny)
    if code ~= 0 or pending then
        return refused(code)
    end
    if not found[0] then
        return false
    end
    return fraction[0], nx[0], ny[0]
end

function thud.mover_passes_one_way(mover, hit, velocity, context)
    local hold = {}
    return C.thud_mover_passes_one_way(input("thud_mover", mover, hold), input("thud_mover_hit", hit, hold), value("thud_vec2", velocity, hold), context)
end

function thud.default_mover(shape_)
    local hold = {}
    return C.thud_default_mover(value("thud_geometry", shape_, hold))
end

function World:mover_move(mover, velocity, dt)
    local hold = {}
    local report = ffi.new("thud_mover_report")
    local code = C.thud_mover_move(pointer(self), mover, value("thud_vec2", velocity, hold), dt, report)
    if code ~= 0 or pending then
        return refused(code)
    end
    return report
end

function World:pack(base, snapshot, buffer)
    local hold = {}
    local buffer_data, buffer_size = to_write(buffer)
    local bytes = ffi.new("size_t[1]")
    local code = C.thud_world_pack(pointer(self), thud_bytes(base, hold), thud_bytes(snapshot, hold), buffer_data, buffer_size, bytes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return tonumber(bytes[0])
end

function World:unpack(base, packed, buffer)
    local hold = {}
    local buffer_data, buffer_size = to_write(buffer)
    local bytes = ffi.new("size_t[1]")
    local code = C.thud_world_unpack(pointer(self), thud_bytes(base, hold), thud_bytes(packed, hold), buffer_data, buffer_size, bytes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return tonumber(bytes[0])
end

function World:extrapolate(bodies, seconds)
    local hold = {}
    local bodies_array, count = array("thud_body_id", bodies, hold)
    local out_ = ffi.new("thud_prediction[?]", count)
    local code = C.thud_world_extrapolate(pointer(self), bodies_array, count, seconds, out_)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out_
end

function World:extrapolate_awake(seconds)
    local code, out, found_count = list("thud_prediction", 16, function(out, room, number)
        return C.thud_world_extrapolate_awake(pointer(self), seconds, out, room, number)
    end)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out, found_count
end

function World:predict(bodies, seconds)
    local hold = {}
    local bodies_array, count = array("thud_body_id", bodies, hold)
    local out_ = ffi.new("thud_prediction[?]", count)
    local code = C.thud_world_predict(pointer(self), bodies_array, count, seconds, out_)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out_
end

function Body:position()
    local position = ffi.new("thud_pos")
    local code = C.thud_body_get_position(pointer(self.world), self.id, position)
    if code ~= 0 or pending then
        return refused(code)
    end
    return position
end

function Body:rotation()
    local angle = ffi.new("double[1]")
    local cosine = ffi.new("float[1]")
    local sine = ffi.new("float[1]")
    local code = C.thud_body_get_rotation(pointer(self.world), self.id, angle, cosine, sine)
    if code ~= 0 or pending then
        return refused(code)
    end
    return angle[0], cosine[0], sine[0]
end

function Body:velocity()
    local velocity = ffi.new("thud_vec2")
    local angular_velocity = ffi.new("float[1]")
    local code = C.thud_body_get_velocity(pointer(self.world), self.id, velocity, angular_velocity)
    if code ~= 0 or pending then
        return refused(code)
    end
    return velocity, angular_velocity[0]
end

function Body:user_data()
    local user_data = ffi.new("uint64_t[1]")
    local code = C.thud_body_get_user_data(pointer(self.world), self.id, user_data)
    if code ~= 0 or pending then
        return refused(code)
    end
    return user_data[0]
end

function Shape:user_data()
    local user_data = ffi.new("uint64_t[1]")
    local code = C.thud_shape_get_user_data(pointer(self.world), self.id, user_data)
    if code ~= 0 or pending then
        return refused(code)
    end
    return user_data[0]
end

function Shape:body()
    local body_ = ffi.new("thud_body_id")
    local code = C.thud_shape_get_body(pointer(self.world), self.id, body_)
    if code ~= 0 or pending then
        return refused(code)
    end
    return body(self.world, body_)
end

function World:step_settings()
    local out = ffi.new("thud_step_settings")
    local code = C.thud_world_get_step_settings(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function World:broadphase_counts()
    local out = ffi.new("thud_broadphase_counts")
    local code = C.thud_world_get_broadphase_counts(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Rollback:input(player, step, input_)
    local code = C.thud_rollback_input(pointer(self), player, step, input_)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Rollback:advance()
    local made = ffi.new("_Bool[1]")
    local code = C.thud_rollback_advance(pointer(self), made)
    if code ~= 0 or pending then
        return refused(code)
    end
    return made[0]
end

function Rollback:settle()
    local code = C.thud_rollback_settle(pointer(self))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Rollback:progress()
    local out = ffi.new("thud_rollback_progress")
    local code = C.thud_rollback_get_progress(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Rollback:state(step, out_state)
    local hash = ffi.new("uint64_t[1]")
    local code = C.thud_rollback_get_state(pointer(self), step, hash, out_state)
    if code ~= 0 or pending then
        return refused(code)
    end
    return hash[0]
end

function Rollback:report(step, buffer)
    local buffer_data, buffer_size = to_write(buffer)
    local bytes = ffi.new("size_t[1]")
    local code = C.thud_rollback_report(pointer(self), step, buffer_data, buffer_size, bytes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return tonumber(bytes[0])
end

function Rollback:compare(report)
    local report_data, report_size = to_read(report)
    local out = ffi.new("thud_rollback_difference")
    local code = C.thud_rollback_compare(pointer(self), report_data, report_size, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Rollback:lead(player)
    local lead = ffi.new("int64_t[1]")
    local code = C.thud_rollback_get_lead(pointer(self), player, lead)
    if code ~= 0 or pending then
        return refused(code)
    end
    return lead[0]
end

function Rollback:set_lead(player, lead)
    local code = C.thud_rollback_set_lead(pointer(self), player, lead)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Rollback:leave(player, step)
    local code = C.thud_rollback_leave(pointer(self), player, step)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Rollback:enter(player, step)
    local code = C.thud_rollback_enter(pointer(self), player, step)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Rollback:snapshot(buffer)
    local buffer_data, buffer_size = to_write(buffer)
    local bytes = ffi.new("size_t[1]")
    local code = C.thud_rollback_snapshot(pointer(self), buffer_data, buffer_size, bytes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return tonumber(bytes[0])
end

function Rollback:restore(buffer)
    local buffer_data, buffer_size = to_read(buffer)
    local code = C.thud_rollback_restore(pointer(self), buffer_data, buffer_size)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.default_rule()
    return C.thud_default_rule()
end

function World:set_rule(first, second, rule)
    local hold = {}
    local code = C.thud_world_set_rule(pointer(self), first, second, input("thud_rule", rule, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:rule(first, second)
    local out = ffi.new("thud_rule")
    local is_set = ffi.new("_Bool[1]")
    local reversed = ffi.new("_Bool[1]")
    local code = C.thud_world_get_rule(pointer(self), first, second, out, is_set, reversed)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out, is_set[0], reversed[0]
end

function World:use_rules()
    local code = C.thud_world_use_rules(pointer(self))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:impulse_events()
    local view, view_count = ffi.new("const thud_impulse_event *[1]"), ffi.new("int[1]")
    local code = C.thud_world_get_impulse_events(pointer(self), view, view_count)
    if code ~= 0 or pending then
        return refused(code)
    end
    return view[0], view_count[0]
end

function World:snapshot_size()
    local bytes = ffi.new("size_t[1]")
    local code = C.thud_world_get_snapshot_size(pointer(self), bytes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return tonumber(bytes[0])
end

function World:snapshot(buffer)
    local buffer_data, buffer_size = to_write(buffer)
    local bytes = ffi.new("size_t[1]")
    local code = C.thud_world_snapshot(pointer(self), buffer_data, buffer_size, bytes)
    if code ~= 0 or pending then
        return refused(code)
    end
    return tonumber(bytes[0])
end

function World:restore(buffer)
    local buffer_data, buffer_size = to_read(buffer)
    local code = C.thud_world_restore(pointer(self), buffer_data, buffer_size)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:save(path, own)
    local own_data, own_size = to_read(own)
    local code = C.thud_world_save(pointer(self), path, own_data, own_size)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function World:load(path, own)
    local own_data, own_size = to_write(own)
    local code = C.thud_world_load(pointer(self), path, own_data, own_size)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.world_def_set_baseline_simd(def, baseline_simd)
    local code = C.thud_world_def_set_baseline_simd(def, baseline_simd)
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function thud.texture_friction_at(texture, sample)
    local hold = {}
    local out = ffi.new("float[1]")
    local code = C.thud_texture_friction_at(input("thud_texture", texture, hold), input("thud_terrain_sample", sample, hold), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out[0]
end

function Shape:set_texture(texture)
    local hold = {}
    local code = C.thud_shape_set_texture(pointer(self.world), self.id, input("thud_texture", texture, hold))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Shape:texture()
    local out = ffi.new("thud_texture")
    local code = C.thud_shape_get_texture(pointer(self.world), self.id, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function Shape:friction_at(x)
    local out = ffi.new("float[1]")
    local code = C.thud_shape_get_friction_at(pointer(self.world), self.id, x, out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out[0]
end

function World:use_textures()
    local code = C.thud_world_use_textures(pointer(self))
    if code ~= 0 or pending then
        return refused(code)
    end
    return true
end

function Threads:job_system()
    local out = ffi.new("thud_job_system")
    local code = C.thud_threads_get_job_system(pointer(self), out)
    if code ~= 0 or pending then
        return refused(code)
    end
    return out
end

function thud.version()
    return C.thud_version()
end

---- end ----

---- what owns ----

-- Frees what an owner has, with its callbacks, after all that use it: the collector may end them in any
-- order. Nil and the reason where C refuses that, inside a callback.
local function free(node)
    if node.users == 0 then
        message = nil
        node.destroy(node.pointer)
        if message then
            return refused(0)
        end
        for _, made in pairs(node.callbacks) do
            made:free()
        end
    end
    node.ended = true
    if node.users == 0 then
        if node.uses then
            node.uses.users = node.uses.users - 1
            if node.uses.ended then
                free(node.uses)
            end
        end
    end
    return true
end

-- An object that C frees with the Lua object, or by close().
local function owner(class, destroy)
    class.__index = class
    function class:close()
        if self.pointer then
            local freed, reason = free(self.node)
            if not freed then
                return nil, reason
            end
            ffi.gc(self.pointer, nil)
            self.pointer = nil
        end
        return true
    end
    return function(made, used)
        local node = { pointer = made, destroy = destroy, users = 0, uses = used and used.node, callbacks = {} }
        if node.uses then
            node.uses.users = node.uses.users + 1
        end
        local held = ffi.gc(ffi.cast(ffi.typeof(made), made), function()
            free(node)
        end)
        return setmetatable({ pointer = held, node = node }, class)
    end
end

local own_world = owner(World, C.thud_world_destroy)
local own_rollback = owner(Rollback, C.thud_rollback_destroy)
local own_threads = owner(Threads, C.thud_threads_destroy)

--- A new world. Options are the fields of thud_world_def, and `threads`, a pool that it uses.
function thud.world(options)
    local given, hold = {}, {}
    for name, option in pairs(options or {}) do
        if name == "log" or name == "log_context" then
            error("the log is this module's: what is refused returns nil and the reason", 2)
        end
        given[name] = option
    end
    local pool = given.threads
    given.threads = nil
    local def = fill(C.thud_default_world_def(), "thud_world_def", given, hold)
    def.log = log
    if pool then
        def.job_system = assert(pool:job_system())
    end
    local out = ffi.new("thud_world *[1]")
    local code = C.thud_world_create(def, out)
    if code ~= 0 then
        return refused(code)
    end
    return own_world(out[0], pool)
end

--- A pool of threads; see thud_threads.h.
function thud.threads(workers)
    local out = ffi.new("thud_threads *[1]")
    local code = C.thud_threads_create(workers, nil, out)
    if code ~= 0 then
        return refused(code)
    end
    return own_threads(out[0])
end

--- Networked play; see thud_rollback.h. Options are the fields of thud_rollback_options.
function World:create_rollback(options)
    local hold = {}
    local given = input("thud_rollback_options", options, hold)
    local out = ffi.new("thud_rollback *[1]")
    local code = C.thud_rollback_create(pointer(self), given, out)
    if code ~= 0 then
        return refused(code)
    end
    return own_rollback(out[0], self)
end

---- what is simpler in Lua ----

local poses, snapshot = World.poses, World.snapshot

--- The poses by slot between the last two steps, x and y relative to `origin`: an array from 0, and its
--- length.
function World:poses(alpha, origin)
    return poses(self, origin or { 0, 0 }, alpha or 1)
end

--- The whole state as a string, for restore().
function World:snapshot()
    local size, reason = self:snapshot_size()
    if not size then
        return nil, reason
    end
    local buffer = ffi.new("char[?]", size)
    local bytes
    bytes, reason = snapshot(self, buffer)
    return bytes and ffi.string(buffer, bytes), reason
end

local advance, step = World.advance, World.step

--- Runs the steps that fit into these seconds; returns their number, and alpha for poses().
function World:advance(seconds, max_steps)
    return advance(self, seconds, max_steps or 4)
end

--- Runs one step, or so many.
function World:step(steps)
    for _ = 1, steps or 1 do
        local done, reason = step(self)
        if not done then
            return nil, reason
        end
    end
    return true
end

return thud
