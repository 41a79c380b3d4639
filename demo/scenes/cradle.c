/* cradle.c: Newton's cradle without strings: touching circles in a row, without gravity.
 *
 * Bodies: two walls; then three rows of `size` circles of radius 0.5, from left to right. In row k
 * (1, 2, 3, from the top) the first k circles start apart and fly in at 5 m/s; the others rest. As
 * many should leave at that speed on the other side, bounce off the wall, and so on without end. */
#include "scene_facts.h"
#include "scenes.h"

static void fill(scene *s, int size) {
    const double gap = 6;
    double half_width = 0.5 * size + 2 * gap;
    s->gravity_y = 0;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    scene_static_box(s, -half_width - 1, 0, 1, 8);
    scene_static_box(s, half_width + 1, 0, 1, 8);
    for (int row = 1; row <= 3; row++) {
        for (int i = 0; i < size; i++) {
            bool flying = i < row;
            double x = i - 0.5 * (size - 1) - (flying ? gap : 0);
            scene_body *body = scene_dynamic_circle(s, x, 4.0 * (2 - row), 0.5);
            body->vx = flying ? 5 : 0;
            body->may_sleep = false;
        }
    }
    s->camera_height = 20;
    s->spawn_y = 6;
}

const scene_info scene_cradle = {SCENE_FACTS(cradle), .place = 110, .fill = fill};
