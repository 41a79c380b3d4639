/* lab_turns.c: see lab_turns.h. A turn is one step where steps are long, and some where they are
 * short, so that a world mostly finds the caches as it left them. */
#include "lab_turns.h"

#include "progress.h"
#include "series.h"

#include <assert.h>

enum { WORLDS = 4, TURN = 5, LEAST_TURNS = 5 };

typedef struct record {
    double step[LAB_TURNS_STEPS], broadphase[LAB_TURNS_STEPS];
    int count;
} record;

static bool step_once(lab_world *lab, lab_turns_times *times) {
    if (!lab_run(lab, 1, NULL))
        return false;
    times->stats = thud_world_stats(lab->world);
    return true;
}

static double broadphase_of(const lab_turns_times *times) {
    return times->stats.stage_seconds[THUD_STAGE_BROADPHASE];
}

static bool warm_up(lab_world *lab, const lab_turns_plan *plan, lab_turns_times *times) {
    *times = (lab_turns_times){0};
    if (!step_once(lab, times))
        return false;
    times->first = broadphase_of(times);
    times->first_step = times->stats.step_seconds;
    times->dropped = times->first_step > plan->too_dear;
    for (int i = 1; i < plan->warm_up && !times->dropped; i++)
        if (!step_once(lab, times))
            return false;
    return true;
}

static bool take_turn(lab_world *lab, const lab_turns_plan *plan, lab_turns_times *times,
                      record *r) {
    for (int i = 0; i < TURN && r->count < plan->steps; i++) {
        if (!step_once(lab, times))
            return false;
        r->step[r->count] = times->stats.step_seconds;
        r->broadphase[r->count++] = broadphase_of(times);
    }
    return true;
}

bool lab_take_turns(const char *label, lab_world *labs, int count, const lab_turns_plan *plan,
                    lab_turns_times *times) {
    static record records[WORLDS];
    assert(count <= WORLDS && plan->steps <= LAB_TURNS_STEPS);
    double start = lab_now(NULL);
    for (int k = 0; k < count; k++) {
        records[k].count = 0;
        if (!warm_up(&labs[k], plan, &times[k]))
            return false;
    }
    for (int turn = 0; turn * TURN < plan->steps; turn++) {
        if (turn >= LEAST_TURNS && lab_now(NULL) - start > plan->seconds)
            break;
        progress_show(label, (double)turn * TURN / plan->steps);
        for (int k = 0; k < count; k++)
            if (!times[k].dropped && !take_turn(&labs[k], plan, &times[k], &records[k]))
                return false;
    }
    for (int k = 0; k < count; k++)
        if (!times[k].dropped) {
            times[k].step = series_median(records[k].step, records[k].count);
            times[k].broadphase = series_median(records[k].broadphase, records[k].count);
        }
    progress_clear();
    return true;
}
