/* joint.h: what the files of this folder share: the parts of a joint, its geometry and its sides.
 *
 * A joint is a td_joint and up to four constraints of the graph, its parts, each with a lane of its
 * own while the joint acts:
 *     part                          constraint kind     lanes, solver passes, direct solver's rows
 *     locked directions             TD_CONSTRAINT_LOCK  lock.c, wide_lock.c, joint_rows.c
 *     locked distance               TD_CONSTRAINT_ROD   rod.c, wide_rod.c, joint_rows.c
 *     a driven direction (spring,   TD_CONSTRAINT_DRIVE_LINE (a distance), _AXIS (along, across),
 *       motor, limits)              _TURN (rotation)    drive.c, wide_drive.c, joint_rows.c
 *     gear                          TD_CONSTRAINT_GEAR  gear.c, wide_gear.c
 * wide_place.c computes the rows at the start of a step. joint_make.c creates joints, joint_set.c
 * changes and joint_state.c reads them for the caller.
 *
 * Geometry. A joint has an anchor on each body and an axis fixed in body a. Its frame is u, the
 * direction `along`, and v = (-u.y, u.x), `across`. The gap is the vector d from a's anchor to b's,
 * with d.u and d.v. With the lever arms r_a and r_b from the centres of mass to the anchors, the
 * coordinate d.u changes by
 *     u . (v_b - v_a) + (r_b x u) w_b - ((r_a + d) x u) w_a
 * since the frame turns with a, whose lever arm then ends at b's anchor. Where both along and
 * across are locked, the frame does not turn within the step, and d is left out. A distance has u
 * along d, and no v. Lanes keep the crosses r x u as cross_a, cross_b of point[0], and r x v as
 * those of point[1].
 *
 * Sides. A static body is always side a of its constraints. Where the caller gave it as body b, the
 * sides are `swapped`: the axis is then stored with the opposite sign, and turn_sign is -1, so that
 * the coordinates are those of the caller's order. */
#ifndef TD_JOINT_H
#define TD_JOINT_H

#include "base/reason.h"
#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "thud/thud_joint.h"

static inline td_joint *td_joint_at(const thud_world *w, int index) {
    return td_slot_of(&w->joints, index, sizeof(td_joint));
}

static inline td_joint *td_joint_of(const thud_world *w, const td_constraint *part) {
    return td_joint_at(w, part->joint);
}

/* joint_state.c: finds a joint by its handle, and sets *index to its slot. THUD_ERROR_NULL without
 * a world, THUD_ERROR_STALE if the joint is destroyed, and, if the caller `edits` it,
 * THUD_ERROR_LOCKED inside a callback. The last two are logged. */
thud_result td_find_joint(const thud_world *w, thud_joint_id id, bool edits, int *index);

thud_joint_id td_joint_handle(const thud_world *w, int index);

/* joint_def.c. Whether a frame is within its ranges; otherwise *why says which value is not. */
bool td_joint_frame_valid(const thud_world *w, td_reason *why, const thud_joint_frame *f);
/* The reason why a drive is not valid for this direction of this kind, or null. */
const char *td_joint_drive_error(const thud_world *w, thud_joint_kind kind, int direction,
                                 const thud_drive *d, td_reason *why);
/* Logs settings that are valid but without effect: a motor's speed with a maximum force of 0. */
void td_joint_warn_of_drive(const thud_world *w, const thud_drive *d);
/* The reason why the def is not valid, or null. a, b: its bodies. */
const char *td_joint_def_error(const thud_world *w, const thud_joint_def *d, td_body_index a,
                               td_body_index b, td_reason *why);
/* Whether a force or torque at which a joint breaks is in range; otherwise *why says so. */
static inline bool td_joint_break_valid(td_reason *why, const char *name, float x) {
    return td_in(why, name, (double)x, 0.0, (double)THUD_JOINT_FORCE_MAX);
}
/* Converts a drive to the form that the joint stores. Limits that are not used, and may be any
 * number, become 0; padding bytes are not copied. */
td_drive td_drive_of(const thud_drive *d);
/* The td_joint of a def, without parts; a static body becomes body[0]. */
td_joint td_joint_of_def(const thud_world *w, const thud_joint_def *d, td_body_index a,
                         td_body_index b);
