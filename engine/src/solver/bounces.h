/* bounces.h: under `bisect` and `swept`, which contacts with restitution are left out of the soft
 * solver, and are resolved at their time of impact by detection/impacts.c instead. */
#ifndef TD_BOUNCES_H
#define TD_BOUNCES_H

#include "state/world.h"

/* An elastic pair (restitution >= 1) bounces without loss at any speed, unless it counts as
 * resting. Thresholds of the closing speed, in multiples of g h, the speed that gravity gives in a
 * step: TD_BOUNCE_REST for a pair in free flight; a pair that meets more slowly would meet again
 * some eight times within the step (1 / 0.125). */
#define TD_BOUNCE_REST 0.125
/* For a pair whose bodies other contacts carry: their velocities fluctuate by less than this, and
 * the pair must not begin to bounce from that alone. Chosen. */
#define TD_BOUNCE_BORNE 4.0

/* Mutes the lanes of the pairs that bounce within this step. Needs the narrowphase's normal
 * velocities, the settings of this step, and the trajectories, whose `borne` it sets for bodies
 * that contacts carry. */
void td_bounces_take(thud_world *w);

#endif
