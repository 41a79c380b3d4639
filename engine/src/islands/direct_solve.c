/* direct_solve.c: see direct.h: the active set first, and the interior point where it fails. */
#include "islands/direct.h"

static double inverse_share(const double *j, const td_direct_body *b) {
    return (j[0] * j[0] + j[1] * j[1]) * b->inverse_mass + j[2] * j[2] * b->inverse_inertia;
}

static void weigh(td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            double inverse = (c->a == TD_NONE ? 0.0 : inverse_share(r->a, &d->bodies[c->a])) +
                             (c->b == TD_NONE ? 0.0 : inverse_share(r->b, &d->bodies[c->b]));
            r->used = r->used && inverse > 0.0;
            r->mass = inverse > 0.0 ? 1.0 / inverse : 0.0;
            r->guess = r->impulse;
        }
    }
}

enum { LEAST_STEPS = 8 }; /* with fewer the interior point need not begin */

double td_direct_solve(td_direct *d, double tolerance) {
    weigh(d);
    td_direct_bound(d);
    d->factored = false;
    if (!td_direct_active(d, tolerance)) {
        td_direct_forget(d);
        /* Bounds of friction come from a first pass; the second one heeds them. */
        for (int pass = 0; pass < 2; pass++) {
            if (d->patience - d->factorings < LEAST_STEPS || !td_direct_interior(d, tolerance)) {
                return __builtin_inf();
            }
            td_direct_bound(d);
        }
    }
    td_direct_measure(d);
    return td_direct_miss(d);
}
