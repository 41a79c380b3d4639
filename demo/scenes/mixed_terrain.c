/* mixed_terrain.c: circles and boxes fall on irregular terrain. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Number of heights between which the hills are interpolated. */
enum { KNOTS = 64 };

/* Smooth hills: random heights at equal distances, joined by 3 u^2 - 2 u^3. `t` is in [0, 1]. */
static double hill(const double *knots, double t) {
    double scaled = t * (KNOTS - 1);
    int i = (int)scaled;
    if (i > KNOTS - 2)
        i = KNOTS - 2;
    double u = scaled - i;
    double blend = u * u * (3 - 2 * u);
    return knots[i] + (knots[i + 1] - knots[i]) * blend;
}

/* Points 0.5 to 2 m apart (more where that would be too many points); the ground rises towards both
 * ends, so that bodies gather in the middle. */
static void add_ground(scene *s, scene_random *random, double half_width) {
    double knots[KNOTS];
    for (int i = 0; i < KNOTS; i++) {
        double off_center = 2.0 * i / (KNOTS - 1) - 1;
        knots[i] = scene_random_range(random, -3, 3) + 6 * off_center * off_center;
    }
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_point points[2048];
    int count = 0;
    double x = -half_width;
    while (x < half_width && count < 2047) {
        double t = (x + half_width) / (2 * half_width);
        points[count++] = (scene_point){x, hill(knots, t) + scene_random_range(random, -0.1, 0.1)};
        x += scene_random_range(random, 0.5, 2) * (half_width > 600 ? half_width / 600 : 1);
    }
    points[count++] = (scene_point){half_width, knots[KNOTS - 1]};
    scene_add_irregular(s, points, count);
}

static void fill(scene *s, int size) {
    const double spacing = 1.6;
    int columns = (int)(2.4 * sqrt(size)) + 1;
    double half_width = 0.5 * spacing * columns + 1;
    scene_random random = {2};
    add_ground(s, &random, half_width);
    scene_static_box(s, -half_width - 1, 20, 1, 40);
    scene_static_box(s, half_width + 1, 20, 1, 40);
    for (int i = 0; i < size; i++) {
        double x = (i % columns - 0.5 * (columns - 1)) * spacing;
        double y = 11 + i / columns * spacing;
        double hx = scene_random_range(&random, 0.25, 0.5);
        double hy = scene_random_range(&random, 0.25, 0.5);
        double angle = scene_random_range(&random, -3, 3);
        if (i % 2 == 0)
            scene_dynamic_circle(s, x, y, hx);
        else
            scene_dynamic_box(s, x, y, hx, hy)->angle = angle;
    }
    s->camera_y = 12;
    s->camera_height = 0.55 * 2 * half_width;
    s->spawn_y = 30;
}

const scene_info scene_mixed_terrain = {SCENE_FACTS(mixed_terrain), .place = 30,
                                        .max_size = 1000000, .fill = fill};
