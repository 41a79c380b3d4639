/* kind_obb.c: plugs into a world the pair kinds and hooks that oriented boxes need; called when the
 * first is made. See kinds.h. */
#include "state/kinds.h"
#include "contact/internal_edges.h"

void td_kind_obb(thud_world *w) {
    TD_OBB_PAIRS(TD_PLUG_PAIR)
    TD_BOX_CIRCLE_PAIRS(TD_PLUG_PAIR)
    w->internal_edges = &td_internal_edges;
    w->instances = &td_all_instances;
}
