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

/* Detection takes (x, y) from the motion of a body, which lacks that fall then. */
static inline void td_error_follow(thud_world *w, td_awake_slot slot, float x, float y) {
    float fall = w->def.gravity.x * x + w->def.gravity.y * y;
    float taken = *TD_AT(float, &w->weight, slot.at) * fall, most = 1e37f; /* as TD_ENERGY_MAX */
    w->errors.energy_change += (double)td_max_float(td_min_float(taken, most), -most);
}

/* After all of that: adds up the kinetic energy anew, and leaves points to td_error_of_step. */
void td_error_settle(thud_world *w);

/* A body was stopped so far before the end of its motion. */
static inline void td_error_fall_short(thud_world *w, float x, float y) {
    float lacks = x * x + y * y;
    if (lacks > w->errors.shortfall) {
        w->errors.shortfall = lacks;
    }
}

/* Whether detection changed motions after points were counted: it projected, held or resolved. */
static inline bool td_error_has_moved(const thud_world *w) {
    return w->errors.moved || w->stats.held_bodies > 0 || w->stats.impacts > 0;
}

/* step_error.c: separation of a touching contact's point where that is so, as the bodies stand at
 * the end of the step. */
float td_error_separation(const thud_world *w, const td_constraint *contact, int point);
/* The step's errors, with points counted anew where detection moved bodies. */
td_errors td_error_of_step(const thud_world *w);

/* Counts all points anew, from separations and velocities as they stand: for a stage that solves
 * some of them again. That is a pass over all contacts by itself. */
void td_error_recount(thud_world *w);

/* Penetration from which on a point is an overlap. */
float td_error_overlap(const thud_world *w);

#endif
