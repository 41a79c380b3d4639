/* lab_world.h: a thud world made from a scene, stepped and timed. */
#ifndef THUD_BENCH_LAB_WORLD_H
#define THUD_BENCH_LAB_WORLD_H

#include "plan.h"

#include <thud/thud.h>

typedef struct lab_world {
    scene scene;
    thud_world *world;
} lab_world;

double lab_now(void *context); /* seconds */

/* The default def with sleeping off. */
thud_world_def lab_settings(void);

/* Create the world; false, with a line on stderr, on failure. `size` 0 is the scene's default. */
bool lab_open_scene(lab_world *lab, const scene_info *info, int size, const thud_world_def *def);
bool lab_open(lab_world *lab, const thud_world_def *def); /* from lab->scene, which the caller has
                                                             filled */
void lab_close(lab_world *lab);

/* Makes `count` steps and writes the seconds of each, unless `seconds` is null. */
bool lab_run(lab_world *lab, int count, double *seconds);

#endif