/* Sets the joint's frame in body[side]. */
void td_joint_set_place(td_joint *joint, int side, const thud_joint_frame *f);

/* Whether edits/locks.c made this joint to lock x or y of a body that a program has axis-locked
 * (thud_locks.h). */
static inline bool td_joint_is_lock(const thud_world *w, const td_joint *joint,
                                    td_body_index body) {
    return td_same_body(joint->body[1], body) &&
           (td_body_at(w, joint->body[0])->flags & TD_BODY_ANCHOR) &&
           (joint->kind == THUD_JOINT_HINGE || joint->kind == THUD_JOINT_WHEEL);
}

/* joint_make.c. Reserves memory for all parts that a joint of this kind may have; false when memory
 * is short. */
bool td_joint_reserve(thud_world *w, int kind);
/* After td_joint_reserve: creates the parts that the joint needs and lacks, destroys the others,
 * and wakes its bodies. */
void td_joint_update_parts(thud_world *w, int index);

/* joint_end.c. After a change of the joint: wakes its bodies, and marks its lanes, so that the next
 * step copies the joint's settings to them again. */
void td_joint_wake(thud_world *w, const td_joint *joint);
/* Destroys the joint, and wakes its bodies. */
void td_joint_end(thud_world *w, int index);

/* joint_measure.c: coordinates and gaps of a joint, as thud_joint_state has them: lengths, and
 * radians for turn. */
typedef struct td_joint_reading {
    double value[TD_JOINT_DIRECTIONS], gap, angle_gap;
} td_joint_reading;

/* The force and torque of a joint on the caller's b. */
typedef struct td_joint_load {
    thud_vec2 force;
    float torque;
} td_joint_load;

td_joint_reading td_joint_read(const thud_world *w, const td_joint *joint);
td_joint_load td_joint_load_of(const thud_world *w, const td_joint *joint);
/* Forces of a direction's limits, spring and motor. */
thud_drive_forces td_joint_drive_forces(const thud_world *w, const td_joint *joint, int direction);
/* Whether the joint acts: one of its parts has a lane in the blocks of awake bodies. */
bool td_joint_acts(const thud_world *w, const td_joint *joint);

/* Whether the joint has a maximum force or torque at which it breaks or reports an event. */
static inline bool td_joint_breaks(const td_joint *joint) {
    return joint->break_force < THUD_JOINT_FORCE_MAX || joint->break_torque < THUD_JOINT_FORCE_MAX;
}

/* Whether a target is the default of a distance, -infinity, which stands for td_joint.length. */
static inline bool td_target_is_length(float target) {
    return target == -__builtin_inff();
}

/* The target of a direction's spring, a length or an angle. */
static inline float td_joint_target(const td_joint *joint, int direction) {
    float target = joint->drive[direction].target;
    return td_target_is_length(target) ? joint->length : target;
}

/* Angular frequency of a spring, rad/s, limited so that its phase in a substep is at most
 * TD_SPRING_PHASE rad. The direct solver has the same limit as the soft one, so that springs act
 * alike under both. `frequency` in Hz. */
static inline double td_spring_omega(const thud_world *w, float frequency) {
    double max_omega = (double)TD_SPRING_PHASE * w->substeps / w->def.time_step;
    return td_min_double(2.0 * TD_PI * (double)frequency, max_omega);
}

/* Whether a drive has limits, a spring or a motor. */
static inline bool td_drive_acts(const td_drive *d) {
    return d->limited || d->frequency > 0.0f || d->motor_force > 0.0f;
}

/* Sets td_joint.locked and .driven by the joint's kind and its drives. */
void td_joint_sort_directions(td_joint *joint);
/* The directions that a kind lets the caller drive: bits 1 << thud_direction. */
unsigned td_joint_drivable(int kind);
/* The kind of constraint of a part. */
int td_joint_part_kind(const td_joint *joint, int part);

/* Geometry of a joint in world axes, from the present poses of its bodies. */
typedef struct td_joint_place {
    float arm[2][2];      /* lever arms, from the centres of mass to the anchors */
    float x, y;           /* from a's anchor to b's */
    float turn;           /* coordinate of turn, in (-pi, pi], for the caller's order of sides */
    float turn_sign;      /* 1; -1 where the sides are swapped */
    float axis_x, axis_y; /* direction `along` */
} td_joint_place;

