/* one_spot.c: many bodies in one spot of a world 10 km wide. A grid of fixed size over the whole
 * world would have all of them in a single cell. */
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static void fill(scene *s, int size) {
    const double spacing = 0.6;
    scene_static_box(s, 0, -1, 5000, 1);
    for (int side = -1; side <= 1; side += 2)
        scene_dynamic_box(s, 4990.0 * side, 0.5, 0.5, 0.5);
    int columns = (int)ceil(sqrt(size));
    for (int i = 0; i < size; i++) {
        int row = i / columns;
        double x = (i % columns - 0.5 * (columns - 1) + 0.25 * (row % 2)) * spacing;
        scene_dynamic_circle(s, x, (row + 0.5) * spacing, 0.25);
    }
    s->camera_y = 0.3 * spacing * columns;
    s->camera_height = 1.3 * spacing * columns + 4;
    s->spawn_y = spacing * columns + 2;
}

const scene_info scene_one_spot = {SCENE_FACTS(one_spot), .place = 150, .max_size = 1000000,
                                   .fill = fill};
