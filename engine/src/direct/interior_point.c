/* interior_point.c: a primal-dual interior point for the quadratic programme of direct.h, by
 * Mehrotra's predictor-corrector ("On the implementation of a primal-dual interior point method",
 * 1992; Nocedal and Wright, Numerical Optimization, 2006, algorithm 16.4).
 *
 * The conditions of each kind of row, with multiplier (impulse) y:
 *
 * - Unilateral: slack s = J v - target and impulse y, both > 0; the product s y goes to zero.
 * - Friction: y within its bounds. The distances low = max + y and high = max - y have slacks s0,
 *   s1 > 0 with s0 - s1 = J v - target; both products s0 low and s1 high go to zero.
 * - Spring with a maximum force: as friction, with s0 - s1 = J v - target + y / weight, so that it
 *   is a spring between its bounds.
 * - Equality: a penalty of weight STIFFNESS times the effective mass, whose multiplier is the
 *   row's impulse so far.
 * - Spring without a maximum force: a penalty of its own weight, without a multiplier.
 *
 * Each iteration linearises these conditions and the equilibrium of the bodies. Eliminating
 * impulses and slacks leaves the equations of td_direct_step, where a unilateral row has weight = y
 * / s, and a friction row or spring has weight = 1 / (s0 / low + s1 / high + compliance), with the
 * spring's compliance 1 / weight. The equations are solved twice with one factor. The predictor
 * aims at products of zero. With gap, the mean of the products, and gap_after, that after the
 * longest part of the predictor's step that makes no slack, impulse or distance negative,
 *     sigma = (gap_after / gap)^3
 * and the corrector aims at products of sigma gap, and adds the second-order term of the products,
 * from the predictor's steps. Products are divided by the row's effective mass, so that heavy and
 * light contacts converge alike. */
#include "direct/direct.h"

/* A step goes this share of the way to the boundary, the point at which the first slack, impulse or
 * distance to a bound would be zero. Chosen; 0.9 to 0.995 is usual. */
#define BOUNDARY_SHARE 0.98
/* The iteration ends when the square root of the mean product per effective mass
 * (complementarity_gap), which is a speed, is below this share of the tolerance. Chosen. */
#define DUALITY_GAP_SHARE 0.1

/* The penalty weight of an equality, in effective masses. After an iteration the row misses its
 * target by about 1e-9 of what it would without the penalty; with rounding (2^-53), seven digits of
 * the masses remain in the matrix. */
#define STIFFNESS 1e9

/* Maximum number of iterations. Islands at rest take 2 to 5, islands in motion 8 to 17. */
enum { ITERATIONS_MAX = 40 };

/* A friction row whose bound is below this, in multiples of the row's mass times g h, is left out
 * as frictionless: its slacks would be divided by almost zero. Chosen. */
#define FRICTION_MIN 1e-9

/* Whether a row has neither a slack nor a bound of its impulse: an equality, or a spring without a
 * maximum force. */
static bool is_unbound(const td_direct_row *r) {
    return r->kind == TD_ROW_EQUALITY ||
           (r->kind == TD_ROW_SOFT && !(r->max_impulse < __builtin_inf()));
}

/* 1 / weight of a soft row, whose weight is in `soft_weight` while the interior point runs. */
static double compliance(const td_direct_row *r) {
    return r->kind == TD_ROW_SOFT ? 1.0 / r->soft_weight : 0.0;
}

/* The difference between the slacks of a row's two bounds: J v - target for a friction row, J v -
 * target + y / weight for a spring. */
static double slack_difference(const td_direct_row *r) {
    return r->speed - r->target_speed + compliance(r) * r->impulse;
}

static bool is_frictionless(const td_direct *d, const td_direct_row *r) {
    return !(r->max_impulse > FRICTION_MIN * r->mass * d->unit_speed);
}

/* Distance of a friction row's impulse from its lower (0) or upper (1) bound. */
static double bound_distance(const td_direct_row *r, int which) {
    return which ? r->max_impulse - r->impulse : r->max_impulse + r->impulse;
}

/* The starting point: v = v*, and positive slacks and impulses of the size of the root mean square
 * of the residuals, or of g h if that is larger (1e-9 keeps it above zero in a world without
 * gravity). Impulses of the last step are not used: where heavy bodies lie on light ones, stale
 * impulses are so far off that the method does not converge. */
