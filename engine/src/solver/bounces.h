/* bounces.h: under `bisect` and `swept`, which contacts with restitution are left out of the soft
 * solver, and are resolved at their time of impact by detection/impacts.c instead. */
#ifndef TD_BOUNCES_H
#define TD_BOUNCES_H

#include "state/world.h"

/* An elastic pair (restitution >= 1) bounces without loss unless it counts as resting, which is
 * decided by its closing speed. This threshold, in multiples of gravity times the time step, is for
 * a pair in free flight: a pair that meets more slowly would meet again some eight times within the
 * step (1 / 0.125). */
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
