/* advise_growth.h: the same scene at larger sizes, until it breaks. */
#ifndef THUD_RUN_ADVISE_GROWTH_H
#define THUD_RUN_ADVISE_GROWTH_H

#include "advise_settings.h"
#include "uses.h"

/* What a size no longer keeps to. */
typedef enum advise_break {
    ADVISE_HOLDS = 0,
    ADVISE_TOO_SLOW, /* a step takes more than the budget, or a sixtieth of a second */
    ADVISE_TOO_WRONG /* the error is larger than asked for, or bodies pass through what stands */
} advise_break;

/* The scene at one size. */
typedef struct advise_size {
    int size, bodies;
    advise_setting setting;
    uses uses;
    advise_break broken;
} advise_size;

enum { ADVISE_SIZES_MAX = 24 };

typedef struct advise_growth {
    advise_size sizes[ADVISE_SIZES_MAX]; /* in the order of trying */
    int count;
    double budget_ms;    /* of a step */
    int held, missed;    /* the largest that holds, and the smallest that is broken; -1: none */
    bool gave_up;        /* larger sizes would have taken too long to measure */
    const char *why_not; /* not measured at all; null: measured */
} advise_growth;

/* Runs the scene at sizes from its present one on, each twice as large as the one before, at the
 * setting that the options name, and then between the largest that holds and the smallest that is
 * broken. False after a message; *out has to be freed in either case. */
bool advise_grow(const run_options *how, advise_growth *out);
void advise_growth_free(advise_growth *growth);

#endif
