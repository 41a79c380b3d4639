/* label.h: which bodies belong together: an island is what touching contacts between dynamic
 * bodies connect. */
#ifndef TD_LABEL_H
#define TD_LABEL_H

#include "state/world.h"

/* scratch.parents gets the island of each awake slot, named by its lowest slot; false when memory
 * is short. Whom a moving kinematic body touches is not at rest: his idle time starts over. */
bool td_islands_label(thud_world *w);

#endif
