/* lab_growth.c: time and memory per body over the number of bodies, in thud and in Box2D. */
#include "lab/lab.h"

#include "engine.h"
#include "lab/lab_world.h"
#include "progress.h"
#include "series.h"

#include <stdio.h>

/* Timed steps; as many untimed ones come before them. */
enum { STEPS = 60, QUICK_STEPS = 5 };

/* The time of a step is the minimum over this many runs, since load of other processes only adds to
 * it. */
enum { REPETITIONS = 3 };

static const int SIZES[] = {1000, 4000, 16000, 64000, 256000};
enum { SIZE_COUNT = sizeof SIZES / sizeof SIZES[0], QUICK_SIZE_COUNT = 2 };

/* Bound on the largest time per body divided by the smallest, over all sizes, in thud. Chosen. */
static const double MOST_SPAN = 1.5;

typedef struct growth {
    double ms; /* median step */
    uint64_t bytes;
} growth;

static bool run_once(const physics_engine *engine, const scene *s, int repetition, series *times,
                     uint64_t *bytes) {
    void *world = engine_create(engine, s, (engine_settings){0});
    bool ok = world != NULL;
    char label[64];
    snprintf(label, sizeof label, "%s %d, %s", s->name, s->body_count, engine->name);
    for (int i = 0; ok && i < 2 * times->steps; i++) {
        progress_show(label, (repetition + 0.5 * i / times->steps) / times->repetitions);
        double start = lab_now(NULL);
        ok = engine->step(world);
        if (i >= times->steps)
            times->ms[repetition * times->steps + i - times->steps] = 1e3 * (lab_now(NULL) - start);
    }
    if (ok)
        *bytes = engine->bytes(world);
    engine->destroy(world);
    return ok;
}

static bool measure(const physics_engine *engine, const scene *s, int steps, growth *out) {
    series times;
    bool ok = series_init(&times, steps, REPETITIONS);
    for (int i = 0; ok && i < REPETITIONS; i++)
        ok = run_once(engine, s, i, &times, &out->bytes);
    if (ok)
        out->ms = series_summarize(&times).median;
    else
        fprintf(stderr, "thud-bench: %s failed in %s\n", engine->name, s->name);
    series_free(&times);
    return ok;
}

/* Measures one size; *each becomes thud's nanoseconds per body. */
static bool grow_to(const scene_info *info, int size, int steps, double *each, json *out) {
    scene s;
    growth own, rival;
    if (!scenes_fill(info, size, &s)) {
        fprintf(stderr, "thud-bench: out of memory for scene %s\n", info->name);
        return false;
    }
    bool ok =
        measure(&engine_thud, &s, steps, &own) && measure(engine_find("box2d"), &s, steps, &rival);
    scene_free(&s);
    if (!ok)
        return false;
    *each = own.ms / size * 1e6;
    progress_clear();
    printf("%-8s %8d  %9.3f %8.1f  %9.3f %8.1f  %8.0f %8.0f\n", info->name, size, own.ms, *each,
           rival.ms, rival.ms / size * 1e6, (double)own.bytes / size, (double)rival.bytes / size);
    fflush(stdout);
    json_begin_object(out, NULL);
    json_number(out, "bodies", size);
    json_number(out, "ns_per_body", *each);
    json_number(out, "box2d_ns_per_body", rival.ms / size * 1e6);
    json_number(out, "bytes_per_body", (double)own.bytes / size);
    json_number(out, "box2d_bytes_per_body", (double)rival.bytes / size);
    json_end(out);
    return true;
}

/* Measures the time per body at all sizes of a scene, and whether it stays within MOST_SPAN. */
static bool grow(const scene_info *info, bool quick, json *out) {
    double each[SIZE_COUNT];
    int sizes = quick ? QUICK_SIZE_COUNT : SIZE_COUNT;
    json_begin_object(out, NULL);
    json_text(out, "scene", info->name);
    json_begin_array(out, "sizes");
    bool ok = true;
    for (int i = 0; ok && i < sizes; i++)
        ok = grow_to(info, SIZES[i], quick ? QUICK_STEPS : STEPS, &each[i], out);
    json_end(out);
    if (ok) {
        double span = series_span(each, sizes);
        printf("%-8s dearest over cheapest body: %.2f; at most %.2f, %s\n", info->name, span,
               MOST_SPAN, span <= MOST_SPAN ? "holds" : "misses");
        json_number(out, "span", span);
        json_number(out, "at_most", MOST_SPAN);
    }
    json_end(out);
    return ok;
}

bool lab_growth(bool quick, json *out) {
    printf("%-8s %8s  %9s %8s  %9s %8s  %8s %8s\n", "scene", "bodies", "thud ms", "ns/body",
           "Box2D ms", "ns/body", "B/body", "its");
    json_begin_array(out, "growth");
    bool ok = grow(scenes_find("gas"), quick, out) && grow(&bench_rubble, quick, out);
    json_end(out);
    return ok;
}
