/* all_pairs.c: the broadphase that keeps its shapes as they come, and tests each against each. */
#include "kinds.h"
#include "row.h"

#include <string.h>

static bool build(thud_world *w, td_population *row, bool quiet)
{
    (void)quiet;
    row->valid = false;
    if (!td_population_reserve(w, row)) {
        return false;
    }
    if (row->list.count) {
        memcpy(row->ids.data, row->list.data, (size_t)row->list.count * sizeof(int32_t));
    }
    td_row_fill(w, row);
    return true;
}

const thud_broadphase thud_broadphase_all = {
    .name = "all pairs",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_row_sweep),
    .find = TD_BOTH_WIDE(td_row_find),
};
