/* budget.c: see budget.h. Substeps are halved where the median of some steps is over the budget,
 * and doubled again, up to the quality's, where that would leave a good part of it. Which is a
 * matter of the clock, and therefore not deterministic. */
#include "solver/budget.h"

#include "solver/quality.h"

/* Substeps rise where this share of the budget would still be enough: less than all of it, so that
 * they do not fall again at the next breath. */
#define RISE_SHARE 0.8

static double median_of(const double *times) {
    double sorted[TD_BUDGET_STEPS];
    for (int i = 0; i < TD_BUDGET_STEPS; i++) {
        int k = i;
        for (; k > 0 && sorted[k - 1] > times[i]; k--) {
            sorted[k] = sorted[k - 1];
        }
        sorted[k] = times[i];
    }
    return sorted[TD_BUDGET_STEPS / 2];
}

void td_budget_keep(thud_world *w) {
    td_budget *b = &w->budget;
    if (w->def.time_budget == 0.0) {
        return;
    }
    b->taken[b->count] = w->stats.step_seconds;
    b->doubled[b->count] = w->stats.step_seconds + w->stats.stage_seconds[THUD_STAGE_SOLVE];
    if (++b->count < TD_BUDGET_STEPS) {
        return;
    }
    b->count = 0;
    if (median_of(b->taken) > w->def.time_budget) {
        td_substeps_set(w, td_max_int(w->substeps / 2, 1));
    } else if (median_of(b->doubled) <= RISE_SHARE * w->def.time_budget) {
        td_substeps_set(w, td_min_int(2 * w->substeps, td_substeps_asked(w)));
    }
}
