/* lab_world.h: a thud world of a scene, stepped and timed. */
#ifndef THUD_BENCH_LAB_WORLD_H
#define THUD_BENCH_LAB_WORLD_H

#include "plan.h"

#include <thud/thud.h>

typedef struct lab_world {
    scene scene;
    thud_world *world;
} lab_world;

double lab_now(void *context); /* seconds */

/* The default settings with sleeping off. */
thud_world_def lab_settings(void);

/* Both false, and a line on stderr, when something fails. `size` 0: the scene's own. */
bool lab_open_scene(lab_world *lab, const scene_info *info, int size, const thud_world_def *def);
bool lab_open(lab_world *lab, const thud_world_def *def); /* of lab->scene, filled by the caller */
void lab_close(lab_world *lab);

/* Seconds of each of `count` steps. */
bool lab_run(lab_world *lab, int count, double *seconds);

#endif
