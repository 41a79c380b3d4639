/* line_search.c: td_direct_search for active_set.c: two measures by which the active set converges
 * where contacts slide. They have a file of their own, so that programs without joints do not link
 * them: only islands with joints use them.
 *
 * part_of_step is a line search: a Newton step that passes the minimum of the function along it is
 * shortened to end near that minimum. The function that active_set.c minimises is convex and
 * piecewise quadratic along the step, so that its derivative is piecewise linear and never falls
 * (Hermans, Themelis, Patrinos, "QPALM: a proximal augmented Lagrangian method for nonconvex
 * quadratic programs", 2022).
 *
 * update_bounds damps the fixed-point iteration of friction bounds. A greater friction bound may
 * lower the normal impulse from which it is computed, for example where the friction force lifts
 * the sliding body. The bounds then oscillate about the solution. So a bound whose change has the
 * opposite sign of its last change goes half of the way only. */
#include "direct/direct.h"

/* The line search ends at a step length at which the magnitude of the derivative is at most this
 * share of that at the beginning of the step. A whole step is taken where the function still falls
 * at its end, or rises no more steeply than that. Chosen. */
#define SLOPE_ENOUGH 0.1
/* Maximum number of step lengths that are tried. Every third halves the interval (bisection), the
 * others are by false position. Chosen. */
enum { TRIALS_MAX = 30 };

/* The impulse that the penalty of a row gives after a part of the Newton step. */
static double impulse_after(const td_direct_row *r, double part) {
    double speed = r->speed + part * r->change;
    double impulse = r->multiplier - r->weight * (speed - r->target_speed);
    double impulse_max = r->kind >= TD_ROW_FRICTION ? r->max_impulse : __builtin_inf();
    double impulse_min = r->kind == TD_ROW_UNILATERAL ? 0.0 : -impulse_max;
    return td_max_double(td_min_double(impulse, impulse_max), impulse_min);
}

/* The derivative of the augmented Lagrangian along the Newton step dv, after a part of it.
 * `kinetic`: that of the term 1/2 (v - v*)' M (v - v*) at the beginning, (v - v*)' M dv, and its
 * increase over the whole step, dv' M dv. */
static double slope_after(const td_direct *d, const double kinetic[2], double part) {
    double slope = kinetic[0] + part * kinetic[1];
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            slope -= r->used ? r->change * impulse_after(r, part) : 0.0;
        }
    }
    return slope;
}

/* td_direct_search.part_of_step: searches for the zero of slope_after, by false position. */
static double part_of_step(const td_direct *d) {
    double kinetic[2] = {0.0, 0.0};
    for (int i = 0; i < d->body_count; i++) {
        const td_direct_body *b = &d->bodies[i];
        for (int k = 0; k < 3; k++) {
            double inverse = k < 2 ? b->inverse_mass : b->inverse_inertia;
            double momentum = inverse > 0.0 ? d->step[i][k] / inverse : 0.0;
            kinetic[0] += (b->velocity[k] - b->free[k]) * momentum;
            kinetic[1] += d->step[i][k] * momentum;
        }
    }
    double low = 0.0, high = 1.0;
    double falls = slope_after(d, kinetic, low), rises = slope_after(d, kinetic, high);
    double enough = -SLOPE_ENOUGH * falls, part = high, slope = rises;
    if (!(falls < 0.0) || !(rises > enough)) {
        return 1.0;
    }
    for (int n = 1; n <= TRIALS_MAX && td_abs(slope) > enough; n++) {
        double share = n % 3 ? falls / (falls - rises) : 0.5;
        part = low + share * (high - low);
        slope = slope_after(d, kinetic, part);
        if (slope < 0.0) {
            low = part;
            falls = slope;
        } else {
            high = part;
            rises = slope;
        }
    }
    return part;
}

/* td_direct_search.update_bounds */
static void update_bounds(td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_row *r = &d->constraints[i].row[TD_DIRECT_TANGENT];
        double bound = td_direct_friction_bound(&d->constraints[i]);
        double change = bound - r->max_impulse;
        r->max_impulse = change * r->bound_change < 0.0 ? 0.5 * (r->max_impulse + bound) : bound;
        r->bound_change = td_finite(change) ? change : 0.0;
    }
}

const td_direct_search td_direct_line_search = {part_of_step, update_bounds};
