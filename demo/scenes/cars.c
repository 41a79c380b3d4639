/* cars.c: cars of random sizes drive over a mountain, on sprung axles with a motor each; part_wheel
 * says how their suspension is tuned.
 *
 * Bodies: the land (uniform terrain), then for each car its body and its wheels. */
#include "parts.h"
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

/* Heights of the terrain, and how many of them from one knoll to the next. */
enum { POINTS = 321, COARSE = 20 };
/* Distance of the heights, m. */
static const double SPACING = 0.36;

/* A mountain in the middle, knolls all over, joined by 3 t^2 - 2 t^3, and a slope at both ends that
 * keeps the cars in. */
static void add_land(scene *s, double heights[POINTS]) {
    double knolls[POINTS / COARSE + 2];
    scene_random random = {11};
    for (int i = 0; i < POINTS / COARSE + 2; i++)
        knolls[i] = scene_random_range(&random, -1, 1);
    for (int i = 0; i < POINTS; i++) {
        double x = 2.0 * i / (POINTS - 1) - 1, t = (double)(i % COARSE) / COARSE;
        double low = knolls[i / COARSE], high = knolls[i / COARSE + 1];
        double hill = 1 - x * x;
        double edge = x * x * x * x * x * x;
        double wall = edge * edge * edge * edge;
        heights[i] = 7 * hill * hill * hill * hill +
                     0.8 * (low + (high - low) * t * t * (3 - 2 * t)) + 5 * edge + 30 * wall +
                     scene_random_range(&random, -0.03, 0.03);
    }
    s->material.friction = 0.9;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_uniform(s, -0.5 * SPACING * (POINTS - 1), SPACING, heights, POINTS);
}

static void add_car(scene *s, double x, double y, scene_random *random, int number) {
    double length = scene_random_range(random, 1.5, 2.1);
    double radius = scene_random_range(random, 0.42, 0.72);
    s->material = (scene_material){.density = 100, .friction = 0.4};
    int body = s->body_count;
    scene_add_body(s, SCENE_DYNAMIC, x, y);
    scene_add_obb(s, length, 0.3);
    scene_shape *cabin = scene_add_obb(s, 0.5 * length, 0.32);
    cabin->x = -0.15 * length;
    cabin->y = 0.6;
    scene_shape *bonnet = scene_add_obb(s, 0.32 * length, 0.12);
    bonnet->x = 0.66 * length;
    bonnet->y = 0.38;
    s->material = (scene_material){.density = 60, .friction = 1.3};
    double weight = 10 * part_mass(s, body);
    for (int side = -1; side <= 1; side += 2) {
        scene_joint *axle =
            part_wheel(s, body, 2, x + side * 0.68 * length, y - 0.2 - 0.3 * radius, radius);
        axle->drive[SCENE_TURN].motor_speed = -scene_random_range(random, 6, 8) / radius;
        axle->drive[SCENE_TURN].motor_force = 0.29 * weight * radius;
    }
    part_keep_apart(s, body, -1 - number);
}

static void fill(scene *s, int size) {
    scene_random random = {3};
    double heights[POINTS];
    add_land(s, heights);
    for (int i = 0; i < size; i++) {
        int point = 80 + 12 * (i % 5);
        double x = SPACING * (point - (POINTS - 1) / 2);
        add_car(s, x, heights[point + 4] + 1.4 + 3 * (i / 5), &random, i);
    }
    s->camera_y = 8;
    s->camera_height = 40;
    s->camera_width = 70;
    s->spawn_y = 16;
}

const scene_info scene_cars = {SCENE_FACTS(cars), .place = 250, .fill = fill};
