/* project.h: the wide kernels of gaps.c, eight contacts at a time.
 *
 * The projection changes the motions of the step (td_project_context.delta) so that no contact
 * point ends with a gap below
 *   min(target_distance, gap at the start of the step - yield)
 * where yield is 0, or yield_at_rest between two bodies that hardly move. The method is projected
 * Gauss-Seidel with over-relaxation (Jourdan, Alart, Jean, "A Gauss-Seidel like algorithm to solve
 * frictional contact problems", 1998) over all touching contacts, block by block. The unknowns are
 * two impulses a point along its normal, both >= 0: one of motion (mass x length), and one of
 * velocity (mass x length/s), which keeps the velocities from closing at points where the first
 * acts. With p the impulse, m the effective mass (td_point.normal_mass), w the over-relaxation and
 * u the gap that is missing, or for the second impulse the closing speed, a pass sets
 *   p' = max(0, p + w m u)
 * and applies p' - p. Without this projection each touching pair of a collapsing heap meets again
 * and again: a step took thirty times as long as with continuous detection, and one body in seven
 * was held.
 *
 * The projection leaves out lanes with restitution >= 1 and lanes of bodies that joints tie to
 * others. */
#ifndef TD_PROJECT_H
#define TD_PROJECT_H

#include "constraint/block.h"

/* The accumulated impulses of the points of a block. */
typedef struct td_pushes {
    f8 motion[2];   /* changes motions; mass x length */
    f8 velocity[2]; /* changes velocities; mass x length/s */
} td_pushes;

/* All lengths are in the caller's unit. */
typedef struct td_project_context {
    float (*delta)[4];        /* by awake slot: motion of the step: x, y, angle */
    float (*velocity)[4];     /* by awake slot: x, y, angular, inverse mass */
    const float (*reach)[2];  /* by awake slot: td_body.min_extent, max_extent */
    float over_relaxation;    /* factor of corrections: 1 is none */
    float skin;               /* thud_world.skin: separations are gaps minus this */
    float target_distance;    /* no gap may end below this, or below its value at the start of the
                                 step if that is smaller */
    float enough, closing;    /* another pass is needed if a gap ends below `enough`, and below its
                                 value at the start, less the yield, by more than `closing` */
    float rest_motion;        /* between two bodies that both move by less than this in the step, */
    float yield_at_rest;      /* a gap may close by as much as this */
    float collision_distance; /* a gap that ends below this, */
    float closing_max;        /* and has shrunk by more than this, is a collision */
    const int32_t *next_tied; /* by awake slot: scratch.next_tied; null: no joint ties bodies */
    float margin;             /* TD_SPECULATIVE: the gap at a missing point is greater than this */
} td_project_context;

/* One pass over blocks with so many `points`; `a_static`: side a is static. Leaves the separation
 * before its correction in td_point.separation. Returns at how many points another pass is needed.
 */
typedef int td_project_fn(td_block *const *blocks, td_pushes *pushes, int count, int points,
                          bool a_static, const td_project_context *context);

/* Sets td_block.apart to the lanes that end without a collision. `turns`: bodies may turn while
 * the shapes are not centred circles or AABBs, so that the rows are not exact; see row_error in
 * gaps.c. */
typedef void td_find_open_fn(td_block *const *blocks, int count, int points, bool turns,
                             const td_project_context *context);

#endif
