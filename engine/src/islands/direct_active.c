/* direct_active.c: which rows push is guessed from the step before, and mended.
 *
 * Active rows become penalties of weight D with a multiplier y, the impulse as known so far: a
 * normal gives max(0, y - D (J v - wanted)), a tangent y - D (J v - wanted) cut off at its bounds
 * (the augmented Lagrangian of Hestenes, 1969, and Powell, 1969, for inequalities after
 * Rockafellar, 1973). Where no row changes its mind in a whole Newton step, that minimises the
 * function of v. What rows still miss then is polished off with the same matrix (direct_polish.c),
 * y takes the impulses, friction gets its bounds, and it goes on until nothing is missed. */
#include "islands/direct.h"

/* The penalty of a contact is the mass that it feels times so much, or the load it carries where
 * that is more; and never more than the second, or rounding ends it. */
#define STIFFNESS 1e5
#define STIFFNESS_MOST 1e9

/* A row keeps its mind for so much of the tolerance. */
#define DOUBT 0.1

/* A bound of friction that was right but for so much, as loads are from step to step, holds. */
#define GROWN 1.02

/* Friction that came nearer than this to its bound, in parts of it, slid there: that it slides is
 * then told by its speed (SLID), or by the impulse alone (AT_BOUND). */
#define SLID 0.9
#define AT_BOUND 0.999
/* Of impulses that were kept from the step before, only what was at its bound, but for rounding. */
#define ROUNDED (1.0 - 1e-6)

/* What rows miss is polished off down to so much of the tolerance. */
#define FINE 1e-4

enum {
    PATIENCE = 6, /* factorisations */
    ROUNDS = 12,  /* in which multipliers take the impulses */
    AGAIN = 4,    /* rounds in which friction gets its bounds, with the matrix that stands */
    HOPELESS = 6, /* where more than one of so many rows changes its mind in a step, and ... */
    MANY = 100    /* ... there are so many rows, the guess was no good */
};

static double size_of(double x) {
    return x < 0.0 ? -x : x;
}

static double clamped(double x, double most) {
    return x > most ? most : x < -most ? -most : x;
}

/* In a heap at rest many contacts carry nothing, or just so much that they stick, and rounding
 * would have them change their minds for ever: `doubt` is the speed, and times its mass the
 * impulse, that a row does not change its mind for. True where it does. */
static bool answer(td_direct_row *r, double impulse, double doubt) {
    bool before = r->active;
    double little = doubt * r->mass;
    if (r->kind == TD_ROW_PUSH) {
        r->active = r->active ? impulse > -little : r->speed < r->wanted - doubt;
        r->impulse = r->active && impulse > 0.0 ? impulse : 0.0;
    } else if (r->kind >= TD_ROW_FRICTION) {
        /* From one bound to the other it sticks in between. */
        double against = r->impulse < 0.0 ? -impulse : impulse;
        r->active = r->active ? size_of(impulse) < r->most + little : against < r->most - little;
        r->active = r->active && r->most > 0.0; /* which has no direction to have slid in */
        r->impulse = clamped(impulse, r->most);
    } else {
        r->impulse = impulse; /* it always is active */
    }
    r->force = r->active ? impulse : r->impulse;
    return r->active != before;
}

/* The impulse of a row that its penalty has changed from what it was. */
static double penalised(const td_direct_row *r, double impulse) {
    return impulse - r->weight * (r->speed - r->wanted);
}

static void set_weight(const td_direct *d, td_direct_constraint *c) {
    double load = 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS && d->unit_speed > 0.0; k++) {
        const td_direct_row *r = &c->row[k];
        if (r->used && r->kind < TD_ROW_FRICTION) {
            load += (r->kind == TD_ROW_EQUAL ? size_of(r->impulse) : r->impulse) / d->unit_speed;
        }
    }
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        double weight = STIFFNESS * td_max_double(load, r->mass), most = STIFFNESS_MOST * r->mass;
        weight = weight < most ? weight : most;
        r->weight = r->kind == TD_ROW_SOFT ? r->weight : weight;
    }
}

/* Nothing is known from a step before. */
static bool is_new(const td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        if (td_direct_load(&d->constraints[i]) > 0.0) {
            return false;
        }
    }
    return true;
}

/* What pushed before does so again, and so does what is about to meet. In an island that is new, or
 * that the soft solver has had so far, all that touches and does not part pushes; and of the
 * latter, whose impulses are still on their way, friction that hardly slides holds whatever it
 * takes. Returns how many rows there are. */
static int guess(td_direct *d, double doubt) {
    int rows = 0;
    double parting = d->fresh || is_new(d) ? doubt : -doubt;
    td_direct_measure(d);
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        set_weight(d, c);
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            rows += r->used;
            if (r->kind == TD_ROW_PUSH) {
                r->active = r->impulse > 0.0 || r->speed < r->wanted + parting;
            } else if (r->kind % 2) {
                r->active = true;
            } else if (d->fresh && c->friction > 0.0 &&
                       size_of(r->speed - r->wanted) <= d->unit_speed) {
                r->most = __builtin_inf();
            }
        }
    }
    return rows;
}

/* Friction that has slid all the way to its bound slides on where that has grown a little since. */
static bool slides_on(const td_direct_row *r, double doubt) {
    double slip = r->impulse < 0.0 ? r->speed - r->wanted : r->wanted - r->speed;
    return slip > doubt && size_of(r->impulse) > SLID * r->most;
}

typedef enum taking {
    BEGINS, /* they are of the step before */
    GOES_ON,
    KEEPS /* nobody changes his mind; they are noted, to go back to */
} taking;

/* The multipliers take the impulses. Friction that had reached a bound, which has grown by much
 * since, sticks for now. True where no row has changed its mind. */