td_joint_place td_joint_place_of(const thud_world *w, const td_joint *joint);

/* Returns the distance between the anchors; (*x, *y) is the unit vector from a's anchor to b's, or
 * (0, 1) if they coincide. */
float td_joint_line(const td_joint_place *place, float *x, float *y);

/* The factor by which a constant in length scales or radians is multiplied to bound a gap in the
 * caller's units: the length of a length scale for lengths, 1 for angles. */
static inline double td_gap_unit(const thud_world *w, bool is_angle) {
    return is_angle ? 1.0 : (double)w->length_scale;
}

/* The speed that closes a gap within `time`, at most TD_JOINT_CLOSING_SPEED units a second. `unit`:
 * td_gap_unit. */
double td_joint_closing_speed(double gap, double unit, double time);
/* The angle, rad, up to which td_joint_sincos evaluates the series. */
#define TD_SERIES_ANGLE_MAX 0.125

/* Square of half a rotation, rad^2, below which the chord is taken to have the length of the arc:
 * sin(x) / x = 1 - x^2 / 6 is then within 2e-13 of 1. Avoids 0 / 0. */
#define TD_CHORD_IS_ARC 1e-12

/* Gaps up to this width, in length scales or radians, are not closed: they come from the rounding
 * of lever arms and motions to single precision (2^-24 = 6e-8 of each, several of them added). In a
 * loop with redundant locks, closing all of them would cause impulses against each other. Measured:
 * at 0 pendulum_keeps_time_by_its_substeps (test_joints_phase.c) and
 * chain_swings_without_stretching (test_joint_scenes.c) fail. */
#define TD_GAP_IGNORED 1e-6

/* Of a gap wider than TD_GAP_IGNORED, this share closes in a whole step (in a part, in proportion
 * to its length), and in every part the width TD_GAP_CLOSED_MIN in addition, in length scales or
 * radians, so that small gaps close completely. In a chain with many open gaps the speeds at which
 * they close add up: if all of them closed at once, its end would move far in one step. Measured on
 * the tests of joints: all pass at half and double the share, and at a width of 0;
 * lorry_crosses_the_bridge (test_joint_scenes.c) fails at a share of 1 and at ten times the
 * width. */
#define TD_GAP_SHARE_PER_STEP 0.2
#define TD_GAP_CLOSED_MIN 1e-4

/* joint_rows.c. The speed at which a gap closes in a part of the step that lasts `time` (s): the
 * part closes a share of the gap, and a small width on top, but at no more than
 * TD_JOINT_CLOSING_SPEED. (closing_of in wide_lock_tree_parts.c is the same for several gaps.) */
double td_joint_part_closing(const thud_world *w, double gap, double unit, double time);

/* arm x (x, y) */
static inline float td_cross(const float arm[2], float x, float y) {
    return arm[0] * y - arm[1] * x;
}

/* A lane's frame in double precision (frame8 of wide_joint.h in single): u = (x, y), v = (-y, x);
 * the cross products of a's and b's lever arms with u and v; and the gap from a's anchor to b's
 * along u and v. */
typedef struct td_joint_frame {
    double x, y, a_u, a_v, b_u, b_v, gap_u, gap_v;
} td_joint_frame;

/* joint.c. Sine and cosine, by their series for small angles. */
void td_joint_sincos(double angle, double *s, double *c);
/* Rotates a lever arm relative to a frame that does not turn; *u, *v are its cross products with u
 * and v. */
void td_joint_rotate_arm(double angle, double *u, double *v);
/* The frame at the start of the step, with this gap. */
td_joint_frame td_joint_frame_at(const td_block *block, int lane, double gap_u, double gap_v);
/* The frame after motions a, b (x, y, turn) of both sides since the start of the step. gap_u,
 * gap_v: the gap at the start. `turns`: the frame turns with a, and a's lever arm ends at b's
 * anchor; false: u and v do not change. */
td_joint_frame td_joint_frame_after(const td_block *block, int lane, double gap_u, double gap_v,
                                    bool turns, const double a[3], const double b[3]);
/* The frame after these motions with u along the gap, for distances. */
td_joint_frame td_joint_line_after(const td_block *block, int lane, double gap_u, double gap_v,
                                   const double a[3], const double b[3]);
