/* catalogue_choices.h: what a world has to choose from: broadphases, and ways of detection in the
 * order of their price. */
#ifndef THUD_BENCH_CATALOGUE_CHOICES_H
#define THUD_BENCH_CATALOGUE_CHOICES_H

#include "scene.h"

#include <thud/thud.h>

enum { BROADPHASE_COUNT = 3, WAY_COUNT = 4 };

const thud_broadphase *broadphase_at(int index); /* grid, plane sweep, all pairs */

const thud_detection *way_at(int index); /* overlap, continuous, bisect, swept */

/* A world of the scene, without sleep, and its bodies in the scene's order. */
typedef struct way_world {
    thud_world *world;
    thud_body_id *bodies;
    int count;
} way_world;

/* False, and a line on stderr, when something fails; way_close is due all the same. */
bool way_open(way_world *w, const scene *s, const thud_detection *detection, double time_step);
bool way_step(way_world *w);
void way_close(way_world *w);

#endif
