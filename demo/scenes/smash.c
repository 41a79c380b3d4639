/* smash.c: without gravity, a heavy box flies into a block of small ones. */
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static void fill(scene *s, int size) {
    const double spacing = 0.4;
    s->gravity_y = 0;
    int columns = (int)ceil(sqrt(1.5 * size));
    int rows = (size + columns - 1) / columns;
    /* The block's height, m; the half extent of the heavy box is an eighth of it. */
    double block = spacing * rows;
    double hammer = block / 8 < 0.4 ? 0.4 : block / 8;
    scene_body *body = scene_add_body(s, SCENE_DYNAMIC, -5 - hammer, 0);
    body->vx = 40;
    scene_add_obb(s, hammer, hammer)->material.density = 8;
    for (int i = 0; i < size; i++)
        scene_dynamic_box(s, (i % columns + 0.5) * spacing,
                          (i / columns - 0.5 * (rows - 1)) * spacing, 0.5 * spacing, 0.5 * spacing);
    s->camera_x = 0.4 * spacing * columns;
    s->camera_height = 1.8 * block + 10;
    s->spawn_x = -10;
}

const scene_info scene_smash = {SCENE_FACTS(smash), .place = 60, .max_size = 1000000, .fill = fill};