static bool take_multipliers(td_direct *d, double doubt, taking how) {
    bool same = true;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            bool before = r->active;
            if (how == KEEPS) {
                r->guess = r->impulse;
            } else if (r->kind == TD_ROW_FRICTION && slides_on(r, doubt)) {
                r->active = false;
                r->impulse = r->impulse < 0.0 ? -r->most : r->most;
            } else if (r->kind == TD_ROW_FRICTION) {
                double most = (how == BEGINS ? ROUNDED : AT_BOUND) * r->most;
                r->active = size_of(r->impulse) < most;
                r->impulse = clamped(r->impulse, r->most);
            }
            r->base = r->kind == TD_ROW_SOFT ? 0.0 : r->impulse;
            r->force = r->active ? penalised(r, r->base) : r->impulse;
            same &= !r->used || r->active == before;
        }
    }
    return same;
}

/* How many rows change their mind by what their penalties say; they keep it all the same where
 * `keeps` is set. */
static int judge(td_direct *d, double doubt, bool keeps) {
    int turned = 0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            double impulse = penalised(r, r->base);
            if (!r->used || !answer(r, impulse, doubt)) {
                continue;
            }
            turned++;
            if (keeps) {
                r->active = !r->active;
                r->force = impulse;
                if (!r->active) {
                    r->force = r->impulse = r->base;
                }
            }
        }
    }
    return turned;
}

/* A whole Newton step, of the matrix as factored. *turned: how many rows change their mind. False
 * where numbers failed. */
static bool leap(td_direct *d, double doubt, bool keeps, int *turned) {
    if (!td_direct_step(d)) {
        return false;
    }
    bool done = td_direct_move(d, 1.0);
    *turned = judge(d, doubt, keeps);
    return done;
}

/* The speed by which friction is wrong for what pushes now: that at which something slides whose
 * bound has changed, or what a force beyond its bound gives. */
static double slip(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        const td_direct_constraint *c = &d->constraints[i];
        const td_direct_row *r = &c->row[TD_DIRECT_TANGENT];
        if (!r->used || r->kind != TD_ROW_FRICTION) {
            continue;
        }
        double most = td_direct_friction(c);
        if (r->active) {
            worst = td_max_double(worst, (size_of(r->impulse) - GROWN * most) / r->mass);
        } else if (most > r->most * GROWN || most * GROWN < r->most) {
            worst = td_max_double(worst, size_of(r->speed - r->wanted));
        }
    }
    return worst;
}

/* The greatest speed at which something parts that is still pushed: impulses kept from a hit in the
 * step before are far too great for this one, and a penalty alone would let them push for another
 * step. */
static double overshoot(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (r->used && r->kind == TD_ROW_PUSH && r->impulse > 0.0) {
                worst = td_max_double(worst, r->speed - r->wanted);
            }
        }
    }
    return worst;
}

/* The greatest speed by which anything is not as it should be. */
static double off(const td_direct *d) {
    return td_max_double(td_direct_miss(d), td_max_double(overshoot(d), slip(d)));
}

/* Newton steps until no row changes its mind; the matrix may stand already for the rows that are
 * active. False where that is not to be had, or more than `hopeless` change it at once. */
static bool settle(td_direct *d, double doubt, int most, int hopeless, bool stands) {
    int turned = 1;
    while (turned) {
        if (!stands && (d->factorings >= most || !td_direct_factor(d))) {
            return false;
        }
        if (!leap(d, doubt, false, &turned) || turned > hopeless) {
            return false;
        }
        stands = false;
    }
    return true;
}

/* Polishes what is missed, where it is not too little, and has the rows judge anew. *turned: how
 * many change their mind; *worst: how far anything is off, or was. False where numbers failed. */
static bool refine(td_direct *d, double tolerance, int *turned, double *worst) {
    double fine = FINE * tolerance;
    *worst = off(d);
    if (!*turned && *worst <= fine) {
        return true;
    }
    bool done = td_direct_polish(d, fine);
    *turned = judge(d, DOUBT * tolerance, false);
    *worst = td_max_double(*worst, off(d));
    return done;
}

bool td_direct_active(td_direct *d, double tolerance) {
    int most = td_min_int(d->factorings + PATIENCE, d->patience);
    double doubt = DOUBT * tolerance;
    bool stands = false, unbound = d->fresh;
    int rows = guess(d, doubt), hopeless = rows < MANY ? rows : rows / HOPELESS;
    take_multipliers(d, doubt, BEGINS);
    for (int round = 0; round < ROUNDS; round++) {
        int turned = 0;
        double worst;
        if (!settle(d, doubt, most, hopeless, stands) || !refine(d, tolerance, &turned, &worst)) {
            return false;
        }
        bool well = worst <= tolerance && !unbound;
        if (well && !turned) {
            return d->factored = true;
        }
        if (!well) {
            td_direct_bound(d);
            unbound = false;
        }
        stands = take_multipliers(d, doubt, GOES_ON) && !turned;
    }
    return false;
}

bool td_direct_again(td_direct *d, double tolerance) {
    double doubt = DOUBT * tolerance, worst;
    bool goes_on = d->factored && take_multipliers(d, doubt, KEEPS);
    for (int round = 0; round < AGAIN && goes_on; round++) {
        int turned;
        /* Impulses may be so far off that rows would change their minds for nothing. */
        if (!leap(d, doubt, true, &turned) || !refine(d, tolerance, &turned, &worst) || turned) {
            break;
        }
        if (worst <= tolerance) {
            return true;
        }
        td_direct_bound(d);
        goes_on = take_multipliers(d, doubt, GOES_ON);
    }
    if (d->factored) {
        td_direct_forget(d);
    }
    return false;
}
