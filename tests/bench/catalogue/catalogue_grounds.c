/* catalogue_grounds.c: nanoseconds of the functions of terrain lines, by kind of line and number of
 * vertices, and of digging and raising in a world. */
#include "catalogue/call_timer.h"
#include "catalogue/catalogue.h"
#include "lab/lab_world.h"
#include "random.h"
#include "series.h"

#include <thud/thud_terrain.h>

#include <stdlib.h>

enum { PLACES = 1024, DIGS = 200, QUICK_DIGS = 10 };

/* A line with random heights between 0 and half the distance of its vertices. */
static bool make_line(thud_terrain_kind kind, int count, double spacing, thud_terrain *out) {
    thud_pos *points = calloc((size_t)count, sizeof *points);
    scene_random random = {6};
    for (int i = 0; points && i < count; i++) {
        double shift = kind == THUD_TERRAIN_IRREGULAR ? scene_random_range(&random, 0, 0.9) : 0;
        points[i] =
            (thud_pos){(i + shift) * spacing, scene_random_range(&random, 0, 0.5) * spacing};
    }
    *out = (thud_terrain){.kind = kind, .spacing = spacing, .points = points, .count = count};
    return points && thud_terrain_check(out) == THUD_OK;
}

/* Shapes of size 0.5 near the ground, in random order, so that the cache does not help. */
typedef struct ground_places {
    thud_terrain terrain;
    double length; /* m: of the line, or of the part of an endless one in which the places are */
    thud_geometry circles[PLACES], boxes[PLACES];
} ground_places;

static void make_places(ground_places *g) {
    scene_random random = {7};
    for (int i = 0; i < PLACES; i++) {
        double x = scene_random_range(&random, 10, g->length - 10);
        thud_terrain_sample sample = {0};
        thud_terrain_sample_at(&g->terrain, x, &sample);
        double y = sample.height + scene_random_range(&random, 0, 1);
        g->circles[i] =
            (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1, .hx = 0.5};
        g->boxes[i] = (thud_geometry){THUD_SHAPE_OBB, x, y, 0.8, 0.6, 0.5, 0.5};
    }
}

#define FOR_EACH_PLACE(inputs, count) \
    const ground_places *g = inputs;  \
    double answers = 0;               \
    for (int n = 0, i = 0; n < count; n++, i = n & (PLACES - 1))

static double sample_at(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        thud_terrain_sample sample = {0};
        thud_terrain_sample_at(&g->terrain, g->circles[i].x, &sample);
        answers += sample.height;
    }
    return answers;
}

static double place_foot(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        thud_foot foot = {0};
        thud_terrain_place_foot(&g->terrain, g->circles[i].x, 0.3, &foot);
        answers += foot.height;
    }
    return answers;
}

static double circle_overlap(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        answers += thud_terrain_overlap(&g->terrain, &g->circles[i]);
    }
    return answers;
}

static double circle_closest(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        thud_closest closest = {0};
        thud_terrain_closest(&g->terrain, &g->circles[i], &closest);
        answers += closest.distance;
    }
    return answers;
}

static double box_contacts(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        thud_contacts contacts = {0};
        thud_terrain_contacts(&g->terrain, &g->boxes[i], 0.02, &contacts);
        answers += contacts.count;
    }
    return answers;
}

/* Rays 10 m down and 10 m to the right, from 9 m above a place. */
static double ray(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        double fraction = 0, nx, ny;
        answers +=
            thud_terrain_cast_ray(&g->terrain,
                                  (thud_segment){g->circles[i].x - 5, g->circles[i].y + 9, 10, -10},
                                  &fraction, &nx, &ny);
        answers += fraction;
    }
    return answers;
}

static double circle_impact(const void *inputs, int count) {
    FOR_EACH_PLACE(inputs, count) {
        thud_geometry shape = g->circles[i];
        bool hit = false;
        double time = 0;
        shape.y += 2;
        thud_terrain_time_of_impact(&g->terrain, &shape, (thud_motion){1, -3, 0}, 0, &hit, &time);
        answers += time;
    }
    return answers;
}

static const struct {
    const char *name;
    call_fn *fn;
} CALLS[] = {
    {"sample_at", sample_at},           {"place_foot", place_foot},
    {"circle overlap", circle_overlap}, {"circle closest", circle_closest},
    {"box contacts", box_contacts},     {"ray", ray},
    {"circle impact", circle_impact},
};

enum { CALL_COUNT = sizeof CALLS / sizeof CALLS[0] };

static const struct {
    const char *name;
    thud_terrain_kind kind;
    int count;
    double spacing; /* m between vertices */
} GROUNDS[] = {
    {"flat", THUD_TERRAIN_FLAT, 100, 1},
    {"uniform", THUD_TERRAIN_UNIFORM, 100, 1},
    {"uniform", THUD_TERRAIN_UNIFORM, 10000, 1},
    {"uniform", THUD_TERRAIN_UNIFORM, 100000, 1},
    {"uniform", THUD_TERRAIN_UNIFORM, 100000, 0.05},
    {"irregular", THUD_TERRAIN_IRREGULAR, 100, 1},
    {"irregular", THUD_TERRAIN_IRREGULAR, 1000, 1},
    {"irregular", THUD_TERRAIN_IRREGULAR, 10000, 1},
    {"irregular", THUD_TERRAIN_IRREGULAR, 100000, 1},
    {"irregular", THUD_TERRAIN_IRREGULAR, 100000, 0.05},
};

