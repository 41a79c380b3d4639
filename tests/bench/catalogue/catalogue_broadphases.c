/* catalogue_broadphases.c: times the three broadphases on the same worlds, over the number of
 * shapes, the number and speed of those that move, the range of their sizes, and their density. */
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"
#include "catalogue/crowd.h"
#include "lab/lab_turns.h"

#include <math.h>

enum { REPETITIONS = 3 };

/* Seconds: a world whose second step takes longer is not timed further. Chosen. */
static const double TOO_DEAR = 0.5;

/* Opens a world for each broadphase. Detection is given by the caller: continuous detection queries
 * the broadphase too, which is not part of what is measured here. */
static bool open_all(const scene *s, bool crowded, const thud_detection *detection,
                     lab_world labs[BROADPHASE_COUNT]) {
    for (int k = 0; k < BROADPHASE_COUNT; k++) {
        thud_world_def def = lab_settings();
        def.clock = lab_now;
        def.contact_events = false;
        def.broadphase = broadphase_at(k);
        def.detection = detection;
        labs[k].scene = *s; /* the scene is shared with the other worlds */
        if (!lab_open(&labs[k], &def))
            return false;
        if (crowded)
            crowd_passes_through(labs[k].world);
    }
    return true;
}

static void close_all(lab_world labs[BROADPHASE_COUNT]) {
    for (int k = 0; k < BROADPHASE_COUNT; k++) {
        thud_world_destroy(labs[k].world);
        labs[k].world = NULL;
    }
}

/* Prints a row of the table and writes it into the results. `overlaps` below 0 means not counted.
 */
static void report(const char *label, int shapes, long overlaps,
                   const lab_turns_times times[BROADPHASE_COUNT], json *out) {
    json_begin_object(out, NULL);
    json_text(out, "case", label);
    json_number(out, "shapes", shapes);
    if (overlaps >= 0)
        json_number(out, "overlaps", (double)overlaps);
    printf("%-22s", label);
    for (int k = 0; k < BROADPHASE_COUNT; k++) {
        const lab_turns_times *t = &times[k];
        json_begin_object(out, thud_broadphase_name(broadphase_at(k)));
        json_number(out, "first_ms", t->first * 1e3);
        if (t->dropped) {
            json_number(out, "step_ms", t->second_step * 1e3);
            printf("  dropped %7.0f ms      ", t->second_step * 1e3);
        } else {
            double broadphase = lab_turns_mean(t->broadphase, t->count) * 1e9 / shapes;
            double step = lab_turns_mean(t->step, t->count) * 1e9 / shapes;
            json_number(out, "ns_per_shape", broadphase);
            json_number(out, "step_ns_per_shape", step);
            printf("  %8.1f %8.1f %7d", broadphase, step, t->stats.pairs);
        }
        json_number(out, "pairs", t->stats.pairs);
        json_bool(out, "dropped", t->dropped);
        json_end(out);
    }
    printf("\n");
    fflush(stdout);
    json_end(out);
}

static void print_head(const char *by) {
    printf("%-22s", by);
    for (int k = 0; k < BROADPHASE_COUNT; k++)
        printf("  %8s %8s %7s", thud_broadphase_name(broadphase_at(k)), "step", "pairs");
    printf("\n");
}

/* Times the scene with each broadphase; returns false if a world failed. */
static bool measure(const char *label, const scene *s, bool crowded,
                    const thud_detection *detection, bool quick,
                    lab_turns_times times[BROADPHASE_COUNT]) {
    lab_turns_plan plan = {10, LAB_TURNS_STEPS, .seconds = 1.5, TOO_DEAR};
    if (quick) /* few steps, and no broadphase is left out */
        plan = (lab_turns_plan){2, 10, .seconds = 0.05, .too_dear = INFINITY};
    bool ok = true;
    for (int i = 0; ok && i < (quick ? 1 : REPETITIONS); i++) {
        lab_world labs[BROADPHASE_COUNT] = {0};
        ok = open_all(s, crowded, detection, labs) &&
             lab_take_turns(label, labs, BROADPHASE_COUNT, &plan, i, times);
        close_all(labs);
    }
    return ok;
}

