/* active_set.c: an active-set method on the augmented Lagrangian, started from the active set of
 * the last step.
 *
 * A row of penalty weight D and multiplier y (the latest estimate of its impulse) acts on its
 * bodies by
 *     unilateral:  impulse = max(0, y - D (J v - target))
 *     equality:    impulse = y - D (J v - target)
 *     friction:    impulse = y - D (J v - target), clamped to -max_impulse and max_impulse
 * (Hestenes, "Multiplier and gradient methods", 1969; Powell, "A method for nonlinear constraints
 * in minimization problems", 1969; for inequalities Rockafellar, "The multiplier method of Hestenes
 * and Powell applied to convex programming", 1973). These impulses are the gradient of a function
 * of v that is convex and piecewise quadratic. A row is active where its impulse is not clamped.
 * Newton's method on the active rows (a semismooth Newton method) has found the minimum when a
 * whole step does not change the active set. Whole steps may lead back and forth between active
 * sets, so in islands with joints, where that is common, they are shortened (line_search.c). Then
 *   1. conjugate gradients reduce the residual that the penalties left (conjugate_gradients.c),
 *   2. y is set to the impulses, and friction bounds are computed from the new normal impulses, and
 *      everything is repeated until residual and friction are within the tolerance. */
#include "direct/direct.h"

/* The penalty weight D of a row is PENALTY times its effective mass, or times the mass whose weight
 * it carries (impulse / (g h)) if that is larger: at 1e5 a body of the row's own mass misses the
 * target speed by 1e-5 g h before conjugate gradients. D is at most PENALTY_MAX effective masses:
 * above it the masses in the matrix are lost to rounding (2^-53), and in a drop test with a load
 * ratio of 10^5 velocities became NaN. */
#define PENALTY 1e5
#define PENALTY_MAX 1e9

/* A row enters or leaves the active set only when it is beyond the threshold by this share of the
 * tolerance of speeds (update_row). Chosen. */
#define HYSTERESIS 0.1

/* A friction bound that is wrong by less than this factor is not recomputed: normal impulses of a
 * heap at rest vary by less from step to step. Chosen. */
#define BOUND_FACTOR 1.02

/* A friction row whose impulse is above this share of its bound is taken to slide: above
 * SLIDING_SHARE if the surfaces also slide against it, above AT_BOUND in any case. Chosen. */
#define SLIDING_SHARE 0.9
#define AT_BOUND 0.999
/* As AT_BOUND, for the warm start: the impulse of a row that slid in the last step equals its bound
 * up to rounding. */
#define AT_BOUND_BEFORE (1.0 - 1e-6)

/* Conjugate gradients reduce residuals to this share of the tolerance. Chosen. */
#define RESIDUAL_SHARE 1e-4

enum {
    FACTORINGS_MAX = 6, /* factorisations before the method gives up; an island at rest takes one */
    /* As FACTORINGS_MAX, with td_direct.search. Measured at the quality `default`: at 6 the widest
     * gaps of 23 bridges of 10 to 98 planks under a lorry are two to five times those at 8
     * (geometric means); at 10 a step of bridges under boxes takes two fifths longer. */
    FACTORINGS_OF_SEARCH = 8,
    UPDATES_MAX =
        12, /* maximum number of updates of multipliers and friction bounds in one solve */
    UPDATES_AGAIN = 4,     /* UPDATES_MAX for td_direct_solve_same_active_set, which does not factor
                            */
    CHANGED_PART = 6,      /* if more than one in CHANGED_PART rows changes its activity in a Newton
                              step, ... */
    CHANGED_ROWS_MIN = 100 /* ... in a problem of at least CHANGED_ROWS_MIN rows, the method gives
                              up */
};

static double magnitude(double x) {
    return x < 0.0 ? -x : x;
}

static double clamp(double x, double max) {
    return x > max ? max : x < -max ? -max : x;
}

