/* measure.h: runs one case at every setting, and measures its errors and its cost. */
#ifndef THUD_TRADEOFF_MEASURE_H
#define THUD_TRADEOFF_MEASURE_H

#include "settings.h"
#include "yardstick.h"

typedef struct measure_plan {
    int repetitions; /* of the timed run */
    bool quick;
    /* Called with the progress in [0, 1]; may be null. */
    void (*progress)(const char *case_name, double fraction);
} measure_plan;

typedef struct cost {
    double median, mean; /* ms per step */
    double total;        /* ms for all steps */
} cost;

typedef struct point {
    const setting *how;
    errors errors;
    cost cost;
} point;

typedef struct measurement {
    const tradeoff_case *c;
    int bodies, steps, repetitions, point_count;
    point points[SETTINGS_MAX];
} measurement;

/* False, with a line on stderr, if an engine fails or memory runs out. */
bool measure_case(const tradeoff_case *c, const measure_plan *plan, measurement *out);

#endif
