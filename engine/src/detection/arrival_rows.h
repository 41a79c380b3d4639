/* arrival_rows.h: the rows of arrivals, which td_gaps_project solves together with the contacts.
 *
 * An arrival is a pair of shapes that does not touch at the start of the step, and would meet in it
 * (arrivals.c finds them). If its bodies touch others, an impact that changes the motion of these
 * two alone drives them into their neighbours, these into theirs, and so on: one body that meets a
 * heap led to twenty impacts. As a row, the arrival is solved together with all contacts of the
 * heap. */
#ifndef TD_ARRIVAL_ROWS_H
#define TD_ARRIVAL_ROWS_H

#include "detection/collide.h"
#include "detection/project.h"
#include "listeners/decisions.h"

/* One contact point of an arrival, at the time at which the pair would meet. With the motions D of
 * both bodies in the step, their turns phi, and c = r x n, its gap at the end of the step is
 *   start + n . (D_b - D_a) + c_b phi_b - c_a phi_a
 * as in gaps.c; here `start` is chosen so that the formula gives the exact gap at the time at which
 * the pair would meet. */
typedef struct td_arrival {
    td_awake_slot a, b;   /* 0: the body does not move */
    float nx, ny;         /* normal, from a to b */
    float ax, ay, bx, by; /* arms: from the centres of mass to the point */
    float start;          /* the gap at the start of the step, length */
    float gap_min;        /* the gap must not end below this, length */
    float inv_inertia[2]; /* of a and b */
    float mass; /* effective mass along the normal: impulse over the change of the closing speed
                   that it causes */
    float motion, velocity;         /* accumulated impulses, >= 0, as in td_pushes */
    float rubbed;                   /* friction impulse on b along (ny, -nx), mass length/s */
    thud_contact_settings settings; /* surface of the pair; its restitution has no effect, since
                                       pairs that bounce are no arrivals */
    td_impact impact;               /* as callbacks will see it; closing_speed is set */
    int32_t contact;                /* its number */
    bool decided; /* the program's prologue (its callback before a contact is solved) has set the
                     velocities (`decision`): nothing is solved */
    td_decision decision;
} td_arrival;

/* One pass over all rows, as td_project_fn does over contacts. Returns at how many rows another
 * pass is needed. */
int td_arrival_rows_project(thud_world *w, const td_project_context *context);

/* Applies Coulomb friction to the velocities, bounded by the normal impulses `velocity`. The
 * motions of this step do not change, so that the gaps stay as solved. */
void td_arrival_rows_rub(thud_world *w);

#endif
