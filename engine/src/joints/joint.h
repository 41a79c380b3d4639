/* joint.h: joints as their parts see them.
 *
 * A joint is a td_joint and up to four constraints of the graph, each with a lane of its own: what
 * it locks (lock.c, or rod.c for a distance), and what drives it in each direction that is driven
 * (drive.c). The caller's side of it is joint_make.c and joint_state.c. */
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

/* joint_state.c: THUD_ERROR_NULL, THUD_ERROR_STALE, or, where it `edits` inside a callback,
 * THUD_ERROR_LOCKED through td_refuse; *index is the slot. */
thud_result td_find_joint(const thud_world *w, thud_joint_id id, bool edits, int *index);

thud_joint_id td_joint_handle(const thud_world *w, int index);

/* joint_def.c */
bool td_joint_frame_valid(const thud_world *w, td_reason *why, const thud_joint_frame *f);
/* Why it is none, or null. */
const char *td_joint_drive_error(const thud_world *w, thud_joint_kind kind, int direction,
                                 const thud_drive *d, td_reason *why);
/* Tells the log of what it takes, and is hardly meant. */
void td_joint_warn_of_drive(const thud_world *w, const thud_drive *d);
/* Why not, or null. */
const char *td_joint_def_error(const thud_world *w, const thud_joint_def *d, td_body_index a,
                               td_body_index b, td_reason *why);
/* Whether a joint may break beyond so much, with the reason. */
static inline bool td_joint_break_valid(td_reason *why, const char *name, float x) {
    return td_in(why, name, (double)x, 0.0, (double)THUD_JOINT_FORCE_MAX);
}
td_drive td_drive_of(const thud_drive *d);
td_joint td_joint_of_def(const thud_world *w, const thud_joint_def *d, td_body_index a,
                         td_body_index b);
/* Where it is in its first or second body. */
void td_joint_set_place(td_joint *joint, int side, const thud_joint_frame *f);

/* Whether it keeps an axis of this body where it is: edits/locks.c. */
static inline bool td_joint_is_lock(const thud_world *w, const td_joint *joint,
                                    td_body_index body) {
    return td_same_body(joint->body[1], body) &&
           (td_body_at(w, joint->body[0])->flags & TD_BODY_ANCHOR) &&
           (joint->kind == THUD_HINGE || joint->kind == THUD_WHEEL);
}

/* joint_make.c: room for all parts that a kind may have; and the parts that it needs, of those. */
bool td_joint_reserve(thud_world *w, int kind);
void td_joint_update_parts(thud_world *w, int index);

/* joint_end.c */
/* It has changed: its bodies wake, and its lanes look it up anew. */
void td_joint_wake(thud_world *w, const td_joint *joint);
/* Destroys it, and wakes its bodies. */
void td_joint_end(thud_world *w, int index);

/* joint_measure.c: as thud_joint_state has it. */
typedef struct td_joint_reading {
    double value[TD_JOINT_DIRECTIONS], gap, angle_gap;
} td_joint_reading;

typedef struct td_joint_load {
    thud_vec2 force;
    float torque;
} td_joint_load;

td_joint_reading td_joint_read(const thud_world *w, const td_joint *joint);
td_joint_load td_joint_load_of(const thud_world *w, const td_joint *joint);
thud_drive_forces td_joint_drive_forces(const thud_world *w, const td_joint *joint, int direction);
/* It has lanes, and is awake. */
bool td_joint_acts(const thud_world *w, const td_joint *joint);

static inline bool td_joint_breaks(const td_joint *joint) {
    return joint->break_force < THUD_JOINT_FORCE_MAX || joint->break_torque < THUD_JOINT_FORCE_MAX;
}

/* The default of a distance's. */
static inline bool td_target_is_length(float target) {
    return target == -__builtin_inff();
}

/* Where its spring pulls to. */
static inline float td_joint_target(const td_joint *joint, int direction) {
    float target = joint->drive[direction].target;
    return td_target_is_length(target) ? joint->length : target;
}

/* Of a spring, rad/s, as the soft solver has it: a spring is the same whichever solves it. */
static inline double td_spring_omega(const thud_world *w, float frequency) {
    double most = (double)TD_SPRING_PHASE * w->substeps / w->def.time_step;
    return td_min_double(2.0 * TD_PI * (double)frequency, most);
}

static inline bool td_drive_acts(const td_drive *d) {
    return d->limited || d->frequency > 0.0f || d->motor_force > 0.0f;
}

/* Which of its directions are locked, and which driven, by its kind and its drives. */
void td_joint_sort_directions(td_joint *joint);
/* Directions that its kind lets the caller drive. */
unsigned td_joint_drivable(int kind);
/* The kind of constraint that its part has. */
int td_joint_part_kind(const td_joint *joint, int part);

/* Where the sides of a part are: the arms of both anchors about the centres of mass, in the world;
 * the way from a's anchor to b's; and by how much b is turned against a. */
