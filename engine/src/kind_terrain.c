/* kind_terrain.c: what a world needs once it has terrain. */
#include "kinds.h"
#include "seams.h"

void td_kind_terrain(thud_world *w)
{
    w->pairs[TD_PAIR_TERRAIN_CIRCLE] = &TD_PICK_WIDE(w, td_pair_terrain_circle);
    w->pairs[TD_PAIR_TERRAIN_BOX] = &TD_PICK_WIDE(w, td_pair_terrain_box);
    w->seams = &td_seams;
}
