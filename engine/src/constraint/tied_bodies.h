/* tied_bodies.h: groups of dynamic bodies that joints with locked directions connect.
 *
 * Two bodies are tied where an acting joint locks a direction between them. The groups are the
 * connected components of this graph, each kept as a circular linked list over awake slots
 * (scratch.next_tied). A body without such joints is a group of its own. td_joints_tie makes the
 * lists once in a step, when a stage first needs them; before that the array is empty, and no body
 * counts as tied.
 *
 * Detection uses them: if it stops a body within the step, it stops the whole group at that time,
 * so that no joint opens; once bodies of a group touch something, their contacts are left to the
 * solver, which also knows the joints' impulses. joint_yield.c corrects whole groups. */
#ifndef TD_TIED_BODIES_H
#define TD_TIED_BODIES_H

#include "state/world.h"

/* The list's link of a slot: the next slot of the group; the slot itself if no joint locks its body
 * to anything; TD_NONE if the body is the only dynamic one of its group but a joint fixes it to a
 * static or kinematic body, so that it counts as tied. */
static inline td_awake_slot *td_tied_link(const thud_world *w, td_awake_slot slot) {
    return TD_AT(td_awake_slot, &w->scratch.next_tied, slot.at);
}

/* The next body of the group; the body itself if it is the only one. */
static inline td_awake_slot td_next_tied(const thud_world *w, td_awake_slot slot) {
    td_awake_slot next = *td_tied_link(w, slot);
    return next.at == TD_NONE ? slot : next;
}

/* Whether locked joints tie the body to another one, static ones included. False for slot 0, and
 * where the lists were not made in this step. */
static inline bool td_is_tied(const thud_world *w, td_awake_slot slot) {
    return slot.at > 0 && slot.at < w->scratch.next_tied.count &&
           td_tied_link(w, slot)->at != slot.at;
}

/* Keeps the lists valid when a body gives up its awake slot within the step and the body in the
 * last slot moves there: the first one is unlinked, and links to the last slot change to `slot`. */
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
