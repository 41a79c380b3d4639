/* toi_candidates.h: whom a body may meet on its way, beyond those that it has contacts with. All
 * are false when memory is short; the body is then best held where it is. */
#ifndef TD_TOI_CANDIDATES_H
#define TD_TOI_CANDIDATES_H

#include "detection/trajectory.h"

/* The ground is looked up along the whole way at once. */
bool td_toi_candidates_find_terrain(thud_world *w, const td_trajectory *trajectory);
/* A body that leaves the bounds that the broadphase knew looks for what else it may meet. */
bool td_toi_candidates_find(thud_world *w, td_trajectory *trajectory);
/* Whether the solver's motion may have taken the body out of those bounds. */
bool td_trajectory_leaves_bounds(const thud_world *w, const td_trajectory *trajectory);

#endif
