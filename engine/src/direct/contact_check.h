/* contact_check.h: checks that a direct solution of joints does not press contacts together. */
#ifndef TD_ISLAND_CONTACTS_H
#define TD_ISLAND_CONTACTS_H

#include "direct/island_step.h"

/* Whether some contact of the island's bodies, in the problem or not, ends the step with more
 * overlap than it had at the start and than it has in the soft solver's result, by more than
 * `slack`. Normals and arms are those of the start of the step. */
bool td_island_sinks(const td_island_work *work, double slack);

#endif
