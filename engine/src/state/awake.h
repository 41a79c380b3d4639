/* awake.h: awake slots: the places of awake bodies in the dense arrays of awake_arrays.h. Slot 0 is
 * a dummy at rest with zero inverse mass, which stands for static sides and empty lanes. */
#ifndef TD_AWAKE_H
#define TD_AWAKE_H

#include "state/world.h"

/* The number of elements that the arrays need for so many bodies, all awake: one more for the
 * dummy, and eight more since the wide kernels work on whole groups of eight. */
int td_awake_capacity(int bodies);
/* Makes room for every live body and `more` further ones, so that waking a body never needs memory.
 * False when memory is short. */
bool td_awake_reserve(thud_world *w, int more);
/* Gives the body, which has none, a slot, with the velocity of its record. */
void td_awake_add(thud_world *w, td_body_index body);
/* Frees the body's slot, and copies its velocity into its record. */
void td_awake_remove(thud_world *w, td_body_index body);
/* Copies mass, damping, extents and the lone shape from the body's record to its slot, if it has
 * one; marks the world's sums that depend on them (thud_world.kinetic, substep_gain) as stale. */
void td_awake_refresh(thud_world *w, td_body_index body);

/* Whether a body is asleep and can wake. */
static inline bool td_may_wake(const td_body *body) {
    return body->kind == THUD_BODY_DYNAMIC && body->awake.at < 0 &&
           !(body->flags & (TD_BODY_QUARANTINED | TD_BODY_DISABLED)) &&
           !(body->changes & TD_CHANGE_ENTER);
}

/* Wakes the whole island of a body; if the body is awake, sets its idle time to 0. False when
 * memory is short; nothing has changed then. */
bool td_wake(thud_world *w, td_body_index body);

#endif
