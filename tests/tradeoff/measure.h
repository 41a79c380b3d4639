/* measure.h: runs one case at every setting, for its errors and for its cost. */
#ifndef THUD_TRADEOFF_MEASURE_H
#define THUD_TRADEOFF_MEASURE_H

#include "settings.h"
#include "yardstick.h"

typedef struct measure_plan {
    int repetitions; /* of the timed runs */
    bool quick;
    /* Told now and then how far it is, in [0, 1]; null: nobody looks. */
    void (*progress)(const char *case_name, double fraction);
} measure_plan;

typedef struct cost {
    double median, mean; /* ms a step */
    double total;        /* ms, all steps */
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

/* False, and a line on stderr, when an engine or memory fails. */
bool measure_case(const tradeoff_case *c, const measure_plan *plan, measurement *out);

#endif
