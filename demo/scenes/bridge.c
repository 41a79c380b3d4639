/* bridge.c: a suspension bridge of `size` planks, hinged to each other and to both sides of a
 * valley. A lorry some hundreds of times as heavy as a plank drives over it.
 *
 * Bodies: the land (irregular terrain), the planks from left to right, the lorry with its wheels.
 */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

/* Half the thickness of a plank, m. */
static const double HALF_PLANK = 0.12;

/* The hinge before plank i of n, on a parabola that sags by a thirtieth of the span. */
static scene_point knot(int i, int n) {
    double t = 2.0 * i / n - 1;
    return (scene_point){0.5 * n * t, -HALF_PLANK - n / 30.0 * (1 - t * t)};
}

/* Returns the index of the body. */
static int add_land(scene *s, int size) {
    double edge = 0.5 * size, deep = -4 - 0.12 * size;
    const scene_point land[] = {
        {-edge - 70, 14},
        {-edge - 60, 9},
        {-edge - 50, 3},
        {-edge - 42, 0.6},
        {-edge - 36, 0},
        {-edge, 0},
        {-edge + 0.05, -0.3},
        {-edge + 1, -3},
        {-0.72 * edge, 0.7 * deep},
        {-0.35 * edge, 0.97 * deep},
        {0, deep},
        {0.4 * edge, 0.95 * deep},
        {0.7 * edge, 0.75 * deep},
        {edge - 1, -3},
        {edge - 0.05, -0.3},
        {edge, 0},
        {edge + 30, 0},
        {edge + 36, 0.5},
        {edge + 44, 3},
        {edge + 52, 8},
        {edge + 60, 15},
    };
    int body = s->body_count;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    s->material.friction = 0.9;
    scene_add_irregular(s, land, sizeof land / sizeof land[0]);
    return body;
}

enum { WHEELS = 3 };

static void add_lorry(scene *s, double x) {
    const double radius = 0.62, deck = 1.35;
    s->material = (scene_material){.density = 500, .friction = 0.6};
    int body = s->body_count;
    scene_add_body(s, SCENE_DYNAMIC, x, deck);
    scene_add_obb(s, 3.6, 0.22);
    scene_shape *cab = scene_add_obb(s, 0.75, 0.85);
    cab->x = 2.85;
    cab->y = 1.05;
    scene_shape *box = scene_add_obb(s, 2.7, 1.1);
    box->x = -0.85;
    box->y = 1.35;
    s->material = (scene_material){.density = 300, .friction = 1.2};
    const double places[WHEELS] = {-2.7, -1.25, 2.5};
    for (int i = 0; i < WHEELS; i++) {
        scene_joint *axle = part_wheel(s, body, WHEELS, x + places[i], radius, radius);
        axle->drive[SCENE_TURN].motor_speed = -5 / radius;
        axle->drive[SCENE_TURN].motor_force = 0.3 * part_mass(s, body) / WHEELS * 10 * radius;
    }
    part_keep_apart(s, body, -1);
}

static void fill(scene *s, int size) {
    int land = add_land(s, size);
    s->material = (scene_material){.density = 120, .friction = 0.9};
    int before = land;
    for (int i = 0; i < size; i++) {
        int plank = part_bar(s, knot(i, size), knot(i + 1, size), HALF_PLANK, 0.03);
        part_hinge(s, before, plank, knot(i, size));
        before = plank;
    }
    part_hinge(s, before, land, knot(size, size));
    add_lorry(s, -0.5 * size - 5);
    s->camera_y = -0.5;
    s->camera_height = 0.5 * size + 16;
    s->camera_width = size + 24;
    s->spawn_y = 6;
}

const scene_info scene_bridge = {SCENE_FACTS(bridge), .place = 210, .fill = fill};
