/* sorted_axis.h: proxy sets in one row, as plane sweep and all-pairs have them. */
#ifndef TD_SORTED_AXIS_H
#define TD_SORTED_AXIS_H

#include "state/world.h"

/* Fills bounds, moved flags and extent of the shapes in `ids`; the row is valid then. */
void td_sorted_axis_fill(thud_world *w, td_proxy_set *row);

#endif
