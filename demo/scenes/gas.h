/* gas.h: a box full of elastic circles, which more than one scene uses. */
#ifndef THUD_DEMO_GAS_H
#define THUD_DEMO_GAS_H

#include "scene.h"

/* Half the width inside the walls of a gas of `count` circles. */
double scene_gas_half(int count);

/* Adds four walls and `count` frictionless, elastic circles of radius 0.25 that fly at 5 m/s in
 * random directions and heed no gravity, in a square about (x, y); returns the half width inside
 * the walls. Leaves the scene's material elastic. */
double scene_add_gas(scene *s, double x, double y, int count);

#endif
