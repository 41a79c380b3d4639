/* wake.h: islands wake as a whole. */
#ifndef TD_WAKE_H
#define TD_WAKE_H

#include "state/world.h"

/* Room for the lists of bodies and contacts of any island: scratch.bodies, scratch.constraints. */
bool td_wake_reserve(thud_world *w);

/* Wakes the body's whole island, or starts the time at rest of one that is awake over; false when
 * memory is short. */
bool td_wake(thud_world *w, td_body_index body);

#endif
