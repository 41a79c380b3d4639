/* direct_polish.c: what active rows still miss, with the matrix that stands.
 *
 * Penalties leave little of what rows miss, but for the few shapes in which a tall column bends:
 * each of its contacts gives way by next to nothing, and its top leans by all of that times its
 * height. Conjugate gradients on the multipliers, with the penalties as preconditioner (Hestenes
 * and Stiefel, 1952), need about as many rounds as there are such shapes. */
#include "islands/direct.h"

enum { ROUNDS = 12 };
/* A step that is so much longer than that of the penalties alone goes where rows contradict each
 * other, and no velocities are right. */
#define PART_MOST 100.0

/* A soft row misses nothing. */
static double lack_of(const td_direct_row *r) {
    return r->kind == TD_ROW_SOFT ? 0.0 : r->wanted - r->speed;
}

/* ---- of a row ---- */

/* What it misses, times the penalty. */
static double product(td_direct_row *r, double unused) {
    (void)unused;
    return lack_of(r) * r->weight * lack_of(r);
}

/* The next direction, in `push`: the penalty, and a share of the direction before. It acts beside
 * the forces that are there. */
static double aim(td_direct_row *r, double share) {
    r->push[0] = r->weight * lack_of(r) + (share > 0.0 ? share * r->push[0] : 0.0);
    r->force += r->push[0];
    return r->push[0];
}

static double curvature(td_direct_row *r, double unused) {
    (void)unused;
    return r->push[0] * r->change;
}

/* A force that balances the velocities again, a part of the step further; and the impulse that has
 * it for its penalty. */
static double balance(td_direct_row *r, double part) {
    r->force += part * (r->push[0] - r->weight * r->change) - r->push[0];
    r->base = r->kind == TD_ROW_SOFT ? 0.0 : r->force - r->weight * lack_of(r);
    return 0.0;
}

static double misses(td_direct_row *r, double enough) {
    return lack_of(r) > enough || -lack_of(r) > enough;
}

/* ---- of all ---- */

/* The sum over the active rows. */
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

bool td_direct_polish(td_direct *d, double enough) {
    double before = 0.0, part = 1.0;
    for (int n = 0; n < ROUNDS && part > 0.0 && sum(d, misses, enough) > 0.0; n++) {
        double now = sum(d, product, 0.0);
        sum(d, aim, before > 0.0 ? now / before : 0.0);
        if (!td_direct_step(d)) {
            return false;
        }
        double bent = sum(d, curvature, 0.0);
        part = now < PART_MOST * bent ? now / bent : 0.0;
        if (!td_direct_move(d, part)) {
            return false;
        }
        sum(d, balance, part);
        before = now;
    }
    return true;
}
