/* lab_pay.c: the cost of each feature: times the same scene with it and without it. */
#include "lab/lab.h"

#include "lab/lab_pair.h"
#include "random.h"

enum { BODIES = 3000 };

static void floor_and_walls(scene *s, double half_width) {
    scene_static_box(s, 0, -1, half_width + 1, 1);
    scene_static_box(s, -half_width - 1, 40, 1, 40);
    scene_static_box(s, half_width + 1, 40, 1, 40);
}

/* Adds BODIES bodies in rows above the floor: circles, rotated boxes, or upright boxes. */
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

static void fill_continuous(bool with, scene *s, thud_world_def *def) {
    fill_gas(s);
    def->detection = with ? &thud_detection_continuous : &thud_detection_overlap;
}

/* A hundred circles fly up and down between two plates beside the heap, at the distance of the
 * plates per step or faster; without the feature they are at rest there. */
static void fill_fast(bool with, scene *s, thud_world_def *def) {
    (void)def;
    floor_and_walls(s, 34);
    drop(s, false, false);
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    scene_static_box(s, 200, -1, 101, 0.5);
    scene_static_box(s, 200, 3, 101, 0.5);
    for (int i = 0; i < 100; i++) {
        scene_body *body = scene_dynamic_circle(s, 102 + 2 * i, 1, 0.25);
        body->gravity_scale = 0;
        body->vy = with ? 200 : 0;
    }
}

/* A prologue without an effect. */
static bool allow(thud_world *w, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)w, (void)contact, (void)settings, (void)context;
    return true;
}

/* An epilogue without an effect. */
static void hear(thud_world *w, const thud_contact *contact, void *context) {
    (void)w, (void)contact, (void)context;
}

static void fill_events(bool with, scene *s, thud_world_def *def) {
    fill_gas(s);
    def->contact_events = with;
}

static const thud_listeners LISTENERS = {.prologue = allow, .epilogue = hear};

static void fill_listeners(bool with, scene *s, thud_world_def *def) {
    (void)with, (void)def;
    floor_and_walls(s, 34);
    drop(s, false, false);
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

/* 20,000 sleeping bodies beside a hundred that never rest, against the hundred and one sleeping
 * body (a scene cannot be empty). */
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
    {"rotation", "boxes that turn", "boxes that do not", fill_rotation, NULL},
    {"friction", "friction 0.6", "friction 0", fill_friction, NULL},
    {"restitution", "restitution 0.1", "restitution 0", fill_restitution, NULL},
    {"terrain", "floor of 79 segments", "floor of one box", fill_terrain, NULL},
    {"continuous", "gas, continuous", "gas, not continuous", fill_continuous, NULL},
    {"fast bodies", "heap, 100 fly at 200 m/s", "heap, they stand still", fill_fast, NULL},
    {"events", "gas with events", "gas without", fill_events, NULL},
    {"listeners", "prologue and epilogue", "neither", fill_listeners, &LISTENERS},
    {"all static", "10,000 static boxes", "an empty world", fill_static, NULL},
    {"all asleep", "1,000 asleep", "an empty world", fill_asleep, NULL},
};

static const lab_pair CROWD = {"asleep", "100 awake, 20,000 asleep", "the 100 alone", fill_crowd,
                               NULL};

bool lab_pay(bool quick, json *out) {
    printf("%-12s %-25s %9s  %-22s %9s  %6s\n", "feature", "with", "ms", "without", "ms", "ratio");
    json_begin_array(out, "pay");
    bool ok = true;
    for (size_t i = 0; ok && i < sizeof PAIRS / sizeof PAIRS[0]; i++) {
        const lab_pair *pair = &PAIRS[i];
        lab_price price;
        ok = lab_compare(pair, quick, &price);
        if (!ok)
            break;
        printf("%-12s %-25s %9.4f  %-22s %9.4f  %6.2f\n", pair->feature, pair->with,
               price.with * 1e3, pair->without, price.without * 1e3, price.with / price.without);
        fflush(stdout);
        json_begin_object(out, NULL);
        json_text(out, "feature", pair->feature);
        json_text(out, "with", pair->with);
        json_text(out, "without", pair->without);
        json_number(out, "ms_with", price.with * 1e3);
        json_number(out, "ms_without", price.without * 1e3);
        json_end(out);
    }
    json_end(out);
    return ok;
}

bool lab_alone(bool quick, json *out) {
    const double most = 1.1;
    lab_price price;
    if (!lab_compare(&CROWD, quick, &price))
        return false;
    double ratio = price.with / price.without;
    printf("  %s: %.4f ms; %s: %.4f ms, %.2f times that; at most %.2f, %s\n", CROWD.without,
           price.without * 1e3, CROWD.with, price.with * 1e3, ratio, most,
           ratio <= most ? "holds" : "misses");
    json_begin_object(out, "alone");
    json_number(out, "ms_alone", price.without * 1e3);
    json_number(out, "ms_among_sleepers", price.with * 1e3);
    json_number(out, "at_most", most);
    json_bool(out, "holds", ratio <= most);
    json_end(out);
    return true;
}
