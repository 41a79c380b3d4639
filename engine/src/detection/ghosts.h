/* ghosts.h: pairs that meet on their way where neighbours hide them from each other: see
 * internal_edges.h. */
#ifndef TD_GHOSTS_H
#define TD_GHOSTS_H

#include "detection/trajectory.h"

/* Whether what the two meet at a time is a ghost; it is one until *again at least. */
bool td_is_ghost(thud_world *w, const td_toi_candidate *e, double time, double *again);

#endif
