/* constraint.h: the graph of constraints. Its nodes are bodies. Each constraint joins two bodies,
 * and is in the doubly linked lists of both (td_body.first_constraint, td_constraint.next, prev).
 * An edge is its place in one of the two lists, written as the number constraint * 2 + side
 * (td_edge_of): side 0 is the list of body[0], side 1 that of body[1].
 *
 * The kind of a contact is a pair kind; a joint consists of up to four constraints of
 * TD_CONSTRAINT_ kinds (joints/joint.h); contact/pair_kinds.h numbers them all. A kind's operations
 * are a td_constraint_ops (constraint_ops.h).
 *
 * States (td_constraint.state): a constraint that acts (TD_TOUCHING) holds a lane (lanes.h). One
 * that does not act is in the waiting list of its kind (TD_WAITING), or in no list while neither of
 * its bodies is awake (TD_RESTING). */
#ifndef TD_CONSTRAINT_H
#define TD_CONSTRAINT_H

#include "state/world.h"

/* Reserves memory for more[kind] further constraints of each kind. False when memory is short. */
bool td_constraints_reserve(thud_world *w, const int more[TD_CONSTRAINT_KINDS]);
/* Creates a waiting constraint of two bodies, and returns its index. If one body is static, it must
 * be body_a. Memory must have been reserved. */
int td_constraint_create(thud_world *w, int kind, td_body_index body_a, td_body_index body_b);
/* Destroys a constraint: frees its lane, or removes it from the waiting list, and removes it from
 * both bodies' lists. A contact that touches must have ended before, with its event
 * (td_contact_destroy). */
void td_constraint_destroy(thud_world *w, int constraint);

/* Removes a waiting constraint from the waiting list, when the last of its awake bodies falls
 * asleep. */
void td_constraint_rest(thud_world *w, int constraint);
/* Adds a constraint that is in no list to the waiting list of its kind. */
void td_constraint_wait(thud_world *w, int constraint);

/* The next edge of a body's list, or TD_NONE. */
static inline int td_next_edge(const thud_world *w, int edge) {
    return td_constraint_at(w, td_edge_constraint(edge))->next[td_edge_side(edge)];
}

/* The other body of an edge's constraint. */
static inline td_body_index td_other_body(const thud_world *w, int edge) {
    return td_constraint_at(w, td_edge_constraint(edge))->body[1 - td_edge_side(edge)];
}

#endif
