/* gas.c: elastic circles in a closed box, whose kinetic energy should stay constant. */
#include "gas.h"

#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* A random unit vector: a point in the unit disc by rejection, normalised, as sine and cosine
 * differ between platforms. */
static scene_point random_direction(scene_random *random) {
    for (;;) {
        double x = scene_random_range(random, -1, 1);
        double y = scene_random_range(random, -1, 1);
        double squared = x * x + y * y;
        if (squared > 0.01 && squared <= 1) {
            double length = sqrt(squared);
            return (scene_point){x / length, y / length};
        }
    }
}

/* Spacing of the square lattice of their start positions, m. */
static const double SPACING = 1.25;

static int columns_of(int count) {
    return (int)ceil(sqrt(count));
}

double scene_gas_half(int count) {
    return 0.5 * SPACING * columns_of(count) + 0.5;
}

static const scene_material ELASTIC = {.density = 1, .friction = 0, .restitution = 1};

void scene_add_gas_circles(scene *s, double x, double y, int count) {
    const double speed = 5;
    int columns = columns_of(count);
    s->material = ELASTIC;
    scene_random random = {4};
    for (int i = 0; i < count; i++) {
        scene_body *body =
            scene_dynamic_circle(s, x + (i % columns - 0.5 * (columns - 1)) * SPACING,
                                 y + (i / columns - 0.5 * (columns - 1)) * SPACING, 0.25);
        scene_point direction = random_direction(&random);
        body->vx = speed * direction.x;
        body->vy = speed * direction.y;
        body->gravity_scale = 0;
        body->may_sleep = false;
    }
}

double scene_add_gas(scene *s, double x, double y, int count) {
    double half = scene_gas_half(count);
    s->material = ELASTIC;
    scene_static_box(s, x, y - half - 1, half + 2, 1);
    scene_static_box(s, x, y + half + 1, half + 2, 1);
    scene_static_box(s, x - half - 1, y, 1, half);
    scene_static_box(s, x + half + 1, y, 1, half);
    scene_add_gas_circles(s, x, y, count);
    return half;
}

static void fill(scene *s, int size) {
    s->gravity_y = 0;
    double half = scene_add_gas(s, 0, 0, size);
    s->camera_height = 2.2 * half + 2;
}

const scene_info scene_gas = {SCENE_FACTS(gas), .place = 80, .max_size = 1000000, .fill = fill};
