/* wrecking_ball.c: a ball of 1,000 times a brick's mass swings on a chain into a wall.
 *
 * Bodies: the ground (flat terrain), the crane (boxes that collide with nothing), the links of the
 * chain from the jib on, the ball, the bricks row by row. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Height from which the chain hangs, and radius of the ball, m. */
static const double PIVOT = 14, RADIUS = 1.1;
enum { LINKS = 16 };

/* Adds the crane: a lattice mast, and a jib that reaches to the chain. */
static int add_crane(scene *s) {
    const double mast = -13, width = 1;
    int crane = s->body_count;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    for (int side = -1; side <= 1; side += 2)
        part_add_bar(s, (scene_point){mast + side * width, 0},
                     (scene_point){mast + side * width, PIVOT + 1}, 0.12);
    for (int i = 0; i < 7; i++) {
        double low = 2.0 * i, left = mast - width, right = mast + width;
        part_add_bar(s, (scene_point){i % 2 ? right : left, low},
                     (scene_point){i % 2 ? left : right, low + 2}, 0.06);
    }
    part_add_bar(s, (scene_point){mast - 5, PIVOT + 0.3}, (scene_point){0.3, PIVOT + 0.3}, 0.14);
    part_add_bar(s, (scene_point){mast, PIVOT + 4}, (scene_point){0, PIVOT + 0.4}, 0.06);
    part_add_bar(s, (scene_point){mast, PIVOT + 4}, (scene_point){mast - 5, PIVOT + 0.4}, 0.06);
    part_add_bar(s, (scene_point){mast, PIVOT + 1}, (scene_point){mast, PIVOT + 4}, 0.12);
    part_add_bar(s, (scene_point){mast - 4.3, PIVOT - 1.6}, (scene_point){mast - 4.3, PIVOT + 0.1},
                 0.8);
    part_keep_apart(s, crane, -1);
    for (int i = 0; !s->failed && i < s->bodies[crane].shape_count; i++)
        s->shapes[s->bodies[crane].first_shape + i].mask = PART_MEETS_NOTHING;
    return crane;
}

/* Adds chain and ball, raised to the left by 60 degrees from the vertical, clear of the mast.
 * `brick` is the mass of a brick. */
static void add_chain(scene *s, int crane, double brick) {
    const double length = 0.62, pi = 3.141592653589793;
    const double sine = 0.8660254037844386, cosine = 0.5;
    int first = s->body_count, before = crane;
    scene_point end = {0, PIVOT};
    for (int i = 0; i < LINKS; i++) {
        scene_point from = end;
        end = (scene_point){-(i + 1) * length * sine, PIVOT - (i + 1) * length * cosine};
        int link = part_bar(s, from, end, 0.09, 0);
        part_hinge(s, before, link, from);
        before = link;
    }
    s->material.density = 1000 * brick / (pi * RADIUS * RADIUS);
    int ball = part_circle(s, end.x - RADIUS * sine, end.y - RADIUS * cosine, RADIUS);
    part_hinge(s, before, ball, end);
    part_keep_apart(s, first, -1);
    for (int i = first; i < s->body_count; i++)
        s->bodies[i].may_sleep = false;
}

static void fill(scene *s, int size) {
    const double hx = 0.4, hy = 0.2, wall = 2.2;
    const int columns = 5;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_flat(s, 0);
    int crane = add_crane(s);
    add_chain(s, crane, 4 * hx * hy);
    s->material.density = 1;
    for (int i = 0; i < size; i++) {
        int row = i / columns;
        double x = wall + 2 * hx * (i % columns) + (row % 2 ? hx : 0);
        part_box(s, x, hy + 2 * hy * row, hx, hy);
    }
    s->camera_x = -3.5;
    s->camera_y = 8;
    s->camera_height = 23;
    s->camera_width = 30;
    s->spawn_x = 4;
    s->spawn_y = 16;
}

const scene_info scene_wrecking_ball = {SCENE_FACTS(wrecking_ball), .place = 230, .fill = fill};
