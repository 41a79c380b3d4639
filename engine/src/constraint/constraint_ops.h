/* constraint_ops.h: the operations of a kind of constraint. */
#ifndef TD_CONSTRAINT_OPS_H
#define TD_CONSTRAINT_OPS_H

#include "constraint/block.h"

struct thud_world;

struct td_direct_constraint;
typedef bool td_take_rows_fn(const struct thud_world *world, td_block *block, int lane,
                             const float *impulses, struct td_direct_constraint *constraint);

/* What happens to the lanes of a kind beside the passes of the solver. The bodies' awake slots and
 * inverse inertias in a lane are set for all kinds alike. */
typedef struct td_lane_ops {
    /* The lane, which is all zeros, becomes the constraint's ... */
    void (*fill)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* ... and here is no longer. */
    void (*clear)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Masses or shapes of its bodies have changed. */
    void (*renew)(struct thud_world *world, td_block *block, int lane, int constraint);
    /* Adds what the lanes miss to the step's errors, once the direct solver has overruled the soft
     * one; null for contacts, which error.c counts itself. */
    void (*count)(struct thud_world *world, const td_block *block);
    /* The rows of a lane for the direct solver; null for contacts, whose rows it knows itself, so
     * that a program without it does not link them: islands/rows.h. */
    td_take_rows_fn *take_rows;
} td_lane_ops;

/* Pair kinds plug theirs in when their shapes are first used (state/kinds.h), and others when the
 * first constraint of theirs is made. */
typedef struct td_constraint_ops {
    td_block_form form;
    const td_lane_ops *lanes; /* null: those of contacts, td_contact_lanes */
    td_sift_fn
        *sift; /* of contacts: a quick look at those that wait; null where `collide_world` is */
    td_collide_fn *collide; /* likewise */
    /* Where the geometry does not lie in the per-shape records: lines, joints. */
    void (*collide_world)(struct thud_world *world, td_block *const *blocks, int count,
                          const td_collide_context *context);
    const td_solve_ops *solve;
    const td_solve_ops *solve_unarmed; /* for runs of blocks of which none is armed, see td_block */
} td_constraint_ops;

#endif
