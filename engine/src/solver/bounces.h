/* bounces.h: which contacts are resolved at their time of impact rather than by the solver. */
#ifndef TD_BOUNCES_H
#define TD_BOUNCES_H

#include "state/world.h"

/* Elastic pairs lose nothing however slowly they meet, up to where they are better taken for at
 * rest. In multiples of the speed that gravity gives in a step: in free trajectory, below this a
 * pair would meet some eight times within the step; ... */
#define TD_BOUNCE_REST 0.125
/* ... what contacts bear trembles a little, and does not begin to bounce by itself. */
#define TD_BOUNCE_BORNE 4.0

/* Takes the lanes of pairs that bounce within this step from the solver. Needs the narrowphase's
 * approaches, the settings of this step, and trajectories, in which it notes who is borne. */
void td_bounces_take(thud_world *w);

#endif