enum { GROUND_COUNT = sizeof GROUNDS / sizeof GROUNDS[0] };

static bool time_ground(int index, ground_places *g, bool quick, json *out) {
    int count = GROUNDS[index].count;
    double spacing = GROUNDS[index].spacing;
    if (!make_line(GROUNDS[index].kind, count, spacing, &g->terrain))
        return false;
    g->length = spacing * (count - 1);
    make_places(g);
    json_begin_object(out, NULL);
    json_text(out, "ground", GROUNDS[index].name);
    json_number(out, "vertices", count);
    json_number(out, "spacing", spacing);
    json_begin_object(out, "ns");
    printf("%-10s %8d %8g", GROUNDS[index].name, count, spacing);
    for (int i = 0; i < CALL_COUNT; i++) {
        double ns = call_timer_ns(CALLS[i].fn, g, quick);
        json_number(out, CALLS[i].name, ns);
        printf(" %14.1f", ns);
    }
    printf("\n");
    fflush(stdout);
    json_end(out);
    json_end(out);
    return true;
}

static bool time_grounds(bool quick, json *out) {
    static ground_places places;
    bool ok = true;
    printf("%-10s %8s %8s", "ground", "vertices", "apart m");
    for (int i = 0; i < CALL_COUNT; i++)
        printf(" %14s", CALLS[i].name);
    printf("\n");
    json_begin_array(out, "grounds");
    for (int i = 0; ok && i < GROUND_COUNT; i++) {
        ok = time_ground(i, &places, quick, out);
        free((void *)places.terrain.points);
    }
    json_end(out);
    return ok;
}

/* ---- digging ---- */

static bool open_diggable(int index, thud_world **world, thud_shape_id *shape) {
    thud_world_def def = lab_settings();
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_id body;
    thud_terrain line;
    bool ok = make_line(GROUNDS[index].kind, GROUNDS[index].count, GROUNDS[index].spacing, &line) &&
              thud_world_create(&def, world) == THUD_OK &&
              thud_body_create(*world, &body_def, &body) == THUD_OK &&
              thud_shape_create_terrain(*world, body, &shape_def, &line, shape) == THUD_OK;
    free((void *)line.points);
    return ok;
}

typedef struct digs {
    double dig[DIGS], raise[DIGS]; /* nanoseconds of each */
    int count;
} digs;

/* Digs and raises at random places of the line. */
static bool dig_about(thud_world *world, thud_shape_id shape, double length, digs *d) {
    scene_random random = {14};
    for (int i = 0; i < d->count; i++) {
        double x = scene_random_range(&random, 20, length - 20);
        double start = lab_now(NULL);
        bool ok = thud_shape_dig(world, shape, (thud_pos){x, 0}, 3) == THUD_OK;
        double between = lab_now(NULL);
        ok = ok && thud_shape_raise(world, shape, length - x, 3, 0.5) == THUD_OK;
        d->dig[i] = (between - start) * 1e9;
        d->raise[i] = (lab_now(NULL) - between) * 1e9;
        if (!ok)
            return false;
    }
    return true;
}

/* Writes the median and the maximum; the maximum includes a reallocation of the line's memory. */
static void report_digs(const char *name, double *ns, int count, json *out) {
    double median = series_median(ns, count); /* sorts the array */
    printf(" %10.0f %10.0f", median, ns[count - 1]);
    json_begin_object(out, name);
    json_number(out, "median", median);
    json_number(out, "worst", ns[count - 1]);
    json_end(out);
}

static bool time_digging(bool quick, json *out) {
    bool ok = true;
    printf("\n%-10s %8s %8s %10s %10s %10s %10s\n", "ground", "vertices", "apart m", "dig ns",
           "worst", "raise ns", "worst");
    json_begin_array(out, "digging");
    for (int i = 1; ok && i < GROUND_COUNT; i++) {
        thud_world *world = NULL;
        thud_shape_id shape;
        digs d = {.count = quick ? QUICK_DIGS : DIGS};
        double length = GROUNDS[i].spacing * (GROUNDS[i].count - 1);
        ok = open_diggable(i, &world, &shape) && dig_about(world, shape, length, &d);
        thud_world_destroy(world);
        if (!ok)
            break;
        printf("%-10s %8d %8g", GROUNDS[i].name, GROUNDS[i].count, GROUNDS[i].spacing);
        json_begin_object(out, NULL);
        json_text(out, "ground", GROUNDS[i].name);
        json_number(out, "vertices", GROUNDS[i].count);
        json_number(out, "spacing", GROUNDS[i].spacing);
        report_digs("dig", d.dig, d.count, out);
        report_digs("raise", d.raise, d.count, out);
        printf("\n");
        json_end(out);
    }
    json_end(out);
    return ok;
}

bool catalogue_grounds(bool quick, json *out) {
    bool ok = time_grounds(quick, out) && time_digging(quick, out);
    if (!ok)
        fprintf(stderr, "thud-catalogue: the ground could not be measured\n");
    return ok;
}
