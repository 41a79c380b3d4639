/* contact_check.h: checks that a direct solution of joints does not press contacts together. */
#ifndef TD_CONTACT_CHECK_H
#define TD_CONTACT_CHECK_H

#include "direct/island_step.h"

/* Whether a contact of the island's bodies, in the problem or not, ends the step with an overlap
 * that exceeds both its overlap at the start and that in the soft solver's result by more than
 * `slack` (length). Normals and lever arms are those of the start of the step. */
bool td_island_sinks(const td_island_work *work, double slack);

#endif
