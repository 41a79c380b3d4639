/* constraint_ops.h: the operations of a kind of constraint: a table of functions that each kind of
 * contact (contact/pair_kinds.h) and of joint constraint (joints/) registers in the world
 * (thud_world.kinds). The stages that work on constraints of all kinds call them: lanes.c, the
 * narrowphase, the solver, the direct solver. */
#ifndef TD_CONSTRAINT_OPS_H
#define TD_CONSTRAINT_OPS_H

#include "constraint/block.h"

struct thud_world;

struct td_direct_constraint;
/* Sets the rows of a lane for the direct solver. `impulses`: the warm start of the points and the
 * tangent, each summed over the step. direct/rows.h says what else the function sets, and what its
 * caller sets. */
typedef bool td_take_rows_fn(const struct thud_world *world, td_block *block, int lane,
                             const float *impulses, struct td_direct_constraint *constraint);

/* A part of a step: direct/island_step_joints.c divides the steps of islands with joints into
 * parts. */
typedef struct td_span {
    /* Motions (x, y, turn) of sides a and b since the start of the step: [0] to the start of the
     * part, [1] to its end, by the present iteration. */
    double a[2][3], b[2][3];
    double start; /* time of the part's start, s from the start of the step; at 0 the motions of [0]
                     are 0 */
    double time;  /* length of the part, s; 0: [0] and [1] are equal, and describe the poses at the
                     end of a part */
} td_span;

/* Computes the Jacobian and the target speeds of a joint's rows for a part of the step. The
 * Jacobian is a discrete gradient: its product with the motion of the part is exactly the change of
 * the joint's coordinate, so that the impulses of locked rows do no work (O. Gonzalez, "Mechanical
 * systems subject to holonomic constraints: differential-algebraic formulations and conservative
 * integration", 1999). The target speeds are the mean speeds that close the gaps by the end of the
 * part. With td_span.time 0 it is the ordinary Jacobian, and the target speeds do not close
 * gaps. */
typedef void td_update_rows_fn(const struct thud_world *world, const td_block *block, int lane,
                               const td_span *span, struct td_direct_constraint *constraint);

/* How a kind fills, clears and measures its lanes. lanes.c sets the bodies' awake slots and inverse
 * inertias in a lane, for all kinds alike. */
typedef struct td_lane_ops {
    /* Sets the kind's own data in a lane that the constraint takes; the lane is all zeros before.
     */
    void (*fill)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Called before the constraint leaves its lane. */
    void (*clear)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Masses or shapes of its bodies have changed: invalidates what is cached, so that the next
     * narrowphase computes the lane again. */
    void (*renew)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Adds the residuals of a block's lanes to the step's error statistics, after the direct solver
     * has changed velocities; null for contacts, which solver/error.c counts itself. */
    void (*count)(struct thud_world *world, const td_block *block);
    /* Returns the load of a lane, length/s: its impulse of a substep, divided by the mass of the
     * lighter of its two bodies. *off is set to the length by which the joint is open. Rotations
     * are multiplied by `size`, the size of the smaller body, to become lengths. Null for contacts.
     */
    float (*load)(const struct thud_world *world, const td_block *block, int lane, float size,
                  float *off);
    /* Null for contacts: direct/rows.h names their function, so that a program without the direct
     * solver does not link it. */
    td_take_rows_fn *take_rows;
    /* Null for contacts, whose rows do not change within a step. */
    td_update_rows_fn *update_rows;
} td_lane_ops;

/* All operations of a kind. Pair kinds are registered when their shapes are first used
 * (state/kinds.h), kinds of joints when the first joint is created. */
typedef struct td_constraint_ops {
    td_block_form form;
    const td_lane_ops *lanes; /* null: those of contacts, td_contact_lanes */
    /* The quick test of waiting contacts, and the manifolds of lanes. Both are null where shape
     * proxies do not have all of the geometry (terrain, joints): then `collide_world` computes the
     * lanes, and waiting contacts are tested singly. */
    td_sift_fn *sift;
    td_collide_fn *collide;
    void (*collide_world)(struct thud_world *world, td_block *const *blocks, int count,
                          const td_collide_context *context);
    const td_solve_ops *solve;
    const td_solve_ops *solve_centered; /* passes with less arithmetic, for runs in which no block
                                           has offsets (td_block.has_offsets) */
} td_constraint_ops;

#endif
