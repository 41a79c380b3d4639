/* kind_terrain.c: plugs into a world the pair kinds and hooks that terrains need; called when the
 * first is made. See kinds.h. */
#include "state/kinds.h"
#include "contact/internal_edges.h"
#include "state/shape.h"

void td_kind_terrain(thud_world *w) {
    TD_TERRAIN_PAIRS(TD_PLUG_PAIR)
    w->internal_edges = &td_internal_edges;
    w->ground = &td_ground;
}
