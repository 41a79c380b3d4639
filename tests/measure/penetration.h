/* penetration.h: the worst and the mean overlap of a scene's bodies, measured on the poses that an
 * engine gives back. One meter serves all engines of a scene. */
#ifndef THUD_BENCH_PENETRATION_H
#define THUD_BENCH_PENETRATION_H

#include "engine.h"

typedef struct penetration_meter penetration_meter;

/* What was seen over any number of samples. */
typedef struct penetration {
    double worst; /* metres */
    double sum;   /* over `pairs` */
    long pairs;   /* that overlapped, in all samples; mean = sum / pairs */
    int lost;     /* shapes without a finite pose, in the worst sample */
} penetration;

/* Null if memory runs out. The scene must outlive the meter. */
penetration_meter *penetration_meter_create(const scene *s);
void penetration_meter_destroy(penetration_meter *meter);

/* Adds one sample. Pairs that cannot collide do not count: two shapes of one body, two bodies of
 * which none is dynamic, sensors, and what filters and joints keep apart. */
void penetration_sample(penetration_meter *meter, const engine_body *bodies, penetration *seen);

double penetration_mean(const penetration *seen);

#endif
