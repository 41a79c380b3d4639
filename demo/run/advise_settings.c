/* advise_settings.c: see advise_settings.h. Each setting runs once. Those that are accurate enough
 * and may be the cheapest run again, in turns, so that other load of the machine affects them
 * alike. The broadphase changes no bit of a run, so that its choices are tried at the setting that
 * is the cheapest so far, and only there. */
#define _POSIX_C_SOURCE 200809L

#include "advise_settings.h"

#include "choices.h"
#include "run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <thud/thud_lists.h>
#include <unistd.h>

/* Shapes up to which each is tried against each: beyond, a step takes as long as many others. */
enum { ALL_PAIRS_MAX = 2000 };

/* A setting that takes more than this times what the cheapest one takes is not timed again. */
static const double CONTENDER = 2;

void advise_progress(const char *doing, int done, int all) {
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%-34s %3d of %d \r", doing, done, all);
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* What a run is watched for. */
typedef struct keeping {
    advise_setting *setting;
    const scene *scene;
    thud_body_id *bodies; /* of the scene */
} keeping;

/* A run_watch: a new world gives the scene's bodies the first slots, in their order. */
static bool keep_bodies(thud_world *world, void *context) {
    const keeping *k = context;
    for (int i = 0; i < k->scene->body_count; i++)
        if (thud_world_get_body_at(world, i, &k->bodies[i]) != THUD_OK)
            k->bodies[i] = (thud_body_id){0};
    return true;
}

static void keep_ends(const keeping *k, const thud_world *world) {
    for (int i = 0; i < k->scene->body_count; i++) {
        thud_body_state body;
        bool exists = thud_body_get_state(world, k->bodies[i], &body) == THUD_OK;
        k->setting->ends[i] = exists ? body.center : (thud_pos){NAN, NAN};
    }
}

/* A run_watch: keeps the shortest time of each step, and where the bodies end. */
static bool keep(thud_world *world, const run_outcome *so_far, void *context) {
    const keeping *k = context;
    advise_setting *setting = k->setting;
    double *ms = &setting->step_ms[so_far->steps - 1], now = 1000 * so_far->stats.step_seconds;
    *ms = setting->runs > 0 ? fmin(*ms, now) : now;
    if (so_far->steps == setting->how.steps && setting->runs == 0)
        keep_ends(k, world);
    return true;
}

/* Works out the setting's times from those of its steps. False if memory runs out. */
static bool sum_up(advise_setting *setting) {
    size_t count = (size_t)setting->how.steps;
    double *sorted = malloc(count * sizeof *sorted), sum = 0;
    if (!sorted)
        return false;
    for (size_t i = 0; i < count; i++) {
        sorted[i] = setting->step_ms[i];
        sum += sorted[i];
    }
    qsort(sorted, count, sizeof *sorted, compare);
    setting->ms = sum / (double)count;
    setting->ms_max = sorted[count - 1];
    setting->ms_median = sorted[count / 2];
    free(sorted);
    return true;
}

static bool out_of_memory(void) {
    fprintf(stderr, "thud-run: out of memory\n");
    return false;
}

bool advise_run(advise_setting *setting, const scene *s) {
    run_outcome outcome;
    keeping kept = {setting, s, NULL};
    run_watch watch = {.built = keep_bodies, .stepped = keep, .context = &kept};
    if (!setting->step_ms)
        setting->step_ms = malloc((size_t)setting->how.steps * sizeof *setting->step_ms);
    if (!setting->ends)
        setting->ends = malloc(((size_t)s->body_count + 1) * sizeof *setting->ends);
    kept.bodies = malloc(((size_t)s->body_count + 1) * sizeof *kept.bodies);
    if (!setting->step_ms || !setting->ends || !kept.bodies) {
        free(kept.bodies);
        return out_of_memory();
    }
    bool done = run_scene(&setting->how, s, &watch, &outcome);
    free(kept.bodies);
    if (!done)
        return false;
    if (setting->runs == 0) {
        setting->outcome = outcome;
        setting->error = run_error_of(&outcome, s);
    } else if (outcome.hash != setting->outcome.hash) {
        fprintf(stderr, "thud-run: two runs of one setting differ; no advice can be given\n");
        return false;
    }
    setting->runs++;
    return sum_up(setting) || out_of_memory();
}

void advise_setting_free(advise_setting *setting) {
    free(setting->step_ms);
    free(setting->ends);
    setting->ends = NULL;
    setting->step_ms = NULL;
}

void advise_series_free(advise_series *series) {
    for (int i = 0; i < series->count; i++)
        advise_setting_free(&series->settings[i]);
}

static bool is_accurate(const advise_setting *setting) {
    return setting->error <= setting->how.max_error;
}

bool advise_meets(const advise_setting *setting) {
    return is_accurate(setting) && setting->ms <= setting->how.budget;
}

static bool same(const run_options *a, const run_options *b) {
    return a->quality == b->quality && a->detection == b->detection &&
           a->broadphase == b->broadphase && a->substeps == b->substeps;
}

/* Adds a setting, unless it is there; returns its index. */
static int add(advise_series *out, run_options how) {
    for (int i = 0; i < out->count; i++)
        if (same(&out->settings[i].how, &how))
            return i;
    out->settings[out->count] = (advise_setting){.how = how};
    return out->count++;
}

/* The settings: each quality with each detection, and quality draft, which has no island solver,
 * with more substeps; after the one that the command line names. */
static void list_settings(const run_options *options, advise_series *out) {
    static const int SUBSTEPS[] = {4, 8, 16};
    run_options how = *options;
    out->now = add(out, how);
    for (how.quality = 0; how.quality < QUALITY_CHOICES; how.quality++)
        for (how.detection = 0; how.detection < DETECTION_CHOICES; how.detection++) {
            how.substeps = 0;
            bool own = how.detection > 0 &&
                       DETECTIONS[how.detection].detection == QUALITIES[how.quality]->detection;
            if (!own)
                add(out, how);
            bool soft = how.quality == 0 &&
                        (how.detection == DETECTION_DEFAULT ||
                         DETECTIONS[how.detection].detection == &thud_detection_overlap);
            for (size_t i = 0; soft && i < sizeof SUBSTEPS / sizeof SUBSTEPS[0]; i++) {
                how.substeps = SUBSTEPS[i];
                add(out, how);
            }
        }
}

/* Finds the advised setting and the nearest one. Of settings that take as long as the cheapest, the
 * most accurate is advised, and of those that are equal the first of the list. */
static void choose(advise_series *out) {
    double cheapest = INFINITY;
    for (int i = 0; i < out->count; i++)
        if (advise_meets(&out->settings[i]))
            cheapest = fmin(cheapest, out->settings[i].ms);
    out->advised = out->nearest = -1;
    for (int i = 0; i < out->count; i++) {
        const advise_setting *s = &out->settings[i];
        const advise_setting *best = out->advised < 0 ? NULL : &out->settings[out->advised];
        const advise_setting *near = out->nearest < 0 ? NULL : &out->settings[out->nearest];
        if (advise_meets(s) && s->ms <= ADVISE_EQUAL * cheapest &&
            (!best || s->error < best->error))
            out->advised = i;
        bool fits = s->ms <= s->how.budget, near_fits = near && near->ms <= near->how.budget;
        bool better = near && (s->error < near->error ||
                               (s->error == near->error && s->ms * ADVISE_EQUAL < near->ms));
        if (!near || fits > near_fits || (fits == near_fits && better))
            out->nearest = i;
    }
}

/* Whether a setting may turn out to be the cheapest. Load of the machine may slow a few steps so
 * much that the mean says nothing, but not half of them. */
static bool contends(const advise_series *out, int index) {
    double mean = INFINITY, median = INFINITY;
    for (int i = 0; i < out->count; i++)
        if (is_accurate(&out->settings[i])) {
            mean = fmin(mean, out->settings[i].ms);
            median = fmin(median, out->settings[i].ms_median);
        }
    const advise_setting *s = &out->settings[index];
    return index == out->now ||
           (is_accurate(s) && (s->ms <= CONTENDER * mean || s->ms_median <= CONTENDER * median));
}

/* Runs the settings that may be the cheapest until each has made `repeats` runs. */
static bool repeat(advise_series *out, const scene *s, int repeats) {
    for (int round = 1; round < repeats; round++)
        for (int k = 0; k < out->count; k++) {
            int i = round % 2 ? out->count - 1 - k : k;
            advise_progress("timing settings", round + 1, repeats);
            if (out->settings[i].runs < repeats && contends(out, i) &&
                !advise_run(&out->settings[i], s))
                return false;
        }
    return true;
}

bool advise_measure(const run_options *options, const scene *s, advise_series *out) {
    *out = (advise_series){.advised = -1, .nearest = -1};
    list_settings(options, out);
    for (int i = 0; i < out->count; i++) {
        advise_progress("trying settings", i + 1, out->count);
        if (!advise_run(&out->settings[i], s))
            return false;
    }
    if (!repeat(out, s, options->repeats))
        return false;
    choose(out);
    int first = out->count;
    run_options how = out->settings[out->advised >= 0 ? out->advised : out->nearest].how;
    for (how.broadphase = 0; how.broadphase < BROADPHASE_CHOICES; how.broadphase++)
        if (BROADPHASES[how.broadphase].broadphase != &thud_broadphase_all ||
            s->shape_count <= ALL_PAIRS_MAX)
            add(out, how);
    for (int i = first; i < out->count; i++)
        if (!advise_run(&out->settings[i], s))
            return false;
    if (!repeat(out, s, options->repeats))
        return false;
    choose(out);
    return true;
}
