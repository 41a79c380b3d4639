/* advise_settings.h: runs a scene at many settings, and finds the cheapest that is accurate enough.
 *
 * Errors are those of run_error_of: the same bits in every run. A step is the same work in every
 * run, so that the shortest of its times is the best estimate of what it takes, and other load of
 * the machine can only add to it. The time of a setting is the mean of these, over its steps. */
#ifndef THUD_RUN_ADVISE_SETTINGS_H
#define THUD_RUN_ADVISE_SETTINGS_H

#include "options.h"
#include "outcome.h"
#include "scene.h"

enum { ADVISE_SETTINGS_MAX = 32 };

/* Times that differ by less than this factor count as equal: the machine's noise is no reason to
 * advise one setting rather than another. */
#define ADVISE_EQUAL 1.05

typedef struct advise_setting {
    run_options how;     /* runs it once */
    run_outcome outcome; /* of its first run */
    double error;        /* length scales */
    double *step_ms;     /* of each step, the shortest of all runs; owned */
    double ms, ms_max;   /* their mean, and the largest */
    double ms_median;    /* their median */
    int runs;
    thud_pos *ends; /* where the bodies of the scene are after the last step of the first run;
                       NaN: destroyed; owned */
} advise_setting;

typedef struct advise_series {
    advise_setting settings[ADVISE_SETTINGS_MAX];
    int count;
    int now;     /* the setting that the command line names */
    int advised; /* the most accurate of the cheapest that meet the error within the budget;
                    -1: none */
    int nearest; /* the one with the smallest error within the budget, or of all if none is */
} advise_series;

/* Runs a setting once more, and checks that it repeats bit for bit. False after a message. */
bool advise_run(advise_setting *setting, const scene *s);

/* Whether a setting is accurate enough, and cheap enough. */
bool advise_meets(const advise_setting *setting);

void advise_setting_free(advise_setting *setting);

/* Measures all settings. False after a message. *out has to be freed in either case. */
bool advise_measure(const run_options *options, const scene *s, advise_series *out);
void advise_series_free(advise_series *series);

/* Says on a terminal what is under way. */
void advise_progress(const char *doing, int done, int all);

#endif
