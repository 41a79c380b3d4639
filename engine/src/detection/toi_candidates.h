/* toi_candidates.h: finds the extra time-of-impact candidates of a body, which have no contact:
 * terrains, and shapes that its escaped shapes may meet. An escaped shape leaves the fat bounds by
 * which the broadphase paired it. Both functions return false when memory is short; the caller
 * then holds the body where it is. */
#ifndef TD_TOI_CANDIDATES_H
#define TD_TOI_CANDIDATES_H

#include "detection/trajectory.h"

/* Adds a candidate for each terrain that the whole path of the body may come down to. */
bool td_toi_candidates_find_terrain(thud_world *w, const td_trajectory *trajectory);
/* For each shape of the body that leaves its fat bounds on the rest of its path: queries the
 * broadphase, and adds candidates with the shapes that it may meet there, including escaped shapes
 * of other bodies. */
bool td_toi_candidates_find(thud_world *w, td_trajectory *trajectory);
/* Whether the solver's motion may have taken one of the body's shapes out of its fat bounds. */
bool td_trajectory_leaves_bounds(const thud_world *w, const td_trajectory *trajectory);

#endif
