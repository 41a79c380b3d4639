/* rings.h: dynamic bodies that joints tie together, in rings. Where detection holds one of them on
 * its way through a step, it holds all at that time, so that no joint opens. */
#ifndef TD_RINGS_H
#define TD_RINGS_H

#include "state/world.h"

/* The next body of the ring, in which it is the only one where nothing ties it. */
static inline td_awake_slot *td_next_tied(const thud_world *w, td_awake_slot slot) {
    return TD_AT(td_awake_slot, &w->scratch.rings, slot.at);
}

/* Whether joints tie it to other bodies. No body is, where there are no rings. */
static inline bool td_is_tied(const thud_world *w, td_awake_slot slot) {
    return slot.at > 0 && slot.at < w->scratch.rings.count && td_next_tied(w, slot)->at != slot.at;
}

#endif
