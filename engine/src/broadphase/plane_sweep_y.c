/* plane_sweep_y.c: the broadphase that sorts and sweeps along y; see plane_sweep.c. */
#include "broadphase/plane_sweep.h"
#include "state/kinds.h"

/* thud_broadphase.build: sorts the keys and makes `ids` their order. */
static bool build(thud_world *w, td_proxy_set *set, bool few_moved) {
    (void)few_moved;
    return td_sweep_build(w, set, TD_AXIS_Y);
}

const thud_broadphase thud_broadphase_sweep_y = {
    .name = "plane sweep y",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
