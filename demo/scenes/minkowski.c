/* minkowski.c: pairs of shapes that a user drags, each pair drawn with its Minkowski sum.
 *
 * The two shapes of a pair do not collide. They overlap where the second's centre is inside of the
 * sum, which is drawn about the first's centre. */
#include "scene_facts.h"
#include "scenes.h"

static void add_shape(scene *s, double x, double y, double hx, double hy, double angle) {
    scene_body *body = scene_add_body(s, SCENE_DYNAMIC, x, y);
    body->angle = angle;
    body->may_sleep = false;
    body->linear_damping = body->angular_damping = 6; /* 1/s: stops it where it is left */
    scene_shape *shape = hy > 0 ? scene_add_obb(s, hx, hy) : scene_add_circle(s, hx);
    shape->group = -1;
}

static void fill(scene *s, int size) {
    const double row = 8;
    s->gravity_y = 0;
    s->sum_pairs = size;
    for (int i = 0; i < size; i++) {
        double y = (0.5 * (size - 1) - i) * row;
        add_shape(s, -0.8, y, 1.5, 0.8, i % 3 == 2 ? 0 : 0.3);
        if (i % 3 == 0)
            add_shape(s, 2.3, y + 2, 1, 0.6, -0.4);
        else
            add_shape(s, 2.3, y + 2, 0.8, 0, 0);
    }
    s->camera_x = 0.4;
    s->camera_height = row * size + 1;
    s->spawn_x = 6;
}

const scene_info scene_minkowski = {SCENE_FACTS(minkowski), .place = 190, .fill = fill};
