/* all_pairs.c: the broadphase that keeps its shapes as they come, and tests each against each. */
#include "state/kinds.h"
#include "broadphase/sorted_axis.h"

#include <string.h>

static bool build(thud_world *w, td_proxy_set *row, bool quiet) {
    (void)quiet;
    row->valid = false;
    if (!td_proxy_set_reserve(w, row)) {
        return false;
    }
    if (row->list.count) {
        memcpy(row->ids.data, row->list.data, (size_t)row->list.count * sizeof(int32_t));
    }
    td_sorted_axis_fill(w, row);
    return true;
}

const thud_broadphase thud_broadphase_all = {
    .name = "all pairs",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
