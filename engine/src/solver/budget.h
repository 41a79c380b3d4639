/* budget.h: accuracy for time, where steps take longer than the world's def allows. */
#ifndef TD_BUDGET_H
#define TD_BUDGET_H

#include "state/world.h"

/* After a step that has been timed: may change the substeps of the next one. */
void td_budget_keep(thud_world *w);

#endif
