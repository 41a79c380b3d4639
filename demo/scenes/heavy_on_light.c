/* heavy_on_light.c: boxes of density 10, 100, 1000 ... on boxes of density 1.
 *
 * Bodies: the ground; then for each density a light box and the heavy one on it; then for each
 * density a column of ten light boxes and the heavy one on top. */
#include "scene_facts.h"
#include "scenes.h"

static void add_column(scene *s, double x, int light, double ratio) {
    for (int i = 0; i < light; i++)
        scene_dynamic_box(s, x, i + 0.5, 0.5, 0.5);
    scene_add_body(s, SCENE_DYNAMIC, x, light + 0.5);
    scene_add_obb(s, 0.5, 0.5)->material.density = ratio;
}

static void fill(scene *s, int size) {
    const double spacing = 4;
    double half_width = spacing * (size + 1);
    scene_static_box(s, 0, -1, half_width, 1);
    for (int group = 0; group < 2; group++) {
        double ratio = 1;
        for (int i = 0; i < size; i++) {
            ratio *= 10;
            double x = (i + 0.5 + group * size - size) * spacing;
            add_column(s, x, group == 0 ? 1 : 10, ratio);
        }
    }
    s->camera_y = 5;
    s->camera_height = 22;
    s->spawn_y = 15;
}

const scene_info scene_heavy_on_light = {SCENE_FACTS(heavy_on_light), .place = 100, .fill = fill};
