/* engage.h: when constraints that are no contacts take effect. */
#ifndef TD_ENGAGE_H
#define TD_ENGAGE_H

#include "state/world.h"

/* Gives lanes to those that wait, where their bodies are in the world and enabled. False when
 * memory is short: the rest goes on waiting. */
bool td_constraints_engage(thud_world *w);

#endif