/* Sets impulse and activity of a row from the impulse that its penalty gives. In a heap at rest
 * many contacts carry no load, or have friction just at its bound, and rounding would make them
 * enter and leave the active set forever. So a row keeps its activity within `hysteresis` of the
 * threshold: `hysteresis` is a speed, and multiplied by the row's effective mass an impulse. True
 * if the activity changed. */
static bool update_row(td_direct_row *r, double impulse, double hysteresis) {
    bool before = r->active;
    double little = hysteresis * r->mass;
    if (r->kind == TD_ROW_UNILATERAL) {
        r->active = r->active ? impulse > -little : r->speed < r->target_speed - hysteresis;
        r->impulse = r->active && impulse > 0.0 ? impulse : 0.0;
    } else if (r->kind >= TD_ROW_FRICTION) {
        /* A sliding row becomes active (sticks) again if its impulse falls below its bound, or if
         * it passes the opposite bound: then it sticks for one Newton step before it slides the
         * other way. */
        double against = r->impulse < 0.0 ? -impulse : impulse;
        r->active = r->active ? magnitude(impulse) < r->max_impulse + little
                              : against < r->max_impulse - little;
        r->active = r->active && r->max_impulse > 0.0; /* bound 0: no friction */
        r->impulse = clamp(impulse, r->max_impulse);
    } else {
        r->impulse = impulse; /* an equality row is always active */
    }
    r->force = r->active ? impulse : r->impulse;
    return r->active != before;
}

/* The impulse y - D (J v - target) of a row, before it is clamped; y is `multiplier`. */
static double penalty_impulse(const td_direct_row *r, double multiplier) {
    return multiplier - r->weight * (r->speed - r->target_speed);
}

/* Sets the penalty weights of a constraint's rows. */
static void set_penalties(const td_direct *d, td_direct_constraint *c) {
    double load = 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS && d->unit_speed > 0.0; k++) {
        const td_direct_row *r = &c->row[k];
        if (r->used && r->kind < TD_ROW_FRICTION) {
            load +=
                (r->kind == TD_ROW_EQUALITY ? magnitude(r->impulse) : r->impulse) / d->unit_speed;
        }
    }
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        double weight = PENALTY * td_max_double(load, r->mass), max = PENALTY_MAX * r->mass;
        weight = weight < max ? weight : max;
        r->weight = r->kind == TD_ROW_SOFT ? r->weight : weight;
    }
}

/* Whether no contact has a normal impulse from the last step. */
static bool has_no_impulses(const td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        if (td_direct_load(&d->constraints[i]) > 0.0) {
            return false;
        }
    }
    return true;
}

/* Guesses the active set with which Newton's method starts. Active are the unilateral rows that had
 * an impulse in the last step, and those whose speed is below the target speed. If the impulses are
 * the soft solver's, which are not converged, or are all 0, every unilateral row that does not
 * separate is active. With the soft solver's impulses, friction rows whose sliding speed is at most
 * td_direct.unit_speed (what gravity adds to a speed in a step) also have an infinite bound, until
 * the first solve has given normal impulses from which the bound is computed. Returns the number of
 * rows. */
static int warm_start(td_direct *d, double hysteresis) {
    int rows = 0;
    double margin = d->soft_warm_start || has_no_impulses(d) ? hysteresis : -hysteresis;
    if (!d->measured) {
        td_direct_update_speeds(d);
    }
    d->measured = false;
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        set_penalties(d, c);
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            rows += r->used;
            r->bound_change = 0.0;
            if (r->kind == TD_ROW_UNILATERAL) {
                r->active = r->impulse > 0.0 || r->speed < r->target_speed + margin;
            } else if (r->kind % 2) { /* equality and soft rows */
                r->active = true;
            } else if (d->soft_warm_start && c->friction > 0.0 &&
                       magnitude(r->speed - r->target_speed) <= d->unit_speed) {
                r->max_impulse = __builtin_inf();
            }
        }
    }
    return rows;
}

/* Whether a friction row keeps sliding although its bound has grown a little since the last update:
 * its impulse is near the bound, and the surfaces slide against the impulse. */
