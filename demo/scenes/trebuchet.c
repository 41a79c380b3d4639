/* trebuchet.c: a trebuchet throws a stone at a tower. The sling is a distance joint that breaks at
 * a force, which releases the stone.
 *
 * Bodies: the ground (flat terrain), the trestle (which collides with nothing), the arm, its
 * counterweight, the stone, the bricks of the tower row by row. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Height of the axle, long and short end of the arm, length of the sling, radius of the stone, m.
 */
static const double AXLE = 5.2, LONG = 6.4, SHORT = 1.5, SLING = 2.4, STONE = 0.32;

static int add_trestle(scene *s, double x) {
    int trestle = s->body_count;
    scene_point top = {x, AXLE};
    scene_add_body(s, SCENE_STATIC, x, 0);
    part_add_bar(s, (scene_point){x - 2.4, 0}, top, 0.14);
    part_add_bar(s, (scene_point){x + 2.4, 0}, top, 0.14);
    part_add_bar(s, (scene_point){x - 1.5, 2}, (scene_point){x + 1.5, 2}, 0.1);
    for (int i = 0; !s->failed && i < s->bodies[trestle].shape_count; i++)
        s->shapes[s->bodies[trestle].first_shape + i].mask = PART_MEETS_NOTHING;
    return trestle;
}

/* Adds the trebuchet with its axle at x, loaded: the arm's long end points down to the left, to
 * just above the ground, and the stone lies to the right of it. */
static void add_engine(scene *s, double x) {
    const double low = 0.6;
    int trestle = add_trestle(s, x);
    double fall = (AXLE - low) / LONG, run = sqrt(1 - fall * fall);
    scene_point tip = {x - LONG * run, low};
    scene_point butt = {x + SHORT * run, AXLE + SHORT * fall};
    s->material.density = 60;
    int arm = part_bar(s, tip, butt, 0.13, 0);
    part_hinge(s, trestle, arm, (scene_point){x, AXLE});
    s->material.density = 1220;
    int weight = part_box(s, butt.x, butt.y - 1.3, 0.75, 0.75);
    s->material.density = 60;
    part_add_bar(s, (scene_point){butt.x, butt.y - 0.6}, butt, 0.08);
    part_hinge(s, arm, weight, butt);
    s->material = (scene_material){.density = 250, .friction = 0.2};
    double drop = low - STONE;
    double beside = sqrt(SLING * SLING - drop * drop);
    int stone = part_circle(s, tip.x + beside, STONE, STONE);
    scene_joint *sling = scene_tie_distance(s, arm, stone, tip.x, tip.y, tip.x + beside, STONE);
    sling->drive[SCENE_ALONG].limited = true;
    sling->drive[SCENE_ALONG].upper = sling->length;
    sling->break_force = 6900; /* N; decides at which angle the stone is released. Chosen */
    part_keep_apart(s, trestle, -1);
}

static void add_tower(scene *s, double x, int size) {
    const double hx = 0.5, hy = 0.4;
    const int columns = 4;
    s->material = (scene_material){.density = 20, .friction = 0.7};
    for (int i = 0; i < size; i++) {
        int row = i / columns;
        part_box(s, x + 2 * hx * (i % columns) + (row % 2 ? 0.5 * hx : 0), hy + 2 * hy * row, hx,
                 hy);
    }
}

static void fill(scene *s, int size) {
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_flat(s, 0);
    add_engine(s, -22);
    add_tower(s, 17.6, size);
    s->camera_x = 2;
    s->camera_y = 11;
    s->camera_height = 38;
    s->camera_width = 62;
    s->spawn_y = 12;
}

const scene_info scene_trebuchet = {SCENE_FACTS(trebuchet), .place = 260, .fill = fill};
