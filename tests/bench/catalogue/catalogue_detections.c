/* catalogue_detections.c: runs the same scenes with each of the four kinds of detection, a step of
 * each world in turn, and measures the time of a step, the overlap (by geometry independent of the
 * engine), the energy, bodies that were held, and the number of pairs after each test of motions.
 * The time of a step is the minimum of several repetitions. Worlds are deterministic, so everything
 * else is measured in the first repetition only. */
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"
#include "lab/lab_turns.h"
#include "penetration.h"
#include "progress.h"
#include "scenes.h"
#include "series.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_STEPS = 600, QUICK_STEPS = 8, REPETITIONS = 3 };

static const struct {
    const char *scene;
    int size, quick_size, steps;
} SCENES[] = {
    {"gas", 1000, 50, 600}, /* 600 steps are 10 s, to see a drift of energy */
    {"bullets", 60, 15, 300},
    {"circle_pit", 1000, 100, 600},
    {"smash", 960, 60, 300},
};

/* The results of one detection in a scene. */
typedef struct outcome {
    double seconds[MOST_STEPS];
    penetration overlap;
    double energy_before, energy_after;
    long impacts, held, unbisectable;
    double held_seconds;
    long motion_pairs, motion_circles, motion_boxes, motion_exact;
} outcome;

typedef struct trial {
    const char *name;
    scene scene;
    way_world worlds[WAY_COUNT];
    outcome outcomes[WAY_COUNT];
    penetration_meter *meter;
    engine_body *poses;
    int steps, repetitions;
} trial;

static double kinetic_energy(way_world *w) {
    return thud_measure_of(w->world).kinetic_energy;
}

static bool prepare(trial *t) {
    t->meter = penetration_meter_create(&t->scene);
    t->poses = calloc((size_t)t->scene.body_count, sizeof *t->poses);
    if (!t->meter || !t->poses)
        fprintf(stderr, "thud-catalogue: out of memory for scene %s\n", t->name);
    return t->meter && t->poses;
}

static bool open_worlds(trial *t) {
    bool ok = true;
    for (int k = 0; ok && k < WAY_COUNT; k++)
        ok = way_open(&t->worlds[k], &t->scene, way_at(k), ENGINE_TIME_STEP);
    return ok;
}

static void close_worlds(trial *t) {
    for (int k = 0; k < WAY_COUNT; k++)
        way_close(&t->worlds[k]);
}

/* Adds the counts of a step. */
static void count_up(outcome *o, const thud_stats *stats) {
    o->impacts += stats->impacts;
    o->held += stats->held_bodies;
    o->held_seconds += stats->held_seconds;
    o->unbisectable += stats->unbisectable;
    o->motion_pairs += stats->motion_pairs;
    o->motion_circles += stats->motion_circles;
    o->motion_boxes += stats->motion_boxes;
    o->motion_exact += stats->motion_exact;
}

static void measure_overlap(trial *t, const way_world *w, penetration *seen) {
    for (int i = 0; i < w->count; i++) {
        thud_body_state body;
        bool known = thud_body_get_state(w->world, w->bodies[i], &body) == THUD_OK;
        t->poses[i] = known ? (engine_body){.x = body.position.x,
                                            .y = body.position.y,
                                            .cosine = body.cosine,
                                            .sine = body.sine}
                            : (engine_body){.x = NAN, .y = NAN};
    }
    penetration_sample(t->meter, t->poses, seen);
}

/* Runs one repetition with all detections in turn, step by step; false if a step failed. */
static bool run_once(trial *t, int repetition) {
    for (int k = 0; repetition == 0 && k < WAY_COUNT; k++)
        t->outcomes[k].energy_before = kinetic_energy(&t->worlds[k]);
    for (int i = 0; i < t->steps; i++) {
        progress_show(t->name, (repetition + (double)i / t->steps) / t->repetitions);
        for (int k = 0; k < WAY_COUNT; k++) {
            way_world *w = &t->worlds[k];
            outcome *o = &t->outcomes[k];
            double start = processor_seconds();
            if (!way_step(w))
                return false;
            double seconds = processor_seconds() - start;
            /* The first step allocates the world's memory and is not timed. */
            if (i > 0)
                o->seconds[i - 1] = repetition == 0 ? seconds : fmin(seconds, o->seconds[i - 1]);
            if (repetition > 0)
                continue;
            thud_stats stats = thud_stats_of(w->world);
            count_up(o, &stats);
            measure_overlap(t, w, &o->overlap);
        }
    }
    for (int k = 0; repetition == 0 && k < WAY_COUNT; k++)
        t->outcomes[k].energy_after = kinetic_energy(&t->worlds[k]);
    return true;
}

