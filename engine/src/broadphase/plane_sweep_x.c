/* plane_sweep_x.c: the broadphase that sorts and sweeps along x; see plane_sweep.c. */
#include "broadphase/plane_sweep.h"
#include "state/kinds.h"

/* thud_broadphase.build: sorts the keys and makes `ids` their order. */
static bool build(thud_world *w, td_proxy_set *set, bool few_moved) {
    (void)few_moved;
    return td_sweep_build(w, set, TD_AXIS_X);
}

const thud_broadphase thud_broadphase_sweep = {
    .name = "plane sweep",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
