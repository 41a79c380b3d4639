/* line_search.c: help for active_set.c where contacts slide, in a file of its own, since only
 * islands with joints use it.
 *
 * A Newton step goes no further than to the minimum on its way. The function that the method
 * minimises is convex and piecewise quadratic along the step, so that its slope is piecewise linear
 * and grows (Hermans, Themelis, Patrinos, "QPALM: a proximal augmented Lagrangian method for
 * nonconvex quadratic programs", 2022).
 *
 * A greater friction bound may lower the normal impulse from which it is computed, as where
 * friction lifts what slides. Then the bounds swing about the solution: one that turns back goes
 * half of the way. */
#include "direct/direct.h"

/* A step is shortened if the function rises at its end more than this many times as steeply as it
 * falls at its beginning, to where its slope is smaller than that. Chosen. */
#define SLOPE_ENOUGH 0.1
/* Trials of a part of the step, of which every third halves the interval. Chosen. */
enum { TRIALS_MAX = 30 };

/* The impulse that the penalty of a row gives after a part of the Newton step. */
static double impulse_after(const td_direct_row *r, double part) {
    double speed = r->speed + part * r->change;
    double impulse = r->multiplier - r->weight * (speed - r->target_speed);
    double most = r->kind >= TD_ROW_FRICTION ? r->max_impulse : __builtin_inf();
    double least = r->kind == TD_ROW_UNILATERAL ? 0.0 : -most;
    return td_max_double(td_min_double(impulse, most), least);
}

/* The derivative of the function along the Newton step, after a part of it. `kinetic`: that of its
 * kinetic energy at the beginning, and how much this grows in a whole step. */
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

/* td_direct_search.part_of_step, by false position. */
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
