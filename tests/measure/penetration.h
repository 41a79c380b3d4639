/* penetration.h: measures the largest and the mean overlap of a scene's bodies from the poses that
 * an engine returns. One meter can be used for all engines that run the scene. */
#ifndef THUD_BENCH_PENETRATION_H
#define THUD_BENCH_PENETRATION_H

#include "engine.h"

typedef struct penetration_meter penetration_meter;

/* Accumulated over any number of samples. */
typedef struct penetration {
    double worst; /* m, deepest overlap */
    double sum;   /* m, sum of the depths of `pairs` */
    long pairs;   /* overlapping pairs in all samples */
    int lost;     /* largest number of shapes without a finite pose in a sample */
} penetration;

/* Null if memory runs out. The scene must outlive the meter. */
penetration_meter *penetration_meter_create(const scene *s);
void penetration_meter_destroy(penetration_meter *meter);

/* Adds a sample. Pairs that cannot collide are left out: two shapes of one body, two bodies of
 * which none is dynamic, sensors, and pairs that filters or joints exclude. */
void penetration_sample(penetration_meter *meter, const engine_body *bodies, penetration *seen);

double penetration_mean(const penetration *seen);

#endif
