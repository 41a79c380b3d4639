/* gas.h: a box full of elastic circles, which more than one scene uses. */
#ifndef THUD_DEMO_GAS_H
#define THUD_DEMO_GAS_H

#include "scene.h"

/* Half the width of the square that `count` circles get. */
double scene_gas_half(int count);

/* Adds `count` frictionless, elastic circles of radius 0.25 that fly at 5 m/s in random directions
 * and heed no gravity, in a square about (x, y). Leaves the scene's material elastic. */
void scene_add_gas_circles(scene *s, double x, double y, int count);

/* The same behind four walls; returns the half width inside them. */
double scene_add_gas(scene *s, double x, double y, int count);

#endif
