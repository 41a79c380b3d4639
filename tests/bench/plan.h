/* plan.h: for each scene, how it is measured and the bounds that thud is held to. */
#ifndef THUD_BENCH_PLAN_H
#define THUD_BENCH_PLAN_H

#include "scenes.h"

#include <stdbool.h>

typedef struct bench_plan {
    const char *scene;
    int size;        /* 0: the scene's default */
    int warm_up;     /* untimed steps at the start */
    int steps;       /* timed steps */
    bool by_default; /* measured in a run that names no scene */
    bool sleeping;   /* false except in scenes about sleep */
    double target;   /* lower bound on Box2D's time divided by thud's; 0: no target */
    double limit_ms; /* upper bound on the time of each step of thud; 0: no limit */
    const char *why; /* reason for warm_up and steps */
} bench_plan;

int bench_plan_count(void);
bench_plan bench_plan_at(int index);

/* The plan of a scene at a size (0: its default). If there is none for that size, the plan of
 * another size without its target, or a general plan. */
bench_plan bench_plan_for(const char *name, int size);

/* The same plan with few steps: enough to test that everything runs, too few to compare times. */
bench_plan bench_plan_quick(bench_plan plan);

/* A scene by its name, from scenes_find or from this benchmark. Null if there is none. */
const scene_info *bench_scene(const char *name);

/* Scenes of this benchmark alone, in extra_scenes.c and joint_scenes.c. */
extern const scene_info bench_rubble, bench_overlapping, bench_chains, bench_bridges,
    bench_ragdoll_heap, bench_boxed_bridge;

#endif
