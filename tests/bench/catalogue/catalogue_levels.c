/* catalogue_levels.c: counts how many of all pairs of a scene each bounding volume leaves, beside
 * the pairs of fat bounds and the touching contacts of the world's own pipeline. */
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"
#include "engine.h"
#include "catalogue/levels.h"
#include "progress.h"
#include "scenes.h"

#include <math.h>
#include <stdlib.h>

enum { LOOKS = 10, STEPS_APART = 30, QUICK_LOOKS = 2, QUICK_STEPS_APART = 3 };

/* Distance in m below which a contact is created: the engine's speculative margin at length scale
 * 1. */
static const double MARGIN = 0.02;

/* Scenes whose bodies have one shape, centred at the body's origin. */
static const struct {
    const char *scene;
    int size, quick_size;
} SCENES[] = {
    {"gas", 1000, 50},   {"circle_pit", 1000, 50}, {"smash", 960, 50},
    {"sizes", 1000, 50}, {"pyramid", 40, 8},
};

typedef struct looks {
    levels seen;
    long bounds, contacts; /* counts of the world itself */
    int count;
} looks;

/* Adds the counts of pairs at the world's present poses to `sum`; false if a call failed. */
static bool look(const scene *s, const way_world *w, thud_geometry *shapes, bool *movable,
                 looks *sum) {
    for (int i = 0; i < w->count; i++) {
        const scene_shape *shape = &s->shapes[s->bodies[i].first_shape];
        thud_body_state body;
        if (thud_body_get_state(w->world, w->bodies[i], &body) != THUD_OK)
            return false;
        double length = hypot(body.cosine, body.sine); /* 1 up to rounding to floats */
        shapes[i] = (thud_geometry){
            .kind = shape->kind == SCENE_CIRCLE ? THUD_SHAPE_CIRCLE
                    : shape->kind == SCENE_AABB ? THUD_SHAPE_AABB
                                                : THUD_SHAPE_OBB,
            .x = body.position.x,
            .y = body.position.y,
            .c = body.cosine / length,
            .s = body.sine / length,
            .hx = shape->hx,
            .hy = shape->hy,
        };
        movable[i] = body.kind == THUD_BODY_DYNAMIC;
    }
    thud_stats stats = thud_stats_of(w->world);
    sum->bounds += stats.pairs;
    sum->contacts += stats.contacts;
    sum->count++;
    return levels_count(shapes, movable, w->count, MARGIN, &sum->seen);
}

/* Runs the scene and calls `look` at equal intervals; false if a call failed. */
static bool watch(const char *name, const scene *s, bool quick, looks *sum) {
    way_world w = {0};
    thud_geometry *shapes = calloc((size_t)s->body_count, sizeof *shapes);
    bool *movable = calloc((size_t)s->body_count, sizeof *movable);
    bool ok = shapes && movable && way_open(&w, s, &thud_detection_continuous, ENGINE_TIME_STEP);
    int looks_wanted = quick ? QUICK_LOOKS : LOOKS;
    int steps = quick ? QUICK_STEPS_APART : STEPS_APART;
    for (int i = 0; ok && i < looks_wanted * steps; i++) {
        progress_show(name, (double)i / (looks_wanted * steps));
        ok = way_step(&w) && ((i + 1) % steps != 0 || look(s, &w, shapes, movable, sum));
    }
    progress_clear();
    way_close(&w);
    free(shapes);
    free(movable);
    if (!ok)
        fprintf(stderr, "thud-catalogue: the levels of %s could not be counted\n", name);
    return ok;
}

static void report(const char *name, int size, const looks *sum, json *out) {
    const struct {
        const char *name;
        long count;
    } COLUMNS[] = {
        {"pairs", sum->seen.pairs},       {"bounds", sum->bounds},
        {"circles", sum->seen.circles},   {"boxes", sum->seen.boxes},
        {"oriented", sum->seen.oriented}, {"exact", sum->seen.exact},
        {"sieved", sum->seen.sieved},     {"near", sum->seen.near},
        {"contacts", sum->contacts},
    };
    printf("%-11s", name);
    json_begin_object(out, NULL);
    json_text(out, "scene", name);
    json_number(out, "size", size);
    for (size_t i = 0; i < sizeof COLUMNS / sizeof COLUMNS[0]; i++) {
        double each = (double)COLUMNS[i].count / sum->count;
        printf(" %10.1f", each);
        json_number(out, COLUMNS[i].name, each);
    }
    printf("\n");
    json_end(out);
}

bool catalogue_levels(bool quick, json *out) {
    bool ok = true;
    printf("%-11s %10s %10s %10s %10s %10s %10s %10s %10s %10s\n", "scene", "all pairs",
           "fat bounds", "circles", "AABBs", "OBBs", "overlap", "sieve", "near", "contacts");
    json_begin_array(out, "levels");
    for (size_t i = 0; ok && i < sizeof SCENES / sizeof SCENES[0]; i++) {
        int size = quick ? SCENES[i].quick_size : SCENES[i].size;
        looks sum = {0};
        scene s;
        ok = scenes_fill(scenes_find(SCENES[i].scene), size, &s) &&
             watch(SCENES[i].scene, &s, quick, &sum);
        if (ok)
            report(SCENES[i].scene, size, &sum, out);
        scene_free(&s);
    }
    json_end(out);
    return ok;
}
