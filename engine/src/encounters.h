/* encounters.h: whom a body may meet on its way, beyond those that it has contacts with. All are
 * false when memory is short; the body is then best held where it is. */
#ifndef TD_ENCOUNTERS_H
#define TD_ENCOUNTERS_H

#include "flight.h"

/* The ground is looked up along the whole way at once. */
bool td_encounters_on_ground(thud_world *w, const td_flight *flight);
/* A body that leaves the bounds that the broadphase knew looks for what else it may meet. */
bool td_encounters_around(thud_world *w, td_flight *flight);
/* Whether the solver's motion may have taken the body out of those bounds. */
bool td_flight_is_unexpected(const thud_world *w, const td_flight *flight);

#endif
