/* extreme.h: the data structures of the envelope. An extreme is a section of docs/stability.md: a
 * function that runs thud at each quality, and Box2D beside it, in scenes that approach one limit
 * (mass ratio, speed, size, ...), and writes its figures with their bounds into a ledger. The same
 * function is used by the tests (`quick`: a few seconds of simulated time, for bounds that hold at
 * any length) and by thud-envelope (full length).
 *
 * To add an extreme, write a file with a `const extreme` and add a line in extremes.c. */
#ifndef THUD_STABILITY_EXTREME_H
#define THUD_STABILITY_EXTREME_H

#include <stdbool.h>
#include <stddef.h>

/* The engines and settings that an extreme is run with: thud at each quality; Box2D v3.2 with its
 * default settings, and with 16 substeps and the highest stiffness of contacts and joints that it
 * allows; Chipmunk 7 with its default of 10 iterations, and with 160. */
typedef enum entrant {
    ENTRANT_DRAFT = 0,
    ENTRANT_DEFAULT,
    ENTRANT_HIGH,
    ENTRANT_EXACT,
    ENTRANT_BOX2D,
    ENTRANT_BOX2D_STIFF,
    ENTRANT_CHIPMUNK,
    ENTRANT_CHIPMUNK_160,
    ENTRANTS
} entrant;

const char *entrant_name(entrant e); /* "default", "Box2D" */

/* Sets of entrants. */
enum {
    ON_DRAFT = 1 << ENTRANT_DRAFT,
    ON_DEFAULT = 1 << ENTRANT_DEFAULT,
    ON_HIGH = 1 << ENTRANT_HIGH,
    ON_EXACT = 1 << ENTRANT_EXACT,
    ON_THUD = (1 << ENTRANT_BOX2D) - 1, /* all qualities of thud */
    ON_USUAL = ON_THUD | 1 << ENTRANT_BOX2D,
    ON_BOX2D = 1 << ENTRANT_BOX2D | 1 << ENTRANT_BOX2D_STIFF,
    ON_CHIPMUNK = 1 << ENTRANT_CHIPMUNK | 1 << ENTRANT_CHIPMUNK_160,
    ON_ALL = (1 << ENTRANTS) - 1
};

typedef struct bound {
    enum {
        BOUND_NONE,
        BOUND_AT_MOST,
        BOUND_AT_LEAST
    } kind; /* none: measured for comparison only */
    double value;
    unsigned on; /* entrants that the bound applies to, as ON_ bits */
} bound;

enum { FIGURE_TEXT = 120, KNOWN_MISS_TEXT = 512 };

/* A row of an extreme's table. */
typedef struct figure {
    char what[FIGURE_TEXT]; /* "10^3 on a column of ten: penetration, % of the size" */
    bound bound;
    unsigned measured;        /* entrants with a value, as ON_ bits */
    double reached[ENTRANTS]; /* value of each entrant; infinite: the structure fell, or a body was
                                 lost */
} figure;

enum { LEDGER_FIGURES = 96 };

/* The table of an extreme, filled while it runs. */
typedef struct ledger {
    bool quick;
    bool baseline_simd; /* thud uses the baseline instruction set; its results are the same bits */
    unsigned entrants;  /* entrants of this run; without Box2D in the build its bits are 0 */
    figure figures[LEDGER_FIGURES];
    int count;
    bool failed; /* something could not be run; a line on stderr says what */
    void (*progress)(const char *what, double share); /* null: no progress is shown */
} ledger;

typedef struct extreme {
    const char *name;  /* name on the command line: "mass-ratio" */
    const char *title; /* heading */
    const char *about; /* one or two sentences that describe the scene and the figures */
    void (*run)(ledger *l);
    unsigned also; /* entrants that run it in addition to ON_USUAL */
} extreme;

extern const extreme *const EXTREMES[];
extern const int EXTREME_COUNT;

const extreme *extreme_find(const char *name); /* null if there is none */

/* Adds a row; `format`, as of printf, makes its text, with the unit. Never null. */
figure *ledger_add(ledger *l, bound b, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Sets the entrant's value. */
void figure_tell(figure *f, entrant e, double reached);
/* Reports the progress of the extreme, as a share in [0, 1] of its work. */
void ledger_progress(ledger *l, const char *what, double share);
/* Whether the entrant is part of this run. */
bool ledger_has(const ledger *l, entrant e);

bound bound_none(void);
bound bound_at_most(double value, unsigned on);
bound bound_at_least(double value, unsigned on);

/* Whether the entrant keeps the figure's bound; true if the bound does not apply to it or it was
 * not measured. */
bool figure_holds(const figure *f, entrant e);

/* The result of comparing a figure with the list in known_misses.c, which has a worst value and a
 * reason for each bound that an entrant is known to miss. */
typedef enum known_miss {
    KNOWN_MISS_NONE, /* the bound holds, or there is none */
    KNOWN_MISS_AS_KNOWN,
    KNOWN_MISS_WRONG /* missed and not in the list, worse than its worst value, or in the list and
                        not missed */
} known_miss;

/* Writes a line into `why`, except for KNOWN_MISS_NONE. */
known_miss known_misses_judge(const extreme *x, const figure *f, entrant e, bool quick, char *why,
                              size_t size);
/* The text of a line of the list that has no reason or no worst value, or that is not a figure of
 * the extreme; null if there is none. */
const char *known_misses_stray(const extreme *x, const ledger *l);

#endif
