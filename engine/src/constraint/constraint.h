/* constraint.h: the graph of constraints. Its nodes are bodies; every constraint joins two of them
 * and is an edge in the list of either. Contacts are one sort of constraints, whose kinds are pair
 * kinds; the others, such as rods, have kinds of their own.
 *
 * The numbers of all kinds, TD_CONSTRAINT_ROD among them, stand in contact/pair_kinds.h, behind the
 * pair kinds; what a kind does is a td_constraint_ops (constraint_ops.h); and what a joint
 * remembers of its bodies is a td_joint (state/records.h).
 *
 * A constraint that acts holds a lane: lanes.h. One that does not is in the waiting list of its
 * kind, or in no list while neither body is awake. */
#ifndef TD_CONSTRAINT_H
#define TD_CONSTRAINT_H

#include "state/world.h"

/* Room for `more` constraints of each kind listed. */
bool td_constraints_reserve(thud_world *w, const int more[TD_CONSTRAINT_KINDS]);
/* A waiting constraint of two bodies, of which the first is the static one if there is one. Room
 * for it is reserved. Returns its index. */
int td_constraint_create(thud_world *w, int kind, td_body_index body_a, td_body_index body_b);
/* Gives back its lane or its place among the waiting, and leaves both bodies' lists. A contact that
 * has begun must have ended: td_contact_destroy. */
void td_constraint_destroy(thud_world *w, int constraint);

/* Between waiting and resting, as the bodies sleep and wake. */
void td_constraint_rest(thud_world *w, int constraint);
void td_constraint_wait(thud_world *w, int constraint);

/* Steps along a body's constraints: edge = constraint * 2 + side. */
static inline int td_next_edge(const thud_world *w, int edge) {
    return td_constraint_at(w, edge / 2)->next[edge & 1];
}

/* The body on the other side of an edge. */
static inline td_body_index td_other_body(const thud_world *w, int edge) {
    return td_constraint_at(w, edge / 2)->body[1 - (edge & 1)];
}

#endif
