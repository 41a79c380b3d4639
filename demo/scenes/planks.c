/* planks.c: balls and crates under one-way planks, which they pass from below and land on from
 * above. The planks are conveyor belts, which move balls to the right and crates to the left. At
 * their ends bodies fall onto trampolines; those that fall in between land on ice and slide to the
 * trampolines. All this is done by collision rules between kinds, without callbacks.
 *
 * Bodies: walls and roof; the ice; the trampolines; the planks, from the lowest up; then balls and
 * crates alternately. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

static const double GAP = 3; /* between a plank's end and the wall, over a trampoline, m */
/* Height of the roof, m. */
static const double ROOF = 16;
/* Half the size of balls and crates, and their distance at the start, m. */
static const double HALF = 0.35, APART = 1.1;

enum { PLANKS = 2 };
/* Heights of the planks, m. */
static const double HEIGHTS[PLANKS] = {5.6, 9.2};

/* Kinds; ANY is everything else. */
enum {
    ANY = 1 << 0,
    PLANK = 1 << 1,
    ICE = 1 << 2,
    TRAMPOLINE = 1 << 3,
    BALL = 1 << 4,
    CRATE = 1 << 5
};

static void add_rules(scene *s) {
    scene_add_rule(s, PLANK, ANY | BALL, SCENE_ONE_WAY)->surface_speed = 2;
    scene_add_rule(s, PLANK, CRATE, SCENE_ONE_WAY)->surface_speed = -2;
    scene_add_rule(s, BALL | CRATE, BALL | CRATE, SCENE_IGNORE);
    scene_add_rule(s, ICE, ANY | BALL | CRATE, SCENE_COLLIDE)->friction = 0;
    scene_add_rule(s, TRAMPOLINE, ANY | BALL | CRATE, SCENE_COLLIDE)->restitution = 1.25;
}

static void add_frame(scene *s, double half) {
    for (int side = -1; side <= 1; side += 2)
        scene_static_box(s, side * (half + 0.5), 0.5 * ROOF, 0.5, 0.5 * ROOF + 2);
    scene_static_box(s, 0, ROOF + 0.5, half, 0.5);
}

/* Adds a body with two bars: one from a to b on the right, and its mirror image on the left. */
static void add_floor(scene *s, scene_point a, scene_point b, double thick, uint32_t category) {
    scene_add_body(s, SCENE_STATIC, 0, 0);
    part_add_bar(s, a, b, thick)->category = category;
    part_add_bar(s, (scene_point){-b.x, b.y}, (scene_point){-a.x, a.y}, thick)->category = category;
}

static void fill(scene *s, int size) {
    double half = 6 + 0.2 * size;
    s->material = (scene_material){.density = 1, .friction = 0.6};
    add_frame(s, half);
    add_floor(s, (scene_point){0, 0.8}, (scene_point){half - GAP, 0}, 0.8, ICE);
    add_floor(s, (scene_point){half - GAP - 0.5, -1.5}, (scene_point){half + 0.5, -0.3}, 0.6,
              TRAMPOLINE);
    for (int i = 0; i < PLANKS; i++) {
        scene_static_box(s, 0, HEIGHTS[i], half - GAP, 0.15);
        s->shapes[s->shape_count - 1].category = PLANK;
    }
    int columns = (int)(2 * (half - 1.5) / APART);
    for (int i = 0; i < size; i++) {
        double x = APART * (i % columns - 0.5 * (columns - 1));
        double y = 2.6 + 1.1 * (i / columns);
        if (i % 2 == 0)
            part_circle(s, x, y, HALF);
        else
            part_box(s, x, y, HALF, HALF);
        if (s->failed)
            return;
        s->shapes[s->shape_count - 1].category = i % 2 == 0 ? BALL : CRATE;
        s->bodies[s->body_count - 1].fixed_rotation = true; /* a ball would roll in place */
        s->bodies[s->body_count - 1].look = 1 + i % 2;
        s->bodies[s->body_count - 1].vy = 8 + 2 * (i / 2 % 4);
    }
    add_rules(s);
    s->camera_y = 7;
    s->camera_height = 20;
    s->camera_width = 2 * half + 2;
    s->spawn_y = 7;
}

const scene_info scene_planks = {SCENE_FACTS(planks), .place = 362, .fill = fill};
