/* kind_circle.c: plugs into a world the pair kinds and hooks that circles need; called when the
 * first is made. See kinds.h. */
#include "state/kinds.h"

void td_kind_circle(thud_world *w) {
    TD_CIRCLE_PAIRS(TD_PLUG_PAIR)
    w->instances = w->instances ? w->instances : &td_circle_instances;
}
