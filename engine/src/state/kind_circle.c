/* kind_circle.c: what a world needs once it has circles. */
#include "state/kinds.h"

void td_kind_circle(thud_world *w) {
    w->pairs[TD_PAIR_CIRCLE_CIRCLE] = &TD_PICK_WIDE(w, td_pair_circle_circle);
}
