/* extra_scenes.c: scenes for measurements only, not shown in the viewer or on the page. */
#include "plan.h"
#include "random.h"

#include <math.h>

/* Layers of bodies in a trough. The heap has the same depth at every size, so that times per body
 * can be compared. */
static void fill_rubble(scene *s, int size) {
    enum { LAYERS = 10, FLOOR_MOST = 16000 };
    const double spacing = 1.1;
    int columns = (size + LAYERS - 1) / LAYERS;
    double half_width = 0.5 * spacing * columns + 1;
    /* A shape has a greatest size: the floor of a million bodies is of several boxes. */
    int floors = (int)ceil(half_width / FLOOR_MOST);
    for (int i = 0; i < floors; i++) {
        double half = (half_width + 1) / floors;
        scene_static_box(s, (2 * i + 1 - floors) * half, -1, half, 1);
    }
    scene_static_box(s, -half_width - 1, 10, 1, 10);
    scene_static_box(s, half_width + 1, 10, 1, 10);
    scene_random random = {7};
    for (int i = 0; i < size; i++) {
        double x = (i / LAYERS - 0.5 * (columns - 1)) * spacing;
        double y = (i % LAYERS + 0.6) * spacing;
        double a = scene_random_range(&random, 0.2, 0.5), b = scene_random_range(&random, 0.2, 0.5);
        if (i % 2)
            scene_dynamic_circle(s, x, y, a);
        else
            scene_dynamic_box(s, x, y, a, b);
    }
}

const scene_info bench_rubble = {
    .name = "rubble",
    .title = "Rubble",
    .about = "Boxes and circles fall ten deep on a floor as wide as it takes.",
    .size_means = "bodies",
    .default_size = 4000,
    .min_size = 1,
    .max_size = 1000000,
    .fill = fill_rubble,
};

/* Circles of radius 0.25 with centres in a square of 5 by 5 m: about twenty overlap at each point.
 */
static void fill_overlapping(scene *s, int size) {
    scene_static_box(s, 0, -1, 5000, 1);
    scene_random random = {3};
    double half = 2.5 * sqrt(size / 4000.0);
    for (int i = 0; i < size; i++) {
        double x = scene_random_range(&random, -half, half);
        double y = scene_random_range(&random, -half, half) + half + 0.3;
        scene_dynamic_circle(s, x, y, 0.25);
    }
}

const scene_info bench_overlapping = {
    .name = "overlapping",
    .title = "All inside each other",
    .about = "A crowd that starts where no crowd can be: every circle overlaps some thirty others.",
    .size_means = "circles",
    .default_size = 4000,
    .min_size = 1,
    .max_size = 100000,
    .fill = fill_overlapping,
};
