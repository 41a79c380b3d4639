/* flags.c: flags in a gusty wind. A flag is three stripes of plates, hinged to one another and to
 * its pole. Wind that strikes a plate at an angle lifts it, so that the flags flutter.
 *
 * Bodies: the ground (irregular terrain), trees and benches, the poles; then the plates, stripe by
 * stripe over all flags, from the pole outwards. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

/* Stripes of a flag, and plates of a stripe. */
enum { STRIPES = 3, PLATES = 7 };

static const double SPACING = 6.5; /* from pole to pole, m */
/* Half extents of a plate, m. */
static const double HALF_LENGTH = 0.3, HALF_HEIGHT = 0.24;

/* The x of pole i. */
static double pole_x(int size, int i) {
    return SPACING * (i - 0.5 * size);
}

/* The height of pole i. */
static double pole_top(int i) {
    return 7 + 0.9 * (i % 3);
}

static void add_park(scene *s, double half) {
    const scene_point land[] = {{-half - 30, 8}, {-half - 12, 1.2}, {-half - 4, 0},
                                {half + 4, 0},   {half + 12, 1.2},  {half + 30, 8}};
    s->material = (scene_material){.density = 1, .friction = 0.8};
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_irregular(s, land, sizeof land / sizeof land[0]);
}

/* Adds a box to the latest body; (x, y) is relative to the body's origin. */
static void add_box(scene *s, double x, double y, double hx, double hy, double angle) {
    scene_shape *box = scene_add_obb(s, hx, hy);
    box->x = x;
    box->y = y;
    box->angle = angle;
}

static void add_tree(scene *s, double x) {
    scene_add_body(s, SCENE_STATIC, x, 0);
    add_box(s, 0, 0.5, 0.13, 0.5, 0);
    for (int i = 0; i < 4; i++)
        add_box(s, 0, 1.25 + 0.55 * i, 1.05 - 0.25 * i, 0.275, 0);
}

static void add_bench(scene *s, double x) {
    scene_add_body(s, SCENE_STATIC, x, 0);
    add_box(s, 0, 0.5, 0.8, 0.06, 0);
    add_box(s, -0.75, 0.85, 0.05, 0.4, 0.15);
    for (int side = -1; side <= 1; side += 2)
        add_box(s, 0.6 * side, 0.22, 0.06, 0.22, 0);
}

/* Adds a pole. It collides with nothing, since flags hang down along it. */
static void add_pole(scene *s, double x, double top) {
    scene_add_body(s, SCENE_STATIC, x, 0);
    add_box(s, 0, 0.5 * top, 0.07, 0.5 * top, 0);
    add_box(s, 0, top + 0.1, 0.14, 0.1, 0);
    if (!s->failed)
        for (int i = 0; i < 2; i++)
            s->shapes[s->shape_count - 1 - i].mask = PART_MEETS_NOTHING;
}

static void add_stripe(scene *s, int pole, double x, double y, int look) {
    int last = pole;
    for (int i = 0; i < PLATES; i++) {
        double left = x + 2 * HALF_LENGTH * i;
        int plate = part_box(s, left + HALF_LENGTH, y, HALF_LENGTH, HALF_HEIGHT);
        if (!s->failed) {
            s->bodies[plate].look = look;
            s->bodies[plate].may_sleep = false; /* wind does not wake sleeping bodies */
            s->shapes[s->shape_count - 1].group = -1;
        }
        part_hinge(s, last, plate, (scene_point){left, y});
        last = plate;
    }
}

static void fill(scene *s, int size) {
    double half = 0.5 * SPACING * size;
    add_park(s, half);
    for (int i = 0; i <= size; i++)
        if (i % 2)
            add_tree(s, pole_x(size, i) - 1.5);
        else
            add_bench(s, pole_x(size, i) - 1.5);
    int first = s->body_count;
    for (int i = 0; i < size; i++)
        add_pole(s, pole_x(size, i), pole_top(i));
    s->material.density = 0.25;
    for (int stripe = 0; stripe < STRIPES; stripe++)
        for (int i = 0; i < size; i++)
            add_stripe(s, first + i, pole_x(size, i),
                       pole_top(i) - HALF_HEIGHT * (2 * stripe + 1.2), 1 + (i + 2 * stripe) % 6);
    s->fields.air_density = 0.08;
    s->fields.wind = 9;
    s->fields.wind_origin = -half;
    s->fields.air_drag = 1.1;
    s->fields.air_lift = 1;
    s->camera_y = 4.6;
    s->camera_height = 12.5;
    s->camera_width = 2 * half + 5;
    s->spawn_y = 10;
}

const scene_info scene_flags = {SCENE_FACTS(flags), .place = 350, .fill = fill};
