/* direct.c: solves the problem of direct.h by the active set, and by the interior point where
 * that does not converge. */
#include "direct/direct.h"

/* The part of one body in J M^-1 J', the inverse effective mass of a row. */
static double inverse_share(const double *j, const td_direct_body *b) {
    return (j[0] * j[0] + j[1] * j[1]) * b->inverse_mass + j[2] * j[2] * b->inverse_inertia;
}

/* Sets the effective mass of every row that is used, and copies the warm start. A row whose bodies
 * have infinite mass in its direction is not used. */
static void set_effective_masses(td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            r->warm_start = r->impulse;
            if (!r->used) {
                continue;
            }
            double inverse = (c->a == TD_NONE ? 0.0 : inverse_share(r->a, &d->bodies[c->a])) +
                             (c->b == TD_NONE ? 0.0 : inverse_share(r->b, &d->bodies[c->b]));
            r->used = inverse > 0.0;
            r->mass = inverse > 0.0 ? 1.0 / inverse : 0.0;
        }
    }
}

/* The interior point does not start with fewer factorisations left than this. Chosen: islands in
 * motion take 8 to 17, so that a solve with fewer would most likely fail. */
enum { INTERIOR_FACTORINGS_MIN = 8 };

double td_direct_approach(td_direct *d, double tolerance) {
    set_effective_masses(d);
    td_direct_update_friction(d);
    d->factored = false;
    if (!td_direct_solve_active_set(d, tolerance)) {
        return __builtin_inf();
    }
    td_direct_update_speeds(d);
    return td_direct_residual(d);
}

/* The first pass uses friction bounds from the warm start; the second uses bounds from the first
 * pass's normal impulses. One pass alone lets a slide at 20 degrees run 8 % too long. */
double td_direct_fall_back(td_direct *d, double tolerance) {
    td_direct_restore(d);
    for (int pass = 0; pass < 2; pass++) {
        if (d->factoring_budget - d->factorings < INTERIOR_FACTORINGS_MIN ||
            !td_direct_solve_interior_point(d, tolerance)) {
            return __builtin_inf();
        }
        td_direct_update_friction(d);
    }
    td_direct_update_speeds(d);
    return td_direct_residual(d);
}

double td_direct_solve(td_direct *d, double tolerance) {
    double residual = td_direct_approach(d, tolerance);
    return td_finite(residual) ? residual : td_direct_fall_back(d, tolerance);
}
