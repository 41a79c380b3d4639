/* wake.h: a sleeping island wakes as a whole, since its contacts get lanes together. */
#ifndef TD_WAKE_H
#define TD_WAKE_H

#include "state/world.h"

/* Makes room for the lists of bodies and constraints of any island, scratch.bodies and
 * scratch.constraints. False when memory is short. */
bool td_wake_reserve(thud_world *w);

/* Wakes the whole island of a body; of a body that is awake, sets the idle time to 0. False when
 * memory is short, and then nothing has changed. */
bool td_wake(thud_world *w, td_body_index body);

#endif
