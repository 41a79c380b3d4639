/* operations.h: the operations that a fuzzer plays. Each takes its arguments from the session's
 * bytes, makes its calls by TRY, PURE or COUNTED, and adds their results to the digest. */
#ifndef FUZZ_OPERATIONS_H
#define FUZZ_OPERATIONS_H

#include "calls.h"
#include "pick.h"

typedef void fuzz_operation(fuzz_session *s);

/* An operation's index in the table is the byte that plays it, and never changes, so that kept
 * inputs keep their meaning when operations are added. Bytes without an operation play `step`. All
 * bytes are taken: a new operation is one of several that share a byte, as those of play_texture.
 */
enum { OPERATION_BYTES = 128 };

typedef struct named_operation {
    const char *name;
    fuzz_operation *play;
} named_operation;

extern const named_operation operations[OPERATION_BYTES];

/* How often each operation was played, in all sessions of the process. */
extern uint64_t operations_played[OPERATION_BYTES];

/* operations_worlds.c */
fuzz_operation play_step, play_advance, play_advance_with, play_log, play_settings, play_qualities,
    play_reading, play_names;
fuzz_operation play_poses, play_drawing, play_refused_worlds, play_nulls, play_limit;
fuzz_operation play_listeners, play_object_epilogues, play_decide;
/* operations_bodies.c */
/* Adds a body to the session's table; if the table is full, destroys the one that it replaces. */
void session_keep_body(fuzz_session *s, thud_body_id made);
fuzz_operation play_body, play_wild_body, play_body_destroy, play_body_get, play_transform;
fuzz_operation play_velocity, play_impulse, play_force, play_awake, play_enabled, play_user_data;
fuzz_operation play_body_shapes, play_body_contacts, play_body_volume, play_make;
fuzz_operation play_make_world;
/* operations_shapes.c */
fuzz_operation play_circle, play_aabb, play_obb, play_ground, play_thing, play_shape_destroy;
fuzz_operation play_shape_get, play_line_of, play_set_heights, play_dig, play_raise, play_replace;
/* operations_queries.c */
fuzz_operation play_ray, play_ray_all, play_cast_shape, play_cast_shape_all, play_cast_circle;
fuzz_operation play_cast_circle_all, play_cast_box, play_cast_box_all, play_overlap_shape;
fuzz_operation play_overlap_circle, play_overlap_aabb, play_overlap_obb, play_closest;
fuzz_operation play_ray_each, play_cast_each, play_rays, play_casts, play_meets_ray;
fuzz_operation play_shape_point, play_shape_bounds, play_prediction;
/* operations_movers.c: character movers and snapshots */
fuzz_operation play_mover, play_mover_settings, play_mover_place, play_snapshot, play_restore;
fuzz_operation play_restore_damaged;
/* operations_geometry.c */
fuzz_operation play_check, play_pair, play_pair_impact, play_pair_collision, play_approach;
thud_capsule pick_capsule(fuzz_session *s);
fuzz_operation play_shape_ray, play_minkowski, play_bisectable, play_sincos, play_angle_of;
fuzz_operation play_approximate, play_capsule;
/* operations_volumes.c */
fuzz_operation play_volume_fit, play_volume_points, play_volume_merge, play_volume_tests;
/* operations_joints.c */
fuzz_operation play_joint, play_joint_destroy, play_joint_edit, play_joint_get, play_joint_frame,
    play_joint_breaking, play_joint_lists, play_linkage, play_joint_at;
/* operations_edits.c */
fuzz_operation play_shape_edit, play_body_edit, play_push, play_points, play_reads;
fuzz_operation play_events, play_locks;
/* operations_lists.c */
fuzz_operation play_lists, play_slots, play_moved, play_sensed, play_sides, play_meetings;
/* operations_fields.c */
fuzz_operation play_explosion, play_wind, play_water, play_rolling, play_below, play_grip;
/* operations_rules.c */
fuzz_operation play_rule, play_rule_get, play_filter, play_impulses;
/* operations_sessions.c */
fuzz_operation play_saved, play_rollback;
/* operations_textures.c */
fuzz_operation play_texture;
/* operations_lines.c: terrain lines without a world */
fuzz_operation play_line_sample, play_line_shape, play_line_impact, play_line_ray, play_foot;
fuzz_operation play_line_capsule;

#endif
