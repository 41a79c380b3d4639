/* verdict.h: compares a result with the bounds of its plan. */
#ifndef THUD_BENCH_VERDICT_H
#define THUD_BENCH_VERDICT_H

#include "race.h"

#include <stddef.h>

/* The bounds that are missed. All false: all hold, or there are none. */
typedef struct verdict {
    bool median, p99, worst; /* the ratio to Box2D is below the target */
    bool overlap;            /* maximum or mean overlap is above Box2D's */
    bool gap;                /* maximum or mean joint gap is above Box2D's */
    bool limit;              /* a step took longer than the plan's limit */
} verdict;

/* Differences of overlaps and gaps below 0.01 mm count as equal. */
verdict verdict_of(const race_result *result);
bool verdict_holds(verdict v);

/* The engine that the target refers to; null if it did not run. */
const race_entry *verdict_rival(const race_result *result);

/* "holds", or "misses: median, p99", or "" if the plan has no bounds. */
void verdict_text(const race_result *result, char *out, size_t size);

#endif
