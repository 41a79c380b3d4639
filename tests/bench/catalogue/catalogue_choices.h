/* catalogue_choices.h: the broadphases and the kinds of detection, in the order of their cost. */
#ifndef THUD_BENCH_CATALOGUE_CHOICES_H
#define THUD_BENCH_CATALOGUE_CHOICES_H

#include "scene.h"

#include <thud/thud.h>

enum { BROADPHASE_COUNT = 3, WAY_COUNT = 4 };

const thud_broadphase *broadphase_at(int index); /* grid, plane sweep, all pairs */

const thud_detection *way_at(int index); /* overlap, continuous, bisect, swept */

/* A world of a scene, without sleep, with the ids of its bodies in the scene's order. */
typedef struct way_world {
    thud_world *world;
    thud_body_id *bodies;
    int count;
} way_world;

/* False, with a line on stderr, on failure; way_close has to be called also then. */
bool way_open(way_world *w, const scene *s, const thud_detection *detection, double time_step);
bool way_step(way_world *w);
void way_close(way_world *w);

/* The thread's processor time in seconds. Unlike wall-clock time it does not advance while another
 * process runs, which would dominate the longest of many steps. */
double processor_seconds(void);

#endif
