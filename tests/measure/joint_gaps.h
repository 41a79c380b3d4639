/* joint_gaps.h: measures how far the joints of a scene are from what they lock and limit, by
 * geometry in double precision from the poses that an engine returns. It uses no measure of an
 * engine. */
#ifndef THUD_MEASURE_JOINT_GAPS_H
#define THUD_MEASURE_JOINT_GAPS_H

#include "engine.h"

/* The errors of one joint. All are >= 0; NaN if one of its bodies is lost. */
typedef struct joint_gap {
    double length;       /* m, error in the directions that its kind locks */
    double angle;        /* rad, error of the angle if its kind locks it */
    double beyond;       /* m, beyond a limit along the axis or of the distance */
    double beyond_angle; /* rad, beyond a limit of the angle */
} joint_gap;

joint_gap joint_gap_of(const scene *s, int joint, const engine_body *bodies);

/* Accumulated over any number of samples. */
typedef struct joint_gaps {
    joint_gap worst;
    double sum;  /* m, sum of all lengths */
    long joints; /* number of joints in all samples */
    int lost;    /* largest number of joints with a lost body in a sample; not counted in the other
                    fields */
} joint_gaps;

/* The mean gap, m; 0 without joints. */
double joint_gaps_mean(const joint_gaps *seen);

void joint_gaps_sample(const scene *s, const engine_body *bodies, joint_gaps *seen);

/* The sum of the present gaps (lengths), m; infinite if a joint has a lost body. */
double joint_gaps_sum(const scene *s, const engine_body *bodies);

#endif
