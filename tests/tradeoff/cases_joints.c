/* cases_joints.c: cases with joints. The errors are distances from the oracle's linkage or from the
 * equilibrium, and joint gaps. */
#include "case.h"

#include "tied_scenes.h"

#include <math.h>

static bool fill_swinging_chain(scene *s, int size) {
    fill_chain(s, &(chain_scene){size, 10, true});
    return !s->failed;
}

static bool fill_loaded_bridge(scene *s, int size) {
    fill_bridge(s, &(bridge_scene){size, 0.96 * size, 2 * size / 5, 40});
    return !s->failed;
}

static bool fill_falling_ragdolls(scene *s, int size) {
    fill_ragdolls(s, size);
    return !s->failed;
}

static bool fill_driving_cars(scene *s, int size) {
    fill_cars(s, size);
    return !s->failed;
}

/* The largest distance of a body from its place in the oracle's linkage, m. */
static double off_the_linkage(const sighting *now) {
    return oracle_compare(now->scene, now->expected, now->bodies).position_max;
}

/* The largest distance of a body from its place at the start, where it is in equilibrium, m. */
static double off_equilibrium(const sighting *now) {
    double furthest = 0;
    for (int i = 0; i < now->scene->body_count; i++) {
        const scene_body *start = &now->scene->bodies[i];
        furthest = fmax(furthest, hypot(now->bodies[i].x - start->x, now->bodies[i].y - start->y));
    }
    return furthest;
}

static double widest_joint(const sighting *now) {
    return now->score.gap_max;
}

const tradeoff_case case_chain = {
    .name = "chain",
    .title = "Swinging chain",
    .about =
        "A chain of ten links with a ball of ten times a link's mass swings from level for 1 s.",
    .error = "furthest off the oracle's path",
    .unit = "m",
    .size = 10,
    .quick_size = 10,
    .steps = 60,
    .quick_steps = 40,
    .floor = 1e-5,
    .chance = 1,
    .fold = CASE_WORST,
    .fill = fill_swinging_chain,
    .error_of = off_the_linkage,
    .has_linkage = true,
};

const tradeoff_case case_bridge = {
    .name = "bridge",
    .title = "Loaded bridge",
    .about =
        "A bridge of 50 planks of 5 kg hangs in equilibrium with 20 weights of 40 kg, for 10 s.",
    .error = "furthest off equilibrium",
    .unit = "m",
    .size = 50,
    .quick_size = 10,
    .steps = 600,
    .quick_steps = 60,
    .floor = 1e-5,
    .chance = 1,
    .fold = CASE_WORST,
    .fill = fill_loaded_bridge,
    .error_of = off_equilibrium,
};

const tradeoff_case case_ragdolls = {
    .name = "ragdolls",
    .title = "Ragdolls on stairs",
    .about = "Twenty figures of 11 bodies and 10 hinges with limits fall on stairs, for 5 s.",
    .error = "widest joint of a step, on average",
    .unit = "m",
    .size = 20,
    .quick_size = 4,
    .steps = 300,
    .quick_steps = 90,
    .floor = 1e-4,
    .chance = 1.2,
    .fold = CASE_MEAN,
    .fill = fill_falling_ragdolls,
    .error_of = widest_joint,
};

const tradeoff_case case_cars = {
    .name = "cars",
    .title = "Cars on bumps",
    .about = "Ten cars with suspensions drive over kerbs, for 10 s.",
    .error = "wheel furthest off its axis, on average",
    .unit = "m",
    .size = 10,
    .quick_size = 3,
    .steps = 600,
    .quick_steps = 120,
    .floor = 1e-6,
    .chance = 1.2,
    .fold = CASE_MEAN,
    .fill = fill_driving_cars,
    .error_of = widest_joint,
};
