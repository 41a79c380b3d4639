/* lab_growth.c: time and memory per body over the number of bodies, in thud and in Box2D. */
#include "lab/lab.h"

#include "engine.h"
#include "lab/lab_world.h"
#include "progress.h"
#include "series.h"

#include <stdio.h>

/* Untimed steps before the timed ones. */
enum { STEPS_BEFORE = 60, QUICK_STEPS = 5 };

/* A number of bodies, how many steps are timed, and how often: the time of a step is the minimum
 * over the repetitions, since load of other processes only adds to it. Of a million bodies fewer
 * steps are timed, once, as they take minutes, and Box2D is left out: it makes no contacts of so
 * many, so that circles pass through each other whole (./run bench --scene gas:1000000 shows the
 * overlaps). */
typedef struct growth_size {
    int bodies, steps, repetitions;
    bool rival;
} growth_size;

static const growth_size SIZES[] = {{1000, 60, 3, true},   {4000, 60, 3, true},
                                    {16000, 60, 3, true},  {64000, 60, 3, true},
                                    {256000, 60, 3, true}, {1000000, 20, 1, false}};
enum { SIZE_COUNT = sizeof SIZES / sizeof SIZES[0], QUICK_SIZE_COUNT = 2 };

/* Bound on the largest time per body divided by the smallest, over all sizes, in thud. Chosen. */
static const double MOST_SPAN = 1.5;

typedef struct growth {
    double ms; /* median step */
    uint64_t bytes;
} growth;

/* Runs `before` untimed steps, then the timed ones. */
static bool run_once(const physics_engine *engine, const scene *s, int before, int repetition,
                     series *times, uint64_t *bytes) {
    void *world = engine_create(engine, s, (engine_settings){0});
    bool ok = world != NULL;
    char label[64];
    snprintf(label, sizeof label, "%s %d, %s", s->name, s->body_count, engine->name);
    int all = before + times->steps;
    for (int i = 0; ok && i < all; i++) {
        progress_show(label, (repetition + (double)i / all) / times->repetitions);
        double start = lab_now(NULL);
        ok = engine->step(world);
        if (i >= before)
            times->ms[repetition * times->steps + i - before] = 1e3 * (lab_now(NULL) - start);
    }
    if (ok)
        *bytes = engine->bytes(world);
    engine->destroy(world);
    return ok;
}

static bool measure(const physics_engine *engine, const scene *s, int before, growth_size size,
                    growth *out) {
    series times;
    bool ok = series_init(&times, size.steps, size.repetitions);
    for (int i = 0; ok && i < size.repetitions; i++)
        ok = run_once(engine, s, before, i, &times, &out->bytes);
    if (ok)
        out->ms = series_summarize(&times).median;
    else
        fprintf(stderr, "thud-bench: %s failed in %s\n", engine->name, s->name);
    series_free(&times);
    return ok;
}

/* Measures one size; *each becomes thud's nanoseconds per body. */
static bool grow_to(const scene_info *info, growth_size how, int before, double *each, json *out) {
    scene s;
    growth own, rival = {0};
    int size = how.bodies;
    if (!scenes_fill(info, size, &s)) {
        fprintf(stderr, "thud-bench: out of memory for scene %s\n", info->name);
        return false;
    }
    bool ok = measure(&engine_thud, &s, before, how, &own) &&
              (!how.rival || measure(engine_find("box2d"), &s, before, how, &rival));
    scene_free(&s);
    if (!ok)
        return false;
    *each = own.ms / size * 1e6;
    progress_clear();
    printf("%-8s %8d  %9.3f %8.1f  %8.0f", info->name, size, own.ms, *each,
           (double)own.bytes / size);
    if (how.rival)
        printf("  %9.3f %8.1f %8.0f", rival.ms, rival.ms / size * 1e6, (double)rival.bytes / size);
    printf("\n");
    fflush(stdout);
    json_begin_object(out, NULL);
    json_number(out, "bodies", size);
    json_number(out, "ns_per_body", *each);
    json_number(out, "bytes_per_body", (double)own.bytes / size);
    if (how.rival) {
        json_number(out, "box2d_ns_per_body", rival.ms / size * 1e6);
        json_number(out, "box2d_bytes_per_body", (double)rival.bytes / size);
    }
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
    for (int i = 0; ok && i < sizes; i++) {
        growth_size how = SIZES[i];
        how.steps = quick ? QUICK_STEPS : how.steps;
        ok = grow_to(info, how, quick ? QUICK_STEPS : STEPS_BEFORE, &each[i], out);
    }
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
    printf("%-8s %8s  %9s %8s  %8s  %9s %8s %8s\n", "scene", "bodies", "thud ms", "ns/body",
           "B/body", "Box2D ms", "ns/body", "B/body");
    json_begin_array(out, "growth");
    bool ok = grow(scenes_find("gas"), quick, out) && grow(&bench_rubble, quick, out);
    json_end(out);
    return ok;
}
