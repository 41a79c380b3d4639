/* ghosts.h: impacts with ghosts: contacts at internal edges, by which the neighbours of a shape
 * hide one of its faces or corners: see contact/internal_edges.h. */
#ifndef TD_GHOSTS_H
#define TD_GHOSTS_H

#include "detection/trajectory.h"

/* Whether the contact that a candidate makes at `time` is a ghost. Then *again, later than `time`,
 * is the time until which it remains one; it may be beyond the end of the step, 1. The pair is to
 * be tested again from there. */
bool td_is_ghost(thud_world *w, const td_toi_candidate *e, double time, double *again);

#endif
