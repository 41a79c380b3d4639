/* lab.h: thud alone, measured against itself: how it grows, what each feature costs, and where the
 * time of a step goes. */
#ifndef THUD_BENCH_LAB_H
#define THUD_BENCH_LAB_H

#include <stdbool.h>
#include <stdio.h>

/* Each prints a table, and to `json`, if not null, an array of objects. `quick` proves only that it
 * runs. False, and a line on stderr, when something fails. */
bool lab_growth(bool quick, FILE *json);
bool lab_pay(bool quick, FILE *json);
bool lab_profile(bool quick, FILE *json);

#endif
