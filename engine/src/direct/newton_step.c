/* newton_step.c: what the active set and the interior point of direct.h share: speeds of rows,
 * bounds of friction, the residual, and a Newton step.
 *
 * Both methods reduce the problem to the same linear equations. An active row of weight D and force
 * f acts on the bodies by the impulse f - D J dv; the equilibrium of all bodies after a step dv,
 *     M (v + dv - v*) = sum J' (f - D J dv),
 * gives (M + sum D J' J) dv = M (v* - v) + sum J' f. The matrix is symmetric and positive definite.
 * Its nonzero 3 x 3 blocks are one for each body and one for each pair of bodies that a constraint
 * joins. */
#include "direct/direct.h"

#include "solver/friction.h"

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- rows ---- */

/* J v of a row, for the velocities of the bodies that are variables. */
static double speed_of(const td_direct_constraint *c, const td_direct_row *r, const double *va,
                       const double *vb) {
    return (c->a == TD_NONE ? 0.0 : dot(r->a, va)) + (c->b == TD_NONE ? 0.0 : dot(r->b, vb));
}

void td_direct_update_speeds(td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        const double *va = c->a == TD_NONE ? NULL : d->bodies[c->a].velocity;
        const double *vb = c->b == TD_NONE ? NULL : d->bodies[c->b].velocity;
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            if (r->used) {
                r->speed = r->known_speed + speed_of(c, r, va, vb);
            }
        }
    }
}

double td_direct_friction_bound(const td_direct_constraint *c) {
    const td_direct_row *tangent = &c->row[TD_DIRECT_TANGENT];
    return c->bound + td_friction_bound(c->friction, td_direct_load(c),
                                        tangent->speed - tangent->target_speed);
}

void td_direct_update_friction(td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        c->row[TD_DIRECT_TANGENT].max_impulse = td_direct_friction_bound(c);
    }
}

void td_direct_restore(td_direct *d) {
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            d->constraints[i].row[k].impulse = d->constraints[i].row[k].warm_start;
        }
    }
    td_direct_update_speeds(d);
    td_direct_update_friction(d);
}

/* The speed by which a unilateral or equality row misses its target speed; negative for a
 * unilateral row that separates faster than its target. */
static double lack_of(const td_direct_row *r) {
    double lack = r->target_speed - r->speed;
    return r->kind == TD_ROW_EQUALITY && lack < 0.0 ? -lack : lack;
}

double td_direct_residual(const td_direct *d) {
    double worst = 0.0;
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            bool counts = r->used && r->kind < TD_ROW_FRICTION;
            worst = counts ? td_max_double(worst, lack_of(r)) : worst;
        }
    }
    return worst;
}

/* ---- a Newton step ---- */

/* The moment of inertia. The rows of a body that does not turn have lever arms of 0, so that any
 * positive number is correct. */
static double inertia_of(const td_direct_body *b) {
    return b->inverse_inertia > 0.0 ? 1.0 / b->inverse_inertia : 1.0;
}

/* block += weight i k' */
static void add_product(td_block3 *block, double weight, const double *i, const double *k) {
    for (int p = 0; p < 3; p++) {
        double wi = weight * i[p];
        block->at[0][p] += wi * k[0];
        block->at[1][p] += wi * k[1];
        block->at[2][p] += wi * k[2];
    }
}

/* Adds weight J' J of a row to the matrix. */
static void add_row(td_direct *d, const td_direct_constraint *c, const td_direct_row *r) {
    if (c->a != TD_NONE) {
        add_product(td_sparse_diagonal(d->matrix, c->a), r->weight, r->a, r->a);
    }
    if (c->b != TD_NONE) {
        add_product(td_sparse_diagonal(d->matrix, c->b), r->weight, r->b, r->b);
    }
    if (c->a != TD_NONE && c->b != TD_NONE) {
        add_product(td_sparse_entry(d->matrix, c->entry), r->weight, c->b_later ? r->b : r->a,
                    c->b_later ? r->a : r->b);
    }
}

/* Work of a constraint and of a body in a Newton step, in multiples of an operation on a block:
 * estimated from the multiplications that each takes (a 3 x 3 product has 27). */
enum { CONSTRAINT_EFFORT = 10, BODY_EFFORT = 5 };

bool td_direct_take_effort(td_direct *d, int64_t blocks) {
    int64_t more = blocks + (int64_t)CONSTRAINT_EFFORT * d->constraint_count +
                   (int64_t)BODY_EFFORT * d->body_count;
    d->spent = d->spent || more > d->effort;
    d->effort -= d->spent ? 0 : more;
    return !d->spent;
}

bool td_direct_factor(td_direct *d) {
    if (!td_direct_take_effort(d, d->matrix->current.work)) {
        return false;
    }
    td_sparse_clear(d->matrix);
    for (int i = 0; i < d->body_count; i++) {
        td_block3 *block = td_sparse_diagonal(d->matrix, i);
        block->at[0][0] = block->at[1][1] = 1.0 / d->bodies[i].inverse_mass;
        block->at[2][2] = inertia_of(&d->bodies[i]);
    }
    for (int i = 0; i < d->constraint_count; i++) {
        const td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            if (c->row[k].used && c->row[k].active) {
                add_row(d, c, &c->row[k]);
            }
        }
    }
    d->factorings++;
    return td_sparse_factor(d->matrix);
}

bool td_direct_step(td_direct *d) {
    if (!td_direct_take_effort(d, 2 * (int64_t)td_sparse_entries(d->matrix))) {
        return false;
    }
    for (int i = 0; i < d->body_count; i++) {
        const td_direct_body *b = &d->bodies[i];
        d->step[i][0] = (b->free[0] - b->velocity[0]) / b->inverse_mass;
        d->step[i][1] = (b->free[1] - b->velocity[1]) / b->inverse_mass;
        d->step[i][2] = (b->free[2] - b->velocity[2]) * inertia_of(b);
        d->step[i][3] = 0.0;
    }
    for (int i = 0; i < d->constraint_count; i++) {
        const td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &c->row[k];
            for (int j = 0; j < 3 && r->used && c->a != TD_NONE; j++) {
                d->step[c->a][j] += r->a[j] * r->force;
            }
            for (int j = 0; j < 3 && r->used && c->b != TD_NONE; j++) {
                d->step[c->b][j] += r->b[j] * r->force;
            }
        }
    }
    td_sparse_solve(d->matrix, d->step, d->work);
    for (int i = 0; i < d->constraint_count; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            c->row[k].change = speed_of(c, &c->row[k], c->a == TD_NONE ? NULL : d->step[c->a],
                                        c->b == TD_NONE ? NULL : d->step[c->b]);
        }
    }
    return true;
}

bool td_direct_advance(td_direct *d, double part) {
    double sum = 0.0;
    for (int i = 0; i < d->body_count; i++) {
        for (int k = 0; k < 3; k++) {
            d->bodies[i].velocity[k] += part * d->step[i][k];
            sum += d->bodies[i].velocity[k];
        }
    }
    for (int i = 0; i < d->constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &d->constraints[i].row[k];
            r->speed += part * r->change;
        }
    }
    return td_finite(sum);
}
