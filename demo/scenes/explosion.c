/* explosion.c: explosions between crates, half of which stand behind a wall. The wall shields the
 * crates behind it from the explosion, and a crate shields the next one; the crates in the open fly
 * off.
 *
 * Bodies: the ground (irregular terrain), the wall, the shelter; then the crates in pairs: one in
 * the open, on the left, and its mirror image behind the wall. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

/* Half the size of a crate, distance of stacks, distance of the first stack from the centre, m. */
static const double HALF = 0.5, APART = 1.2, NEAREST = 6;
/* Crates in a stack. */
enum { ROWS = 4 };

static void add_ground(scene *s, double half) {
    const scene_point land[] = {{-half - 31, 60}, {-half - 30, 14}, {-half - 12, 4},
                                {-half - 4, 0},   {half + 4, 0},    {half + 12, 4},
                                {half + 30, 14},  {half + 31, 60}};
    s->material = (scene_material){.density = 1, .friction = 0.6};
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_irregular(s, land, sizeof land / sizeof land[0]);
}

static void add_crate(scene *s, double x, double y, bool round) {
    if (round)
        part_circle(s, x, y, HALF);
    else
        part_box(s, x, y, HALF, HALF);
}

static void fill(scene *s, int size) {
    int pairs = (size + 1) / 2;
    double half = NEAREST + APART * (pairs / ROWS) + 4;
    add_ground(s, half);
    scene_static_box(s, 4, 2.2, 0.3, 2.2);
    scene_add_body(s, SCENE_STATIC, half, 0);
    part_add_bar(s, (scene_point){half - 2, 2.6}, (scene_point){half + 2, 2.6}, 0.2);
    part_add_bar(s, (scene_point){half - 1.8, 0}, (scene_point){half - 1.8, 2.4}, 0.2);
    for (int i = 0; i < pairs; i++) {
        double x = NEAREST + APART * (i / ROWS), y = HALF + 2 * HALF * (i % ROWS);
        bool round = i % 7 == 3;
        add_crate(s, -x, y, round);
        add_crate(s, x, y, round);
    }
    scene_add_blast(s, (scene_blast){60, 0, 0.4, 3, 14, 40});
    scene_add_blast(s, (scene_blast){240, 8, 6.5, 3, 10, 20});
    scene_add_blast(s, (scene_blast){420, -12, 0.4, 3, 12, 20});
    s->camera_y = 4.6;
    s->camera_height = 13;
    s->camera_width = 2 * half + 2;
    s->spawn_y = 9;
}

const scene_info scene_explosion = {SCENE_FACTS(explosion), .place = 360, .fill = fill};
