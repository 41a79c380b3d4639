/* plan.c: the table of plans. Ten steps make the contacts and grow the buffers; longer warm-ups
 * wait for a scene to become what it is meant to measure. The whole default run takes about one
 * minute with three repetitions. */
#include "plan.h"

#include <string.h>

static const bench_plan PLANS[] = {
    {"pyramid", 10, 300, true, false, "stands from the start: a solver full of resting contacts"},
    {"circle_pit", 30, 600, true, false, "ten seconds from free fall to a settling heap"},
    {"mixed_terrain", 30, 600, true, false, "fall, impact and settling in the valleys"},
    {"smash", 1, 300, true, false, "resting block, impact, and the spreading debris"},
    {"tumbler", 120, 600, true, false, "starts when the load has dropped to the turning floor"},
    {"tumbler_half", 120, 600, true, false, "as tumbler"},
    {"platformer", 30, 600, true, false, "falling on the tiles, then running and resting there"},
    {"gas", 10, 300, true, false, "never rests: all pairs change all the time"},
    {"sizes", 10, 600, false, false, "the heap while it collapses and settles"},
    {"one_spot", 1, 300, false, false, "the collapse itself"},
    {"asleep", 180, 300, false, true, "starts when the stacks sleep; the hundred circles do not"},
};

static const bench_plan GENERAL = {NULL, 10, 300, false, false, "the first five seconds"};

bench_plan bench_plan_for(const char *scene) {
    for (size_t i = 0; i < sizeof PLANS / sizeof PLANS[0]; i++)
        if (strcmp(PLANS[i].scene, scene) == 0)
            return PLANS[i];
    bench_plan plan = GENERAL;
    plan.scene = scene;
    return plan;
}

bench_plan bench_plan_quick(bench_plan plan) {
    plan.warm_up = plan.warm_up < 10 ? plan.warm_up : 10;
    plan.steps = plan.steps < 40 ? plan.steps : 40;
    return plan;
}
