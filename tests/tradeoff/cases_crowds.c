/* cases_crowds.c: cases with many moving bodies. Their paths are chaotic, so the errors are overlap
 * and the drift of energy. */
#include "case.h"
#include "random.h"

#include <math.h>
#include <stdio.h>

/* Scale: metres of the measured profile for a metre of the scene, in both directions, so that
 * slopes are kept. */
static const double SHRINK = 50;
enum { PROFILE_MAX = 96 };

/* Reads the first samples of a measured profile, see assets/terrain/README.md. Returns their
 * number; 0, with a line on stderr, if the file cannot be read. */
static int read_profile(scene_point *points) {
    FILE *file = fopen(THUD_TERRAIN_PROFILE, "r");
    double east, elevation;
    int count = 0;
    if (file && fscanf(file, "%*[^\n]") == 0)
        while (count < PROFILE_MAX && fscanf(file, "%lf,%lf", &east, &elevation) == 2)
            points[count++] = (scene_point){east / SHRINK, elevation / SHRINK};
    if (file)
        fclose(file);
    if (count < 2)
        fprintf(stderr, "thud-tradeoff: cannot read %s\n", THUD_TERRAIN_PROFILE);
    return count < 2 ? 0 : count;
}

static bool fill_rubble(scene *s, int size) {
    scene_point points[PROFILE_MAX];
    int count = read_profile(points);
    if (count == 0)
        return false;
    double left = points[0].x, right = points[count - 1].x, top = 0;
    for (int i = 0; i < count; i++)
        top = fmax(top, points[i].y);
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_irregular(s, points, count);
    scene_static_box(s, left - 1, top, 1, 40);
    scene_static_box(s, right + 1, top, 1, 40);
    scene_random random = {5};
    const double spacing = 1.6;
    int columns = (int)((right - left) / spacing) - 1;
    for (int i = 0; i < size; i++) {
        double x = left + (i % columns + 1) * spacing, y = top + (i / columns + 1) * spacing;
        double hx = scene_random_range(&random, 0.25, 0.5);
        double hy = scene_random_range(&random, 0.25, 0.5);
        double angle = scene_random_range(&random, -3, 3);
        if (i % 2 == 0)
            scene_dynamic_circle(s, x, y, hx);
        else
            scene_dynamic_box(s, x, y, hx, hy)->angle = angle;
    }
    return !s->failed;
}

static double energy_drift(const sighting *now) {
    return fabs(now->score.energy / now->start->energy - 1);
}

const tradeoff_case case_rubble = {
    .name = "rubble",
    .title = "Rubble on terrain",
    .about =
        "Circles and boxes fall on a real terrain profile and roll into its valleys, for 10 s.",
    .error = "deepest overlap of a step, on average",
    .unit = "m",
    .size = 400,
    .quick_size = 60,
    .steps = 600,
    .quick_steps = 180,
    .floor = 1e-4,
    .chance = 1.2,
    .fold = CASE_MEAN,
    .fill = fill_rubble,
    .error_of = case_deepest_overlap,
};

const tradeoff_case case_pit = {
    .name = "pit",
    .title = "Dense pit",
    .about = "A thousand circles of many sizes fall into a pit and settle into a heap, for 10 s.",
    .error = "deepest overlap of a step, on average",
    .unit = "m",
    .size = 1000,
    .quick_size = 80,
    .steps = 600,
    .quick_steps = 180,
    .floor = 1e-4,
    .chance = 1.2,
    .fold = CASE_MEAN,
    .built_in = &scene_circle_pit,
    .error_of = case_deepest_overlap,
};

const tradeoff_case case_gas = {
    .name = "gas",
    .title = "Elastic gas",
    .about = "A hundred elastic circles fly about in a closed box for 60 s.",
    .error = "energy drift",
    .unit = "",
    .size = 100,
    .quick_size = 30,
    .steps = 3600,
    .quick_steps = 120,
    .floor = 1e-6,
    .chance = 1.2,
    .fold = CASE_WORST,
    .built_in = &scene_gas,
    .error_of = energy_drift,
};
