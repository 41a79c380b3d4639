/* joint_islands.h: the islands of a world with joints. */
#ifndef TD_JOINT_ISLANDS_H
#define TD_JOINT_ISLANDS_H

#include "islands/island_solve.h"

/* In place of thud_islands_direct, from the first joint of a world on: after the islands that were
 * found to be direct come those that give way in this step, and what joints alone hold. */
extern const thud_island_solver td_islands_of_joints;

/* The room that these need is there beforehand, since no step fails once it has begun to move
 * bodies. What needs more waits for the next step, or stays soft. */
enum {
    TD_LATE_BODIES = 128,
    TD_LATE_CONSTRAINTS = 512,
    TD_LATE_ENTRIES = 8 * TD_LATE_BODIES /* blocks that its order fills in */
};

/* The island goes back to where the step began, in an order of its own, behind those that were
 * found before. False where it is too large. */
bool td_joint_island_begin(thud_world *w, td_island *island);

/* Solves it, or marks its bodies. */
void td_joint_island_solve(thud_world *w, const td_island *island);
/* The value of td_islands.local where an island was tried in this step, and stays as the soft
 * solver has it. */
enum { TD_ISLAND_SOFT = -4 };

/* late_islands.c: islands whose joints have just given way under the soft solver. `last` is the
 * last system of those found before. */
void td_late_solve(thud_world *w, td_system last);
/* linkages.c: what joints hold in islands that are not solved directly. The lists of td_islands
 * mean nothing afterwards. */
void td_linkages_solve(thud_world *w, td_system last);
/* Some body's island was left to the soft solver before, and may be again. */
bool td_linkages_may_come(const thud_world *w);

#endif
