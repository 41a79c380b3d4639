/* sorted_axis.h: proxy sets that are one list, without cells: sorted along x (plane_sweep.c), or in
 * the order in which the shapes were listed (all_pairs.c). Both are searched by
 * wide_axis_sweep.c. */
#ifndef TD_SORTED_AXIS_H
#define TD_SORTED_AXIS_H

#include "state/world.h"

/* Fills the bounds, the moved flags, and the range of centres (origin, end) of the shapes in `ids`,
 * whose order the caller has chosen, and makes the set valid. */
void td_sorted_axis_fill(thud_world *w, td_proxy_set *set);

#endif
