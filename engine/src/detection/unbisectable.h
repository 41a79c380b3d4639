/* unbisectable.h: who moves further in a step than bisection can see. */
#ifndef TD_UNBISECTABLE_H
#define TD_UNBISECTABLE_H

#include "state/world.h"

/* Whether an awake body moved further than the thinnest shape is thick, and may have passed through
 * it unseen: one that is bisected, or, where others are, is looked for in no finer way. */
bool td_is_unbisectable(thud_world *w, td_awake_slot slot);

#endif