static bool keeps_sliding(const td_direct_row *r, double hysteresis) {
    double slip = r->impulse < 0.0 ? r->speed - r->target_speed : r->target_speed - r->speed;
    return slip > hysteresis && magnitude(r->impulse) > SLIDING_SHARE * r->max_impulse;
}

typedef enum multiplier_update {
    FROM_LAST_STEP,  /* the impulses are the warm start */
    FROM_THIS_SOLVE, /* the impulses are those of the Newton steps so far */
    KEEP_ACTIVE_SET  /* no row changes its activity; impulses are copied to `warm_start`, for
                        td_direct_restore */
} multiplier_update;

/* Sets the multipliers y of the head of this file to the present impulses. A sliding friction row
 * whose bound has grown by more than a little since its last update becomes active. True if no row
 * changed its activity. */
static bool update_multipliers(td_direct *d, double hysteresis, multiplier_update how) {
    bool same = true;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            bool before = r->active;
            if (how == KEEP_ACTIVE_SET) {
                r->warm_start = r->impulse;
            } else if (r->kind == TD_ROW_FRICTION && keeps_sliding(r, hysteresis)) {
                r->active = false;
                r->impulse = r->impulse < 0.0 ? -r->max_impulse : r->max_impulse;
            } else if (r->kind == TD_ROW_FRICTION) {
                double sliding =
                    (how == FROM_LAST_STEP ? AT_BOUND_BEFORE : AT_BOUND) * r->max_impulse;
                r->active = magnitude(r->impulse) < sliding;
                r->impulse = clamp(r->impulse, r->max_impulse);
            }
            r->multiplier = r->kind == TD_ROW_SOFT ? 0.0 : r->impulse;
            r->force = r->active ? penalty_impulse(r, r->multiplier) : r->impulse;
            same &= !r->used || r->active == before;
        }
    }
    return same;
}

/* Updates impulses and activities from the penalties, and returns how many rows changed their
 * activity. With `keeps` the active set does not change: a row that would change its activity keeps
 * it, and if that row is inactive, its impulse is its multiplier. */
static int update_active_set(td_direct *d, double hysteresis, bool keeps) {
    int changed = 0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            double impulse = penalty_impulse(r, r->multiplier);
            if (!r->used || !update_row(r, impulse, hysteresis)) {
                continue;
            }
            changed++;
            if (keeps) {
                r->active = !r->active;
                r->force = impulse;
                if (!r->active) {
                    r->force = r->impulse = r->multiplier;
                }
            }
        }
    }
    return changed;
}

/* A Newton step with the present factor. *changed: the number of rows that changed their activity,
 * and one more after a shortened step, which is never the last one. False where numbers are not
 * finite or the budget of work is spent. */
static bool newton_step(td_direct *d, double hysteresis, bool keeps, int *changed) {
    if (!td_direct_step(d)) {
        return false;
    }
    double part = d->search && !keeps ? d->search->part_of_step(d) : 1.0;
    bool done = td_direct_advance(d, part);
    *changed = update_active_set(d, hysteresis, keeps) + (part < 1.0);
    return done;
}

/* The error of friction, as a speed. Bounds were computed from earlier normal impulses; with the
 * present ones, a sliding row whose bound has changed has an error of its sliding speed, and a
 * sticking row beyond its bound an error of (impulse - bound) / effective mass. */
static double friction_error(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        const td_direct_constraint *c = &d->constraints[i];
        const td_direct_row *r = &c->row[TD_DIRECT_TANGENT];
        if (!r->used || r->kind != TD_ROW_FRICTION) {
            continue;
        }
        double max = td_direct_friction_bound(c);
        if (r->active) {
            worst = td_max_double(worst, (magnitude(r->impulse) - BOUND_FACTOR * max) / r->mass);
        } else if (max > r->max_impulse * BOUND_FACTOR || max * BOUND_FACTOR < r->max_impulse) {
            worst = td_max_double(worst, magnitude(r->speed - r->target_speed));
        }
    }
    return worst;
}

