/* race.h: runs one scene in several engines in turns, and measures time, overlap, joint gaps and
 * memory of each in the same way. */
#ifndef THUD_BENCH_RACE_H
#define THUD_BENCH_RACE_H

#include "engine.h"
#include "joint_gaps.h"
#include "penetration.h"
#include "plan.h"
#include "series.h"

enum { RACE_MAX_ENGINES = 4 };

typedef struct race_settings {
    const physics_engine *const *engines; /* each of the others is compared with the first */
    int engine_count;                     /* 1 .. RACE_MAX_ENGINES */
    int repetitions;
} race_settings;

typedef struct race_entry {
    const char *engine;
    series_summary time; /* ms per step */
    penetration overlap;
    joint_gaps gaps;
    uint64_t bytes;
    /* The lowest and the highest ratio, over single repetitions, of this engine's median time to
     * that of the first engine. */
    double ratio_low, ratio_high;
} race_entry;

typedef struct race_result {
    const char *scene;
    int size, bodies, steps, entry_count;
    double target;   /* bound on Box2D's time over thud's; 0: none */
    double limit_ms; /* bound on thud's slowest step; 0: none */
    race_entry entries[RACE_MAX_ENGINES];
} race_result;

/* False, with a line on stderr, if an engine fails or memory runs out. `size` is the one that the
 * scene was filled with. */
bool race_run(const scene *s, int size, bench_plan plan, const race_settings *settings,
              race_result *out);

#endif
