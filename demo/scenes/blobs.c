/* blobs.c: soft balls: twelve circles around a hub, connected to the hub and to each other by
 * springs (distance joints), whose stiffness is given as a frequency.
 *
 * Bodies: floor and two walls; then for each blob its hub and the circles around it. */
#include "parts.h"
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

/* Circles around a hub. */
enum { RIM = 12 };

/* Unit vectors at the twelfths of a turn. */
static const scene_point ROUND[RIM] = {
    {1, 0},  {0.8660254037844386, 0.5},   {0.5, 0.8660254037844386},
    {0, 1},  {-0.5, 0.8660254037844386},  {-0.8660254037844386, 0.5},
    {-1, 0}, {-0.8660254037844386, -0.5}, {-0.5, -0.8660254037844386},
    {0, -1}, {0.5, -0.8660254037844386},  {0.8660254037844386, -0.5}};

/* Connects the centres of two bodies by a spring; `frequency` in Hz. */
static void spring(scene *s, int a, int b, double frequency) {
    if (s->failed)
        return;
    const scene_body *from = &s->bodies[a], *to = &s->bodies[b];
    scene_joint *joint = scene_tie_distance(s, a, b, from->x, from->y, to->x, to->y);
    joint->drive[SCENE_ALONG].frequency = frequency;
    joint->drive[SCENE_ALONG].damping = 0.3;
    joint->drive[SCENE_ALONG].target = joint->length;
    /* A blob whose springs were compressed to nothing would turn inside out. */
    joint->drive[SCENE_ALONG].limited = true;
    joint->drive[SCENE_ALONG].lower = 0.4 * joint->length;
    joint->drive[SCENE_ALONG].upper = 1.6 * joint->length;
}

/* The shapes of one blob do not collide with each other. */
static void add_blob(scene *s, double x, double y, double radius, double frequency, int number) {
    int hub = part_circle(s, x, y, 0.3 * radius);
    for (int i = 0; i < RIM; i++) {
        int rim = part_circle(s, x + radius * ROUND[i].x, y + radius * ROUND[i].y, 0.26 * radius);
        spring(s, hub, rim, frequency);
    }
    for (int i = 0; i < RIM; i++)
        spring(s, hub + 1 + i, hub + 1 + (i + 1) % RIM, 1.5 * frequency);
    part_keep_apart(s, hub, -1 - number);
}

static void fill(scene *s, int size) {
    scene_random random = {7};
    const double half_width = 9;
    s->material = (scene_material){.density = 1, .friction = 0.5};
    scene_static_box(s, 0, -1, half_width + 2, 1);
    scene_static_box(s, -half_width - 1, 7, 1, 7);
    scene_static_box(s, half_width + 1, 7, 1, 7);
    for (int i = 0; i < size; i++) {
        double x = 3.4 * (i % 5 - 2) + scene_random_range(&random, -0.3, 0.3);
        double y = 2.2 + 3.4 * (i / 5);
        double radius = scene_random_range(&random, 0.8, 1.2);
        double frequency = scene_random_range(&random, 6, 11);
        add_blob(s, x, y, radius, frequency, i);
    }
    s->camera_y = 7.5;
    s->camera_height = 19;
    s->spawn_y = 16;
}

const scene_info scene_blobs = {SCENE_FACTS(blobs), .place = 310, .fill = fill};
