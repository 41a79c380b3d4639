/* lab.h: thud measured against itself: how it grows, what each feature costs, what a second
 * thread brings, and where the time of a step goes. */
#ifndef THUD_BENCH_LAB_H
#define THUD_BENCH_LAB_H

#include "json.h"
#include "plan.h"

/* Each prints a table and writes one member of the results' object. `quick` proves only that it
 * runs. False, and a line on stderr, when something fails. */
bool lab_growth(bool quick, json *out);  /* "growth" */
bool lab_memory(bool quick, json *out);  /* "memory" */
bool lab_pay(bool quick, json *out);     /* "pay" */
bool lab_alone(bool quick, json *out);   /* "alone": the scene asleep against its hundred awake */
bool lab_workers(bool quick, json *out); /* "workers" */
/* "profile": of the given plans' scenes. */
bool lab_profile(const bench_plan *plans, int count, json *out);

#endif
