/* row.h: populations in one row, as plane sweep and all-pairs have them. */
#ifndef TD_ROW_H
#define TD_ROW_H

#include "world.h"

/* Fills bounds, moved flags and extent of the shapes in `ids`; the row is valid then. */
void td_row_fill(thud_world *w, td_population *row);

#endif
