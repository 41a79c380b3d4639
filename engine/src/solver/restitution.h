/* restitution.h: the passes of the soft solver that only contacts with restitution need.
 *
 * A world has them by its def (thud_parts), or is given them by thud_shape_set_restitution or a
 * snapshot, so that a program in which nothing bounces does not link them. Without them no shape,
 * rule or prologue gives a contact restitution. */
#ifndef TD_RESTITUTION_H
#define TD_RESTITUTION_H

#include "solver/motion.h"
#include "state/world.h"

/* The functions of wide_bounce.c. Of each there are two, one for each instruction set: the index is
 * thud_world.wide. */
typedef struct td_restitution_hooks {
    td_solve_fn *one_point[2], *two_points[2]; /* the bounce passes of contacts */
    td_end_flights_fn *end_flights[2];
} td_restitution_hooks;

/* Whether a contact that touches has restitution. The table is tested too, since a snapshot that
 * was tampered with may say that contacts bounce and still bring no table. */
static inline bool td_has_bounces(const thud_world *w) {
    return w->bouncy > 0 && w->restitution_hooks;
}

/* restitution.c */
extern const td_restitution_hooks td_restitution;

#endif
