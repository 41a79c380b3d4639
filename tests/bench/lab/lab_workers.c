/* lab_workers.c: the gain of a second thread: times the same world with one worker and with two. */
#include "lab/lab.h"

#include "lab/lab_pair.h"
#include "plan.h"

#include <thud/thud_threads.h>

#include <stdio.h>

enum { WORKERS = 2 };

/* The scenes, with what a second thread shall bring at least: what is asked for where much can be
 * shared, and elsewhere that it costs next to nothing. */
static const struct {
    const char *name;
    int size; /* 0: the scene's default */
    double least;
} SCENES[] = {
    {"pyramid", 0, 1.8},       {"circle_pit", 0, 1.8}, {"smash", 0, 1.8},
    {"gas", 16000, 1.8},       {"tumbler", 0, 1.8},    {"mixed_terrain", 0, 0.95},
    {"platformer", 0, 0.95},   {"sizes", 0, 0.95},     {"ragdolls", 200, 0.95},
    {"joint_grid", 100, 0.95},
};
enum { SCENE_COUNT = sizeof SCENES / sizeof SCENES[0] };

static thud_threads *threads; /* of the world with two workers */
static int current;           /* the scene that is measured */

/* Fills a scene (a lab_pair's), `with` a second worker. */
static void fill(bool with, scene *s, thud_world_def *def) {
    scene filled;
    if (!scenes_fill(bench_scene(SCENES[current].name), SCENES[current].size, &filled)) {
        s->failed = true;
        return;
    }
    scene_free(s);
    *s = filled;
    if (with)
        def->job_system = thud_job_system_of(threads);
}

static bool compare_all(bool quick, json *out) {
    for (current = 0; current < SCENE_COUNT; current++) {
        const char *name = SCENES[current].name;
        lab_pair pair = {name, "2 workers", "1 worker", fill, NULL};
        lab_price price;
        if (!lab_compare(&pair, quick, &price))
            return false;
        double gain = price.without / price.with, least = SCENES[current].least;
        printf("%-13s %9.3f %9.3f  %5.2f  at least %.2f, %s\n", name, price.without * 1e3,
               price.with * 1e3, gain, least, gain >= least ? "holds" : "misses");
        fflush(stdout);
        json_begin_object(out, NULL);
        json_text(out, "scene", name);
        json_number(out, "ms_one_worker", price.without * 1e3);
        json_number(out, "ms_two_workers", price.with * 1e3);
        json_number(out, "at_least", least);
        json_end(out);
    }
    return true;
}

bool lab_workers(bool quick, json *out) {
    if (thud_threads_create(WORKERS, NULL, &threads) != THUD_OK) {
        fprintf(stderr, "thud-bench: no second thread to be had\n");
        return false;
    }
    printf("%-13s %9s %9s  %5s\n", "scene", "1, ms", "2, ms", "gain");
    json_begin_array(out, "workers");
    bool ok = compare_all(quick, out);
    json_end(out);
    thud_threads_destroy(threads);
    return ok;
}
