/* tied.c: see tied.h. */
#include "extremes/tied.h"

#include <math.h>

double tied_worse(double a, double b) {
    return a >= b ? a : b >= a ? b : INFINITY;
}

static bound bound_of(double value, unsigned on) {
    return value > 0 ? bound_at_most(value, on) : bound_none();
}

void tied_tell(ledger *l, const tied_row *rows, int row_count, const char *about, tied_run *run,
               const void *how) {
    figure *all[TIED_FIGURES] = {0}, *exact[TIED_FIGURES] = {0};
    for (int i = 0; i < row_count; i++) {
        const tied_row *row = &rows[i];
        all[i] = ledger_add(l, bound_of(row->bound, ON_TIED), "%s: %s", about, row->what);
        if (row->exact > 0)
            exact[i] =
                ledger_add(l, bound_of(row->exact, ON_EXACT), "%s: %s, at exact", about, row->what);
    }
    for (entrant e = 0; e < ENTRANTS; e++) {
        if (!ledger_has(l, e))
            continue;
        tied_outcome o = run(l, e, how);
        for (int i = 0; i < row_count; i++) {
            figure_tell(all[i], e, o.value[i]);
            if (exact[i] && e == ENTRANT_EXACT)
                figure_tell(exact[i], e, o.value[i]);
        }
    }
}
