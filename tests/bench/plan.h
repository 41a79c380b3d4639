/* plan.h: how each scene is measured: which steps, and why those. */
#ifndef THUD_BENCH_PLAN_H
#define THUD_BENCH_PLAN_H

#include <stdbool.h>

typedef struct bench_plan {
    const char *scene;
    int warm_up;     /* steps before the clock starts */
    int steps;       /* timed steps */
    bool by_default; /* part of a run that names no scene */
    bool sleeping;   /* off wherever sleep itself is not the subject */
    const char *why; /* these steps */
} bench_plan;

/* The plan of a scene; one that has none of its own gets the general plan. */
bench_plan bench_plan_for(const char *scene);

/* The same, cut short: enough to see that everything runs, too little to compare. */
bench_plan bench_plan_quick(bench_plan plan);

#endif
