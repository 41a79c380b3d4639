/* broadphases.c: a few drifting bodies of many sizes, to show how each broadphase sorts them: by
 * the cells of the grid, or by the intervals along an axis. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static void fill(scene *s, int size) {
    const double cell = 2.6; /* m; the largest body fits into a cell of the start lattice */
    int columns = (int)ceil(sqrt(1.5 * size));
    int rows = (size + columns - 1) / columns;
    double half_x = 0.5 * cell * columns + 0.5, half_y = 0.5 * cell * rows + 0.5;
    s->gravity_y = 0;
    s->show = SCENE_SHOW_CELLS | SCENE_SHOW_AXES;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    scene_static_box(s, 0, -half_y - 1, half_x + 2, 1);
    scene_static_box(s, 0, half_y + 1, half_x + 2, 1);
    scene_static_box(s, -half_x - 1, 0, 1, half_y);
    scene_static_box(s, half_x + 1, 0, 1, half_y);
    scene_random random = {6};
    for (int i = 0; i < size; i++) {
        double x = (i % columns - 0.5 * (columns - 1)) * cell;
        double y = (i / columns - 0.5 * (rows - 1)) * cell;
        double part = scene_random_range(&random, 0, 1);
        double half = 0.06 + 0.8 * part * part * part; /* small ones are the most frequent */
        double vx = scene_random_range(&random, -3, 3), vy = scene_random_range(&random, -3, 3);
        scene_body *body = i % 2 == 0 ? scene_dynamic_circle(s, x, y, half)
                                      : scene_dynamic_box(s, x, y, half, 0.6 * half);
        body->vx = vx;
        body->vy = vy;
        body->may_sleep = false;
    }
    s->camera_y = -2; /* leaves room for the intervals, which are drawn below the field */
    s->camera_height = 2 * half_y + 9;
}

const scene_info scene_broadphases = {SCENE_FACTS(broadphases), .place = 200, .fill = fill};
