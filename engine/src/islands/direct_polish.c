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
    return r->wanted - r->speed;
}

static double misses(td_direct_row *r, double enough, double unused) {
    (void)unused;
    double lack = lack_of(r);
    return lack > enough || -lack > enough ? 1.0 : 0.0;
}

/* What the row misses, times the penalties. */
static double product(td_direct_row *r, double unused, double nor_this) {
    (void)unused, (void)nor_this;
    return lack_of(r) * r->weight * lack_of(r);
}

/* The next direction, in `push`: the penalties, and a share of the direction before. It acts beside
 * the forces that are there. */
static double aim(td_direct_row *r, double share, double unused) {
    (void)unused;
    r->push[0] = r->weight * lack_of(r) + (share > 0.0 ? share * r->push[0] : 0.0);
    r->force += r->push[0];
    return 0.0;
}

static double curvature(td_direct_row *r, double unused, double nor_this) {
    (void)unused, (void)nor_this;
    return r->push[0] * r->change;
}

/* Forces that balance the velocities again, a part of the step further; and the impulses that have
 * these for their penalties. */
static double balance(td_direct_row *r, double part, double unused) {
    (void)unused;
    r->force += part * (r->push[0] - r->weight * r->change) - r->push[0];
    r->base = r->force - r->weight * lack_of(r);
    return 0.0;
}

bool td_direct_polish(td_direct *d, double enough) {
    double before = 0.0;
    for (int round = 0; round < ROUNDS && td_direct_sum(d, misses, enough, 0.0) > 0.0; round++) {
        double now = td_direct_sum(d, product, 0.0, 0.0);
        td_direct_sum(d, aim, before > 0.0 ? now / before : 0.0, 0.0);
        td_direct_step(d);
        double bent = td_direct_sum(d, curvature, 0.0, 0.0);
        bool contradict = now >= PART_MOST * bent;
        double part = contradict ? 0.0 : now / bent;
        if (!td_direct_move(d, part)) {
            return false;
        }
        td_direct_sum(d, balance, part, 0.0);
        if (contradict) {
            break;
        }
        before = now;
    }
    return true;
}
