/* extreme.h: what the envelope is made of. An extreme is a row of docs/stability.md: a function
 * that drives thud at each quality, and Box2D beside it, to one extreme, and tells its figures with
 * the bounds that they must keep. The same function serves the tests (`quick`: seconds of simulated
 * time, for what must hold at any length) and thud-envelope (the full length).
 *
 * A new extreme is a file with one `const extreme` and a line in extremes.c. */
#ifndef THUD_STABILITY_EXTREME_H
#define THUD_STABILITY_EXTREME_H

#include <stdbool.h>
#include <stddef.h>

/* Who goes through an extreme: thud at a quality, Box2D v3.2 at its defaults, and at 16
 * substeps with contacts and joints as stiff as it allows, Chipmunk 7 at its default of 10
 * iterations, and at 160. */
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
    ON_THUD = (1 << ENTRANT_BOX2D) - 1, /* at every quality */
    ON_USUAL = ON_THUD | 1 << ENTRANT_BOX2D,
    ON_BOX2D = 1 << ENTRANT_BOX2D | 1 << ENTRANT_BOX2D_STIFF,
    ON_CHIPMUNK = 1 << ENTRANT_CHIPMUNK | 1 << ENTRANT_CHIPMUNK_160,
    ON_ALL = (1 << ENTRANTS) - 1
};

typedef struct bound {
    enum { BOUND_NONE, BOUND_AT_MOST, BOUND_AT_LEAST } kind; /* none: told for comparison */
    double value;
    unsigned on; /* whom it binds: ON_ */
} bound;

enum { FIGURE_TEXT = 120, KNOWN_MISS_TEXT = 512 };

/* A line of an extreme's table. */
typedef struct figure {
    char what[FIGURE_TEXT]; /* "10^3 on a column of ten: penetration, % of the size" */
    bound bound;
    unsigned measured;        /* of whom there is a figure: ON_ */
    double reached[ENTRANTS]; /* infinite: it fell, or something was lost */
} figure;

enum { LEDGER_FIGURES = 96 };

/* Where an extreme writes down what it measures. */
typedef struct ledger {
    bool quick;
    bool baseline_simd; /* thud never takes AVX2: the same bits */
    unsigned entrants;  /* who can be run here: without Box2D its bit is missing */
    figure figures[LEDGER_FIGURES];
    int count;
    bool failed; /* something could not be run; a line on stderr says what */
    void (*progress)(const char *what, double share); /* null: nobody looks */
} ledger;

typedef struct extreme {
    const char *name;  /* as on the command line: "mass-ratio" */
    const char *title; /* as a heading */
    const char *about; /* a sentence or two: the scene, and what the figures mean */
    void (*run)(ledger *l);
    unsigned also; /* who goes through it beyond ON_USUAL */
} extreme;

extern const extreme *const EXTREMES[];
extern const int EXTREME_COUNT;

const extreme *extreme_find(const char *name); /* null if there is none */

/* A new line; `format` as of printf makes its text, with the unit. Never null. */
figure *ledger_add(ledger *l, bound b, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void figure_tell(figure *f, entrant e, double reached);
/* Shows how far the extreme is, as a share in [0, 1] of its work. */
void ledger_progress(ledger *l, const char *what, double share);
/* Whether this entrant can be run, and is wanted in this form. */
bool ledger_has(const ledger *l, entrant e);

bound bound_none(void);
bound bound_at_most(double value, unsigned on);
bound bound_at_least(double value, unsigned on);

/* Whether the entrant keeps the figure's bound; true if it binds him not, or was not measured. */
bool figure_holds(const figure *f, entrant e);

/* What known_misses.c says of a figure and an entrant, which has a worst value and a reason for
 * each miss. */
typedef enum known_miss {
    KNOWN_MISS_NONE, /* the bound is kept, or there is none */
    KNOWN_MISS_AS_KNOWN,
    KNOWN_MISS_WRONG /* missed and not in the list, worse than its worst value, or kept again */
} known_miss;

/* `why` gets a line about all but KNOWN_MISS_NONE. */
known_miss known_misses_judge(const extreme *x, const figure *f, entrant e, bool quick, char *why,
                              size_t size);
/* The text of a line of the list that has no reason or no worst value, or that is no figure of the
 * extreme; null if there is none. */
const char *known_misses_stray(const extreme *x, const ledger *l);

#endif