static void start(td_direct *d) {
    double sum = 0.0;
    int rows = 0;
    for (int i = 0; i < d->body_count; i++) {
        for (int k = 0; k < 3; k++) {
            d->bodies[i].velocity[k] = d->bodies[i].free[k];
        }
    }
    td_direct_update_speeds(d);
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (r->kind >= TD_ROW_FRICTION) {
                continue;
            }
            bool misses = r->speed < r->target_speed || r->kind == TD_ROW_EQUALITY;
            double lack = r->used && misses ? r->target_speed - r->speed : 0.0;
            sum += lack * lack;
            rows += r->used;
        }
    }
    double typical = td_max_double(d->unit_speed, rows ? __builtin_sqrt(sum / rows) : 0.0);
    typical = td_max_double(typical, 1e-9);
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            double over = r->speed - r->target_speed;
            r->soft_weight = r->weight;
            if (is_unbound(r)) {
                r->slack[0] = r->slack[1] = r->direction[1] = r->direction[2] = r->impulse = 0.0;
            } else if (r->kind == TD_ROW_UNILATERAL) {
                r->slack[0] = td_max_double(over, typical);
                r->impulse = r->mass * typical;
            } else {
                r->slack[0] = td_max_double(over, 0.0) + typical;
                r->slack[1] = td_max_double(-over, 0.0) + typical;
                r->impulse = 0.0;
            }
            bool frictionless = r->kind >= TD_ROW_FRICTION && is_frictionless(d, r);
            r->active = r->used && !frictionless;
            r->force = 0.0;
        }
    }
}

/* The mean, over all conditions, of the product of impulse and slack divided by the effective mass
 * (a speed squared), after `part` of the step has been taken. */
static double complementarity_gap(const td_direct *d, double part) {
    double sum = 0.0;
    int products = 0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (!r->active || is_unbound(r)) {
                continue;
            }
            double impulse = part * r->direction[0], first = r->slack[0] + part * r->direction[1];
            if (r->kind == TD_ROW_UNILATERAL) {
                sum += first * (r->impulse + impulse) / r->mass;
                products++;
            } else {
                double second = r->slack[1] + part * r->direction[2];
                sum += (first * (bound_distance(r, 0) + impulse) +
                        second * (bound_distance(r, 1) - impulse)) /
                       r->mass;
                products += 2;
            }
        }
    }
    return products ? sum / products : 0.0;
}

/* Sets the row's weight in the matrix and its force on the right side. `aim` is the target for the
 * products per mass; `second_order` is 1 to include the products of the predictor's steps (in
 * `direction`), and 0 to leave them out. */
static void linearise_row(td_direct_row *r, double aim, double second_order) {
    double over = r->speed - r->target_speed;
    if (is_unbound(r)) {
        bool soft = r->kind == TD_ROW_SOFT;
        r->weight = soft ? r->soft_weight : STIFFNESS * r->mass;
        r->force = (soft ? 0.0 : r->impulse) - r->weight * over;
        return;
    }
    if (r->kind == TD_ROW_UNILATERAL) {
        double lack = over - r->slack[0];
        double product = aim * r->mass - r->slack[0] * r->impulse -
                         second_order * r->direction[0] * r->direction[1];
        r->weight = r->impulse / r->slack[0];
        r->force = r->impulse + product / r->slack[0] - r->weight * lack;
        return;
    }
    double low = bound_distance(r, 0), high = bound_distance(r, 1);
    double lack = slack_difference(r) - (r->slack[0] - r->slack[1]);
    double first =
        aim * r->mass - r->slack[0] * low - second_order * r->direction[0] * r->direction[1];
    double second =
        aim * r->mass - r->slack[1] * high + second_order * r->direction[0] * r->direction[2];
    r->weight = 1.0 / (r->slack[0] / low + r->slack[1] / high + compliance(r));
    r->force = r->impulse + r->weight * (first / low - second / high - lack);
}

/* The steps of the row's impulse and slacks, from the change of its speed, by substitution into the
 * linearised conditions. */
static void substitute_row(td_direct_row *r, double aim, double second_order) {
    double over = r->speed - r->target_speed, old = r->direction[0];
    r->direction[0] = r->force - r->impulse - r->weight * r->change;
    if (is_unbound(r)) {
        return;
    }
    if (r->kind == TD_ROW_UNILATERAL) {
        r->direction[1] = r->change + over - r->slack[0];
        return;
    }
    double low = bound_distance(r, 0), high = bound_distance(r, 1);
    double first = aim * r->mass - r->slack[0] * low - second_order * old * r->direction[1];
    double second = aim * r->mass - r->slack[1] * high + second_order * old * r->direction[2];
    r->direction[1] = (first - r->slack[0] * r->direction[0]) / low;
    r->direction[2] = (second + r->slack[1] * r->direction[0]) / high;
}

