/* yardstick.h: measures the bodies of a world after each step and accumulates the errors of a run:
 * one case (case.h) in one engine at one setting (settings.h). Measured by the oracle's meter
 * (tests/oracle), and so in the same way for every engine. */
#ifndef THUD_TRADEOFF_YARDSTICK_H
#define THUD_TRADEOFF_YARDSTICK_H

#include "case.h"

typedef struct yardstick yardstick;

/* The errors of all steps so far. A body is lost in a step if its pose or velocity is not finite. A
 * step with lost bodies counts in `lost` and in `error` only. */
typedef struct errors {
    double error; /* the largest, mean or last of the steps' errors (tradeoff_case.fold), in
                     tradeoff_case.unit; infinite once a body was lost, NaN if it is a mean and
                     there was no step */
    double penetration_worst; /* m */
    double penetration_mean;  /* m, mean over the pairs that touch (ORACLE_TOUCH) in all steps, with
                                 0 for one that does not overlap */
    double energy_gained; /* a ratio, >= 0. Numerator: the largest kinetic plus potential energy of
                             all bodies minus that at the start. Denominator: the largest kinetic
                             energy, but at least the energy that all dynamic bodies release when
                             they fall by a length scale, so that a scene at rest has one */
    int lost;             /* largest number of lost bodies in a step */
} errors;

/* Creates a yardstick for one run. Null if memory runs out. Case and scene must outlive it. */
yardstick *yardstick_create(const tradeoff_case *c, const scene *s);
void yardstick_destroy(yardstick *y); /* may be null */

/* Measures the energies at the start. `bodies`: as they are before the first step, in the scene's
 * order. yardstick_begin and yardstick_look return false if memory runs out. */
bool yardstick_begin(yardstick *y, const engine_body *bodies);
/* Measures the state at the given time in s; called once for every step. */
bool yardstick_look(yardstick *y, const engine_body *bodies, double time);
/* The errors so far. Changes nothing: further steps may follow. */
errors yardstick_conclude(const yardstick *y);

#endif
