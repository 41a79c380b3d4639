/* kind_obb.c: what a world needs once it has oriented boxes. */
#include "state/kinds.h"
#include "contact/internal_edges.h"

void td_kind_obb(thud_world *w) {
    w->pairs[TD_PAIR_BOX_BOX] = &TD_PICK_WIDE(w, td_pair_box_box);
    w->pairs[TD_PAIR_BOX_CIRCLE] = &TD_PICK_WIDE(w, td_pair_box_circle);
    w->pairs[TD_PAIR_CIRCLE_BOX] = &TD_PICK_WIDE(w, td_pair_circle_box);
    w->internal_edges = &td_internal_edges;
}
