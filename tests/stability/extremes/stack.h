/* stack.h: a stack of equal boxes, the scene of several extremes. */
#ifndef THUD_STABILITY_STACK_H
#define THUD_STABILITY_STACK_H

#include "trial.h"

/* Initialises the scene: body 0 is the ground, whose surface is at height 0; the boxes, `size`
 * wide, are bodies 1 to `count` from the bottom up, and touch each other. */
void stack_init(scene *s, int count, double size);

/* How much lower the body is than at the start, in sizes. Infinite if a body from 1 to it has moved
 * sideways by more than half a size: the stack has fallen. */
double stack_lost(trial *t, int body, double size);

#endif
