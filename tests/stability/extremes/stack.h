/* stack.h: boxes of one size on each other, which most extremes are made of. */
#ifndef THUD_STABILITY_STACK_H
#define THUD_STABILITY_STACK_H

#include "trial.h"

/* Initialises the scene: body 0 is the ground, at height 0; the boxes, `size` wide, are 1 to
 * `count` from the bottom up, and just touch. */
void stack_init(scene *s, int count, double size);

/* By how much the body is lower than it started, in sizes. Infinite when one of the bodies from 1
 * to it has moved sideways by more than half a size: the stack has fallen. */
double stack_lost(trial *t, int body, double size);

#endif
