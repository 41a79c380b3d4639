/* direct_interior.c: the rows' complementarity approached from inside.
 *
 * Mehrotra's predictor-corrector ("On the implementation of a primal-dual interior point method",
 * 1992) for the quadratic problem of direct.h. A normal has a slack s = J v - wanted and an impulse
 * l, both > 0, whose product goes to zero. A tangent's impulse y lies between its bounds; the
 * distances to them, most + y and most - y, have slacks whose difference is the sliding speed, and
 * their products go to zero likewise. Products are measured in the mass that a row feels, so that
 * heavy and light contacts converge alike.
 *
 * A spring with a greatest force is a tangent that gives way: instead of J v - wanted,
 * J v - wanted + y / weight is zero between its bounds.
 *
 * An equality has neither slack nor bound: it is a stiff penalty whose multiplier takes its impulse
 * with each step, which leaves no more of what it misses than the penalty's share. So is a spring
 * without a greatest force, but for the multiplier. */
#include "islands/direct.h"

/* A step goes so much of the way to where the first number would be zero. */
#define NEARLY 0.98
/* So much of the tolerance may the square root of a product per mass be. */
#define CLOSE 0.1

/* The penalty of an equality, in multiples of the mass that it feels. */
#define STIFFNESS 1e9

enum { STEPS = 40 };

/* Impulses at least so strong, against what gravity gives the row's mass, are worth a tangent. */
#define FRICTION_LEAST 1e-9

/* It has neither slack nor bound. */
static bool is_unbound(const td_direct_row *r) {
    return r->kind == TD_ROW_EQUAL || (r->kind == TD_ROW_SOFT && !(r->most < __builtin_inf()));
}

/* 1 / weight of a spring, which `base` has meanwhile. */
static double compliance(const td_direct_row *r) {
    return r->kind == TD_ROW_SOFT ? 1.0 / r->base : 0.0;
}

/* What the slacks of a bound row are to make up. */
static double excess(const td_direct_row *r) {
    return r->speed - r->wanted + compliance(r) * r->impulse;
}

static bool slides_free(const td_direct *d, const td_direct_row *r) {
    return !(r->most > FRICTION_LEAST * r->mass * d->unit_speed);
}

/* Distance of a tangent's impulse from its lower and upper bound. */
static double room(const td_direct_row *r, int which) {
    return which ? r->most - r->impulse : r->most + r->impulse;
}

/* What a state needs to begin with: everything well inside. */
static void start(td_direct *d) {
    double sum = 0.0;
    int rows = 0;
    for (int i = 0; i < d->body_count; i++) {
        for (int k = 0; k < 3; k++) {
            d->bodies[i].velocity[k] = d->bodies[i].free[k];
        }
    }
    td_direct_measure(d);
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (r->kind >= TD_ROW_FRICTION) {
                continue;
            }
            bool misses = r->speed < r->wanted || r->kind == TD_ROW_EQUAL;
            double lack = r->used && misses ? r->wanted - r->speed : 0.0;
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
            double over = r->speed - r->wanted;
            r->base = r->weight;
            if (is_unbound(r)) {
                r->slack[0] = r->slack[1] = r->push[1] = r->push[2] = r->impulse = 0.0;
            } else if (r->kind == TD_ROW_PUSH) {
                r->slack[0] = td_max_double(over, typical);
                r->impulse = r->mass * typical;
            } else {
                r->slack[0] = td_max_double(over, 0.0) + typical;
                r->slack[1] = td_max_double(-over, 0.0) + typical;
                r->impulse = 0.0;
            }
            bool idle = r->kind >= TD_ROW_FRICTION && slides_free(d, r);
            r->active = r->used && !idle;
            r->force = 0.0;
        }
    }
}

/* Mean product per mass, after a part of the step. */
static double gap(const td_direct *d, double part) {
    double sum = 0.0;
    int products = 0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (!r->active || is_unbound(r)) {
                continue;
            }
            double impulse = part * r->push[0], first = r->slack[0] + part * r->push[1];
            if (r->kind == TD_ROW_PUSH) {
                sum += first * (r->impulse + impulse) / r->mass;
                products++;
            } else {
                double second = r->slack[1] + part * r->push[2];
                sum += (first * (room(r, 0) + impulse) + second * (room(r, 1) - impulse)) / r->mass;
                products += 2;
            }
        }
    }
    return products ? sum / products : 0.0;
}

/* Sets what the row gives to matrix and right side. The products aim at `aim` per mass; with `mend`
 * they heed what the steps of the predictor, in `push`, did to them. */
