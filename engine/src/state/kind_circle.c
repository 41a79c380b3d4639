/* kind_circle.c: what a world needs once it has circles. */
#include "state/kinds.h"

void td_kind_circle(thud_world *w) {
    TD_CIRCLE_PAIRS(TD_PLUG_PAIR)
}
