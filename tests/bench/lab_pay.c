/* lab_pay.c: the price of each feature: the same scene with it and without it, step by step in turn,
 * so that whatever else the machine does hits both alike. */
#include "lab.h"

#include "lab_world.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

typedef struct lab_pair {
    const char *feature;
    const char *with, *without; /* what the two worlds are */
    /* Fills the scene and the settings of one of the two. */
    void (*fill)(bool with, scene *s, thud_world_def *def);
} lab_pair;

enum { BODIES = 3000 };

static void floor_and_walls(scene *s, double half_width) {
    scene_static_box(s, 0, -1, half_width + 1, 1);
    scene_static_box(s, -half_width - 1, 40, 1, 40);
    scene_static_box(s, half_width + 1, 40, 1, 40);
}

static void drop(scene *s, bool boxes, bool upright) {
    scene_random random = {5};
    int columns = 60;
    for (int i = 0; i < BODIES; i++) {
        double x = (i % columns - 0.5 * (columns - 1)) * 1.1;
        double y = (i / columns + 0.6) * 1.1;
        double a = scene_random_range(&random, 0.3, 0.5);
        if (!boxes) {
            scene_dynamic_circle(s, x, y, a);
        } else if (upright) {
            scene_add_body(s, SCENE_DYNAMIC, x, y);
            scene_add_aabb(s, a, 0.4);
        } else {
            scene_dynamic_box(s, x, y, a, 0.4);
        }
    }
}

static void fill_rotation(bool with, scene *s, thud_world_def *def) {
    (void)def;
    floor_and_walls(s, 34);
    drop(s, true, !with);
}

static void fill_friction(bool with, scene *s, thud_world_def *def) {
    (void)def;
    s->material.friction = with ? 0.6 : 0;
    floor_and_walls(s, 34);
    drop(s, false, false);
}

static void fill_restitution(bool with, scene *s, thud_world_def *def) {
    (void)def;
    s->material.restitution = with ? 0.1 : 0;
    floor_and_walls(s, 34);
    drop(s, false, false);
}

static void fill_terrain(bool with, scene *s, thud_world_def *def) {
    (void)def;
    if (with) {
        double heights[80] = {0};
        scene_add_body(s, SCENE_STATIC, 0, 0);
        scene_add_uniform(s, -40, 1, heights, 80);
    } else {
        scene_static_box(s, 0, -1, 40, 1);
    }
    scene_static_box(s, -35, 40, 1, 40);
    scene_static_box(s, 35, 40, 1, 40);
    drop(s, false, false);
}

static void fill_gas(scene *s) {
    scene gas;
    if (scenes_fill(scenes_find("gas"), BODIES, &gas)) {
        scene_free(s);
        *s = gas;
    } else {
        s->failed = true;
    }
}

static void fill_fast(bool with, scene *s, thud_world_def *def) {
    fill_gas(s);
    def->continuous = with;
}

static bool allow(thud_world *w, const thud_contact *contact, void *context) {
    (void)w, (void)contact, (void)context;
    return true;
}

static void hear(thud_world *w, const thud_contact *contact, void *context) {
    (void)w, (void)contact, (void)context;
}

static void fill_events(bool with, scene *s, thud_world_def *def) {
    fill_gas(s);
    def->contact_events = with;
}

static void fill_listeners(bool with, scene *s, thud_world_def *def) {
    floor_and_walls(s, 34);
    drop(s, false, false);
    if (with) {
        def->prologue = allow;
        def->epilogue = hear;
    }
}

static void fill_static(bool with, scene *s, thud_world_def *def) {
    (void)def;
    scene_static_box(s, 0, -1, 200, 1);
    for (int i = 0; with && i < 10000; i++)
        scene_static_box(s, i % 100 * 1.5, 3 + i / 100 * 1.5, 0.5, 0.5);
}

static void fill_asleep(bool with, scene *s, thud_world_def *def) {
    def->sleeping = true;
    scene_static_box(s, 0, -1, 2000, 1);
    for (int i = 0; with && i < 1000; i++)
        scene_dynamic_box(s, i * 1.5 - 750, 0.5, 0.5, 0.5);
}

/* 20,000 asleep beside a hundred that never rest, against the hundred alone. */
static void fill_crowd(bool with, scene *s, thud_world_def *def) {
    def->sleeping = true;
    scene crowd;
    if (!scenes_fill(scenes_find("asleep"), with ? 20000 : 1, &crowd)) {
        s->failed = true;
        return;
    }
    scene_free(s);
    *s = crowd;
}

static const lab_pair PAIRS[] = {
    {"rotation", "boxes that turn", "boxes that do not", fill_rotation},
    {"friction", "friction 0.6", "friction 0", fill_friction},
    {"restitution", "restitution 0.1", "restitution 0", fill_restitution},
    {"terrain", "floor of 79 segments", "floor of one box", fill_terrain},
    {"fast bodies", "gas, continuous", "gas, not continuous", fill_fast},
    {"events", "gas with events", "gas without", fill_events},
    {"listeners", "prologue and epilogue", "neither", fill_listeners},
    {"all static", "10,000 static boxes", "an empty world", fill_static},
    {"all asleep", "1,000 asleep", "an empty world", fill_asleep},
    {"20,000 asleep", "100 awake among them", "the 100 alone", fill_crowd},
};

enum { STEPS = 300, TURN = 10, WARM_UP = 120 };

static bool open_one(const lab_pair *pair, bool with, lab_world *lab) {
    thud_world_def def = lab_settings();
    *lab = (lab_world){0};
    scene_init(&lab->scene);
    pair->fill(with, &lab->scene, &def);
    return lab_open(lab, &def);
}

static bool compare(const lab_pair *pair, bool quick, FILE *json, const char *between) {
    lab_world labs[2];
    memset(labs, 0, sizeof labs);
    static double seconds[2][STEPS];
    int steps = quick ? 20 : STEPS;
    bool ok = open_one(pair, false, &labs[0]) && open_one(pair, true, &labs[1]);
    for (int k = 0; k < 2 && ok; k++)
        ok = lab_run(&labs[k], quick ? 2 : WARM_UP, NULL);
    for (int first = 0; ok && first < steps; first += TURN)
        for (int k = 0; k < 2 && ok; k++)
            ok = lab_run(&labs[k], TURN, seconds[k] + first);
    lab_close(&labs[0]);
    lab_close(&labs[1]);
    if (!ok)
        return false;
    double without = lab_median(seconds[0], steps), with = lab_median(seconds[1], steps);
    printf("%-14s %-24s %9.4f  %-22s %9.4f  %6.2f\n", pair->feature, pair->with, with * 1e3,
           pair->without, without * 1e3, with / without);
    fflush(stdout);
    if (json)
        fprintf(json,
                "%s  {\"feature\": \"%s\", \"with\": \"%s\", \"without\": \"%s\", "
                "\"ms_with\": %.5g, \"ms_without\": %.5g}",
                between, pair->feature, pair->with, pair->without, with * 1e3, without * 1e3);
    return true;
}

bool lab_pay(bool quick, FILE *json) {
    printf("%-14s %-24s %9s  %-22s %9s  %6s\n", "feature", "with", "ms", "without", "ms", "ratio");
    if (json)
        fprintf(json, "[\n");
    bool ok = true;
    for (size_t i = 0; ok && i < sizeof PAIRS / sizeof PAIRS[0]; i++)
        ok = compare(&PAIRS[i], quick, json, i ? ",\n" : "");
    if (json)
        fprintf(json, "\n]\n");
    return ok;
}
