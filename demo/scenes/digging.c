/* digging.c: boxes and balls on a real hillside, in which a user digs.
 *
 * The ground consists of samples 60 to 180 of assets/terrain/jacksboro_200.csv (Tennessee), which
 * are 74.4 m apart there and 1 m apart in the scene; heights are exaggerated by 1.5. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Metres above sea level. */
static const short ELEVATION[] = {
    545, 561, 573, 565, 568, 576, 574, 562, 544, 527, 502, 479, 461, 441, 419, 397, 386, 386,
    400, 413, 421, 433, 445, 461, 477, 494, 518, 542, 565, 584, 591, 591, 599, 616, 637, 654,
    665, 663, 649, 625, 616, 606, 607, 598, 576, 548, 515, 496, 519, 552, 580, 606, 611, 604,
    611, 612, 613, 608, 590, 583, 593, 583, 564, 554, 551, 546, 544, 548, 558, 573, 595, 625,
    649, 657, 646, 657, 658, 660, 665, 675, 692, 715, 739, 759, 782, 812, 841, 863, 882, 898,
    893, 870, 842, 817, 790, 763, 750, 767, 795, 825, 855, 881, 914, 948, 974, 985, 990, 991,
    994, 996, 992, 975, 942, 902, 868, 832, 799, 759, 741, 720, 683,
};

enum {
    SAMPLES = sizeof ELEVATION / sizeof ELEVATION[0],
    FINER = 4, /* vertices from one sample to the next, so that craters are round */
    VERTICES = (SAMPLES - 1) * FINER + 1,
    LOWEST = 386 /* m: the smallest sample */
};

static const double RISE = 1.5 / 74.4; /* metres of height in the scene for a real metre */

static void add_ground(scene *s) {
    double heights[VERTICES];
    for (int i = 0; i < VERTICES; i++) {
        int sample = i / FINER < SAMPLES - 1 ? i / FINER : SAMPLES - 2;
        double share = (double)(i - sample * FINER) / FINER;
        double metres = ELEVATION[sample] + share * (ELEVATION[sample + 1] - ELEVATION[sample]);
        heights[i] = (metres - LOWEST) * RISE;
    }
    s->material.friction = 0.9;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_uniform(s, -0.5 * (SAMPLES - 1), 1.0 / FINER, heights, VERTICES);
}

/* Adds a wall at each end of the ground. */
static void add_walls(scene *s) {
    double x = 0.5 * (SAMPLES - 1) + 1;
    scene_static_box(s, -x, 20, 1, 40);
    scene_static_box(s, x, 20, 1, 40);
}

static void fill(scene *s, int size) {
    const double spacing = 1.45; /* m; more than the diagonal of the largest box */
    int columns = (int)((SAMPLES - 3) / spacing);
    scene_random random = {5};
    add_ground(s);
    add_walls(s);
    for (int i = 0; i < size; i++) {
        int column = i % columns;
        double x = (column - 0.5 * (columns - 1)) * spacing;
        int sample = (int)(x + 0.5 * SAMPLES);
        double ground = (ELEVATION[sample] - LOWEST) * RISE;
        double y = ground + 1.5 + i / columns * spacing;
        double hx = scene_random_range(&random, 0.25, 0.5);
        double hy = scene_random_range(&random, 0.25, 0.5);
        if (scene_random_range(&random, 0, 1) < 0.35)
            scene_dynamic_circle(s, x, y, hx);
        else
            scene_dynamic_box(s, x, y, hx, hy);
    }
    s->camera_x = -30;
    s->camera_y = 5;
    s->camera_height = 30;
    s->spawn_x = -30;
    s->spawn_y = 18;
}

const scene_info scene_digging = {SCENE_FACTS(digging), .place = 170, .max_size = 100000,
                                  .fill = fill};