static void prepare_row(td_direct_row *r, double aim, double mend) {
    double over = r->speed - r->wanted;
    if (is_unbound(r)) {
        bool soft = r->kind == TD_ROW_SOFT;
        r->weight = soft ? r->base : STIFFNESS * r->mass;
        r->force = (soft ? 0.0 : r->impulse) - r->weight * over;
        return;
    }
    if (r->kind == TD_ROW_PUSH) {
        double lack = over - r->slack[0];
        double product = aim * r->mass - r->slack[0] * r->impulse - mend * r->push[0] * r->push[1];
        r->weight = r->impulse / r->slack[0];
        r->force = r->impulse + product / r->slack[0] - r->weight * lack;
        return;
    }
    double low = room(r, 0), high = room(r, 1);
    double lack = excess(r) - (r->slack[0] - r->slack[1]);
    double first = aim * r->mass - r->slack[0] * low - mend * r->push[0] * r->push[1];
    double second = aim * r->mass - r->slack[1] * high + mend * r->push[0] * r->push[2];
    r->weight = 1.0 / (r->slack[0] / low + r->slack[1] / high + compliance(r));
    r->force = r->impulse + r->weight * (first / low - second / high - lack);
}

/* The row's own steps, from the change of its speed. */
static void follow_row(td_direct_row *r, double aim, double mend) {
    double over = r->speed - r->wanted, old = r->push[0];
    r->push[0] = r->force - r->impulse - r->weight * r->change;
    if (is_unbound(r)) {
        return;
    }
    if (r->kind == TD_ROW_PUSH) {
        r->push[1] = r->change + over - r->slack[0];
        return;
    }
    double low = room(r, 0), high = room(r, 1);
    double first = aim * r->mass - r->slack[0] * low - mend * old * r->push[1];
    double second = aim * r->mass - r->slack[1] * high + mend * old * r->push[2];
    r->push[1] = (first - r->slack[0] * r->push[0]) / low;
    r->push[2] = (second + r->slack[1] * r->push[0]) / high;
}

static double cut(double part, double value, double change) {
    return value + part * change < 0.0 ? -value / change : part;
}

/* So many steps, or parts of one, may be taken until something is negative; at most `most`. */
static double reach(const td_direct *d, double most) {
    double part = most;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (!r->active || is_unbound(r)) {
                continue;
            }
            part = cut(part, r->slack[0], r->push[1]);
            if (r->kind == TD_ROW_PUSH) {
                part = cut(part, r->impulse, r->push[0]);
            } else {
                part = cut(part, r->slack[1], r->push[2]);
                part = cut(part, room(r, 0), r->push[0]);
                part = cut(part, room(r, 1), -r->push[0]);
            }
        }
    }
    return part;
}

static void for_rows(td_direct *d, void (*each)(td_direct_row *, double, double), double aim,
                     double mend) {
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            if (r->active) {
                each(r, aim, mend);
            }
        }
    }
}

static void advance_row(td_direct_row *r, double part, double unused) {
    (void)unused;
    r->impulse += part * r->push[0];
    r->slack[0] += part * r->push[1];
    r->slack[1] += part * r->push[2];
}

/* Forward by a part of the step; false where numbers failed. */
static bool advance(td_direct *d, double part) {
    bool done = td_direct_move(d, part);
    for_rows(d, advance_row, part, 0.0);
    td_direct_measure(d);
    return done;
}

/* The greatest speed that a slack is off by: zero once a whole step was taken. */
static double lack(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            if (r->kind >= TD_ROW_FRICTION) {
                continue;
            }
            double off = r->used ? r->slack[0] - (r->speed - r->wanted) : 0.0;
            worst = td_max_double(worst, off < 0.0 ? -off : off);
        }
    }
    return worst;
}

/* What is nearer to opening than to pushing does not push. */
static void decide(td_direct_row *r, double unused, double nor_this) {
    (void)unused, (void)nor_this;
    if (r->kind == TD_ROW_PUSH && !(r->impulse > r->mass * r->slack[0])) {
        r->impulse = 0.0;
    }
}

static bool approach(td_direct *d, double tolerance) {
    double close = CLOSE * tolerance * CLOSE * tolerance;
    start(d);
    for (int n = 0; n < STEPS && d->factorings < d->patience; n++) {
        for_rows(d, prepare_row, 0.0, 0.0);
        if (!td_direct_factor(d) || !td_direct_step(d)) {
            return false;
        }
        for_rows(d, follow_row, 0.0, 0.0);
        double now = gap(d, 0.0), after = gap(d, reach(d, 1.0)),
               share = now > 0.0 ? after / now : 0.0;
        double aim = share * share * share * now;
        for_rows(d, prepare_row, aim, 1.0);
        if (!td_direct_step(d)) {
            return false;
        }
        for_rows(d, follow_row, aim, 1.0);
        if (!advance(d, NEARLY * reach(d, 1.0 / NEARLY))) {
            return false;
        }
        if (gap(d, 0.0) <= close && lack(d) <= tolerance) {
            for_rows(d, decide, 0.0, 0.0);
            return true;
        }
    }
    return false;
}

bool td_direct_interior(td_direct *d, double tolerance) {
    bool done = approach(d, tolerance);
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            r->weight = r->kind == TD_ROW_SOFT ? r->base : r->weight;
        }
    }
    return done;
}
