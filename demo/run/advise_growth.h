/* advise_growth.h: measures up to which size of a scene, which speed and which mass a setting of
 * the engine stays within the error and the time that are asked for. */
#ifndef THUD_RUN_ADVISE_GROWTH_H
#define THUD_RUN_ADVISE_GROWTH_H

#include "advise_settings.h"
#include "uses.h"

/* Why a size is not possible. */
typedef enum advise_break {
    ADVISE_HOLDS = 0,
    ADVISE_TOO_SLOW, /* a step takes more than the budget, or a sixtieth of a second */
    ADVISE_TOO_WRONG /* the error is larger than asked for, or bodies pass through static shapes */
} advise_break;

/* The scene at one size. */
typedef struct advise_size {
    int size, bodies;
    advise_setting setting;
    uses uses;
    advise_break broken;
} advise_size;

enum { ADVISE_SIZES_MAX = 24, ADVISE_FACTORS_MAX = 8 };

/* Runs of the scene with one of its values multiplied by growing factors, until the error is larger
 * than asked for. */
typedef struct advise_strain {
    advise_setting tried[ADVISE_FACTORS_MAX];
    double factors[ADVISE_FACTORS_MAX];
    int count;
    bool broke; /* at the last factor the error was too large; the factor before it was the last
                   that is possible */
} advise_strain;

typedef struct advise_growth {
    advise_size sizes[ADVISE_SIZES_MAX]; /* in the order of trying */
    int count;
    double budget_ms;    /* of a step */
    int held, missed;    /* indices in `sizes` of the largest size that is possible, and of the
                            smallest that is not; -1: none */
    bool gave_up;        /* larger sizes would have taken too long to measure */
    const char *why_not; /* sizes are not measured at all; null: they are */
    /* All motions `factor` times as fast compared with the step: the scene is run with 1 / factor
     * times as many steps a second, for the same time, so that each body moves `factor` times as
     * far in a step. */
    advise_strain faster;
    advise_strain heavier; /* the mass of the heaviest body multiplied by a factor */
    const char *no_speeds; /* why speeds are not measured; null: they are */
} advise_growth;

/* Runs the scene at the setting that the options name: at its present size, then at sizes each
 * twice as large as the one before, and then at sizes between the largest that is possible and the
 * smallest that is not. Then with faster motions, and with a heavier body, at its present size.
 * False after a message; *out has to be freed in either case. */
bool advise_grow(const run_options *how, const scene *s, advise_growth *out);

/* Which of these limits the scene reaches at the smallest factor. */
typedef struct advise_first {
    const char *what; /* "time" or "size" (as it grows, steps become too slow or the error too
                         large), "speed", "mass"; "": no limit was reached */
    double factor;
} advise_first;
advise_first advise_first_of(const advise_growth *growth);
void advise_growth_free(advise_growth *growth);

#endif
