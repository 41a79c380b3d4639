/* constraint.h: the graph of constraints. Its nodes are bodies. Each constraint joins two bodies,
 * and is an edge in the doubly linked list of either (td_body.first_constraint, td_constraint.next,
 * prev). An edge (td_edge_of) is the number constraint * 2 + side, with side 0 for the list of
 * body[0], 1 for that of body[1].
 *
 * A contact is a constraint of a pair kind, a part of a joint one of a TD_CONSTRAINT_ kind;
 * contact/pair_kinds.h numbers them all. A kind's operations are a td_constraint_ops
 * (constraint_ops.h).
 *
 * States (td_constraint.state): a constraint that acts (TD_TOUCHING) holds a lane (lanes.h). One
 * that does not act is in the waiting list of its kind (TD_WAITING), or in no list while neither of
 * its bodies is awake (TD_RESTING). */
#ifndef TD_CONSTRAINT_H
#define TD_CONSTRAINT_H

#include "state/world.h"

/* Makes room for more[kind] constraints of each kind. False when memory is short. */
bool td_constraints_reserve(thud_world *w, const int more[TD_CONSTRAINT_KINDS]);
/* Makes a constraint of two bodies, which waits. If one of them is static, it must be body_a. Room
 * for it must be reserved. Returns its index. */
int td_constraint_create(thud_world *w, int kind, td_body_index body_a, td_body_index body_b);
/* Destroys a constraint: it gives back its lane or its place in the waiting list, and leaves both
 * bodies' lists. A contact that has begun must have ended (td_contact_destroy). */
void td_constraint_destroy(thud_world *w, int constraint);

/* A waiting constraint leaves the waiting list, as its last awake body falls asleep. */
void td_constraint_rest(thud_world *w, int constraint);
/* A constraint that is in no list joins the waiting list of its kind. */
void td_constraint_wait(thud_world *w, int constraint);

/* The next edge of a body's list, or TD_NONE. */
static inline int td_next_edge(const thud_world *w, int edge) {
    return td_constraint_at(w, td_edge_constraint(edge))->next[td_edge_side(edge)];
}

/* The body at the other end of an edge. */
static inline td_body_index td_other_body(const thud_world *w, int edge) {
    return td_constraint_at(w, td_edge_constraint(edge))->body[1 - td_edge_side(edge)];
}

#endif
