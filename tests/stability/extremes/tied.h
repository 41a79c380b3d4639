/* tied.h: what the extremes of joints share. */
#ifndef THUD_STABILITY_TIED_H
#define THUD_STABILITY_TIED_H

#include "tied_scenes.h"
#include "trial.h"

static const double DEGREES = 57.295779513082321; /* in a radian */

/* What one entrant made of a scene: any number of figures. */
enum { TIED_FIGURES = 4 };
typedef struct tied_outcome {
    double value[TIED_FIGURES];
} tied_outcome;

typedef tied_outcome tied_run(ledger *l, entrant e, const void *how);

/* A row of the ledger for a figure of an outcome. Bounds at most, 0: none: on default and finer,
 * and, as a row of its own, on exact alone. */
typedef struct tied_row {
    const char *what;
    double bound, exact;
} tied_row;

/* Runs every entrant through `about`, and tells values 0 and up of the outcomes as so many rows. */
void tied_tell(ledger *l, const tied_row *rows, int row_count, const char *about, tied_run *run,
               const void *how);

/* The largest of two; what is not a number is the largest of all. */
double tied_worse(double a, double b);

enum { ON_TIED = ON_DEFAULT | ON_HIGH | ON_EXACT };

#endif
