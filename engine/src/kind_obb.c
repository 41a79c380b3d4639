/* kind_obb.c: what a world needs once it has oriented boxes. */
#include "kinds.h"
#include "seams.h"

void td_kind_obb(thud_world *w)
{
    w->pairs[TD_PAIR_BOX_BOX] = &TD_PICK_WIDE(w, td_pair_box_box);
    w->pairs[TD_PAIR_BOX_CIRCLE] = &TD_PICK_WIDE(w, td_pair_box_circle);
    w->pairs[TD_PAIR_CIRCLE_BOX] = &TD_PICK_WIDE(w, td_pair_circle_box);
    w->seams = &td_seams;
}
