/* circle_pit.c: circles of several sizes fall into a pit. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static void fill(scene *s, int size) {
    const double spacing = 1.04;
    int columns = (int)sqrt(size);
    int rows = (size + columns - 1) / columns;
    double half_width = 0.5 * spacing * columns + 0.5;
    double height = spacing * rows;
    scene_static_box(s, 0, -1, half_width + 2, 1);
    scene_static_box(s, -half_width - 1, 0.5 * height, 1, 0.5 * height);
    scene_static_box(s, half_width + 1, 0.5 * height, 1, 0.5 * height);

    scene_random random = {1};
    for (int i = 0; i < size; i++) {
        double jitter = scene_random_range(&random, -0.02, 0.02);
        double x = (i % columns - 0.5 * (columns - 1)) * spacing + jitter;
        double y = (i / columns + 0.6) * spacing;
        scene_dynamic_circle(s, x, y, scene_random_range(&random, 0.25, 0.5));
    }
    s->camera_y = 0.4 * height;
    s->camera_height = 1.1 * height;
    s->spawn_y = height + 2;
}

const scene_info scene_circle_pit = {SCENE_FACTS(circle_pit), .place = 20, .max_size = 1000000,
                                     .fill = fill};