typedef struct td_joint_place {
    float arm[2][2];
    float x, y;
    float turn;           /* in (-pi, pi], as the caller has it */
    float turn_sign;      /* -1 where its sides have changed places */
    float axis_x, axis_y; /* of `along`, in the world */
} td_joint_place;

td_joint_place td_joint_place_of(const thud_world *w, const td_joint *joint);

/* How far apart both anchors are, and the direction from a's to b's; where they meet, any. */
float td_joint_line(const td_joint_place *place, float *x, float *y);

/* The speed at which a gap goes within so much time, as far as TD_JOINT_CLOSING allows. */
double td_joint_closing_speed(const thud_world *w, double gap, double time);

static inline float td_cross(const float arm[2], float x, float y) {
    return arm[0] * y - arm[1] * x;
}

/* A lane's frame after a motion of its sides (x, y, turn) from the start of the step, as
 * wide_joint.h has it, in double precision: u = (x, y), v = (-y, x), and the crosses of the arms
 * with both. The gap is from a's anchor to b's. Where `turns` is set the frame turns with a, whose
 * arm ends at b's anchor then. */
typedef struct td_joint_frame {
    double x, y, a_u, a_v, b_u, b_v, gap_u, gap_v;
} td_joint_frame;

void td_joint_sincos(double angle, double *s, double *c);
td_joint_frame td_joint_frame_after(const td_block *block, int lane, double gap_u, double gap_v,
                                    bool turns, const double a[3], const double b[3]);
/* The same with u along the gap. */
td_joint_frame td_joint_line_after(const td_block *block, int lane, double gap_u, double gap_v,
                                   const double a[3], const double b[3]);
/* By the motion of its sides in this step, as far as it has got. */
void td_joint_motion(const thud_world *w, const td_block *block, int lane, double a[3],
                     double b[3]);
/* Speed of b past a along a direction with these crosses. */
float td_joint_speed(const thud_world *w, const td_block *block, int lane, double x, double y,
                     double cross_a, double cross_b);

/* 1 / the mass that a lane's row feels. */
float td_joint_inverse_mass(const thud_world *w, const td_block *block, int lane, float linear,
                            float cross_a, float cross_b);
/* For td_lane_ops: what is no contact has no shapes, and what a lane keeps of its joint is to be
 * looked up anew, after changes too. */
void td_joint_fill_lane(thud_world *w, td_block *block, int lane, int index);
void td_joint_renew_lane(thud_world *w, td_block *block, int lane, int index);
void td_joint_clear_lane(thud_world *w, td_block *block, int lane, int index);

/* anchors.c: what lanes keep of their joints. */
void td_joint_update_anchors(const thud_world *w, td_block *block);

/* wide_place.c: the rows of rods, holds and drives from the present poses; for
 * td_constraint_ops.collide_world. Joints never part: all lanes go on touching. */
typedef void td_place_fn(thud_world *w, td_block *const *blocks, int count,
                         const td_collide_context *context);
TD_DECLARE_WIDE(td_place_fn, td_place_joints);

/* Inverse mass of the lighter side. */
static inline float td_joint_max_inverse_mass(const thud_world *w, const td_block *block, int lane) {
    return td_max_float(td_row(&w->velocity, td_slot_of_side(block->a[lane]))[3],
                        td_row(&w->velocity, td_slot_of_side(block->b[lane]))[3]);
}

static inline float td_joint_abs(float x) {
    return x < 0.0f ? -x : x;
}

/* Stands in the file of a kind of part, below its count and load; defines `lanes`. */
#define TD_DEFINE_JOINT_LANES(take, turn)                       \
    static const td_lane_ops lanes = {.fill = td_joint_fill_lane,    \
                                      .clear = td_joint_clear_lane, \
                                      .renew = td_joint_renew_lane,  \
                                      .count = count,           \
                                      .load = load,             \
                                      .take_rows = (take),      \
                                      .turn_rows = (turn)};

#define TD_JOINT_OPS(block_form, prepare, solve_ops)                                              \
    {                                                                                             \
        .form = (block_form), .lanes = &lanes, .collide_world = (prepare), .solve = &(solve_ops), \
        .solve_unarmed = &(solve_ops)                                                             \
    }

/* Below those: the operations `ops` for TD_PICK_WIDE, of passes that are `solve`. */
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

/* The operations of the kinds, for this world's instruction set. */
const td_constraint_ops *td_rod_ops(const thud_world *w);
const td_constraint_ops *td_lock_ops(const thud_world *w);
const td_constraint_ops *td_drive_ops(const thud_world *w, int kind);

/* Their rows for the direct solver. */
td_take_rows_fn td_rod_take_rows, td_lock_take_rows, td_drive_take_rows;
td_turn_rows_fn td_rod_turn_rows, td_lock_turn_rows, td_drive_turn_rows;

#endif
