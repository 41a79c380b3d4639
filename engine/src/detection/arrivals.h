/* arrivals.h: finds the arrivals of a step: pairs that do not touch yet, would meet within the
 * step, and have a body that touches others. They are solved together with the contacts, for the
 * reason that arrival_rows.h gives. Only pairs whose detection is `swept` and that do not bounce
 * are arrivals; all other pairs have an impact at its exact time (impacts.c). */
#ifndef TD_ARRIVALS_H
#define TD_ARRIVALS_H

#include "detection/arrival_rows.h"

/* The maximum number of arrivals in a step. Pairs beyond it are left to impacts.c. */
int td_arrivals_max(const thud_world *w);
/* Fills scratch.arrivals, before td_gaps_project. Needs contact_count of all trajectories. */
void td_arrivals_find(thud_world *w);
/* The arrival of a contact, or null. The prologue has been asked about an arrival already, and must
 * not be asked again in this step. */
const td_arrival *td_arrival_of(const thud_world *w, int contact);
/* Applies friction to arrivals that have a normal impulse, and appends an impact for each to
 * scratch.impacts. */
void td_arrivals_end(thud_world *w);

#endif
