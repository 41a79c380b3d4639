/* walker.h: walking linkages, see walker.c. */
#ifndef THUD_DEMO_WALKER_H
#define THUD_DEMO_WALKER_H

#include "scene.h"

/* Adds a walker that stands at height 0, with its crank's axle at x. Even numbers are Jansen's, odd
 * ones Klann's. The parts of a walker do not collide with each other: `number` is their group.
 * Changes the scene's material. */
void walker_add(scene *s, int number, double x);

#endif
