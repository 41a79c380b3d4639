/* constraint_ops.h: the operations of a kind of constraint. */
#ifndef TD_CONSTRAINT_OPS_H
#define TD_CONSTRAINT_OPS_H

#include "constraint/block.h"

struct thud_world;

struct td_direct_constraint;
typedef bool td_take_rows_fn(const struct thud_world *world, td_block *block, int lane,
                             const float *impulses, struct td_direct_constraint *constraint);

/* A part of a step: motions (x, y, turn) of both sides from the start of the step to the part's
 * start and, as known so far, to its end; and how long it is. */
typedef struct td_span {
    double a[2][3], b[2][3];
    double time;
} td_span;

/* Directions for which the work along them over the part is that of the joint's own coordinates, so
 * that what is locked takes no energy (O. Gonzalez, "Mechanical systems subject to holonomic
 * constraints: differential-algebraic formulations and conservative integration", 1999); and the
 * mean speeds that close gaps by its end. Where the part is an instant, speeds at it. */
typedef void td_turn_rows_fn(const struct thud_world *world, const td_block *block, int lane,
                             const td_span *span, struct td_direct_constraint *constraint);

/* How a kind fills, empties and counts its lanes; the passes of the solver are td_solve_ops. The
 * bodies' awake slots and inverse inertias in a lane are set for all kinds alike. */
typedef struct td_lane_ops {
    /* The constraint gets the lane, which is all zeros. */
    void (*fill)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* The constraint loses the lane. */
    void (*clear)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Masses or shapes of its bodies have changed. */
    void (*renew)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Adds what the lanes miss to the step's errors, once the direct solver has overruled the soft
     * one; null for contacts, which error.c counts itself. */
    void (*count)(struct thud_world *world, const td_block *block);
    /* What a lane carries: impulse a substep over the lighter side's mass; and by what length it is
     * *off. `size` is the smaller body's. Null for contacts. */
    float (*load)(const struct thud_world *world, const td_block *block, int lane, float size,
                  float *off);
    /* The rows of a lane for the direct solver; null for contacts, whose rows it knows itself, so
     * that a program without it does not link them: direct/rows.h. */
    td_take_rows_fn *take_rows;
    /* Turns the rows of a lane to a part of the step's motion; null where they stay as they are. */
    td_turn_rows_fn *turn_rows;
} td_lane_ops;

/* Pair kinds plug theirs in when their shapes are first used (state/kinds.h), and others when the
 * first constraint of theirs is made. */
typedef struct td_constraint_ops {
    td_block_form form;
    const td_lane_ops *lanes; /* null: those of contacts, td_contact_lanes */
    /* Both null where the geometry does not lie in the records of shapes, as of lines and joints:
     * then `collide_world` does the work. `sift` looks at contacts that wait. */
    td_sift_fn *sift;
    td_collide_fn *collide;
    void (*collide_world)(struct thud_world *world, td_block *const *blocks, int count,
                          const td_collide_context *context);
    const td_solve_ops *solve;
    const td_solve_ops *solve_unarmed; /* for runs of blocks of which none is armed, see td_block */
} td_constraint_ops;

#endif
