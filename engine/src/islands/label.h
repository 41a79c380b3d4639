/* label.h: which bodies belong together: an island is what touching contacts between dynamic
 * bodies connect. */
#ifndef TD_LABEL_H
#define TD_LABEL_H

#include "state/world.h"

/* In a forest of parents, each of which may be its own; ways there get shorter. */
static inline td_awake_slot td_root_of(td_awake_slot *parents, td_awake_slot i) {
    while (parents[i.at].at != i.at) {
        parents[i.at] = parents[parents[i.at].at];
        i = parents[i.at];
    }
    return i;
}

/* scratch.parents gets the island of each awake slot, named by its lowest slot; false when memory
 * is short. `keep_awake`: what a moving kinematic body touches is not at rest, and its idle time
 * starts over. */
bool td_islands_label(thud_world *w, bool keep_awake);

#endif
