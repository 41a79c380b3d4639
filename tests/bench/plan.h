/* plan.h: what is measured, how, and what thud is held to. */
#ifndef THUD_BENCH_PLAN_H
#define THUD_BENCH_PLAN_H

#include "scenes.h"

#include <stdbool.h>

typedef struct bench_plan {
    const char *scene;
    int size;        /* 0: the scene's own */
    int warm_up;     /* steps before the clock starts */
    int steps;       /* timed steps */
    bool by_default; /* part of a run that names no scene */
    bool sleeping;   /* off wherever sleep itself is not the subject */
    double target;   /* how many times as fast as Box2D thud is to be, at least; 0: no target */
    double limit_ms; /* no step of thud's may take longer; 0: no limit */
    const char *why; /* these steps */
} bench_plan;

int bench_plan_count(void);
bench_plan bench_plan_at(int index);

/* The plan of a scene at a size (0: its own); one that has none gets that of another size of the
 * scene without its target, or the general plan. */
bench_plan bench_plan_for(const char *name, int size);

/* The same, cut short: enough to see that everything runs, too little to compare. */
bench_plan bench_plan_quick(bench_plan plan);

/* A scene by its name: a built-in one or one of the benchmark's own. Null if there is none. */
const scene_info *bench_scene(const char *name);

/* The benchmark's own, in extra_scenes.c and joint_scenes.c. */
extern const scene_info bench_rubble, bench_overlapping, bench_chains, bench_bridges, bench_heap,
    bench_boxed_bridge;

#endif
