/* detection.c: the four ways of detection next to each other, a lane for each.
 *
 * At the top of a lane three bullets fly up and down between floor and ceiling, with two thin walls
 * in their way; below them a gas of elastic circles. All is the same in each lane but for the
 * detection that the lane's bodies choose. */
#include "gas.h"
#include "scenes.h"

#include <math.h>

enum { LANES = 4, BULLETS = 3, WALLS = 2 };

/* m/s. A bullet moves by up to 0.75 m a step: far beyond what a wall and it measure together, and
 * less than half of what floor and ceiling do, so that overlap pushes it back inside. */
static const double SPEEDS[BULLETS] = {12, 24, 45};
static const double RADIUS = 0.12, THIN = 0.02, STOREY = 3;

/* Between x - half and x + half, standing on `floor`. Bullets keep clear of each other. */
static void add_range(scene *s, double x, double half, double floor, scene_detection detection) {
    double top = floor + (WALLS + 1) * STOREY;
    scene_static_box(s, x, top + 1, half + 2, 1);
    scene_static_box(s, x - half - 1, 0.5 * (floor + top), 1, 0.5 * (top - floor));
    scene_static_box(s, x + half + 1, 0.5 * (floor + top), 1, 0.5 * (top - floor));
    for (int i = 1; i <= WALLS; i++)
        scene_static_box(s, x, floor + i * STOREY, half, THIN);
    for (int i = 0; i < BULLETS; i++) {
        double side = 2 * half * (i + 1) / (BULLETS + 1) - half;
        scene_body *bullet = scene_dynamic_circle(s, x + side, floor + 0.5 * STOREY, RADIUS);
        bullet->vy = SPEEDS[i];
        bullet->may_sleep = false;
        bullet->detection = detection;
    }
}

static void fill(scene *s, int size) {
    const scene_detection detections[LANES] = {SCENE_OVERLAP, SCENE_CONTINUOUS, SCENE_BISECT,
                                               SCENE_SWEPT};
    s->gravity_y = 0;
    s->show = SCENE_SHOW_MOTIONS;
    double half = scene_gas_half(size);
    for (int i = 0; i < LANES; i++) {
        double x = (i - 0.5 * (LANES - 1)) * (2 * half + 2);
        int first = s->body_count;
        scene_add_gas(s, x, 0, size);
        for (int k = first; k < s->body_count; k++)
            s->bodies[k].detection = detections[i];
        add_range(s, x, half, half + 2, detections[i]);
    }
    double height = 2 * half + 6 + (WALLS + 1) * STOREY, width = LANES * (2 * half + 2) + 2;
    s->camera_y = 0.5 * height - half - 2;
    s->camera_height = fmax(1.15 * height, 0.8 * width);
    s->spawn_y = s->camera_y;
}

const scene_info scene_detection_lanes = {
    .name = "detection",
    .title = "Four ways of detection",
    .about =
        "From left to right: overlap, continuous, bisect, swept. Bullets pass thin walls on the "
        "first and third.",
    .size_means = "circles of each gas",
    .default_size = 16,
    .min_size = 4,
    .max_size = 10000,
    .fill = fill,
};
