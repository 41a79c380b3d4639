/* cases_stacks.c: cases with stacks that should stand still; each movement is an error. */
#include "case.h"

#include <math.h>

/* The change in height of the topmost box, the last body, m; higher is as wrong as lower. */
static double height_lost(const sighting *now) {
    int top = now->scene->body_count - 1;
    return fabs(now->bodies[top].y - now->scene->bodies[top].y);
}

static double furthest_moved(const sighting *now) {
    double furthest = 0;
    for (int i = 0; i < now->scene->body_count; i++) {
        const scene_body *start = &now->scene->bodies[i];
        furthest = fmax(furthest, hypot(now->bodies[i].x - start->x, now->bodies[i].y - start->y));
    }
    return furthest;
}

const tradeoff_case case_column_30 = {
    .name = "column_30",
    .title = "Column of 30",
    .about = "Thirty boxes of 1 m stand on each other for 20 s.",
    .error = "height lost",
    .unit = "m",
    .size = 30,
    .quick_size = 10,
    .steps = 1200,
    .quick_steps = 120,
    .floor = 1e-5,
    .chance = 1,
    .fold = CASE_WORST,
    .built_in = &scene_tall_stack,
    .error_of = height_lost,
};

const tradeoff_case case_column_100 = {
    .name = "column_100",
    .title = "Column of 100",
    .about = "A hundred boxes of 1 m stand on each other for 20 s.",
    .error = "height lost",
    .unit = "m",
    .size = 100,
    .quick_size = 30,
    .steps = 1200,
    .quick_steps = 120,
    .floor = 1e-5,
    .chance = 1,
    .fold = CASE_WORST,
    .built_in = &scene_tall_stack,
    .error_of = height_lost,
};

const tradeoff_case case_pyramid = {
    .name = "pyramid",
    .title = "Pyramid",
    .about = "A pyramid of boxes of 1 m, 30 in its lowest row, stands for 10 s.",
    .error = "furthest that a box moved",
    .unit = "m",
    .size = 30,
    .quick_size = 6,
    .steps = 600,
    .quick_steps = 60,
    .floor = 1e-5,
    .chance = 1,
    .fold = CASE_WORST,
    .built_in = &scene_pyramid,
    .error_of = furthest_moved,
};

const tradeoff_case case_heavy_on_light = {
    .name = "heavy_on_light",
    .title = "Heavy on light",
    .about =
        "Boxes of 1 m, 10, 100 and 1,000 times as heavy, stand for 10 s on a light box, and on "
        "columns of ten.",
    .error = "deepest overlap",
    .unit = "m",
    .size = 3,
    .quick_size = 2,
    .steps = 600,
    .quick_steps = 60,
    .floor = 1e-5,
    .chance = 1,
    .fold = CASE_WORST,
    .built_in = &scene_heavy_on_light,
    .error_of = case_deepest_overlap,
};
