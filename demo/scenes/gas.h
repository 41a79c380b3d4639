/* gas.h: a box of elastic circles, which more than one scene uses. */
#ifndef THUD_DEMO_GAS_H
#define THUD_DEMO_GAS_H

#include "scene.h"

/* Half the side of the square that `count` circles start in, with a margin, m. */
double scene_gas_half(int count);

/* Adds `count` frictionless, elastic circles of radius 0.25 m without gravity, which fly at 5 m/s
 * in random directions, in a square about (x, y). Leaves the scene's material elastic. */
void scene_add_gas_circles(scene *s, double x, double y, int count);

/* Adds the same between four walls. Returns half the inner width. */
double scene_add_gas(scene *s, double x, double y, int count);

#endif
