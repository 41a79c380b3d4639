/* step_parts.h: the number of parts into which a step of an island with joints is divided. */
#ifndef TD_STEP_PARTS_H
#define TD_STEP_PARTS_H

#include "direct/island_step.h"

/* The number of parts, from the fastest rotation of a body that moves a joint, in the velocities
 * before the step and in the soft solver's result. 0: the rotation is too fast for the direct
 * solver. Sets `sweeps` and `turn_limited` of the problem's bodies. */
int td_island_parts(td_island_work *work);
/* The number of parts for a given rotation: `fastest`, the maximum rate at which a lever arm or rod
 * turns, rad/s. `joints`: the island has no contacts. `phase`: the maximum phase of a spring in the
 * step, rad. */
int td_parts_of(const thud_world *w, const td_island *island, double fastest, bool joints,
                double phase);
/* Whether a lever arm, given by two components along any two axes at a right angle, is so short
 * that rotation does not move its end beyond rounding (CENTRED, step_parts.c). */
bool td_arm_is_centred(const thud_world *w, double x, double y);
/* Whether a body that has contacts, and is no disc, has turned by more than work->turn_max, so that
 * the contacts' normals and lever arms of the start of the step are too inaccurate. */
bool td_island_turns_too_far(const td_island_work *work);

#endif
