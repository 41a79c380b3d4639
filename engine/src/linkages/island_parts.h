/* island_parts.h: in how many parts a step of an island with joints is solved. */
#ifndef TD_ISLAND_PARTS_H
#define TD_ISLAND_PARTS_H

#include "islands/island_solve.h"

/* By how far anything turns that moves a joint, as it came and as the soft solver has it; 0: what
 * turns so fast is left to the soft solver. Notes whose turn matters, and to what, in the bodies of
 * the problem. */
int td_island_parts(td_island_work *work);
/* Something that others touch, and that is no disc, has turned past work->turn_most. */
bool td_island_rubs(const td_island_work *work);

#endif
