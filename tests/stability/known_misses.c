/* known_misses.c: the bounds that thud does not keep yet, line by line. A bound that is kept again
 * leaves the list, and is asserted from then on. docs/stability.md tells how far each is missed. */
#include "extremes/extreme.h"

#include <string.h>

static const struct {
    const char *extreme, *what; /* a figure's text, as in the ledger */
    unsigned by;                /* ON_ */
    double worst;               /* of them all, in either form; a figure beyond it is a fault */
} MISSES[] = {
    {"energy", "pyramid: energy above its lowest before, %", ON_DRAFT, 0.25},
    {"energy", "smash: energy above its lowest before, %", ON_THUD, 5.5},
    {"energy", "heavy_on_light: energy above its lowest before, %", ON_DRAFT | ON_DEFAULT, 0.45},
    {"energy", "circle_pit: energy above its lowest before, %", ON_DRAFT | ON_HIGH, 1.15},
    {"energy", "tall_stack: energy above its lowest before, %", ON_DRAFT, 0.4},
    {"energy", "sizes: energy above its lowest before, %", ON_DRAFT | ON_DEFAULT | ON_HIGH, 2.65},
    {"long-run", "stack of ten, an hour: furthest that a box has moved, mm", ON_DRAFT, 4},
};

enum { MISS_COUNT = sizeof MISSES / sizeof MISSES[0] };

unsigned known_misses(const extreme *x, const figure *f) {
    for (int i = 0; i < MISS_COUNT; i++)
        if (strcmp(MISSES[i].extreme, x->name) == 0 && strcmp(MISSES[i].what, f->what) == 0)
            return MISSES[i].by;
    return 0;
}

double known_misses_worst(const extreme *x, const figure *f) {
    for (int i = 0; i < MISS_COUNT; i++)
        if (strcmp(MISSES[i].extreme, x->name) == 0 && strcmp(MISSES[i].what, f->what) == 0)
            return MISSES[i].worst;
    return f->bound.value;
}

static bool has_figure(const ledger *l, const char *what) {
    for (int i = 0; i < l->count; i++)
        if (strcmp(l->figures[i].what, what) == 0)
            return true;
    return false;
}

const char *known_misses_stray(const extreme *x, const ledger *l) {
    for (int i = 0; i < MISS_COUNT; i++)
        if (strcmp(MISSES[i].extreme, x->name) == 0 && !has_figure(l, MISSES[i].what))
            return MISSES[i].what;
    return NULL;
}
