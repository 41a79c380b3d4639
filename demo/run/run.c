/* run.c: see run.h. */
#define _POSIX_C_SOURCE 200809L

#include "run.h"

#include "act_thud.h"
#include "build_thud.h"
#include "choices.h"
#include "passing.h"
#include "without.h"

#include <thud/thud_threads.h>

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

/* Last: the calls of this file are recorded, and those of a scene's step by CMakeLists.txt. */
#include <thud/thud_recorded.h>

/* A thud_clock_fn, in seconds. */
static double seconds_now(void *context) {
    (void)context;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void log_to_stderr(thud_result result, const char *message, void *context) {
    (void)result;
    (void)context;
    fprintf(stderr, "thud: %s\n", message);
}

/* Writes why a run failed to where the options say, or to stderr. */
static void fail(const run_options *options, const char *format, ...) {
    char text[RUN_FAILURE_MAX];
    va_list values;
    va_start(values, format);
    vsnprintf(options->failure ? options->failure : text, sizeof text, format, values);
    va_end(values);
    if (!options->failure)
        fprintf(stderr, "thud-run: %s\n", text);
}

/* Builds the scene's world with the systems that the options choose. Null after a message. */
static thud_world *build(const run_options *options, const scene *s, thud_threads *threads) {
    thud_world_def def = thud_default_world_def();
    def.quality = QUALITIES[options->quality];
    def.detection = DETECTIONS[options->detection].detection;
    def.broadphase = BROADPHASES[options->broadphase].broadphase;
    def.cell_size = (float)options->cell_size;
    def.substeps = options->substeps;
    def.time_step = 1 / options->rate;
    def.sleeping = !options->no_sleeping;
    def.clock = seconds_now;
    def.log = options->failure ? NULL : log_to_stderr;
    def.job_system = thud_job_system_of(threads);
    thud_quality quality;
    without_change_world(&def, &quality, options->without);
    thud_world *world;
    int failed_body;
    thud_result result = scene_build_thud(s, &def, &world, NULL, &failed_body);
    if (result == THUD_OK)
        return world;
    char where[64] = "";
    if (failed_body >= 0)
        snprintf(where, sizeof where, " (body %d, object %u)", failed_body,
                 s->bodies[failed_body].id);
    fail(options, "%.200s cannot be built: %s%s", s->name, thud_result_text(result), where);
    return NULL;
}

/* Prints a progress line on stderr four times a second once a run takes more than a second. `start`
 * and *last are times in seconds; *last is when the line was last printed. */
static void show_progress(const run_options *options, long step, double start, double *last) {
    double now = seconds_now(NULL);
    if (now - start > 1 && now - *last > 0.25) {
        fprintf(stderr, "\r%ld of %ld steps ", step, options->steps);
        fflush(stderr);
        *last = now;
    }
}

/* Raises each value of *worst to that of a step where that is larger. */
static void keep_worst(thud_step_error *worst, thud_step_error step, bool first) {
    worst->penetration_max = fmax(worst->penetration_max, step.penetration_max);
    worst->penetration_mean = fmax(worst->penetration_mean, step.penetration_mean);
    worst->residual = fmax(worst->residual, step.residual);
    worst->joint_gap_max = fmax(worst->joint_gap_max, step.joint_gap_max);
    worst->joint_angle_max = fmax(worst->joint_angle_max, step.joint_angle_max);
    if (first || step.energy_change > worst->energy_change)
        worst->energy_change = step.energy_change;
    if (step.overlaps > worst->overlaps)
        worst->overlaps = step.overlaps;
}

/* Steps the world and fills *o. False after a message, if a step fails. */
static bool step_all(thud_world *world, const scene *s, const run_options *options,
                     const run_watch *watch, passing *passed, run_outcome *o) {
    bool terminal = !options->failure && isatty(STDERR_FILENO);
    double start = seconds_now(NULL), last_shown = 0;
    *o = (run_outcome){0};
    while (o->steps < options->steps) {
        thud_result result = passing_before(passed, world);
        if (result == THUD_OK)
            result = scene_step_thud(&s->fields, world);
        if (result == THUD_OK)
            result = passing_after(passed, world, &o->passed);
        if (result != THUD_OK) {
            fail(options, "step %ld failed: %s", o->steps + 1, thud_result_text(result));
            return false;
        }
        o->steps++;
        o->stats = thud_stats_of(world);
        o->seconds += o->stats.step_seconds;
        if (o->stats.step_seconds > o->worst_seconds)
            o->worst_seconds = o->stats.step_seconds;
        for (int i = 0; i < THUD_STAGE_COUNT; i++)
            o->stage_seconds[i] += o->stats.stage_seconds[i];
        keep_worst(&o->worst, thud_step_error_of(world), o->steps == 1);
        o->quarantined += thud_events_of(world).quarantined_count;
        o->measure = thud_measure_of(world);
        if (o->measure.penetration_max > o->penetration_max)
            o->penetration_max = o->measure.penetration_max;
        if (watch && !watch->stepped(world, o, watch->context))
            return false;
        if (terminal)
            show_progress(options, o->steps, start, &last_shown);
    }
    if (last_shown > 0)
        fprintf(stderr, "\r%30s\r", "");
    o->hash = thud_hash_of(world);
    return true;
}

bool run_scene(const run_options *options, const scene *s, const run_watch *watch,
               run_outcome *out) {
    thud_threads *threads = NULL;
    if (options->workers > 1 && thud_threads_create(options->workers, NULL, &threads) != THUD_OK)
        fprintf(stderr, "thud-run: threads cannot be created; running on one thread\n");
    passing passed = {0};
    thud_world *world = build(options, s, threads);
    bool done = world && (!watch || !watch->built || watch->built(world, watch->context)) &&
                step_all(world, s, options, watch, &passed, out);
    passing_free(&passed);
    thud_world_destroy(world);
    thud_threads_destroy(threads);
    return done;
}
