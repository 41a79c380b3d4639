/* bounces.h: which contacts are resolved at their time of impact rather than by the solver. */
#ifndef TD_BOUNCES_H
#define TD_BOUNCES_H

#include "state/world.h"

/* Elastic pairs bounce without loss however slowly they meet, unless they are better taken for at
 * rest. The two limits are in multiples of the speed that gravity gives in a step. A pair in free
 * flight that meets more slowly than TD_BOUNCE_REST would meet some eight times within the step. */
#define TD_BOUNCE_REST 0.125
/* A pair that contacts bear trembles a little, and must not begin to bounce from that alone. */
#define TD_BOUNCE_BORNE 4.0

/* Takes the lanes of pairs that bounce within this step from the solver. Needs the narrowphase's
 * approaches, the settings of this step, and trajectories, in which it notes who is borne. */
void td_bounces_take(thud_world *w);

#endif
