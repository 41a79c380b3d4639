/* arrivals.h: pairs that would meet in this step, of which one body at least lies against others.
 * Only pairs that are swept and do not bounce; every other impact is left to impacts.c, at its
 * exact time. */
#ifndef TD_ARRIVALS_H
#define TD_ARRIVALS_H

#include "detection/arrival_rows.h"

/* Most arrivals of a step. Pairs beyond it are left to impacts.c. */
int td_arrivals_max(const thud_world *w);
/* Fills scratch.arrivals, before td_gaps_project. Needs contact_count of all trajectories. */
void td_arrivals_find(thud_world *w);
/* The arrival of a contact, or null. The prologue was asked about it, and need not be again. */
const td_arrival *td_arrival_of(const thud_world *w, int contact);
/* Applies friction to what arrived, and appends its impacts to scratch.impacts. */
void td_arrivals_end(thud_world *w);

#endif
