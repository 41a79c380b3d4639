/* restitution.c: the passes of restitution, as the table that a world in which contacts may bounce
 * has; see restitution.h. */
#include "solver/restitution.h"

#include "state/kinds.h"

const td_restitution_hooks td_restitution = {
    .one_point = TD_BOTH_WIDE(td_bounce_one),
    .two_points = TD_BOTH_WIDE(td_bounce_two),
    .end_flights = TD_BOTH_WIDE(td_end_flights),
};