static bool run_trial(trial *t) {
    bool ok = true;
    for (int i = 0; ok && i < t->repetitions; i++) {
        ok = open_worlds(t) && run_once(t, i);
        close_worlds(t);
    }
    progress_clear();
    return ok;
}

static void report(trial *t, int way, json *out) {
    outcome *o = &t->outcomes[way];
    int timed = t->steps - 1;
    double mean = lab_turns_mean(o->seconds, timed);
    double kept = o->energy_before > 0 ? o->energy_after / o->energy_before : NAN;
    double median = series_median(o->seconds, timed); /* sorts the array */
    printf("%-11s %-10s %8.4f %8.4f %8.3f %9.2f %8.4f %8ld %7ld %9.4f %7ld\n", t->name,
           thud_detection_name(way_at(way)), median * 1e3, mean * 1e3, o->seconds[timed - 1] * 1e3,
           o->overlap.worst * 1e3, kept, o->impacts, o->held, o->held_seconds, o->unbisectable);
    json_begin_object(out, thud_detection_name(way_at(way)));
    json_number(out, "ms_median", median * 1e3);
    json_number(out, "ms_mean", mean * 1e3);
    json_number(out, "ms_max", o->seconds[timed - 1] * 1e3);
    json_number(out, "overlap_max", o->overlap.worst);
    json_number(out, "overlap_mean", penetration_mean(&o->overlap));
    json_number(out, "energy_kept", kept);
    json_number(out, "impacts", (double)o->impacts);
    json_number(out, "held_bodies", (double)o->held);
    json_number(out, "held_seconds", o->held_seconds);
    json_number(out, "unbisectable", (double)o->unbisectable);
    json_number(out, "motion_pairs", (double)o->motion_pairs);
    json_number(out, "motion_circles", (double)o->motion_circles);
    json_number(out, "motion_boxes", (double)o->motion_boxes);
    json_number(out, "motion_exact", (double)o->motion_exact);
    json_end(out);
}

static bool try_scene(trial *t, int index, bool quick, json *out) {
    t->name = SCENES[index].scene;
    t->steps = quick ? QUICK_STEPS : SCENES[index].steps;
    int size = quick ? SCENES[index].quick_size : SCENES[index].size;
    t->repetitions = quick ? 1 : REPETITIONS;
    bool ok = scenes_fill(scenes_find(t->name), size, &t->scene) && prepare(t) && run_trial(t);
    if (ok) {
        json_begin_object(out, NULL);
        json_text(out, "scene", t->name);
        json_number(out, "size", size);
        json_number(out, "steps", t->steps);
        json_begin_object(out, "ways");
        for (int k = 0; k < WAY_COUNT; k++)
            report(t, k, out);
        json_end(out);
        json_end(out);
    }
    penetration_meter_destroy(t->meter);
    free(t->poses);
    scene_free(&t->scene);
    fflush(stdout);
    return ok;
}

bool catalogue_detections(bool quick, json *out) {
    bool ok = true;
    printf("%-11s %-10s %8s %8s %8s %9s %8s %8s %7s %9s %7s\n", "scene", "detection", "ms", "mean",
           "worst", "overlap", "energy", "impacts", "held", "seconds", "unsafe");
    json_begin_array(out, "detections");
    for (size_t i = 0; ok && i < sizeof SCENES / sizeof SCENES[0]; i++) {
        trial *t = calloc(1, sizeof *t);
        ok = t && try_scene(t, (int)i, quick, out);
        free(t);
    }
    json_end(out);
    return ok;
}
