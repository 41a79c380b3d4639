/* gaps.h: the gaps of touching shapes through the step, by the rows of their contacts: a gap is a
 * linear function of the motion of both bodies, which is much cheaper than a distance of shapes.
 * Used by impacts.c, so that contacts under load need no time of impact. */
#ifndef TD_GAPS_H
#define TD_GAPS_H

#include "detection/trajectory.h"

/* Changes the motion of the step, before it becomes poses, so that touching pairs stay apart: see
 * project.h. */
void td_gaps_project(thud_world *w);

/* Number of elements of scratch.impacts (td_impact) that td_gaps_project needs as memory. */
int td_gaps_room(const thud_world *w);

/* Sets td_block.apart: the lanes of contacts whose shapes provably stay apart during the motion of
 * the step. Runs after td_gaps_project, while trajectories are at the start of the step. */
void td_gaps_find_open(thud_world *w);
/* Whether a touching contact needs no time of impact for the motion of the step: td_gaps_find_open
 * found it apart, or it is left to the solver. */
bool td_gap_was_found_open(const thud_world *w, const td_constraint *contact);

/* Whether a touching contact is left to the solver and to td_gaps_project: joints tie one of its
 * bodies to others, so that the solver knows the load on them, or the bodies rest on each other. If
 * the small closing motion of resting bodies under a load were an impact, every body of a stack
 * would move away from the first neighbour that it meets, and the stack would fall. */
bool td_gap_is_left_to_solver(const thud_world *w, const td_constraint *contact);
/* Whether the shapes of a touching contact provably do not collide (COLLISION_DISTANCE,
 * TD_LOAD_CLOSING_MAX) on both trajectories from `now` to the end of the step. False if the rows
 * cannot prove it. */
bool td_gap_stays_open(const thud_world *w, const td_contact *contact, double now);

#endif
