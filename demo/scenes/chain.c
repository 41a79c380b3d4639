/* chain.c: a chain of `size` links, horizontal at the start, with a ball of 10,000 times a link's
 * mass at its end, which swings without end.
 *
 * Bodies: the hook, the links from left to right, the ball. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static void fill(scene *s, int size) {
    const double length = 0.5, half = 0.06, pi = 3.141592653589793;
    double reach = length * size;
    /* m; grows with the chain's length, so that the ball stays in proportion to it */
    double radius = 0.4 + 0.04 * reach;
    int hook = s->body_count;
    scene_static_box(s, 0, 0.5, 0.5, 0.5);
    int before = hook, link = hook;
    for (int i = 0; i < size; i++) {
        scene_point a = {i * length, 0}, b = {(i + 1) * length, 0};
        link = part_bar(s, a, b, half, 0);
        part_hinge(s, before, link, a);
        before = link;
    }
    double mass = part_mass(s, link);
    s->material.density = 10000 * mass / (pi * radius * radius);
    int ball = part_circle(s, reach + radius, 0, radius);
    part_hinge(s, before, ball, (scene_point){reach, 0});
    part_keep_apart(s, hook, -1);
    s->camera_y = -0.44 * reach - 1;
    s->camera_height = 1.32 * reach + 4;
    s->camera_width = 2.3 * reach;
    s->spawn_y = -0.3 * reach;
}

const scene_info scene_chain = {SCENE_FACTS(chain), .place = 220, .fill = fill};
