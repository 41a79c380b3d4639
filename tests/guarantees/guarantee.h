/* guarantee.h: a guarantee: a promise of the headers and READMEs with the function that tests it on
 * any settings. Each has a row in docs/guarantees.md; check_table.py compares the rows with these
 * tables. */
#ifndef GUARANTEE_H
#define GUARANTEE_H

#include "trial.h"

enum { EXCEPTIONS_MAX = 2 };

/* Values of a dimension for which nothing is promised, as bits. */
typedef struct exception {
    int dimension;
    unsigned values;
    const char *reason; /* null: no exception */
} exception;

typedef struct guarantee {
    const char *name;
    /* Builds a scene, runs it, and reports in the trial (trial_fault) what is not as promised. */
    void (*check)(trial *t);
    exception except[EXCEPTIONS_MAX];
} guarantee;

#define BIT(value) (1u << (value))
#define ALL_BUT(value) (~BIT(value))

/* A line of a table: a guarantee that holds on all settings, or on all but those of one exception.
 * Its name is that of its function. */
#define GUARANTEE(function) \
    { .name = #function, .check = function }
#define GUARANTEE_EXCEPT(function, ...)                                 \
    {                                                                   \
        .name = #function, .check = function, .except = { __VA_ARGS__ } \
    }

/* One table for each file of guarantees; each ends with an entry without a name. */
extern const guarantee guarantees_of_asking[], guarantees_of_bits[], guarantees_of_bodies[],
    guarantees_of_callbacks[], guarantees_of_events[], guarantees_of_features[],
    guarantees_of_filters[], guarantees_of_joints[], guarantees_of_passing[],
    guarantees_of_refusal[], guarantees_of_rest[], guarantees_of_state[];

enum { GUARANTEES_MAX = 96 };

/* Fills `out` with all of them, in the order of the tables, and returns the number. */
int guarantees_all(const guarantee *out[GUARANTEES_MAX]);

/* False if one of the exceptions excludes the settings. */
bool guarantee_covers(const guarantee *g, const settings *s);

#endif
