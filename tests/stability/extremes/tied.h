/* tied.h: helpers for the extremes with joints: they run a scene with each entrant and add rows to
 * the ledger. */
#ifndef THUD_STABILITY_TIED_H
#define THUD_STABILITY_TIED_H

#include "tied_scenes.h"
#include "trial.h"

static const double DEGREES = 57.295779513082321; /* degrees in a radian */

/* The values that an entrant reaches in a scene. */
enum { TIED_FIGURES = 4 };
typedef struct tied_outcome {
    double value[TIED_FIGURES];
} tied_outcome;

typedef tied_outcome tied_run(ledger *l, entrant e, const void *how);

/* A row for one of the values. `bound` applies to quality default and higher; `exact`, in a row of
 * its own, to exact. Upper bounds; 0: none. */
typedef struct tied_row {
    const char *what;
    double bound, exact;
} tied_row;

/* Runs `run` with each entrant and adds a row for each of the first row_count values. `about` names
 * the scene. */
void tied_tell(ledger *l, const tied_row *rows, int row_count, const char *about, tied_run *run,
               const void *how);

/* The larger of two values; NaN is larger than any number. */
double tied_worse(double a, double b);

enum { ON_TIED = ON_DEFAULT | ON_HIGH | ON_EXACT };

#endif
