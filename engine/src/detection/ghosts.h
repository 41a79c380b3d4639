/* ghosts.h: finds impacts that are ghosts: contacts with a face or corner of a shape that its
 * neighbours hide (contact/internal_edges.h). They must have no effect. */
#ifndef TD_GHOSTS_H
#define TD_GHOSTS_H

#include "detection/trajectory.h"

/* Whether the contact of a candidate at `time` is a ghost. If so, *again is the time until which it
 * stays one, later than `time`; the pair has to be tested again from there. It may be above 1, the
 * end of the step. */
bool td_is_ghost(thud_world *w, const td_toi_candidate *e, double time, double *again);

#endif
