/* tied_bodies.h: dynamic bodies that joints tie together, in rings. Where detection holds one of
 * them on its way through a step, it holds all at that time, so that no joint opens; contacts of
 * what is tied are left to the solver, which sees what they bear, once they touch. */
#ifndef TD_TIED_BODIES_H
#define TD_TIED_BODIES_H

#include "state/world.h"

/* What a slot is followed by: itself where no joint locks its body to anything, TD_NONE where
 * joints lock it to what they cannot move alone. */
static inline td_awake_slot *td_tied_link(const thud_world *w, td_awake_slot slot) {
    return TD_AT(td_awake_slot, &w->scratch.next_tied, slot.at);
}

/* The next body of the ring, in which it may be the only one. */
static inline td_awake_slot td_next_tied(const thud_world *w, td_awake_slot slot) {
    td_awake_slot next = *td_tied_link(w, slot);
    return next.at == TD_NONE ? slot : next;
}

/* Whether joints tie it to anything. No body is, where there are no rings. */
static inline bool td_is_tied(const thud_world *w, td_awake_slot slot) {
    return slot.at > 0 && slot.at < w->scratch.next_tied.count &&
           td_tied_link(w, slot)->at != slot.at;
}

/* A body leaves its awake slot within the step, and the one in the last slot gets it: the others of
 * its ring stay tied. */
static inline void td_tied_leave(thud_world *w, td_awake_slot slot) {
    td_awake_slot last = {w->scratch.next_tied.count - 1};
    if (last.at < 0) {
        return;
    }
    td_awake_slot after = *td_tied_link(w, slot);
    for (td_awake_slot i = {0}; i.at <= last.at; i.at++) {
        td_awake_slot *next = td_tied_link(w, i);
        *next = next->at == slot.at ? after : *next;
        *next = next->at == last.at ? slot : *next;
    }
    *td_tied_link(w, slot) = *td_tied_link(w, last);
    w->scratch.next_tied.count = last.at;
}

#endif
