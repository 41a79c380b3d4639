/* budget.c: the controller of the time budget. Over each TD_BUDGET_STEPS steps it takes the median
 * of the step times. Substeps are halved where the median is over the budget. They are doubled, up
 * to the number that the def or the quality asks for, where the estimated time of a step with twice
 * the substeps is below RISE_SHARE of the budget. The estimate is the median of the step times to
 * which the times of their solver are added once more. The result depends on the clock, so that
 * worlds with a time budget are not deterministic. */
#include "solver/budget.h"

#include "solver/quality.h"

/* Hysteresis: substeps are doubled only where the estimated time is below this share of the budget,
 * so that they are not halved again by noise. Chosen. */
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