/* Times scenes of growing size: the scene gas with 10 to 100,000 shapes. */
static bool grow(bool quick, json *out) {
    static const int SIZES[] = {10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000};
    int count = quick ? 5 : (int)(sizeof SIZES / sizeof SIZES[0]);
    bool ok = true;
    print_head("shapes of a gas, ns");
    json_begin_array(out, "growth");
    for (int i = 0; ok && i < count; i++) {
        scene s;
        lab_turns_times times[BROADPHASE_COUNT];
        char label[64];
        snprintf(label, sizeof label, "%d", SIZES[i]);
        ok = scenes_fill(scenes_find("gas"), SIZES[i], &s) &&
             measure(label, &s, false, &thud_detection_overlap, quick, times);
        if (ok)
            report(label, s.shape_count, -1, times, out);
        scene_free(&s);
    }
    json_end(out);
    return ok;
}

/* Measures a crowd; with `counted`, the number of overlapping pairs is written too. */
static bool measure_crowd(const char *label, const crowd *c, bool counted, bool quick, json *out) {
    scene s;
    lab_turns_times times[BROADPHASE_COUNT];
    scene_init(&s);
    crowd_fill(c, &s);
    bool ok = measure(label, &s, true, &thud_detection_continuous, quick, times);
    if (ok)
        report(label, s.shape_count, counted ? crowd_overlaps(&s) : -1, times, out);
    scene_free(&s);
    return ok;
}

/* Times crowds of equal size in which a varying share of bodies moves at varying speeds. */
static bool move(bool quick, json *out) {
    static const struct {
        double moving, speed;
    } CASES[] = {{0, 0}, {0.01, 5}, {0.1, 5}, {1, 0.5}, {1, 5}, {1, 50}, {1, 500}};
    crowd c = {.bodies = quick ? 500 : 10000, .area = 1.5625, .least = 0.25, .most = 0.25};
    bool ok = true;
    printf("\n");
    print_head("moving, at m/s, ns");
    json_begin_array(out, "coherence");
    for (size_t i = 0; ok && i < sizeof CASES / sizeof CASES[0]; i++) {
        char label[64];
        c.moving = CASES[i].moving;
        c.speed = CASES[i].speed;
        snprintf(label, sizeof label, "%g %%, %g m/s", 100 * c.moving, c.speed);
        ok = measure_crowd(label, &c, false, quick, out);
    }
    json_end(out);
    return ok;
}

/* Times crowds whose radii differ by factors of 1 to 400. */
static bool mix(bool quick, json *out) {
    static const double SPANS[] = {1, 20, 400};
    bool ok = true;
    printf("\n");
    print_head("largest/smallest, ns");
    json_begin_array(out, "sizes");
    for (size_t i = 0; ok && i < sizeof SPANS / sizeof SPANS[0]; i++) {
        char label[64];
        double root = sqrt(SPANS[i]);
        crowd c = {quick ? 500 : 4000, 0, 0.5 / root, 0.5 * root, 1, 5};
        c.area = crowd_area_filled(&c, 0.3);
        snprintf(label, sizeof label, "%g", SPANS[i]);
        ok = measure_crowd(label, &c, true, quick, out);
    }
    json_end(out);
    return ok;
}

/* Times crowds of growing density. */
static bool gather(bool quick, json *out) {
    /* Square metres for each circle of radius 0.25. In the last row all centres lie in a square of
     * 0.25 m, so that all pairs overlap. */
    static const double AREAS[] = {1.5625, 0.15625, 0.015625, 0.000125};
    bool ok = true;
    printf("\n");
    print_head("gathered, ns");
    json_begin_array(out, "gathering");
    for (size_t i = 0; ok && i < sizeof AREAS / sizeof AREAS[0]; i++) {
        char label[64];
        crowd c = {quick ? 100 : 500, AREAS[i], 0.25, 0.25, 1, 5};
        snprintf(label, sizeof label, "%g m^2 each", AREAS[i]);
        ok = measure_crowd(label, &c, true, quick, out);
    }
    json_end(out);
    return ok;
}

bool catalogue_broadphases(bool quick, json *out) {
    return grow(quick, out) && move(quick, out) && mix(quick, out) && gather(quick, out);
}
