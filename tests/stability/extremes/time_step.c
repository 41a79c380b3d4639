/* time_step.c: the extreme "time-step": a column of boxes at coarse, fine and alternating time
 * steps. Measured is the height that its top loses. */
#include "extremes/stack.h"

#include <math.h>

enum { BOXES = 10 };

/* Alternates time steps of `first` and `second` seconds. Returns the height that the top has lost
 * at the end, in boxes. */
static double height_lost(ledger *l, entrant e, double first, double second) {
    scene s;
    stack_init(&s, BOXES, 1);
    trial *t = trial_begin(l, e, &s, (engine_settings){.time_step = first});
    double lost = NAN;
    if (t) {
        double seconds = l->quick ? 1 : 20;
        int steps = (int)round(seconds / (0.5 * (first + second)));
        bool ok = true;
        for (int i = 0; ok && i < steps; i++) {
            if (first != second)
                ok = trial_set_time_step(t, i % 2 == 0 ? first : second);
            ok = ok && trial_step(t);
        }
        lost = ok ? stack_lost(t, BOXES, 1) : INFINITY;
    }
    trial_end(t);
    scene_free(&s);
    return lost;
}

static void run(ledger *l) {
    static const int RATES[][2] = {{15, 15},   {30, 30},   {60, 60},     {120, 120},
                                   {240, 240}, {480, 480}, {1000, 1000}, {30, 120}};
    enum { CASE_COUNT = sizeof RATES / sizeof RATES[0] };
    for (int i = 0; i < CASE_COUNT; i++) {
        int first = RATES[i][0], second = RATES[i][1];
        bound b = bound_at_most(0.1, ON_DEFAULT | ON_EXACT);
        figure *f = first == second ? ledger_add(l, b, "1/%d s", first)
                                    : ledger_add(l, b, "1/%d s and 1/%d s in turn", first, second);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, f->what, (double)i / CASE_COUNT);
            if (ledger_has(l, e))
                figure_tell(f, e, height_lost(l, e, 1.0 / first, 1.0 / second));
        }
    }
}

const extreme extreme_time_step = {
    .name = "time-step",
    .title = "Time step",
    .about = "A column of ten boxes for 20 s. Figures: by how much the top is lower than it "
             "started, in box heights; the bound is 1 % a box.",
    .run = run,
};
