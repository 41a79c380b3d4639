/* walker.h: walking linkages, which stand at height 0; see walker.c. */
#ifndef THUD_DEMO_WALKER_H
#define THUD_DEMO_WALKER_H

#include "scene.h"

/* A walker, whose crank turns about x. By their numbers, from 0 on, both kinds take turns; those of
 * one number do not meet themselves. Changes the scene's material. */
void walker_add(scene *s, int number, double x);

#endif
