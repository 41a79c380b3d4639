/* linkage.h: the exact motion of bodies connected by joints alone, without contacts, springs and
 * motors, as a reference for engines.
 *
 * Newton-Euler equations with Lagrange multipliers p: M a = f + J^T p, J a = -J' v, integrated by
 * the fourth order Runge-Kutta rule in double precision. After each step positions and velocities
 * are projected back onto the constraints in the metric of the mass matrix. */
#ifndef THUD_ORACLE_LINKAGE_H
#define THUD_ORACLE_LINKAGE_H

#include "engine.h"

typedef struct linkage linkage;

/* Null if memory runs out, the scene has failed, the step (s; 0: 1/1920) is negative or not finite,
 * or a joint has a limit, a spring or a motor, or is a target or a gear. The scene must outlive the
 * linkage. */
linkage *linkage_create(const scene *s, double step);
void linkage_destroy(linkage *l); /* may be null */

/* Advances by `seconds`. False if they are negative or not finite; also false, with an unusable
 * state, if the constraints are redundant. */
bool linkage_advance(linkage *l, double seconds);

/* Writes all bodies in the scene's order. */
void linkage_read(const linkage *l, engine_body *bodies);

/* The present force of a joint on its body b, N. False if the constraints are redundant. */
bool linkage_force(linkage *l, int joint, double *x, double *y);

#endif
