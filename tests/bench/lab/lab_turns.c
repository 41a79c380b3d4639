/* lab_turns.c: see lab_turns.h. A turn is several steps, so that in most of them a world's data are
 * still in the cache. */
#include "lab/lab_turns.h"

#include "progress.h"

#include <assert.h>
#include <math.h>

enum { TURN = 5, LEAST_TURNS = 5 };

/* Makes a step and reads the world's stats. */
static bool step_once(lab_world *lab, lab_turns_times *times) {
    if (!lab_run(lab, 1, NULL))
        return false;
    times->stats = thud_stats_of(lab->world);
    return true;
}

/* Seconds of the last step's broadphase stage. */
static double broadphase_of(const lab_turns_times *times) {
    return times->stats.stage_seconds[THUD_STAGE_BROADPHASE];
}

static bool warm_up(lab_world *lab, const lab_turns_plan *plan, int repetition,
                    lab_turns_times *times) {
    if (repetition == 0)
        *times = (lab_turns_times){.first = INFINITY, .second_step = INFINITY};
    if (times->dropped)
        return true;
    if (!step_once(lab, times))
        return false;
    times->first = fmin(times->first, broadphase_of(times));
    if (!step_once(lab, times))
        return false;
    times->second_step = fmin(times->second_step, times->stats.step_seconds);
    times->dropped = repetition == 0 && times->second_step > plan->too_dear;
    for (int i = 2; i < plan->warm_up && !times->dropped; i++)
        if (!step_once(lab, times))
            return false;
    return true;
}

static bool take_turn(lab_world *lab, int first, int steps, int repetition,
                      lab_turns_times *times) {
    for (int i = first; i < first + TURN && i < steps; i++) {
        if (!step_once(lab, times))
            return false;
        double step = times->stats.step_seconds, broadphase = broadphase_of(times);
        times->step[i] = repetition == 0 ? step : fmin(step, times->step[i]);
        times->broadphase[i] =
            repetition == 0 ? broadphase : fmin(broadphase, times->broadphase[i]);
        times->count = repetition == 0 ? i + 1 : times->count;
    }
    return true;
}

bool lab_take_turns(const char *label, lab_world *labs, int count, const lab_turns_plan *plan,
                    int repetition, lab_turns_times *times) {
    assert(plan->steps <= LAB_TURNS_STEPS);
    double start = lab_now(NULL);
    for (int k = 0; k < count; k++)
        if (!warm_up(&labs[k], plan, repetition, &times[k]))
            return false;
    for (int first = 0; first < plan->steps; first += TURN) {
        bool late = lab_now(NULL) - start > plan->seconds;
        if (repetition == 0 && late && first >= LEAST_TURNS * TURN)
            break;
        progress_show(label, (double)first / plan->steps);
        for (int k = 0; k < count; k++) {
            int steps = repetition == 0 ? plan->steps : times[k].count;
            if (!times[k].dropped && !take_turn(&labs[k], first, steps, repetition, &times[k]))
                return false;
        }
    }
    progress_clear();
    return true;
}

double lab_turns_mean(const double *values, int count) {
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += values[i];
    return sum / count;
}
