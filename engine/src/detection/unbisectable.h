/* unbisectable.h: bodies that move too far in a step for bisection to find all their collisions
 * (thud_stats.unbisectable). */
#ifndef TD_UNBISECTABLE_H
#define TD_UNBISECTABLE_H

#include "state/world.h"

/* Whether |motion of the centre| + |turn| times the reach of its corners is at least the thickness
 * of the world's thinnest shape: an awake body may then have passed through a shape without overlap
 * at the end of the step. False in a world without bisected bodies, and for dynamic bodies whose
 * detection is finer than `bisect`. */
bool td_is_unbisectable(thud_world *w, td_awake_slot slot);

#endif
