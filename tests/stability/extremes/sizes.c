/* sizes.c: the extreme "sizes": tiny and huge boxes with the same settings (length_scale 1, gravity
 * 10 m/s^2, step 1/60 s). Measured is the penetration in % of the box's size. */
#include "extremes/stack.h"

#include <math.h>

enum { STACKED = 10 };

/* The largest penetration of the last step in % of the size; infinite if the stack fell. */
static double stack_penetration(ledger *l, entrant e, double size) {
    scene s;
    stack_init(&s, STACKED, size);
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double reached = NAN;
    if (t) {
        penetration seen = {0};
        bool stepped = trial_steps(t, l->quick ? 60 : 600);
        trial_penetration(t, &seen);
        reached =
            stepped && isfinite(stack_lost(t, STACKED, size)) ? 100 * seen.worst / size : INFINITY;
    }
    trial_end(t);
    scene_free(&s);
    return reached;
}

/* A box on one that is 1,000 times as wide; the penetration in % of the small one's size. */
static double flea_penetration(ledger *l, entrant e, double small) {
    double big = 1000 * small;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -big, 2 * big, big);
    s.bodies[0].y = -big;
    scene_dynamic_box(&s, 0, 0, 0.5 * big, 0.5 * big)->y = 0.5 * big;
    scene_dynamic_box(&s, 0, 0, 0.5 * small, 0.5 * small)->y = big + 0.5 * small;
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    double reached = NAN;
    if (t) {
        bool stepped = trial_steps(t, l->quick ? 60 : 600);
        const engine_body *now = trial_read(t);
        double gap = (now[2].y - 0.5 * small) - (now[1].y + 0.5 * big);
        /* A gap as wide as the contacts' resting distance is no error; the box must not have flown
         * off. */
        bool there = fabs(now[2].x) < small && gap < 0.1 * small + 0.01;
        reached = stepped && there ? 100 * fmax(-gap, 0) / small : INFINITY;
    }
    trial_end(t);
    scene_free(&s);
    return reached;
}

static void run(ledger *l) {
    enum { POWERS = 7, FLEAS = 3 };
    static const double FLEA[FLEAS] = {0.01, 0.1, 1};
    for (int i = 0; i < POWERS + FLEAS; i++) {
        bound b = bound_at_most(1, ON_DEFAULT | ON_EXACT);
        double size = i < POWERS ? pow(10, i - 3) : FLEA[i - POWERS];
        figure *f = i < POWERS ? ledger_add(l, b, "ten boxes of %g", size)
                               : ledger_add(l, b, "a box of %g on one of %g", size, 1000 * size);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, f->what, (double)i / (POWERS + FLEAS));
            if (ledger_has(l, e))
                figure_tell(f, e,
                            i < POWERS ? stack_penetration(l, e, size)
                                       : flea_penetration(l, e, size));
        }
    }
}

const extreme extreme_sizes = {
    .name = "sizes",
    .title = "Sizes",
    .about = "Boxes of one size on each other, and a box on one 1,000 times as big, all in worlds "
             "of length scale 1, for 10 s. Figures: penetration at the end, in % of the (smaller) "
             "box's size.",
    .run = run,
};
