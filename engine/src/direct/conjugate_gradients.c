/* conjugate_gradients.c: conjugate gradients on the multipliers of the active rows.
 *
 * The penalties of active_set.c leave a residual r_i = target_i - speed_i of about impulse_i / D.
 * That is small, except in the few bending modes of a tall column, in which the small compliances
 * of all contacts add up over the height. With the active rows as equalities, the multipliers y
 * solve a linear system whose matrix is J (M + sum D J' J)^-1 J'; the factor of its inner matrix is
 * already there. Preconditioned conjugate gradients (Hestenes and Stiefel, "Methods of conjugate
 * gradients for solving linear systems", 1952), with the penalties D as preconditioner, converge in
 * about as many iterations as there are such modes. One iteration:
 *
 *     rho = sum r D r
 *     p   = D r + (rho / rho_before) p
 *     dv  from  (M + sum D J' J) dv = J' p            (td_direct_step)
 *     alpha = rho / sum p (J dv)
 *     v  += alpha dv
 *     f  += alpha (p - D J dv),  y = f - D r          (balance)
 *
 * The residual r, the direction p, the force f and the multiplier y have a number for each active
 * row; D is the diagonal of the rows' penalty weights. The forces f hold the bodies in equilibrium
 * at the velocities v: M (v - v*) = J' f. In the code alpha is `part`. */
#include "direct/direct.h"

/* Maximum number of iterations. Chosen; each costs one solve with the present factor. */
enum { ITERATIONS_MAX = 12 };
/* Maximum of alpha, the length of a step along the search direction p. A larger alpha means that
 * the active rows contradict each other along p: no velocities satisfy all of them, and the
 * iteration is given up. Chosen. */
#define STEP_MAX 100.0

/* The residual of a row. A soft row has none: it is satisfied by its own stiffness. */
static double residual_of(const td_direct_row *r) {
    return r->kind == TD_ROW_SOFT ? 0.0 : r->target_speed - r->speed;
}

/* ---- one row's part of each sum and update ---- */

/* r D r */
static double weighted_square(td_direct_row *r, double unused) {
    (void)unused;
    return residual_of(r) * r->weight * residual_of(r);
}

/* Sets the next search direction p, in direction[0], and adds it to the forces. */
static double set_direction(td_direct_row *r, double share) {
    r->direction[0] = r->weight * residual_of(r) + (share > 0.0 ? share * r->direction[0] : 0.0);
    r->force += r->direction[0];
    return r->direction[0];
}

/* p (J dv) */
static double curvature(td_direct_row *r, double unused) {
    (void)unused;
    return r->direction[0] * r->change;
}

/* After a step of length `part`: updates the force f, by which the bodies are in equilibrium at
 * their new velocities, and the multiplier y = f - D r. */
static double balance(td_direct_row *r, double part) {
    r->force += part * (r->direction[0] - r->weight * r->change) - r->direction[0];
    r->multiplier = r->kind == TD_ROW_SOFT ? 0.0 : r->force - r->weight * residual_of(r);
    return 0.0;
}

/* Whether the residual is above `enough`. */
static double exceeds(td_direct_row *r, double enough) {
    return residual_of(r) > enough || -residual_of(r) > enough;
}

/* ---- all rows ---- */

/* The sum of a function over the active rows; `x` is its second argument. */
static double sum(td_direct *d, double (*each)(td_direct_row *, double), double x) {
    double all = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            all += r->used && r->active ? each(r, x) : 0.0;
        }
    }
    return all;
}

bool td_direct_reduce_residual(td_direct *d, double enough) {
    double before = 0.0, part = 1.0;
    for (int n = 0; n < ITERATIONS_MAX && part > 0.0 && sum(d, exceeds, enough) > 0.0; n++) {
        double now = sum(d, weighted_square, 0.0);
        sum(d, set_direction, before > 0.0 ? now / before : 0.0);
        if (!td_direct_step(d)) {
            return false;
        }
        double bent = sum(d, curvature, 0.0);
        part = now < STEP_MAX * bent ? now / bent : 0.0;
        if (!td_direct_advance(d, part)) {
            return false;
        }
        sum(d, balance, part);
        before = now;
    }
    return true;
}
