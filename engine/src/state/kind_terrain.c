/* kind_terrain.c: what a world needs once it has terrain. */
#include "state/kinds.h"
#include "contact/internal_edges.h"
#include "state/shape.h"

static const td_ground_ops ground = {thud_terrain_overlap, thud_terrain_time_of_impact,
                                     thud_terrain_sample_at};

void td_kind_terrain(thud_world *w) {
    w->pairs[TD_PAIR_TERRAIN_CIRCLE] = &TD_PICK_WIDE(w, td_pair_terrain_circle);
    w->pairs[TD_PAIR_TERRAIN_BOX] = &TD_PICK_WIDE(w, td_pair_terrain_box);
    w->internal_edges = &td_internal_edges;
    w->ground = &ground;
}
