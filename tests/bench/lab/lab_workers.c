/* lab_workers.c: the gain of a second thread: times the same world with one worker and with two. */
#include "lab/lab.h"

#include "lab/lab_pair.h"

#include <thud/thud_threads.h>

#include <stdio.h>

enum { WORKERS = 2 };

static const double LEAST_GAIN = 1.8;

static thud_threads *threads; /* of the world with two workers */

static void fill(const char *name, bool with, scene *s, thud_world_def *def) {
    scene filled;
    if (!scenes_fill(scenes_find(name), 0, &filled)) {
        s->failed = true;
        return;
    }
    scene_free(s);
    *s = filled;
    if (with)
        def->job_system = thud_job_system_of(threads);
}

static void fill_pyramid(bool with, scene *s, thud_world_def *def) {
    fill("pyramid", with, s, def);
}

static void fill_circle_pit(bool with, scene *s, thud_world_def *def) {
    fill("circle_pit", with, s, def);
}

static const lab_pair PAIRS[] = {
    {"pyramid", "2 workers", "1 worker", fill_pyramid, NULL},
    {"circle_pit", "2 workers", "1 worker", fill_circle_pit, NULL},
};

static bool compare_all(bool quick, json *out) {
    for (size_t i = 0; i < sizeof PAIRS / sizeof PAIRS[0]; i++) {
        lab_price price;
        if (!lab_compare(&PAIRS[i], quick, &price))
            return false;
        double gain = price.without / price.with;
        printf("%-12s %9.3f %9.3f  %5.2f  at least %.1f, %s\n", PAIRS[i].feature,
               price.without * 1e3, price.with * 1e3, gain, LEAST_GAIN,
               gain >= LEAST_GAIN ? "holds" : "misses");
        fflush(stdout);
        json_begin_object(out, NULL);
        json_text(out, "scene", PAIRS[i].feature);
        json_number(out, "ms_one_worker", price.without * 1e3);
        json_number(out, "ms_two_workers", price.with * 1e3);
        json_number(out, "at_least", LEAST_GAIN);
        json_end(out);
    }
    return true;
}

bool lab_workers(bool quick, json *out) {
    if (thud_threads_create(WORKERS, NULL, &threads) != THUD_OK) {
        fprintf(stderr, "thud-bench: no second thread to be had\n");
        return false;
    }
    printf("%-12s %9s %9s  %5s\n", "scene", "1, ms", "2, ms", "gain");
    json_begin_array(out, "workers");
    bool ok = compare_all(quick, out);
    json_end(out);
    thud_threads_destroy(threads);
    return ok;
}
