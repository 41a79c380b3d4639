/* kind_terrain.c: what a world needs once it has terrain. */
#include "state/kinds.h"
#include "broadphase/pairs.h"
#include "contact/internal_edges.h"
#include "state/shape.h"

static const td_ground_ops ground = {thud_terrain_overlap,   thud_terrain_time_of_impact,
                                     thud_terrain_sample_at, td_terrain_view,
                                     td_terrain_below,       td_terrain_segments_of,
                                     td_terrain_reaches,     td_pairs_add_ground};

void td_kind_terrain(thud_world *w) {
    TD_TERRAIN_PAIRS(TD_PLUG_PAIR)
    w->internal_edges = &td_internal_edges;
    w->ground = &ground;
}