/* Shortens a step so that value + part * change is not negative. */
static double shorten(double part, double value, double change) {
    return value + part * change < 0.0 ? -value / change : part;
}

/* The longest part of the step, up to `max`, for which no slack, impulse or distance to a bound is
 * negative. */
static double step_to_boundary(const td_direct *d, double max) {
    double part = max;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (!r->active || is_unbound(r)) {
                continue;
            }
            part = shorten(part, r->slack[0], r->direction[1]);
            if (r->kind == TD_ROW_UNILATERAL) {
                part = shorten(part, r->impulse, r->direction[0]);
            } else {
                part = shorten(part, r->slack[1], r->direction[2]);
                part = shorten(part, bound_distance(r, 0), r->direction[0]);
                part = shorten(part, bound_distance(r, 1), -r->direction[0]);
            }
        }
    }
    return part;
}

/* Calls a function for every active row. */
static void for_rows(td_direct *d, void (*each)(td_direct_row *, double, double), double aim,
                     double second_order) {
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            if (r->active) {
                each(r, aim, second_order);
            }
        }
    }
}

static void advance_row(td_direct_row *r, double part, double unused) {
    (void)unused;
    r->impulse += part * r->direction[0];
    r->slack[0] += part * r->direction[1];
    r->slack[1] += part * r->direction[2];
}

/* Takes a part of the step. False where a velocity is not finite. */
static bool advance(td_direct *d, double part) {
    bool done = td_direct_advance(d, part);
    for_rows(d, advance_row, part, 0.0);
    td_direct_update_speeds(d);
    return done;
}

/* The primal residual: the greatest difference between a unilateral row's slack and J v - target,
 * and the greatest miss of an equality. It is zero after a whole step was taken. */
static double primal_residual(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (r->kind >= TD_ROW_FRICTION) {
                continue;
            }
            double off = r->used ? r->slack[0] - (r->speed - r->target_speed) : 0.0;
            worst = td_max_double(worst, off < 0.0 ? -off : off);
        }
    }
    return worst;
}

/* Sets the impulse of a unilateral row to zero if the slack is the larger of the two: this is the
 * active set to which the method has converged. */
static void round_to_active_set(td_direct_row *r, double unused, double also_unused) {
    (void)unused, (void)also_unused;
    if (r->kind == TD_ROW_UNILATERAL && !(r->impulse > r->mass * r->slack[0])) {
        r->impulse = 0.0;
    }
}

/* The iteration. False where a factorisation fails, or budgets run out. */
static bool iterate(td_direct *d, double tolerance) {
    double gap_enough = DUALITY_GAP_SHARE * tolerance * DUALITY_GAP_SHARE * tolerance;
    start(d);
    for (int n = 0; n < ITERATIONS_MAX && d->factorings < d->factoring_budget; n++) {
        for_rows(d, linearise_row, 0.0, 0.0);
        if (!td_direct_factor(d) || !td_direct_step(d)) {
            return false;
        }
        for_rows(d, substitute_row, 0.0, 0.0);
        double now = complementarity_gap(d, 0.0);
        double after = complementarity_gap(d, step_to_boundary(d, 1.0));
        double left = now > 0.0 ? after / now : 0.0, sigma = left * left * left;
        double aim = sigma * now;
        for_rows(d, linearise_row, aim, 1.0);
        if (!td_direct_step(d)) {
            return false;
        }
        for_rows(d, substitute_row, aim, 1.0);
        if (!advance(d, BOUNDARY_SHARE * step_to_boundary(d, 1.0 / BOUNDARY_SHARE))) {
            return false;
        }
        if (complementarity_gap(d, 0.0) <= gap_enough && primal_residual(d) <= tolerance) {
            for_rows(d, round_to_active_set, 0.0, 0.0);
            return true;
        }
    }
    return false;
}

bool td_direct_solve_interior_point(td_direct *d, double tolerance) {
    bool done = iterate(d, tolerance);
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            r->weight = r->kind == TD_ROW_SOFT ? r->soft_weight : r->weight;
        }
    }
    return done;
}
