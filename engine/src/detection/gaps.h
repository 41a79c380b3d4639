/* gaps.h: how far apart touching shapes are, as the rows of their contact tell it: a linear
 * function of the motion of their bodies, and much cheaper than their shapes. */
#ifndef TD_GAPS_H
#define TD_GAPS_H

#include "detection/trajectory.h"

/* Keeps touching pairs apart by changing the motion of the step, before it becomes poses: see
 * project.h. */
void td_gaps_project(thud_world *w);

/* So many elements of scratch.impacts are the room for that. */
int td_gaps_room(const thud_world *w);

/* Finds out which contacts the motion of the step, as the solver and td_gaps_project made it,
 * surely keeps apart; and whether one is of them. */
void td_gaps_find_open(thud_world *w);
bool td_gap_was_found_open(const thud_world *w, const td_constraint *contact);

/* Whether the contact, which touches, is of a body that joints tie to others: it is left to the
 * solver, which sees what they bear. */
bool td_gap_is_left_to_solver(const thud_world *w, const td_constraint *contact);
/* Whether the rest of both ways, from `now` on, surely brings the shapes of a contact no nearer
 * than what collisions begin at; false where that is not sure. */
bool td_gap_stays_open(const thud_world *w, const td_contact *contact, double now);

#endif
