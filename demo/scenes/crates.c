/* crates.c: stacks of crates, and weights that fall onto some of them. A crate breaks into four
 * pieces if the impulse of a contact exceeds the max of its rule (break_thud.h).
 *
 * Bodies: the ground, both walls; then the crates, stack by stack from the bottom; then the
 * weights. */
#include "scene_facts.h"
#include "scenes.h"

/* Half the size of a crate, and the distance of stacks, m. */
static const double HALF = 0.5, APART = 1.3;
/* kg m/s in a step: what stops a crate, which has 1 kg, after a fall of 1.8 m. */
static const double MOST = 6;
/* Of the weights, m: radius, height of the lowest, difference in height to the next. */
static const double RADIUS = 0.7, LOWEST = 8, HIGHER = 3;

/* Crates in a stack. */
enum { ROWS = 4, EVERY = 3 /* stacks for each weight */ };
/* Kinds: everything else, crates, and pieces of crates. */
enum { ANY = 1 << 0, CRATE = 1 << 1, PIECE = 1 << 2 };

static void fill(scene *s, int size) {
    int stacks = (size + ROWS - 1) / ROWS, weights = (stacks + EVERY - 1) / EVERY;
    double half = 0.5 * APART * stacks + 4, first = -0.5 * APART * (stacks - 1);
    s->material = (scene_material){.density = 1, .friction = 0.6};
    scene_static_box(s, 0, -0.5, half + 1, 0.5);
    for (int side = -1; side <= 1; side += 2)
        scene_static_box(s, side * (half + 0.5), 3, 0.5, 3);
    for (int i = 0; i < size; i++) {
        scene_dynamic_box(s, first + APART * (i / ROWS), HALF + 2 * HALF * (i % ROWS), HALF, HALF);
        if (s->failed)
            return;
        s->shapes[s->shape_count - 1].category = CRATE;
        s->bodies[s->body_count - 1].look = 1;
    }
    s->material.density = 8;
    for (int i = 0; i < weights; i++)
        scene_dynamic_circle(s, first + APART * EVERY * i + 0.3, LOWEST + HIGHER * (i % 6), RADIUS)
            ->look = 2;
    scene_add_rule(s, CRATE, ANY | CRATE | PIECE, SCENE_COLLIDE)->event_impulse = MOST;
    s->fields.breaks = CRATE;
    s->fields.pieces = PIECE;
    s->camera_y = 5;
    s->camera_height = 13;
    s->camera_width = 2 * half + 2;
    s->spawn_y = 10;
}

const scene_info scene_crates = {SCENE_FACTS(crates), .place = 364, .fill = fill};
