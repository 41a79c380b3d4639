/* joint_islands.h: the island solver of a world with joints.
 *
 * After the soft solver it solves, in this order,
 *   1. the islands that were found before the step (direct/direct_islands.c),
 *   2. islands in which a joint has yielded under the soft solver in this step (yielding_joints.c),
 *   3. the joints of islands that are left to the soft solver, without their contacts
 * (joint_subsystems.c).
 */
#ifndef TD_JOINT_ISLANDS_H
#define TD_JOINT_ISLANDS_H

#include "direct/island_step.h"

/* Replaces thud_islands_direct from the first joint of a world on. */
extern const thud_island_solver td_islands_of_joints;

/* Sizes up to which islands of 2. and 3. are solved. Memory for one of this size is reserved before
 * the step moves any body, since a step cannot fail later. Larger ones are found before the next
 * step, or stay soft. Chosen. */
enum {
    TD_LATE_BODIES_MAX = 128,
    TD_LATE_CONSTRAINTS_MAX = 512,
    TD_LATE_ENTRIES_MAX = 8 * TD_LATE_BODIES_MAX /* blocks of the factor below its diagonal */
};

/* Takes the island back to the velocities at the start of the step, with the soft solver's impulses
 * as the warm start, and finds its elimination order as a further system. False where it is too
 * large. */
bool td_joint_island_begin(thud_world *w, td_island *island);

/* Solves it; where that fails, sets td_islands.local of its bodies to TD_ISLAND_SOFT. */
void td_joint_island_solve(thud_world *w, const td_island *island);
/* The value of td_islands.local of a body whose island was tried in this step without success, so
 * that the soft solver's result stands. */
enum { TD_ISLAND_SOFT = -4 };

/* yielding_joints.c: 2. above. `last` is the last system of the islands of 1. */
void td_yielding_islands_solve(thud_world *w, td_system last);
/* joint_subsystems.c: 3. above. It uses the lists of td_islands for its own, and leaves them
 * invalid. */
void td_joint_subsystems_solve(thud_world *w, td_system last);
/* Whether 3. may be needed: some island has been left to the soft solver in the last steps. */
bool td_joint_subsystems_possible(const thud_world *w);

#endif
