/* kind_terrain.c: what a world needs once it has terrain. */
#include "state/kinds.h"
#include "contact/internal_edges.h"
#include "state/shape.h"

void td_kind_terrain(thud_world *w) {
    TD_TERRAIN_PAIRS(TD_PLUG_PAIR)
    w->internal_edges = &td_internal_edges;
    w->ground = &td_ground;
}
