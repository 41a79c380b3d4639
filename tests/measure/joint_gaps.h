/* joint_gaps.h: by how much a scene's joints are open, by geometry in double precision on the poses
 * that an engine gives back. No engine's own measure. */
#ifndef THUD_MEASURE_JOINT_GAPS_H
#define THUD_MEASURE_JOINT_GAPS_H

#include "engine.h"

/* Of one joint. All >= 0; not a number where a body is lost. */
typedef struct joint_gap {
    double length;       /* m, by which what the kind locks is off */
    double angle;        /* rad, likewise */
    double beyond;       /* m, past a limit, along the axis or of the distance */
    double beyond_angle; /* rad, past a limit of the turn */
} joint_gap;

joint_gap joint_gap_of(const scene *s, int joint, const engine_body *bodies);

/* Over any number of samples. */
typedef struct joint_gaps {
    joint_gap worst;
    double sum;  /* m, of all lengths */
    long joints; /* in all samples */
    int lost;    /* joints of lost bodies, in the worst sample; they count nowhere else */
} joint_gaps;

double joint_gaps_mean(const joint_gaps *seen);

void joint_gaps_sample(const scene *s, const engine_body *bodies, joint_gaps *seen);

/* The sum of the lengths by which the joints are open now, in m; infinite when one is lost. */
double joint_gaps_sum(const scene *s, const engine_body *bodies);

#endif
