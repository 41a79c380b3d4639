/* all_pairs.c: the broadphase that tests the bounds of each shape against those of every other,
 * eight at a time (wide_axis_sweep.c, without keys). It has no order to keep up to date. A sweep
 * over n shapes takes n^2 / 16 tests of eight pairs of bounds each, which for a few dozen shapes is
 * less work than any order would be. */
#include "state/kinds.h"
#include "broadphase/sorted_axis.h"

#include <string.h>

/* thud_broadphase.build: puts the shapes of `list` into `ids` in the order that they have there. */
static bool build(thud_world *w, td_proxy_set *set, bool few_moved) {
    (void)few_moved;
    set->valid = false;
    if (!td_proxy_set_reserve(w, set, set->list.count)) {
        return false;
    }
    set->ids.count = set->list.count;
    if (set->list.count) {
        memcpy(set->ids.data, set->list.data, (size_t)set->list.count * sizeof(int32_t));
    }
    td_sorted_axis_fill(w, set);
    return true;
}

const thud_broadphase thud_broadphase_all = {
    .name = "all pairs",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
