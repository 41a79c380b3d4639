/* joint_islands.h: the island solver of a world with joints.
 *
 * Before the soft solver runs, this solver solves the islands whose constraints are hinges and
 * welds that form a tree (lock_tree.h); the soft solver then skips their joints. After the soft
 * solver it writes their results, and solves directly (sparse.h), in this order,
 *   1. the other islands, which td_islands_find listed before the soft solver (direct_islands.c);
 *   2. islands with an overloaded joint: its load in this step exceeded the threshold of
 *      td_islands_load_max, or its gap exceeded max_error (overloaded_joints.c);
 *   3. of islands that are left to the soft solver, the linkages (bodies that joints connect) whose
 *      joints are overloaded; the contacts act on them by the impulses that the soft solver found
 *      (joint_subsystems.c).
 * The velocities, motions and impulses of the soft solver stay in the world until a direct result
 * is accepted, so that they need not be restored if the direct result is refused. */
#ifndef TD_JOINT_ISLANDS_H
#define TD_JOINT_ISLANDS_H

#include "direct/island_step.h"

/* The island solver of a world from its first joint on, in place of thud_islands_direct. */
extern const thud_island_solver td_islands_of_joints;

/* Sizes up to which an island of 2. or a linkage of 3. is solved in the same step. Memory for one
 * of this size is reserved before the soft solver, since the step must not fail after that; 100 KB
 * of the memory are for the factor. A larger island of 2. is solved in the next step, as one of 1.;
 * a larger linkage of 3. stays soft. Chosen; not tuned. */
enum {
    TD_RESOLVE_BODIES_MAX = 128,
    TD_RESOLVE_CONSTRAINTS_MAX = 512, /* contacts and parts of joints, not rows */
    /* 3 x 3 blocks of the factor below its diagonal, with fill-in: 8 for each body. */
    TD_RESOLVE_ENTRIES_MAX = 8 * TD_RESOLVE_BODIES_MAX
};

/* Prepares an island of 2. or 3.: copies the velocities at the start of the step
 * (td_islands.island_start_velocity), and the soft solver's impulses as the warm start, and adds a
 * system with the island's elimination order to td_islands.matrix, behind the present one.
 * Velocities and impulses of the world do not change. False where a size above is exceeded. */
bool td_joint_island_begin(thud_world *w, td_island *island);

/* Solves an island of 1., or one that td_joint_island_begin has prepared (td_island_solve), and
 * writes the result to the world. The soft solver's result is kept if the direct solve does not
 * converge, exceeds its budget, fails its checks, or a contact bounces; td_islands.local of the
 * bodies then becomes TD_ISLAND_REFUSED, and 3. may still solve their linkages. */
void td_joint_island_solve(thud_world *w, const td_island *island);

/* overloaded_joints.c: 2. above. `last` is the last system of the islands of 1.: systems for 2. are
 * appended after it, and removed before the function returns. */
void td_overloaded_islands_solve(thud_world *w, td_system last);
/* joint_subsystems.c: 3. above. `last` as above. It writes its linkages over the lists of
 * td_islands (slots, constraints), which are then invalid until the islands of the next step are
 * found. */
void td_joint_subsystems_solve(thud_world *w, td_system last);
/* Whether 3. may be needed in this step: an awake body is in the cooldown of its island, or its
 * island had a cooldown and was not solved directly since (direct_steps and slow_steps,
 * direct_islands.h). */
bool td_joint_subsystems_expected(const thud_world *w);

#endif
