/* error.h: the error statistics of a step, summed up by the solver, td_finalize and detection, and
 * read by thud_step_error_of. */
#ifndef TD_ERROR_H
#define TD_ERROR_H

#include "state/world.h"

/* Before the solver: resets the statistics, and takes the kinetic energy as it is for the start. */
void td_error_begin(thud_world *w);

/* Adds the statistics of the contact points that one worker has solved. */
void td_error_add(thud_world *w, const td_tally *found);

/* Corrects the energy change after detection has shortened the motion of a body by (x, y): gravity
 * did no work on that part. */
static inline void td_error_follow(thud_world *w, td_awake_slot slot, float x, float y) {
    float fall = w->def.gravity.x * x + w->def.gravity.y * y;
    float taken = *TD_AT(float, &w->weight, slot.at) * fall, max = 1e37f; /* TD_ENERGY_MAX */
    w->errors.energy_change += (double)td_max_float(td_min_float(taken, max), -max);
}

/* After detection has changed velocities: sums up the kinetic energy anew. Contact points are
 * counted anew by td_error_of_step, on request. */
void td_error_settle(thud_world *w);

/* Detection stopped a body (x, y) before the end of its motion: keeps the longest, squared. */
static inline void td_error_fall_short(thud_world *w, float x, float y) {
    float lacks = x * x + y * y;
    if (lacks > w->errors.shortfall) {
        w->errors.shortfall = lacks;
    }
}

/* Whether detection changed motions after points were counted: projections, held bodies or impacts.
 */
static inline bool td_error_has_moved(const thud_world *w) {
    return w->errors.moved || w->stats.held_bodies > 0 || w->stats.impacts > 0;
}

/* step_error.c: the separation of a touching contact's point for the poses at the end of the step,
 * where td_error_has_moved. */
float td_error_separation(const thud_world *w, const td_constraint *contact, int point);
/* The statistics of the step, with points counted anew where detection moved bodies. */
td_errors td_error_of_step(const thud_world *w);

/* Counts all contact points anew from their present separations and velocities, after a stage has
 * solved some of them again. It is a pass over all contacts. */
void td_error_recount(thud_world *w);

/* The penetration depth from which on a point counts as an overlap. */
float td_error_overlap(const thud_world *w);

#endif
