/* known_misses.c: the list of bounds that thud misses at present, with a line for each figure and
 * quality. The tests fail if a value gets worse than in the list, and if a bound that is listed
 * holds. docs/stability.md shows the values that are reached. */
#include "extremes/extreme.h"

#include <stdio.h>
#include <string.h>

#define PUSHED_OUT "soft contacts push out what overlaps after an impact, and lift what lies on it"
#define SETTLES "at two substeps the weight sinks in, and rises again as impulses grow to carry it"
#define SOFT_AT_FIRST \
    "joints are soft until they have given way by more than the quality allows, and direct then"
#define SOFT_JOINTS "soft joints give way under what swings, and pull back"
#define CLOSING "gaps of joints that close leave some of that speed where it is too little to tell"
#define CLOSED_AT_ONCE \
    "joints that were soft for some steps are closed at once by the direct solver, and fly on"

typedef struct miss {
    const char *extreme, *what; /* the figure's text in the ledger */
    entrant by;
    double quick, full; /* worst known values, quick and full length; KEPT: the bound holds at this
                           length */
    const char *reason;
} miss;

#define KEPT 0
#define RISE "energy above its lowest before, %"
#define START "energy above its start, %"

/* Results do not depend on the machine: the worst values are those that were reached, rounded up to
 * three digits. */
static const miss MISSES[] = {
    {"energy", "pyramid: " RISE, ENTRANT_DRAFT, 0.207, 0.207, SETTLES},
    {"energy", "circle_pit: " RISE, ENTRANT_DRAFT, KEPT, 1.04, PUSHED_OUT},
    {"energy", "circle_pit: " RISE, ENTRANT_HIGH, KEPT, 0.145, PUSHED_OUT},
    {"energy", "smash: " RISE, ENTRANT_DRAFT, 0.716, 0.716, PUSHED_OUT},
    {"energy", "smash: " RISE, ENTRANT_DEFAULT, 5.01, 5.01, PUSHED_OUT},
    {"energy", "smash: " RISE, ENTRANT_HIGH, 5.11, 5.11, PUSHED_OUT},
    {"energy", "tall_stack: " RISE, ENTRANT_DRAFT, KEPT, 0.356, SETTLES},
    {"energy", "heavy_on_light: " RISE, ENTRANT_DRAFT, KEPT, 0.302, SETTLES},
    {"energy", "heavy_on_light: " RISE, ENTRANT_DEFAULT, 0.395, 0.397,
     "what sank in under the heavy box is put right at once when its island goes to the direct "
     "solver"},
    {"energy", "sizes: " RISE, ENTRANT_DRAFT, KEPT, 2.38, PUSHED_OUT},
    {"energy", "sizes: " RISE, ENTRANT_DEFAULT, KEPT, 1.11, PUSHED_OUT},
    {"energy", "sizes: " RISE, ENTRANT_HIGH, KEPT, 1.10, PUSHED_OUT},
    {"energy", "sizes: " RISE, ENTRANT_EXACT, KEPT, 0.128, PUSHED_OUT},
    {"energy", "wrecking_ball: " RISE, ENTRANT_DRAFT, KEPT, 1.98, SOFT_JOINTS},
    {"energy", "trebuchet: " RISE, ENTRANT_DRAFT, 0.117, 2.33, SOFT_JOINTS},
    {"energy", "trebuchet: " RISE, ENTRANT_HIGH, KEPT, 0.124, CLOSING},
    {"energy", "trebuchet: " RISE, ENTRANT_DEFAULT, KEPT, 2.37, CLOSED_AT_ONCE},
    {"energy", "clock: " RISE, ENTRANT_DRAFT, 0.174, 0.434, SOFT_JOINTS},
    {"energy", "clock: " RISE, ENTRANT_EXACT, KEPT, 0.161, CLOSING},
    {"energy", "chain: " START, ENTRANT_DEFAULT, KEPT, 0.0481, SOFT_JOINTS},
    {"energy", "chain: " RISE, ENTRANT_DEFAULT, KEPT, 0.190, SOFT_JOINTS},
    {"energy", "chain: " RISE, ENTRANT_EXACT, KEPT, 0.106, CLOSING},
    {"energy", "joint_grid: " RISE, ENTRANT_DRAFT, KEPT, 5.06, SOFT_JOINTS},
    {"energy", "joint_grid: " RISE, ENTRANT_DEFAULT, KEPT, 1.31, SOFT_JOINTS},
    {"long-run", "stack of ten, an hour: furthest that a box has moved, mm", ENTRANT_DRAFT, 3.61,
     3.61, "the stack goes on settling after the tenth second, and stands after the fortieth"},
    {"linkages", "slider, 100 times its mass hung on its corner: sideways, mm", ENTRANT_DEFAULT,
     1.48, 1.48, SOFT_AT_FIRST},
};

enum { MISS_COUNT = sizeof MISSES / sizeof MISSES[0] };

static const miss *find(const extreme *x, const figure *f, entrant by) {
    for (int i = 0; i < MISS_COUNT; i++)
        if (strcmp(MISSES[i].extreme, x->name) == 0 && strcmp(MISSES[i].what, f->what) == 0 &&
            MISSES[i].by == by)
            return &MISSES[i];
    return NULL;
}

/* Whether `reached` is worse than `worst`, in the direction of the figure's bound. */
static bool is_beyond(const figure *f, double reached, double worst) {
    /* Negated comparisons, so that NaN is beyond. */
    return f->bound.kind == BOUND_AT_MOST ? !(reached <= worst) : !(reached >= worst);
}

/* Writes which figure is wrong, and what it is compared with, to `why`. */
static void blame(char *why, size_t size, const extreme *x, const figure *f, entrant e,
                  const char *what, double value) {
    snprintf(why, size, "%s: %s: %s reached %g: %s %g", x->name, f->what, entrant_name(e),
             f->reached[e], what, value);
}

known_miss known_misses_judge(const extreme *x, const figure *f, entrant e, bool quick, char *why,
                              size_t size) {
    const miss *m = find(x, f, e);
    double worst = !m ? KEPT : quick ? m->quick : m->full;
    bool holds = figure_holds(f, e);
    *why = '\0';
    if (worst == KEPT) {
        if (!holds)
            blame(why, size, x, f, e, "beyond the bound,", f->bound.value);
        return holds ? KNOWN_MISS_NONE : KNOWN_MISS_WRONG;
    }
    if (holds)
        blame(why, size, x, f, e, "kept; in known_misses.c it is still a miss of", worst);
    else if (is_beyond(f, f->reached[e], worst))
        blame(why, size, x, f, e, "worse than the worst value of known_misses.c,", worst);
    else
        snprintf(why, size, "missed, as known: %s: %s: %g (%s), bound %g: %s", x->name, f->what,
                 f->reached[e], entrant_name(e), f->bound.value, m->reason);
    return holds || is_beyond(f, f->reached[e], worst) ? KNOWN_MISS_WRONG : KNOWN_MISS_AS_KNOWN;
}

static bool has_figure(const ledger *l, const char *what) {
    for (int i = 0; i < l->count; i++)
        if (strcmp(l->figures[i].what, what) == 0)
            return true;
    return false;
}

const char *known_misses_stray(const extreme *x, const ledger *l) {
    for (int i = 0; i < MISS_COUNT; i++) {
        const miss *m = &MISSES[i];
        if (!extreme_find(m->extreme) || !m->reason || !*m->reason ||
            (m->quick == KEPT && m->full == KEPT))
            return m->what;
        if (strcmp(m->extreme, x->name) == 0 && !has_figure(l, m->what))
            return m->what;
    }
    return NULL;
}
