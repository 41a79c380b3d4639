/* pyramid.c: boxes stacked to a triangle, at rest. */
#include "scene_facts.h"
#include "scenes.h"

static void fill(scene *s, int size) {
    const double half = 0.5;
    scene_static_box(s, 0, -1, size, 1);
    for (int row = 0; row < size; row++)
        for (int i = 0; i < size - row; i++)
            scene_dynamic_box(s, (2 * i + row + 1 - size) * half, (2 * row + 1) * half, half, half);
    s->camera_y = 0.45 * size;
    s->camera_height = 1.1 * size;
    s->spawn_y = size + 5.0;
}

const scene_info scene_pyramid = {SCENE_FACTS(pyramid), .place = 10, .fill = fill};
