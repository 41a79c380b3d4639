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

static double lack_of(const td_direct_row *r) {
    return r->used && r->active ? r->wanted - r->speed : 0.0;
}

static double worst_lack(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            double lack = lack_of(&d->constraints[i].row[k]);
            worst = td_max_double(worst, td_max_double(lack, -lack));
        }
    }
    return worst;
}

/* What the rows miss, times the penalties. */
static double product(const td_direct *d) {
    double sum = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            double lack = lack_of(r);
            sum += lack * r->weight * lack;
        }
    }
    return sum;
}

/* The next direction, in `push`: the penalties, and a share of the direction before. It acts beside
 * the forces that are there. */
static void aim(td_direct *d, double share) {
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            if (r->used && r->active) {
                r->push[0] = r->weight * lack_of(r) + (share > 0.0 ? share * r->push[0] : 0.0);
                r->force += r->push[0];
            }
        }
    }
}

static double curvature(const td_direct *d) {
    double sum = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            sum += r->used && r->active ? r->push[0] * r->change : 0.0;
        }
    }
    return sum;
}

/* Forces that balance the velocities again, a part of the step further. */
static void balance(td_direct *d, double part) {
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            if (r->used && r->active) {
                r->force += part * (r->push[0] - r->weight * r->change) - r->push[0];
            }
        }
    }
}

bool td_direct_polish(td_direct *d, double enough) {
    double before = 0.0;
    for (int round = 0; round < ROUNDS && worst_lack(d) > enough; round++) {
        double now = product(d);
        aim(d, before > 0.0 ? now / before : 0.0);
        td_direct_step(d);
        double bent = curvature(d);
        bool contradict = now >= PART_MOST * bent;
        double part = contradict ? 0.0 : now / bent;
        if (!td_direct_move(d, part)) {
            return false;
        }
        balance(d, part);
        if (contradict) {
            break;
        }
        before = now;
    }
    return true;
}
