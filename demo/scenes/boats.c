/* boats.c: boats with loose cargo on a lake, which float by their weight and that of their cargo,
 * and other bodies in the water: crates from light to too heavy to float, a log in tow, a buoy on a
 * chain.
 *
 * Bodies: the land (irregular terrain), the jetty; for each boat its hull, then its cargo or what
 * it tows; the buoy's anchor, the links of its chain, the buoy; the crates, the ball. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static const double SPACING = 9; /* between boats, m */
static const double WATER = 2;   /* density, kg/m^2: a body of density 1 floats half submerged */

/* Adds the lake's bed with both shores, and the jetty. */
static void add_land(scene *s, double half) {
    const scene_point land[] = {
        {-half - 24, 9},   {-half - 14, 3},   {-half - 6, 1.7}, {-half - 1.5, 0.8}, {-half, 0},
        {-half + 3, -2.4}, {-half + 6, -4.8}, {half - 6, -5.6}, {half - 3, -2.8},   {half, 0},
        {half + 1.5, 0.8}, {half + 6, 1.5},   {half + 14, 3.4}, {half + 24, 9},
    };
    s->material = (scene_material){.density = 1, .friction = 0.7};
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_irregular(s, land, sizeof land / sizeof land[0]);
    scene_add_body(s, SCENE_STATIC, -half + 1, 1.3);
    part_add_bar(s, (scene_point){-half - 3, 1.3}, (scene_point){-half + 4, 1.3}, 0.15);
    part_add_bar(s, (scene_point){-half + 1, -3}, (scene_point){-half + 1, 1.2}, 0.12);
    part_add_bar(s, (scene_point){-half + 3.4, -4}, (scene_point){-half + 3.4, 1.2}, 0.12);
}

/* Adds a box to the latest body; (x, y) is relative to the body's origin. */
static void add_box(scene *s, double x, double y, double hx, double hy, double density) {
    s->material.density = density;
    scene_shape *box = scene_add_obb(s, hx, hy);
    box->x = x;
    box->y = y;
}

/* Adds a hull with a bow and a stern that lean outwards and keep the cargo in. Returns the body. */
static int add_hull(scene *s, double x, double y, double hx, double hy, double density) {
    s->material.density = density;
    int hull = part_box(s, x, y, hx, hy);
    for (int side = -1; side <= 1; side += 2)
        part_add_bar(s, (scene_point){x + side * (hx - 0.1), y - hy + 0.1},
                     (scene_point){x + side * (hx + 0.5), y + hy + 0.4}, 0.12);
    return hull;
}

static void add_barge(scene *s, double x) {
    const double y = 0.6, hy = 0.55, half = 0.4;
    add_hull(s, x, y, 2.8, hy, 0.5);
    s->material.density = 0.6;
    for (int i = 0; i < 7; i++) {
        int row = i / 4;
        part_box(s, x + 0.85 * (i % 4 - (row ? 1 : 1.5)), y + hy + half + 2 * half * row, half,
                 half);
    }
}

static void add_sailing_boat(scene *s, double x) {
    const double y = 0.7, hy = 0.4, half = 0.25;
    add_hull(s, x, y, 2.1, hy, 0.6);
    add_box(s, 0, -0.8, 0.5, 0.45, 3); /* the keel */
    add_box(s, -0.2, 2.6, 0.07, 2.2, 0.3);
    for (int i = 0; i < 5; i++)
        add_box(s, 0.9 - 0.17 * i, 1.5 + 0.6 * i, 0.95 - 0.17 * i, 0.29, 0.05);
    s->material.density = 0.7;
    for (int i = 0; i < 3; i++)
        part_circle(s, x - 1.7 + 0.55 * i, y + hy + half, half);
}

static void add_tug(scene *s, double x) {
    const double y = 0.6, hy = 0.5, log_x = x + 4.6;
    int tug = add_hull(s, x, y, 1.6, hy, 0.8);
    add_box(s, -0.3, 1, 0.8, 0.5, 0.3);
    add_box(s, -0.1, 1.95, 0.2, 0.45, 0.3);
    s->material.density = 1.3;
    int log = part_box(s, log_x, 0.3, 1.3, 0.28);
    scene_joint *rope = scene_tie_distance(s, tug, log, x + 1.9, y + hy, log_x - 1.2, 0.3);
    rope->drive[SCENE_ALONG].limited = true;
    rope->drive[SCENE_ALONG].upper = rope->length;
}

/* Adds a buoy on a chain from an anchor on the ground. */
static void add_buoy(scene *s, double x) {
    enum { LINKS = 8 };
    const double y = 0.3, top = y - 0.9;
    s->material.density = 4;
    int last = s->body_count;
    scene_point at = {x - 3, -5};
    scene_add_body(s, SCENE_STATIC, at.x, at.y);
    scene_add_obb(s, 0.5, 0.3);
    int first = last;
    for (int i = 0; i < LINKS; i++) {
        scene_point to = {at.x + 3.0 / LINKS, at.y + (top + 5) / LINKS};
        int link = part_bar(s, at, to, 0.05, 0);
        part_hinge(s, last, link, at);
        last = link;
        at = to;
    }
    s->material.density = 0.4;
    int buoy = part_circle(s, x, y, 0.6);
    part_hinge(s, last, buoy, at);
    add_box(s, 0, 1, 0.07, 0.5, 0.4);
    add_box(s, 0, 1.6, 0.2, 0.2, 0.4);
    add_box(s, 0, -0.6, 0.15, 0.3, 5);
    part_keep_apart(s, first, -1);
}

/* Adds crates from light to too heavy to float, and a ball. */
static void add_loose(scene *s, double half) {
    static const double densities[] = {0.3, 0.8, 1.4, 5};
    for (int i = 0; i < 4; i++) {
        s->material.density = densities[i];
        part_box(s, -half + 5 + 1.2 * i, 1.5 + 1.2 * i, 0.45, 0.45);
    }
    s->material.density = 0.1;
    part_circle(s, -half + 2.5, 2.5, 0.55);
}

static void fill(scene *s, int size) {
    double half = 0.5 * SPACING * size + 6.5, first = 2.5 - 0.5 * SPACING * (size - 1);
    add_land(s, half);
    s->material = (scene_material){.density = 1, .friction = 0.5};
    for (int i = 0; i < size; i++) {
        double x = first + SPACING * i;
        if (i % 3 == 0)
            add_barge(s, x);
        else if (i % 3 == 1)
            add_sailing_boat(s, x);
        else
            add_tug(s, x);
    }
    add_buoy(s, first + 4.9);
    add_loose(s, half);
    s->fields.water_density = WATER;
    s->fields.water_drag = 1.5;
    s->camera_y = 0.6;
    s->camera_height = 15;
    s->camera_width = 2 * half + 1;
    s->spawn_y = 7;
}

const scene_info scene_boats = {SCENE_FACTS(boats), .place = 340, .fill = fill};
