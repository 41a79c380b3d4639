/* error.h: the errors of the step, as the solver and td_finalize add them up for thud_world_error.
 */
#ifndef TD_ERROR_H
#define TD_ERROR_H

#include "state/world.h"

/* Before the solver: nothing has been found yet, and energy counts from the velocities as they are.
 */
void td_error_begin(thud_world *w);

/* Adds what a worker found of the contact points that it solved. */
void td_error_add(thud_world *w, const td_tally *found);

/* Detection gave a body another motion than the solver did, `before`: the separations of its
 * contacts and what it fell follow. Once that is done for all bodies, td_error_settle. */
void td_error_follow(thud_world *w, td_awake_slot slot, const float *before);

/* Counts overlaps and kinetic energy anew, as detection left them. */
void td_error_settle(thud_world *w);

/* A body was stopped so far before the end of its motion; a length. */
void td_error_fall_short(thud_world *w, double x, double y);

/* Counts all points anew, from separations and velocities as they stand: for a stage that solves
 * some of them again. That is a pass over all contacts by itself. */
void td_error_recount(thud_world *w);

/* Penetration from which on a point is an overlap. */
float td_error_overlap(const thud_world *w);

#endif
