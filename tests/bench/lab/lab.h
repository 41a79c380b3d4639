/* lab.h: measurements of thud by itself: time over the number of bodies, the cost of each feature,
 * the gain of a second thread, and the time of each stage of a step. */
#ifndef THUD_BENCH_LAB_H
#define THUD_BENCH_LAB_H

#include "json.h"
#include "plan.h"

/* Each prints a table and writes one member of the results' JSON object. `quick` takes few steps,
 * to test that it runs. Returns false and prints a line on stderr on failure. */
bool lab_growth(bool quick, json *out);  /* "growth" */
bool lab_memory(bool quick, json *out);  /* "memory" */
bool lab_pay(bool quick, json *out);     /* "pay" */
bool lab_alone(bool quick, json *out);   /* "alone": a hundred awake bodies with and without 20,000
                                            sleeping ones */
bool lab_workers(bool quick, json *out); /* "workers" */
/* "profile": of the scenes of these plans */
bool lab_profile(const bench_plan *plans, int count, json *out);

#endif
