/* yardstick.h: measures a world after each step and accumulates its errors, in the same way for
 * every engine. */
#ifndef THUD_TRADEOFF_YARDSTICK_H
#define THUD_TRADEOFF_YARDSTICK_H

#include "case.h"

typedef struct yardstick yardstick;

/* The errors of all steps so far. */
typedef struct errors {
    double error;             /* the case's error; infinite once a body was lost */
    double penetration_worst; /* m */
    double penetration_mean;  /* m, mean over all touching pairs of all steps */
    double energy_gained; /* largest energy minus that at the start, over the larger of the largest
                             kinetic energy and the energy of a fall of all bodies by a metre; 0: no
                             gain */
    int lost;             /* largest number of bodies without a finite pose or velocity in a step */
} errors;

/* Creates a yardstick for one run of one setting. Null if memory runs out. Case and scene must
 * outlive it. */
yardstick *yardstick_create(const tradeoff_case *c, const scene *s);
void yardstick_destroy(yardstick *y); /* may be null */

/* Begins with the bodies as they are before the first step, in the scene's order. yardstick_begin
 * and yardstick_look return false if memory runs out. */
bool yardstick_begin(yardstick *y, const engine_body *bodies);
/* Measures the state at the given time in s; called once for every step. */
bool yardstick_look(yardstick *y, const engine_body *bodies, double time);
errors yardstick_conclude(const yardstick *y);

#endif
