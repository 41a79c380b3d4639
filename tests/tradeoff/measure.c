/* measure.c: see measure.h. Each setting runs once with its errors measured after every step. Then
 * all settings run together and are timed, without measuring errors: their worlds take turns of a
 * few steps, so that load of other processes affects all alike. Engines are deterministic, so that
 * a step is the same work in each repetition, and the minimum of its times is the best estimate. */
#include "measure.h"

#include "series.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { TURN = 8 };

typedef struct run {
    const tradeoff_case *c;
    const measure_plan *plan;
    scene scene;
    int steps;
    engine_body *bodies;
    void *worlds[SETTINGS_MAX];
    series times[SETTINGS_MAX];
    int used[SETTINGS_MAX], count; /* indices of the settings that run the case, and their number */
    double done, all;              /* steps of all worlds, for the progress */
} run;

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

/* Reports progress by `steps` further steps. */
static void tell(run *r, int steps) {
    r->done += steps;
    if (r->plan->progress)
        r->plan->progress(r->c->name, r->done / r->all);
}

static bool fail(const run *r, int which, const char *what) {
    const setting *how = &SETTINGS[which];
    fprintf(stderr, "thud-tradeoff: %s: %s, %s: %s\n", r->c->name, how->engine->name, how->name,
            what);
    return false;
}

static bool open_world(run *r, int which) {
    const setting *how = &SETTINGS[which];
    r->worlds[which] = engine_create(how->engine, &r->scene, how->with);
    return r->worlds[which] || fail(r, which, "no world");
}

static void close_worlds(run *r) {
    for (int i = 0; i < SETTING_COUNT; i++) {
        SETTINGS[i].engine->destroy(r->worlds[i]);
        r->worlds[i] = NULL;
    }
}

/* Runs a setting once, and measures its errors after each step. */
static bool look_at(run *r, int which, yardstick *y) {
    const physics_engine *engine = SETTINGS[which].engine;
    if (!open_world(r, which))
        return false;
    engine->read(r->worlds[which], r->bodies);
    if (!yardstick_begin(y, r->bodies))
        return fail(r, which, "out of memory");
    for (int step = 1; step <= r->steps; step++) {
        if (!engine->step(r->worlds[which]))
            return fail(r, which, "a step failed");
        engine->read(r->worlds[which], r->bodies);
        if (!yardstick_look(y, r->bodies, step * ENGINE_TIME_STEP))
            return fail(r, which, "out of memory");
        if (step % TURN == 0)
            tell(r, TURN);
    }
    return true;
}

/* The errors of one setting. */
static bool take_errors(run *r, int which, errors *out) {
    yardstick *y = yardstick_create(r->c, &r->scene);
    bool ok = y ? look_at(r, which, y) : fail(r, which, "out of memory");
    if (ok)
        *out = yardstick_conclude(y);
    close_worlds(r);
    yardstick_destroy(y);
    return ok;
}

/* Times `count` steps of a setting. */
static bool take_turn(run *r, int which, double *ms, int count) {
    const physics_engine *engine = SETTINGS[which].engine;
    for (int i = 0; i < count; i++) {
        double start = now_ms();
        bool ok = engine->step(r->worlds[which]);
        ms[i] = now_ms() - start;
        if (!ok)
            return fail(r, which, "a step failed");
    }
    tell(r, count);
    return true;
}

static bool repeat_once(run *r, int repetition) {
    bool ok = true;
    for (int i = 0; ok && i < r->count; i++)
        ok = open_world(r, r->used[i]);
    for (int first = 0; ok && first < r->steps; first += TURN) {
        int count = r->steps - first < TURN ? r->steps - first : TURN;
        /* The setting that goes first changes each time. */
        for (int i = 0; ok && i < r->count; i++) {
            int which = r->used[(first / TURN + repetition + i) % r->count];
            ok = take_turn(r, which, r->times[which].ms + repetition * r->steps + first, count);
        }
    }
    close_worlds(r);
    return ok;
}

/* Median, mean and sum of the step times, ms; mean and sum use each step's minimum over
 * repetitions. */
static cost cost_of(const series *times) {
    cost c = {.median = series_summarize(times).median};
    for (int step = 0; step < times->steps; step++) {
        double least = times->ms[step];
        for (int i = 1; i < times->repetitions; i++)
            least = times->ms[i * times->steps + step] < least ? times->ms[i * times->steps + step]
                                                               : least;
        c.total += least;
    }
    c.mean = c.total / times->steps;
    return c;
}

static bool take_all(run *r, measurement *out) {
    int repetitions = r->plan->repetitions;
    for (int i = 0; i < SETTING_COUNT; i++)
        if (setting_goes_through(&SETTINGS[i], &r->scene))
            r->used[r->count++] = i;
    r->all = (double)r->count * r->steps * (1 + repetitions);
    *out = (measurement){.c = r->c,
                         .bodies = r->scene.body_count,
                         .steps = r->steps,
                         .repetitions = repetitions,
                         .point_count = r->count};
    r->bodies = calloc((size_t)r->scene.body_count + 1, sizeof *r->bodies);
    bool ok = r->bodies != NULL;
    for (int i = 0; ok && i < r->count; i++)
        ok = series_init(&r->times[r->used[i]], r->steps, repetitions);
    if (!ok)
        fprintf(stderr, "thud-tradeoff: %s: out of memory\n", r->c->name);
    for (int i = 0; ok && i < r->count; i++)
        ok = take_errors(r, r->used[i], &out->points[i].errors);
    for (int i = 0; ok && i < repetitions; i++)
        ok = repeat_once(r, i);
    for (int i = 0; ok && i < r->count; i++) {
        out->points[i].how = &SETTINGS[r->used[i]];
        out->points[i].cost = cost_of(&r->times[r->used[i]]);
    }
    for (int i = 0; i < SETTING_COUNT; i++)
        series_free(&r->times[i]);
    free(r->bodies);
    return ok;
}

bool measure_case(const tradeoff_case *c, const measure_plan *plan, measurement *out) {
    run r = {.c = c, .plan = plan, .steps = plan->quick ? c->quick_steps : c->steps};
    if (!case_fill(c, plan->quick, &r.scene))
        return false;
    bool ok = take_all(&r, out);
    scene_free(&r.scene);
    return ok;
}
