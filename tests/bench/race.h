/* race.h: runs one scene in several engines at once and measures all of them alike. */
#ifndef THUD_BENCH_RACE_H
#define THUD_BENCH_RACE_H

#include "engine.h"
#include "joint_gaps.h"
#include "penetration.h"
#include "plan.h"
#include "series.h"

enum { RACE_MAX_ENGINES = 4 };

typedef struct race_settings {
    const physics_engine *const *engines; /* the first is compared with every other */
    int engine_count;                     /* 1 .. RACE_MAX_ENGINES */
    int repetitions;
} race_settings;

typedef struct race_entry {
    const char *engine;
    series_summary time; /* ms per step */
    penetration overlap;
    joint_gaps gaps;
    uint64_t bytes;
    /* Time of this engine over the first one's: the lowest and the highest ratio of medians that
     * a single repetition gave. */
    double ratio_low, ratio_high;
} race_entry;

typedef struct race_result {
    const char *scene;
    int size, bodies, steps, entry_count;
    double target;   /* against Box2D; 0: none */
    double limit_ms; /* on thud's worst step; 0: none */
    race_entry entries[RACE_MAX_ENGINES];
} race_result;

/* False, and a line on stderr, when an engine or memory fails. `size` is the scene's. */
bool race_run(const scene *s, int size, bench_plan plan, const race_settings *settings,
              race_result *out);

#endif
