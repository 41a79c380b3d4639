/* slopes.c: discs that roll and boxes that slide down slopes of 10, 20, 30 and 40 degrees, and out
 * onto a level plain.
 *
 * Bodies: the plain (flat terrain at height 0); then for each slope its ramp (irregular terrain), a
 * disc, and a box with friction 0.5 on friction 0.5, which begins to slide at 26.6 degrees. */
#include "scene_facts.h"
#include "scenes.h"

typedef struct slope {
    double run, rise; /* cosine and sine of the slope: the direction downhill is (run, -rise) */
} slope;

/* Unit vectors, rounded to double. */
static const slope SLOPES[] = {
    {0.98480775301220806, 0.17364817766693035}, /* 10 degrees */
    {0.93969262078590839, 0.34202014332566873}, /* 20 */
    {0.86602540378443865, 0.5},                 /* 30 */
    {0.76604444311897804, 0.64278760968653933}, /* 40 */
};
static const double RADIANS[] = {0.17453292519943295, 0.34906585039886590, 0.52359877559829887,
                                 0.69813170079773179};

enum { SLOPE_COUNT = sizeof SLOPES / sizeof SLOPES[0] };

static void add_slope(scene *s, double x, double length, slope d, double angle) {
    double top = length * d.rise;
    const scene_point ramp[] = {{-4, top}, {0, top}, {length * d.run, 0}};
    s->material.friction = 0.5;
    scene_add_body(s, SCENE_STATIC, x, 0);
    scene_add_irregular(s, ramp, 3);
    /* Centres: a point on the ramp, plus half a size along the ramp's normal. */
    const double half = 0.5;
    double disc_along = 3, box_along = 1;
    scene_dynamic_circle(s, x + disc_along * d.run + half * d.rise,
                         top - disc_along * d.rise + half * d.run, half);
    scene_dynamic_box(s, x + box_along * d.run + half * d.rise,
                      top - box_along * d.rise + half * d.run, half, half)
        ->angle = -angle;
}

static void fill(scene *s, int size) {
    double length = size;
    double spacing = length + 14;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_flat(s, 0);
    for (int i = 0; i < SLOPE_COUNT; i++)
        add_slope(s, (i - 0.5 * SLOPE_COUNT) * spacing, length, SLOPES[i], RADIANS[i]);
    s->camera_y = 0.4 * length;
    s->camera_height = 2.2 * length;
    s->spawn_y = length;
}

const scene_info scene_slopes = {SCENE_FACTS(slopes), .place = 120, .fill = fill};
