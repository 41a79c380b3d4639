/* race.c: see race.h. The worlds of all engines exist at the same time and are stepped in turns, so
 * that load of other processes affects all alike. Each repetition begins with new worlds. */
#include "race.h"

#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* Steps of a turn: many enough that most of them find their data in the cache, and few enough that
 * the machine's speed does not change within a round. Chosen. */
enum { TURN = 8 };

/* Samples of overlap and of joint gaps in a run, taken between turns. */
enum { SAMPLES = 32 };

typedef struct race {
    const scene *scene;
    bench_plan plan;
    const race_settings *settings;
    void *worlds[RACE_MAX_ENGINES];
    series times[RACE_MAX_ENGINES];
    penetration overlap[RACE_MAX_ENGINES];
    joint_gaps gaps[RACE_MAX_ENGINES];
    uint64_t bytes[RACE_MAX_ENGINES];
    penetration_meter *meter;
    engine_body *bodies;
} race;

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static bool report(const race *r, int engine, const char *what) {
    fprintf(stderr, "thud-bench: %s: %s %s\n", r->scene->name, r->settings->engines[engine]->name,
            what);
    return false;
}

static bool warm_up(race *r, int engine) {
    const physics_engine *e = r->settings->engines[engine];
    for (int i = 0; i < r->plan.warm_up; i++)
        if (!e->step(r->worlds[engine]))
            return report(r, engine, "failed to step");
    return true;
}

static bool take_turn(race *r, int engine, int repetition, int first, int count) {
    const physics_engine *e = r->settings->engines[engine];
    double *ms = r->times[engine].ms + repetition * r->plan.steps + first;
    for (int i = 0; i < count; i++) {
        double start = now_ms();
        bool ok = e->step(r->worlds[engine]);
        ms[i] = now_ms() - start;
        if (!ok)
            return report(r, engine, "failed to step");
    }
    return true;
}

static void sample_errors(race *r) {
    for (int e = 0; e < r->settings->engine_count; e++) {
        r->settings->engines[e]->read(r->worlds[e], r->bodies);
        penetration_sample(r->meter, r->bodies, &r->overlap[e]);
        joint_gaps_sample(r->scene, r->bodies, &r->gaps[e]);
    }
}

static bool take_all_turns(race *r, int repetition) {
    int engines = r->settings->engine_count;
    int sample_every = r->plan.steps / (SAMPLES * TURN) * TURN;
    sample_every = sample_every < TURN ? TURN : sample_every;
    for (int first = 0, turn = 0; first < r->plan.steps; first += TURN, turn++) {
        int count = r->plan.steps - first < TURN ? r->plan.steps - first : TURN;
        /* The engine that goes first in a round, after sampling has filled the cache, changes each
         * time. */
        for (int i = 0; i < engines; i++)
            if (!take_turn(r, (turn + repetition + i) % engines, repetition, first, count))
                return false;
        /* All repetitions have the same motion, so errors are sampled in the first only. */
        if (repetition == 0 && (first + TURN) % sample_every == 0)
            sample_errors(r);
        double done = (double)(first + count) / r->plan.steps;
        progress_show(r->scene->name, (repetition + done) / r->settings->repetitions);
    }
    return true;
}

static void destroy_worlds(race *r) {
    for (int e = 0; e < r->settings->engine_count; e++) {
        r->settings->engines[e]->destroy(r->worlds[e]);
        r->worlds[e] = NULL;
    }
}

static bool repeat_once(race *r, int repetition) {
    engine_settings world_settings = {.sleeping = r->plan.sleeping};
    bool ok = true;
    for (int e = 0; ok && e < r->settings->engine_count; e++) {
        r->worlds[e] = engine_create(r->settings->engines[e], r->scene, world_settings);
        ok = r->worlds[e] && warm_up(r, e);
    }
    ok = ok && take_all_turns(r, repetition);
    for (int e = 0; ok && e < r->settings->engine_count; e++)
        r->bytes[e] = r->settings->engines[e]->bytes(r->worlds[e]);
    destroy_worlds(r);
    return ok;
}

static void conclude(const race *r, int size, race_result *out) {
    *out = (race_result){
        .scene = r->scene->name,
        .size = size,
        .bodies = r->scene->body_count,
        .steps = r->plan.steps,
        .target = r->plan.target,
        .limit_ms = r->plan.limit_ms,
        .entry_count = r->settings->engine_count,
    };
    for (int e = 0; e < out->entry_count; e++) {
        race_entry *entry = &out->entries[e];
        *entry = (race_entry){
            .engine = r->settings->engines[e]->name,
            .time = series_summarize(&r->times[e]),
            .overlap = r->overlap[e],
            .gaps = r->gaps[e],
            .bytes = r->bytes[e],
        };
        for (int i = 0; i < r->settings->repetitions; i++) {
            double ratio = series_median_of(&r->times[e], i) / series_median_of(&r->times[0], i);
            if (i == 0 || ratio < entry->ratio_low)
                entry->ratio_low = ratio;
            if (i == 0 || ratio > entry->ratio_high)
                entry->ratio_high = ratio;
        }
    }
}

bool race_run(const scene *s, int size, bench_plan plan, const race_settings *settings,
              race_result *out) {
    race r = {.scene = s, .plan = plan, .settings = settings};
    r.meter = penetration_meter_create(s);
    r.bodies = calloc((size_t)s->body_count + 1, sizeof *r.bodies);
    bool ok = r.meter && r.bodies;
    for (int e = 0; ok && e < settings->engine_count; e++)
        ok = series_init(&r.times[e], plan.steps, settings->repetitions);
    if (!ok)
        fprintf(stderr, "thud-bench: %s: out of memory\n", s->name);
    for (int i = 0; ok && i < settings->repetitions; i++)
        ok = repeat_once(&r, i);
    progress_clear();
    if (ok)
        conclude(&r, size, out);
    for (int e = 0; e < settings->engine_count; e++)
        series_free(&r.times[e]);
    penetration_meter_destroy(r.meter);
    free(r.bodies);
    return ok;
}
