/* tall_stack.c: one column of boxes, which should neither sag nor lean. */
#include "scene_facts.h"
#include "scenes.h"

static void fill(scene *s, int size) {
    scene_static_box(s, 0, -1, 20, 1);
    for (int i = 0; i < size; i++)
        scene_dynamic_box(s, 0, i + 0.5, 0.5, 0.5);
    s->camera_y = 0.5 * size;
    s->camera_height = 1.2 * size + 4;
    s->spawn_x = 5;
    s->spawn_y = size;
}

const scene_info scene_tall_stack = {SCENE_FACTS(tall_stack), .place = 90, .fill = fill};
