/* bounces.h: chooses the contacts with restitution that the soft solver leaves out, because
 * detection/impacts.c resolves them at their time of impact (detections `bisect` and `swept`). */
#ifndef TD_BOUNCES_H
#define TD_BOUNCES_H

#include "state/world.h"

/* The closing speed, in multiples of gravity times the time step, below which a swept pair in free
 * flight counts as resting at its impact (bounce_speed in detection/collide.c; bounces.c has its
 * own, FLIGHT_REST). Chosen: an elastic pair (restitution >= 1) that meets at this speed v would
 * meet again after 2 v / g, a quarter of the step. */
#define TD_BOUNCE_REST 0.125
/* TD_BOUNCE_REST for a pair with a body that other contacts carry. The solver's errors let the
 * velocity of such a body fluctuate by less than this, which must not make the pair bounce. Chosen.
 */
#define TD_BOUNCE_BORNE 4.0

/* Takes the contacts of pairs that bounce within this step out of the soft solver
 * (td_surface_mute). Needs the narrowphase's normal velocities, the settings of this step, and the
 * trajectories, whose `borne` it sets for bodies that contacts carry. */
void td_bounces_take(thud_world *w);

#endif
