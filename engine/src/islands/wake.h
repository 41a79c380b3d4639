/* wake.h: wakes sleeping islands, each as a whole, so that all of its contacts take lanes in the
 * same step. */
#ifndef TD_WAKE_H
#define TD_WAKE_H

#include "state/world.h"

/* Reserves memory for the lists of bodies and constraints of any island, scratch.bodies and
 * scratch.constraints. False when memory is short. */
bool td_wake_reserve(thud_world *w);

/* Wakes a body and its whole island (td_sleep_hooks.wake). False when memory is short; nothing has
 * changed then. */
bool td_wake_island(thud_world *w, td_body_index body);

#endif
