/* yardstick.h: looks at a world after each step and adds up its errors, alike for every engine. */
#ifndef THUD_TRADEOFF_YARDSTICK_H
#define THUD_TRADEOFF_YARDSTICK_H

#include "case.h"

typedef struct yardstick yardstick;

/* Over all steps so far. */
typedef struct errors {
    double error;             /* the case's own; infinite once a body was lost */
    double penetration_worst; /* m */
    double penetration_mean;  /* m, over all pairs that touched and all steps */
    double energy_gained; /* the most over that of the start, as a part of the most that ever was
                             kinetic, or of what all weigh times a metre; 0: never more */
    int lost;             /* bodies without a finite pose or velocity, in the worst step */
} errors;

/* For one run of one setting. Null if memory runs out; case and scene must outlive it. */
yardstick *yardstick_create(const tradeoff_case *c, const scene *s);
void yardstick_destroy(yardstick *y); /* null is fine */

/* `bodies`: those of the scene before the first step, in its order. These two give false if memory
 * runs out. */
bool yardstick_begin(yardstick *y, const engine_body *bodies);
/* As of the given time in s, once for every step. */
bool yardstick_look(yardstick *y, const engine_body *bodies, double time);
errors yardstick_conclude(const yardstick *y);

#endif
