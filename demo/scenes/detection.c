/* detection.c: the four kinds of collision detection beside each other, in a lane each.
 *
 * At the top of a lane three bullets fly up and down between floor and ceiling, with two thin walls
 * in their path; below them is a gas of elastic circles. The lanes differ only in the detection of
 * their bodies. */
#include "gas.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

enum { LANES = 4, BULLETS = 3, WALLS = 2 };

/* m/s. A bullet moves by up to 0.75 m a step: further than its diameter plus the thickness of a
 * thin wall, but less than half the thickness of floor and ceiling, so that discrete detection
 * pushes it back inside. */
static const double SPEEDS[BULLETS] = {12, 24, 45};
/* Radius of a bullet, half the thickness of a thin wall, distance of thin walls, half the width of
 * a pillar, m. */
static const double RADIUS = 0.12, THIN = 0.02, STOREY = 3, PILLAR = 0.5;

/* Adds floor, ceiling and the slab between, through all lanes, and the pillars that separate the
 * lanes. */
static void add_house(scene *s, double half, double range) {
    double pitch = 2 * (half + PILLAR), end = 0.5 * LANES * pitch + PILLAR;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    scene_static_box(s, 0, -half - 1, end, 1);
    scene_static_box(s, 0, half + 1, end, 1);
    scene_static_box(s, 0, half + 3 + range, end, 1);
    for (int i = 0; i <= LANES; i++) {
        scene_static_box(s, (i - 0.5 * LANES) * pitch, 0, PILLAR, half);
        scene_static_box(s, (i - 0.5 * LANES) * pitch, half + 2 + 0.5 * range, PILLAR, 0.5 * range);
    }
}

/* Adds the thin walls and bullets of a lane, from x - half to x + half, above `floor`. The bullets
 * fly side by side and do not meet. */
static void add_range(scene *s, double x, double half, double floor) {
    for (int i = 1; i <= WALLS; i++)
        scene_static_box(s, x, floor + i * STOREY, half, THIN);
    for (int i = 0; i < BULLETS; i++) {
        double side = 2 * half * (i + 1) / (BULLETS + 1) - half;
        scene_body *bullet = scene_dynamic_circle(s, x + side, floor + 0.5 * STOREY, RADIUS);
        bullet->vy = SPEEDS[i];
        bullet->may_sleep = false;
    }
}

static void fill(scene *s, int size) {
    const scene_detection detections[LANES] = {SCENE_OVERLAP, SCENE_CONTINUOUS, SCENE_BISECT,
                                               SCENE_SWEPT};
    double half = scene_gas_half(size), range = (WALLS + 1) * STOREY;
    s->gravity_y = 0;
    s->show = SCENE_SHOW_MOTIONS;
    add_house(s, half, range);
    for (int i = 0; i < LANES; i++) {
        double x = (i - 0.5 * (LANES - 1)) * 2 * (half + PILLAR);
        int first = s->body_count;
        scene_add_gas_circles(s, x, 0, size);
        add_range(s, x, half, half + 2);
        for (int k = first; k < s->body_count; k++)
            s->bodies[k].detection = detections[i];
    }
    double height = 2 * half + 6 + range, width = 2 * LANES * (half + PILLAR) + 2;
    s->camera_y = 0.5 * height - half - 2;
    s->camera_height = fmax(1.2 * height, 0.8 * width);
    s->spawn_y = s->camera_y;
}

const scene_info scene_detection_lanes = {SCENE_FACTS(detection), .place = 180, .fill = fill};