/* The error of complementarity: the greatest speed above the target speed of a unilateral row that
 * has an impulse. The warm-start impulse of an impact in the last step is far too large for this
 * step; without this test the solve would end before the impulse is reduced. */
static double complementarity_error(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (r->used && r->kind == TD_ROW_UNILATERAL && r->impulse > 0.0) {
                worst = td_max_double(worst, r->speed - r->target_speed);
            }
        }
    }
    return worst;
}

/* The greatest error of any kind, as a speed. */
static double error_of(const td_direct *d) {
    return td_max_double(td_direct_residual(d),
                         td_max_double(complementarity_error(d), friction_error(d)));
}

/* Newton steps until one leaves the active set as it is. `factored`: the matrix already holds the
 * factor of the present active set. False where `factorings_max` is reached, a step fails, or more
 * than `changes_max` rows change in one. */
static bool find_active_set(td_direct *d, double hysteresis, int factorings_max, int changes_max,
                            bool factored) {
    int changed = 1;
    while (changed) {
        if (!factored && (d->factorings >= factorings_max || !td_direct_factor(d))) {
            return false;
        }
        if (!newton_step(d, hysteresis, false, &changed) || changed > changes_max) {
            return false;
        }
        factored = false;
    }
    return true;
}

/* Reduces the residual by conjugate gradients unless it is already small, and updates the active
 * set. *changed: the number of rows that changed their activity; *error: the greatest error before
 * and after, as a speed. False where numbers are not finite. */
static bool reduce_residual(td_direct *d, double tolerance, int *changed, double *error) {
    double enough = RESIDUAL_SHARE * tolerance;
    *error = error_of(d);
    if (!*changed && *error <= enough) {
        return true;
    }
    bool done = td_direct_reduce_residual(d, enough);
    *changed = update_active_set(d, HYSTERESIS * tolerance, false);
    *error = td_max_double(*error, error_of(d));
    return done;
}

bool td_direct_solve_active_set(td_direct *d, double tolerance) {
    int further = d->search ? FACTORINGS_OF_SEARCH : FACTORINGS_MAX;
    int factorings_max = td_min_int(d->factorings + further, d->factoring_budget);
    double hysteresis = HYSTERESIS * tolerance;
    bool factored = false, unbounded_friction = d->soft_warm_start;
    int rows = warm_start(d, hysteresis);
    int changes_max = rows < CHANGED_ROWS_MIN ? rows : rows / CHANGED_PART;
    update_multipliers(d, hysteresis, FROM_LAST_STEP);
    for (int n = 0; n < UPDATES_MAX; n++) {
        int changed = 0;
        double error;
        if (!find_active_set(d, hysteresis, factorings_max, changes_max, factored) ||
            !reduce_residual(d, tolerance, &changed, &error)) {
            return false;
        }
        bool converged = error <= tolerance && !unbounded_friction;
        if (converged && !changed) {
            return d->factored = true;
        }
        if (!converged) {
            (d->search ? d->search->update_bounds : td_direct_update_friction)(d);
            unbounded_friction = false;
        }
        factored = update_multipliers(d, hysteresis, FROM_THIS_SOLVE) && !changed;
    }
    return false;
}

bool td_direct_solve_same_active_set(td_direct *d, double tolerance) {
    double hysteresis = HYSTERESIS * tolerance, error;
    bool same_set = d->factored && update_multipliers(d, hysteresis, KEEP_ACTIVE_SET);
    for (int n = 0; n < UPDATES_AGAIN && same_set; n++) {
        int changed;
        /* The impulses may be far from the solution, so that rows would change their activity for
         * no reason: the first Newton step keeps the active set. */
        if (!newton_step(d, hysteresis, true, &changed) ||
            !reduce_residual(d, tolerance, &changed, &error) || changed) {
            break;
        }
        if (error <= tolerance) {
            return true;
        }
        td_direct_update_friction(d);
        same_set = update_multipliers(d, hysteresis, FROM_THIS_SOLVE);
    }
    if (d->factored) {
        td_direct_restore(d);
    }
    return false;
}
