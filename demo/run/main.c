/* main.c: the program thud-run, which loads a scene or a level, runs a number of steps without a
 * display, and prints what it measured. */
#define _POSIX_C_SOURCE 200809L

#include "act_thud.h"
#include "build_thud.h"
#include "choices.h"
#include "level.h"
#include "options.h"
#include "outcome.h"
#include "pool.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

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

/* Prints a level's problems, and how many more were only counted. */
static void print_report(const char *path, const level_report *report) {
    static const char *const WORDS[] = {"note", "unsupported", "error"};
    for (int i = 0; i < report->count; i++)
        fprintf(stderr, "%s: %s: %s\n", path, WORDS[report->problems[i].severity],
                report->problems[i].text);
    int more = report->notes + report->skipped + report->fatal - report->count;
    if (more > 0)
        fprintf(stderr, "%s: and %d more\n", path, more);
}

/* Loads a level into *s. False, and *s is empty, after messages on stderr. */
static bool load_level(const run_options *options, scene *s) {
    level_report report;
    bool loaded = level_read_file(options->source, options->skip_unsupported, s, &report);
    print_report(options->source, &report);
    if (!loaded && report.fatal == 0)
        fprintf(stderr,
                "thud-run: refused because of %d problems; --skip-unsupported leaves them "
                "out\n",
                report.skipped);
    level_report_free(&report);
    return loaded;
}

/* Loads the built-in scene or the level that the command line names. False after a message. A
 * source with a dot or a slash is a level's path; names of scenes have neither. */
static bool load(const run_options *options, scene *s) {
    const scene_info *info = scenes_find(options->source);
    bool is_path = strpbrk(options->source, "./") != NULL;
    if (!info && !is_path) {
        fprintf(stderr, "thud-run: no scene is called '%s'; --list shows them all\n",
                options->source);
        return false;
    }
    if (!info && options->size != 0) {
        fprintf(stderr, "thud-run: --size is for built-in scenes, not for levels\n");
        return false;
    }
    if (!info)
        return load_level(options, s);
    if (options->size != 0 && (options->size < info->min_size || options->size > info->max_size)) {
        fprintf(stderr, "thud-run: the size of %s is from %d to %d %s\n", info->name,
                info->min_size, info->max_size, info->size_means);
        return false;
    }
    if (!scenes_fill(info, options->size, s)) {
        fprintf(stderr, "thud-run: out of memory\n");
        return false;
    }
    return true;
}

/* Builds the scene's world with the systems that the options choose. Null after a message. */
static thud_world *build(const run_options *options, const scene *s, pool *threads) {
    thud_world_def def = thud_default_world_def();
    def.quality = QUALITIES[options->quality];
    def.detection = DETECTIONS[options->detection].detection;
    def.broadphase = BROADPHASES[options->broadphase].broadphase;
    def.cell_size = options->cell_size;
    def.sleeping = !options->no_sleeping;
    def.clock = seconds_now;
    def.log = log_to_stderr;
    def.job_system = pool_job_system(threads);
    thud_world *world;
    int failed_body;
    thud_result result = scene_build_thud(s, &def, &world, NULL, &failed_body);
    if (result == THUD_OK)
        return world;
    fprintf(stderr, "thud-run: %s cannot be built: %s", s->name, thud_result_text(result));
    if (failed_body >= 0)
        fprintf(stderr, " (body %d, object %u)", failed_body, s->bodies[failed_body].id);
    fputc('\n', stderr);
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
static bool run(thud_world *world, const scene *s, const run_options *options, run_outcome *o) {
    bool terminal = isatty(STDERR_FILENO);
    double start = seconds_now(NULL), last_shown = 0;
    *o = (run_outcome){0};
    while (o->steps < options->steps) {
        thud_result result = scene_step_thud(&s->fields, world);
        if (result != THUD_OK) {
            fprintf(stderr, "thud-run: step %ld failed: %s\n", o->steps + 1,
                    thud_result_text(result));
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
        if (terminal)
            show_progress(options, o->steps, start, &last_shown);
    }
    if (last_shown > 0)
        fprintf(stderr, "\r%30s\r", "");
    o->hash = thud_hash_of(world);
    return true;
}

/* Returns the exit status. */
static int load_and_run(const run_options *options) {
    scene s;
    if (!load(options, &s))
        return 1;
    run_outcome outcome;
    pool *threads = pool_create(options->workers);
    if (options->workers > 1 && !threads)
        fprintf(stderr, "thud-run: threads cannot be created; running on one thread\n");
    thud_world *world = build(options, &s, threads);
    bool done = world && run(world, &s, options, &outcome);
    if (done && options->json)
        done = run_print_json(&outcome, &s, options);
    else if (done)
        run_print_text(&outcome, &s, options);
    thud_world_destroy(world);
    pool_destroy(threads);
    scene_free(&s);
    return done ? 0 : 1;
}

int main(int count, char **arguments) {
    run_options options;
    if (!run_options_parse(count, arguments, &options))
        return 2;
    if (options.help)
        run_print_help();
    else if (options.list)
        run_print_list();
    else
        return load_and_run(&options);
    return 0;
}
