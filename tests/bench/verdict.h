/* verdict.h: whether a result keeps what the plan promises. */
#ifndef THUD_BENCH_VERDICT_H
#define THUD_BENCH_VERDICT_H

#include "race.h"

#include <stddef.h>

/* What does not hold; all false: everything does, or nothing was promised. */
typedef struct verdict {
    bool median, p99, worst; /* the ratio to Box2D's is below the target */
    bool overlap;            /* deeper than Box2D's, worst or mean */
    bool gap;                /* joints are further open than Box2D's, worst or mean */
    bool limit;              /* a step took longer than the plan allows */
} verdict;

/* Overlaps and gaps count as equal within a hundredth of a millimetre. */
verdict verdict_of(const race_result *result);
bool verdict_holds(verdict v);

/* The rival that a target speaks of; null if it did not run. */
const race_entry *verdict_rival(const race_result *result);

/* "holds", or "misses: median, p99", or "" where nothing was promised. */
void verdict_text(const race_result *result, char *out, size_t size);

#endif
