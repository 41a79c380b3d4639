/* columns.c: the extreme "columns": how high a column of equal boxes may be and still stand.
 * Measured is the height that the top loses, in boxes. */
#include "extremes/stack.h"

#include <math.h>

static double height_lost(ledger *l, entrant e, const scene *s, int boxes) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return NAN;
    double lost = trial_steps(t, l->quick ? 60 : 1200) ? stack_lost(t, boxes, 1) : INFINITY;
    trial_end(t);
    return lost;
}

static void run(ledger *l) {
    const struct {
        int boxes;
        bound bound;
    } CASES[] = {
        {30, bound_none()},
        {100, bound_at_most(0.05, ON_DEFAULT)},
        {150, bound_at_most(0.05, ON_DEFAULT)},
        {200, bound_at_most(0.01, ON_DEFAULT | ON_EXACT)},
        /* Bound of half a box: the column counts as standing. */
        {1000, bound_at_most(0.5, ON_EXACT)},
    };
    enum { CASE_COUNT = sizeof CASES / sizeof CASES[0] };
    for (int i = 0; i < CASE_COUNT; i++) {
        int boxes = CASES[i].boxes;
        scene s;
        stack_init(&s, boxes, 1);
        figure *f = ledger_add(l, CASES[i].bound, "column of %d", boxes);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, f->what, (double)i / CASE_COUNT);
            if (ledger_has(l, e))
                figure_tell(f, e, height_lost(l, e, &s, boxes));
        }
        scene_free(&s);
    }
}

const extreme extreme_columns = {
    .name = "columns",
    .title = "Column of boxes",
    .about = "Equal boxes on each other, for 20 s. Figures: by how much the topmost is lower than "
             "it started, in box heights; fallen when any has moved sideways by half a box.",
    .run = run,
};
