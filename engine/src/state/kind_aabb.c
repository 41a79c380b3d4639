/* kind_aabb.c: plugs into a world the pair kinds and hooks that axis-aligned boxes need; called
 * when the first is made. See kinds.h. */
#include "state/kinds.h"
#include "contact/internal_edges.h"

void td_kind_aabb(thud_world *w) {
    TD_AABB_PAIRS(TD_PLUG_PAIR)
    TD_BOX_CIRCLE_PAIRS(TD_PLUG_PAIR)
    w->internal_edges = &td_internal_edges;
    w->instances = &td_all_instances;
}
