/* sizes.c: bodies of 0.05 to 20 m in one heap; half as many with each doubling of the size, as in
 * natural rubble. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* A random half extent from 0.025 to 10 m: an octave, each half as likely as the one below, and
 * uniform within it. */
static double random_half(scene_random *random) {
    double octave = 0.025;
    while (octave < 5 && scene_random_range(random, 0, 1) < 0.5)
        octave *= 2;
    double half = octave * scene_random_range(random, 1, 2);
    return half > 10 ? 10 : half;
}

static void fill(scene *s, int size) {
    double half_width = 2.5 * sqrt(size);
    if (half_width < 25)
        half_width = 25;
    scene_random random = {5};
    double x = -half_width, y = 0, row_height = 0;
    double top = 0;
    for (int i = 0; i < size; i++) {
        double half = random_half(&random);
        double reach = 1.5 * half; /* more than the radius of the circle around a rotated square */
        double angle = scene_random_range(&random, -3, 3);
        if (x + 2 * reach > half_width) {
            x = -half_width;
            y += row_height;
            row_height = 0;
        }
        double center_x = x + reach, center_y = y + reach;
        if (i % 3 == 0) {
            scene_dynamic_circle(s, center_x, center_y, half);
        } else if (i % 3 == 1) {
            scene_dynamic_box(s, center_x, center_y, half, half)->angle = angle;
        } else {
            scene_add_body(s, SCENE_DYNAMIC, center_x, center_y);
            scene_add_aabb(s, half, half);
        }
        x += 2 * reach;
        row_height = row_height > 2 * reach ? row_height : 2 * reach;
        top = y + row_height;
    }
    scene_static_box(s, 0, -2, half_width + 4, 2);
    scene_static_box(s, -half_width - 2, 0.5 * top, 2, 0.5 * top);
    scene_static_box(s, half_width + 2, 0.5 * top, 2, 0.5 * top);
    s->camera_y = 0.35 * top;
    s->camera_height = top;
    s->spawn_y = top;
}

const scene_info scene_sizes = {SCENE_FACTS(sizes), .place = 140, .fill = fill};
