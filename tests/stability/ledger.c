/* ledger.c: rows of an extreme's table and their bounds, see extreme.h. */
#include "extremes/extreme.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

const char *entrant_name(entrant e) {
    static const char *const NAMES[ENTRANTS] = {"draft", "default",     "high",     "exact",
                                                "Box2D", "Box2D stiff", "Chipmunk", "Chipmunk 160"};
    return NAMES[e];
}

figure *ledger_add(ledger *l, bound b, const char *format, ...) {
    if (l->count == LEDGER_FIGURES) {
        fprintf(stderr, "stability: more than %d figures in one extreme\n", LEDGER_FIGURES);
        l->failed = true;
        l->count--; /* the last row is overwritten; the run counts as failed */
    }
    figure *f = &l->figures[l->count++];
    *f = (figure){.bound = b};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(f->what, sizeof f->what, format, arguments);
    va_end(arguments);
    return f;
}

void figure_tell(figure *f, entrant e, double reached) {
    f->measured |= 1u << e;
    f->reached[e] = reached;
}

void ledger_progress(ledger *l, const char *what, double share) {
    if (l->progress)
        l->progress(what, share);
}

bool ledger_has(const ledger *l, entrant e) {
    return (l->entrants & 1u << e) != 0;
}

bound bound_none(void) {
    return (bound){.kind = BOUND_NONE};
}

bound bound_at_most(double value, unsigned on) {
    return (bound){.kind = BOUND_AT_MOST, .value = value, .on = on};
}

bound bound_at_least(double value, unsigned on) {
    return (bound){.kind = BOUND_AT_LEAST, .value = value, .on = on};
}

bool figure_holds(const figure *f, entrant e) {
    if (f->bound.kind == BOUND_NONE || !(f->bound.on & f->measured & 1u << e))
        return true;
    /* These comparisons are false for NaN, which does not hold. */
    return f->bound.kind == BOUND_AT_MOST
               ? f->reached[e] <= f->bound.value
               : isfinite(f->reached[e]) && f->reached[e] >= f->bound.value;
}
