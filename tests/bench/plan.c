/* plan.c: the table of plans, with the bounds that thud is held to. A warm-up of ten steps creates
 * the contacts and grows the buffers; a longer one waits until the scene is in the state that it is
 * meant to measure. */
#include "plan.h"

#include <string.h>

/* In the order of the fields of bench_plan: scene, size, warm-up, steps, by default, sleeping,
 * target, limit, reason for warm-up and steps. */
static const bench_plan PLANS[] = {
    {"pyramid", 0, 10, 300, true, false, 4.5, 0,
     "stands from the start: a solver full of contacts"},
    {"circle_pit", 0, 30, 600, true, false, 6, 0, "ten seconds, from free fall to a heap"},
    {"mixed_terrain", 0, 30, 600, true, false, 5, 0, "fall, impact and settling in the valleys"},
    {"smash", 0, 1, 300, true, false, 8, 0, "resting block, impact, and the spreading debris"},
    {"tumbler", 0, 120, 600, true, false, 7, 0, "starts when the load is on the turning floor"},
    {"tumbler_half", 0, 120, 600, true, false, 7, 0, "as tumbler"},
    {"platformer", 0, 30, 600, true, false, 6, 0, "falling on the tiles, then running and resting"},
    {"gas", 1000, 10, 300, true, false, 8, 0, "never rests: all pairs change all the time"},
    {"gas", 4000, 10, 300, true, false, 8, 0, "as above"},
    {"gas", 16000, 10, 300, true, false, 8, 0, "as above"},
    {"gas", 64000, 10, 100, true, false, 8, 0, "as above"},
    {"sizes", 0, 10, 600, true, false, 5, 0, "the heap while it collapses and settles"},
    {"one_spot", 0, 1, 300, true, false, 7, 0, "the collapse itself"},
    {"overlapping", 0, 0, 100, true, false, 0, 50, "from the first step, which finds every pair"},
    {"asleep", 0, 180, 300, true, true, 4, 0, "starts when the stacks sleep; the circles do not"},
    {"ragdolls", 200, 10, 600, true, false, 4, 0, "fall, impact, and rest in a heap"},
    {"joint_grid", 100, 10, 300, true, false, 5, 0, "hangs, and swings on"},
    {"swinging_chains", 0, 10, 600, true, false, 3, 0, "never rest"},
    {"bridges", 0, 10, 600, true, false, 4, 0, "impacts, and swinging out"},
};

enum { PLAN_COUNT = sizeof PLANS / sizeof PLANS[0] };

static const bench_plan GENERAL = {NULL, 0, 10, 300, false, false, 0, 0, "the first five seconds"};

int bench_plan_count(void) {
    return PLAN_COUNT;
}

bench_plan bench_plan_at(int index) {
    return PLANS[index];
}

/* Whether `size` is the plan's own size; 0 stands for the scene's default. */
static bool is_size(const bench_plan *plan, int size) {
    const scene_info *info = bench_scene(plan->scene);
    int own = plan->size ? plan->size : info->default_size;
    return (size ? size : info->default_size) == own;
}

bench_plan bench_plan_for(const char *name, int size) {
    const bench_plan *other = NULL;
    for (int i = 0; i < PLAN_COUNT; i++) {
        if (strcmp(PLANS[i].scene, name) != 0)
            continue;
        if (is_size(&PLANS[i], size))
            return PLANS[i];
        other = &PLANS[i];
    }
    bench_plan plan = other ? *other : GENERAL;
    plan.scene = name;
    plan.size = size;
    plan.target = plan.limit_ms = 0;
    return plan;
}

bench_plan bench_plan_quick(bench_plan plan) {
    plan.warm_up = plan.warm_up < 10 ? plan.warm_up : 10;
    plan.steps = plan.steps < 40 ? plan.steps : 40;
    return plan;
}

const scene_info *bench_scene(const char *name) {
    const scene_info *own[] = {&bench_rubble,  &bench_overlapping,  &bench_chains,
                               &bench_bridges, &bench_ragdoll_heap, &bench_boxed_bridge};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++)
        if (strcmp(own[i]->name, name) == 0)
            return own[i];
    return scenes_find(name);
}
