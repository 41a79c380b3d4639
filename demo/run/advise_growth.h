/* advise_growth.h: the same scene at larger sizes, with faster motions and a heavier body, until it
 * breaks. */
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

enum { ADVISE_SIZES_MAX = 24, ADVISE_FACTORS_MAX = 8 };

/* The scene with one of its values times a factor: the largest that holds, and the smallest that
 * was tried and is too wrong. */
typedef struct advise_strain {
    advise_setting tried[ADVISE_FACTORS_MAX];
    double factors[ADVISE_FACTORS_MAX];
    int count;
    bool broke; /* by the last factor; the one before it holds */
} advise_strain;

typedef struct advise_growth {
    advise_size sizes[ADVISE_SIZES_MAX]; /* in the order of trying */
    int count;
    double budget_ms;    /* of a step */
    int held, missed;    /* the largest that holds, and the smallest that is broken; -1: none */
    bool gave_up;        /* larger sizes would have taken too long to measure */
    const char *why_not; /* sizes are not measured at all; null: they are */
    /* All that moves so many times as fast, by that many times fewer steps a second, for the same
     * time of the scene; speed times step is then so many times as long. */
    advise_strain faster;
    advise_strain heavier; /* the heaviest body so many times as heavy */
    const char *no_speeds; /* why speeds are not measured; null: they are */
} advise_growth;

/* Runs the scene at sizes from its present one on, each twice as large as the one before, at the
 * setting that the options name, and then between the largest that holds and the smallest that is
 * broken. Then with faster motions, and with a heavier body, at its present size. False after a
 * message; *out has to be freed in either case. */
bool advise_grow(const run_options *how, const scene *s, advise_growth *out);

/* What broke at the smallest factor. */
typedef struct advise_first {
    const char *what; /* "time" or "size" (too slow or too wrong as it grows), "speed", "mass"; "":
                         nothing that was tried */
    double factor;
} advise_first;
advise_first advise_first_of(const advise_growth *growth);
void advise_growth_free(advise_growth *growth);

#endif
