/* joint.h: joints as their parts see them.
 *
 * A joint is a td_joint and up to four constraints of the graph, each with a lane of its own: what
 * it locks (hold.c, or rod.c for a distance), and what drives it in each direction that is driven
 * (drive.c). The caller's side of it is joint_make.c and joint_state.c. */
#ifndef TD_JOINT_H
#define TD_JOINT_H

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

static inline bool td_drive_acts(const td_drive *d) {
    return d->limited || d->frequency > 0.0f || d->motor_force > 0.0f;
}

/* Bits of the directions that are locked, or driven. */
unsigned td_joint_locked(const td_joint *joint);
unsigned td_joint_driven(const td_joint *joint);
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
/* Directions and arms of a lane, of which both points get the crosses of a frame with u = (x, y).
 */
void td_joint_set_frame(td_block *block, int lane, const td_joint_place *place, float x, float y);

/* For td_lane_ops: what is no contact has no shapes, and all else is worked out anew each step. */
void td_joint_fill(thud_world *w, td_block *block, int lane, int index);
void td_joint_let_be(thud_world *w, td_block *block, int lane, int index);

/* Joints never part: each lane is prepared, and all go on touching. */
static inline void td_joint_prepare(thud_world *w, td_block *const *blocks, int count,
                                    void lane(const thud_world *w, td_block *block, int lane)) {
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < blocks[i]->used; k++) {
            lane(w, blocks[i], k);
        }
        blocks[i]->touching = (1u << blocks[i]->used) - 1u;
    }
}

/* Inverse mass of the lighter side. */
static inline float td_joint_lighter(const thud_world *w, const td_block *block, int lane) {
    return td_max_float(td_row(&w->velocity, td_slot_of_side(block->a[lane]))[3],
                        td_row(&w->velocity, td_slot_of_side(block->b[lane]))[3]);
}

static inline float td_joint_size(float x) {
    return x < 0.0f ? -x : x;
}

#define TD_JOINT_OPS(block_form, lane_ops, prepare, solve_ops)                  \
    {                                                                           \
        .form = (block_form), .lanes = &(lane_ops), .collide_world = (prepare), \
        .solve = &(solve_ops), .solve_unarmed = &(solve_ops)                    \
    }

/* The operations of the kinds, for this world's instruction set. */
const td_constraint_ops *td_rod_ops(const thud_world *w);
const td_constraint_ops *td_hold_ops(const thud_world *w);
const td_constraint_ops *td_drive_ops(const thud_world *w, int kind);

/* Their rows for the direct solver. */
td_take_rows_fn td_rod_take_rows, td_hold_take_rows, td_drive_take_rows;
td_turn_rows_fn td_rod_turn_rows, td_hold_turn_rows, td_drive_turn_rows;

#endif
