/* ragdolls.c: dolls of eleven bodies and ten hinges, with the limits of human joints, fall down a
 * flight of stairs.
 *
 * Bodies: the ground (flat terrain), the steps from the top down; then for each doll head, chest,
 * hips, and for either side upper arm, forearm, thigh, shin. */
#include "parts.h"
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

enum { STEPS = 9 };
/* Width and height of a step, m. */
static const double RUN = 1.35, RISE = 0.62;

/* Hinges b to a at (x, y), with limits in radians relative to the standing doll. */
static void limb(scene *s, int a, int b, double x, double y, double lower, double upper) {
    scene_joint *joint = part_hinge(s, a, b, (scene_point){x, y});
    scene_drive *turn = &joint->drive[SCENE_TURN];
    turn->limited = true;
    turn->lower = lower;
    turn->upper = upper;
    /* A weak spring: muscles with some tension. */
    turn->frequency = 0.5;
    turn->damping = 1;
    turn->target = 0;
}

/* Adds a doll that stands upright with its feet at (x, y), seen from the side and facing right. */
static void add_doll(scene *s, double x, double y, double speed, int number) {
    int first = s->body_count;
    int head = part_circle(s, x, y + 1.83, 0.17);
    int chest = part_box(s, x, y + 1.4, 0.15, 0.24);
    int hips = part_box(s, x, y + 1.02, 0.14, 0.14);
    limb(s, chest, head, x, y + 1.65, -0.5, 0.6);
    limb(s, chest, hips, x, y + 1.16, -0.3, 0.7);
    for (int side = 0; side < 2; side++) {
        int upper_arm = part_box(s, x, y + 1.42, 0.055, 0.18);
        int forearm = part_box(s, x, y + 1.06, 0.05, 0.18);
        int thigh = part_box(s, x, y + 0.71, 0.08, 0.23);
        int shin = part_box(s, x, y + 0.24, 0.065, 0.24);
        limb(s, chest, upper_arm, x, y + 1.58, -0.7, 2.6);
        limb(s, upper_arm, forearm, x, y + 1.24, 0, 2.4);
        limb(s, hips, thigh, x, y + 0.92, -0.4, 1.9);
        limb(s, thigh, shin, x, y + 0.48, -2.3, 0);
    }
    part_keep_apart(s, first, -1 - number);
    for (int i = first; i < s->body_count; i++)
        s->bodies[i].vx = speed;
}

static void fill(scene *s, int size) {
    scene_random random = {1};
    s->material = (scene_material){.density = 1, .friction = 0.5};
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_flat(s, 0);
    for (int i = 0; i < STEPS; i++) {
        double high = 0.5 * RISE * (STEPS - i);
        scene_static_box(s, (i - 0.5 * STEPS + 0.5) * RUN - 1.5, high, 0.5 * RUN, high);
    }
    scene_static_box(s, -0.5 * STEPS * RUN - 4.5, 0.5 * RISE * STEPS + 0.5, 3,
                     0.5 * RISE * STEPS + 0.5);
    double top = RISE * STEPS + 0.4;
    s->material.density = 60;
    for (int i = 0; i < size; i++) {
        int row = i / 5;
        double x = (i % 5 - 0.5 * STEPS) * RUN - 1.2 + scene_random_range(&random, -0.2, 0.2);
        add_doll(s, x, top + 2.6 * row, scene_random_range(&random, 1, 2.5), i);
    }
    s->camera_x = -0.5;
    s->camera_y = 5;
    s->camera_height = 13;
    s->camera_width = 18;
    s->spawn_x = -4;
    s->spawn_y = 11;
}

const scene_info scene_ragdolls = {SCENE_FACTS(ragdolls), .place = 240, .fill = fill};
