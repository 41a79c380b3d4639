/* awake.h: the dense arrays of bodies that move. Slot 0 is a dummy at rest. */
#ifndef TD_AWAKE_H
#define TD_AWAKE_H

#include "state/world.h"

/* Elements that the arrays need for so many bodies, all awake: the dummy and a last eight in full
 * come on top, since the wide kernels work on whole eights. */
int td_awake_capacity(int bodies);
/* Room for every live body and `more`, so that waking never needs memory. */
bool td_awake_reserve(thud_world *w, int more);
/* Gives the body a slot, with the velocity of its record. */
void td_awake_add(thud_world *w, td_body_index body);
/* Takes its slot, and puts the velocity into its record. */
void td_awake_remove(thud_world *w, td_body_index body);
/* Copies mass, damping and reach of the body's record to its slot, if it has one. */
void td_awake_refresh(thud_world *w, td_body_index body);

#endif
