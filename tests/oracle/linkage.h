/* linkage.h: the right motion of bodies that joints alone hold: nothing touches, nothing is driven.
 *
 * Newton and Euler with Lagrange multipliers: M a = f + J^T p, J a = -J' v, integrated by the
 * fourth order Runge-Kutta rule in double precision; after each step places and velocities are
 * projected back onto the joints, by the masses' metric. */
#ifndef THUD_ORACLE_LINKAGE_H
#define THUD_ORACLE_LINKAGE_H

#include "engine.h"

typedef struct linkage linkage;

/* Null if memory runs out, the scene failed, the step (s; 0: 1/1920) is negative or not finite, or
 * a joint has a limit, a spring or a motor, or is a target or a gear. The scene must outlive it. */
linkage *linkage_create(const scene *s, double step);
void linkage_destroy(linkage *l); /* null is fine */

/* False where that is negative or not finite; false, and the state of no use, where joints hold
 * something twice over. */
bool linkage_advance(linkage *l, double seconds);

/* In the scene's order. */
void linkage_read(const linkage *l, engine_body *bodies);

/* The force of a joint on its body b, as it is now, N. False as above. */
bool linkage_force(linkage *l, int joint, double *x, double *y);

#endif
