/* budget.h: fewer substeps where steps take longer than thud_world_def.time_budget. */
#ifndef TD_BUDGET_H
#define TD_BUDGET_H

#include "state/world.h"

/* After a timed step: may change the number of substeps of the next one. */
void td_budget_keep(thud_world *w);

#endif