/* Motions (x, y, turn) of a lane's sides in this step so far. */
void td_joint_motion(const thud_world *w, const td_block *block, int lane, double a[3],
                     double b[3]);
/* Speed of b's anchor relative to a's along (x, y); cross_a, cross_b: lever arms crossed with (x,
 * y). */
float td_joint_speed(const thud_world *w, const td_block *block, int lane, double x, double y,
                     double cross_a, double cross_b);

/* The inverse of a row's effective mass, J M^-1 J'. `linear`: 1, or 0 for a row of rotation
 * alone. */
float td_joint_inverse_mass(const thud_world *w, const td_block *block, int lane, float linear,
                            float cross_a, float cross_b);
/* td_lane_ops of all joints (anchors.c): a new or changed lane copies its joint in the next step; a
 * lane that a joint leaves needs no work. */
void td_joint_fill_lane(thud_world *w, td_block *block, int lane, int index);
void td_joint_renew_lane(thud_world *w, td_block *block, int lane, int index);
void td_joint_clear_lane(thud_world *w, td_block *block, int lane, int index);

/* anchors.c: copies anchors and settings from the joints to a block's lanes, and clears
 * td_block.anchors_stale. */
void td_joint_update_anchors(const thud_world *w, td_block *block);

/* wide_place.c: td_constraint_ops.collide_world of rods, locks and drives: computes their rows from
 * the present poses. All lanes stay in use. */
typedef void td_place_fn(thud_world *w, td_block *const *blocks, int count,
                         const td_collide_context *context);
TD_DECLARE_WIDE(td_place_fn, td_place_joints);

/* Inverse mass of the lighter body of a lane. */
static inline float td_joint_max_inverse_mass(const thud_world *w, const td_block *block,
                                              int lane) {
    return td_max_float(td_inv_mass_of(w, td_slot_of_side(block->a[lane])),
                        td_inv_mass_of(w, td_slot_of_side(block->b[lane])));
}

static inline float td_joint_abs(float x) {
    return x < 0.0f ? -x : x;
}

/* Defines the td_lane_ops `lanes` of a kind, below its functions `count` and `load` in its file. */
#define TD_DEFINE_JOINT_LANES(take, turn)                           \
    static const td_lane_ops lanes = {.fill = td_joint_fill_lane,   \
                                      .clear = td_joint_clear_lane, \
                                      .renew = td_joint_renew_lane, \
                                      .count = count,               \
                                      .load = load,                 \
                                      .take_rows = (take),          \
                                      .update_rows = (turn)};

#define TD_JOINT_OPS(block_form, prepare, solve_ops)                                              \
    {                                                                                             \
        .form = (block_form), .lanes = &lanes, .collide_world = (prepare), .solve = &(solve_ops), \
        .solve_centered = &(solve_ops)                                                            \
    }

/* Defines the operations ops_base and ops_avx2 of a kind, from which TD_PICK_WIDE chooses; used
 * below TD_DEFINE_JOINT_LANES. `solve` names its td_solve_ops, `prepare` its collide_world. */
#if defined(TD_HAS_AVX2)
#define TD_DEFINE_JOINT_OPS(ops, form, prepare, solve)                    \
    static const td_constraint_ops ops##_base =                           \
        TD_JOINT_OPS(form, TD_JOIN(prepare, base), TD_JOIN(solve, base)); \
    static const td_constraint_ops ops##_avx2 =                           \
        TD_JOINT_OPS(form, TD_JOIN(prepare, avx2), TD_JOIN(solve, avx2));
#else
#define TD_DEFINE_JOINT_OPS(ops, form, prepare, solve) \
    static const td_constraint_ops ops##_base =        \
        TD_JOINT_OPS(form, TD_JOIN(prepare, base), TD_JOIN(solve, base));
#endif

/* The operations of each kind, for the world's instruction set. */
const td_constraint_ops *td_rod_ops(const thud_world *w);
const td_constraint_ops *td_lock_ops(const thud_world *w);
const td_constraint_ops *td_drive_ops(const thud_world *w, int kind);

/* joint_rows.c: the rows of these kinds for the direct solver. */
td_take_rows_fn td_rod_take_rows, td_lock_take_rows, td_drive_take_rows;
td_update_rows_fn td_rod_update_rows, td_lock_update_rows, td_drive_update_rows;

#endif
