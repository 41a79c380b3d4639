/* direct_support.h: small problems for the direct solver (direct/direct.h), built without a world:
 * bodies, contact rows and the sparse matrix; and assertions on a solution: impulses and velocities
 * balance, contacts satisfy the Karush-Kuhn-Tucker conditions, friction stays within its cones. */
#ifndef DIRECT_SUPPORT_H
#define DIRECT_SUPPORT_H

#include "engine_support.h"

#include "direct/direct.h"

#include <limits.h>

/* Bodies and contacts of a problem at most; body index of the ground. */
enum { BODIES_MOST = 32, CONTACTS_MOST = 64, GROUND = TD_NONE };

/* A problem with its own memory. `step` and `work` are the arrays of which the solver needs one
 * entry for each body. */
typedef struct problem {
    td_memory memory;
    td_sparse matrix;
    td_direct d;
    td_direct_body bodies[BODIES_MOST];
    td_direct_constraint contacts[CONTACTS_MOST];
    double step[BODIES_MOST][4], work[BODIES_MOST][4];
} problem;

/* The speed that gravity of 10 m/s^2 gives a body in a step of 1/60 s. */
#define UNIT_SPEED (10.0 / 60)
/* Tolerance of row velocities in m/s, for the assertions below. Chosen. */
#define TOLERANCE (1e-3 * UNIT_SPEED)

static inline void begin_problem(problem *p) {
    *p = (problem){.memory = td_memory_make((thud_allocator){0})};
    td_sparse_init(&p->matrix, false);
    p->d = (td_direct){.bodies = p->bodies,
                       .constraints = p->contacts,
                       .matrix = &p->matrix,
                       .step = p->step,
                       .work = p->work,
                       .factoring_budget = 200,
                       .effort = INT64_MAX,
                       .unit_speed = UNIT_SPEED};
}

static inline void end_problem(problem *p) {
    td_sparse_free(&p->memory, &p->matrix);
}

/* Adds a body whose free velocity is that after one step of gravity; returns its index. With an
 * inertia of 0 it does not turn. */
static inline int add_mass(problem *p, double mass, double inertia) {
    td_direct_body *b = &p->bodies[p->d.body_count];
    *b = (td_direct_body){.inverse_mass = 1 / mass,
                          .inverse_inertia = inertia > 0 ? 1 / inertia : 0,
                          .free = {0, -UNIT_SPEED, 0}};
    return p->d.body_count++;
}

/* Sets the row's Jacobian: the direction (x, y) from body a to body b, and the lever arms relative
 * to the bodies' centres. */
static inline void put_row(td_direct_row *r, double x, double y, const double arm_a[2],
                           const double arm_b[2]) {
    *r = (td_direct_row){.a = {-x, -y, -(arm_a[0] * y - arm_a[1] * x)},
                         .b = {x, y, arm_b[0] * y - arm_b[1] * x},
                         .used = true};
}

/* Adds a contact from a to b with the normal (x, y) and 1 or 2 `points`. `arms` lead from the
 * centres of a and b to the first point; the second is `width` further across the normal. */
static inline td_direct_constraint *add_contact(problem *p, int a, int b, double x, double y,
                                                const double arms[2][2], int points, double width,
                                                double friction) {
    td_direct_constraint *c = &p->contacts[p->d.constraint_count++];
    *c = (td_direct_constraint){.a = a, .b = b, .friction = friction};
    for (int k = 0; k < points; k++) {
        double s = k * width;
        double arm_a[2] = {arms[0][0] + s * y, arms[0][1] - s * x};
        double arm_b[2] = {arms[1][0] + s * y, arms[1][1] - s * x};
        put_row(&c->row[k], x, y, arm_a, arm_b);
    }
    double middle = 0.5 * (points - 1) * width;
    double arm_a[2] = {arms[0][0] + middle * y, arms[0][1] - middle * x};
    double arm_b[2] = {arms[1][0] + middle * y, arms[1][1] - middle * x};
    put_row(&c->row[TD_DIRECT_TANGENT], y, -x, arm_a, arm_b);
    c->row[TD_DIRECT_TANGENT].kind = TD_ROW_FRICTION;
    c->row[TD_DIRECT_TANGENT].used = friction > 0;
    return c;
}

/* Adds the contact of two boxes of edge 1, of which b stands on a. */
static inline td_direct_constraint *stack(problem *p, int a, int b, double friction) {
    const double arms[2][2] = {{-0.5, 0.5}, {-0.5, -0.5}};
    return add_contact(p, a, b, 0, 1, arms, 2, 1, friction);
}

/* Begins the matrix, in two passes over all contacts: the first tells it which bodies are coupled
 * and orders the elimination, the second keeps the place of each contact's block. Called once all
 * contacts exist. */
static inline void order_problem(problem *p) {
    assert_true(td_sparse_reserve(&p->memory, &p->matrix, p->d.body_count));
    td_sparse_forget(&p->matrix);
    assert_true(td_sparse_begin(&p->memory, &p->matrix, p->d.body_count));
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < p->d.constraint_count; i++) {
            td_direct_constraint *c = &p->contacts[i];
            if (c->a == GROUND || c->b == GROUND) {
                continue;
            }
            if (pass == 0) {
                td_sparse_tie(&p->matrix, c->a, c->b);
            } else {
                c->entry = td_sparse_find(&p->matrix, c->a, c->b);
                c->b_later = td_sparse_is_later(&p->matrix, c->b, c->a);
            }
        }
        assert_true(pass || td_sparse_order(&p->memory, &p->matrix, INT_MAX));
    }
}

/* Sets all impulses to 0, so that the active set is not warm-started from those of the last
 * solution. */
static inline void forget_impulses(problem *p) {
    for (int i = 0; i < p->d.constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            p->contacts[i].row[k].impulse = 0;
        }
    }
    p->d.factorings = 0;
}

/* The velocity of row k: its Jacobian times the velocities of its bodies, and the part that is
 * known. */
static inline double row_speed(const problem *p, const td_direct_constraint *c, int k) {
    const td_direct_row *r = &c->row[k];
    double speed = r->known_speed;
    for (int j = 0; j < 3; j++) {
        speed += c->a == GROUND ? 0 : r->a[j] * p->bodies[c->a].velocity[j];
        speed += c->b == GROUND ? 0 : r->b[j] * p->bodies[c->b].velocity[j];
    }
    return speed;
}

/* The sum of the contact's normal impulses. */
static inline double load_of(const td_direct_constraint *c) {
    return c->row[0].used * c->row[0].impulse + c->row[1].used * c->row[1].impulse;
}

/* Asserts that the change of each body's momentum is the sum of the impulses on it. A row may be
 * off by `tolerance` (m/s) times its effective mass; rounding may add 1e-7 of the sum of all
 * magnitudes (chosen). */
static inline void assert_balanced(const problem *p, double tolerance) {
    for (int i = 0; i < p->d.body_count; i++) {
        const td_direct_body *b = &p->bodies[i];
        for (int j = 0; j < 3; j++) {
            double inverse = j < 2 ? b->inverse_mass : b->inverse_inertia;
            if (inverse == 0) {
                near_to(b->velocity[j], 0, 0);
                continue;
            }
            double off = (b->velocity[j] - b->free[j]) / inverse, doubt = 0;
            double most = (fabs(b->velocity[j]) + fabs(b->free[j])) / inverse;
            for (int n = 0; n < p->d.constraint_count; n++) {
                const td_direct_constraint *c = &p->contacts[n];
                for (int k = 0; k < TD_DIRECT_ROWS; k++) {
                    const td_direct_row *r = &c->row[k];
                    double side = c->a == i ? r->a[j] : c->b == i ? r->b[j] : 0;
                    off -= r->used ? side * r->impulse : 0;
                    most += r->used ? fabs(side * r->impulse) : 0;
                    doubt += r->used ? fabs(side) * r->mass : 0;
                }
            }
            near_to(off, 0, tolerance * doubt + 1e-7 * most);
        }
    }
}

/* Asserts the Karush-Kuhn-Tucker conditions: a normal row has an impulse >= 0, a velocity that is
 * not below its target, and one of the two at its bound; a friction row sticks, or its impulse is
 * at max_impulse, the bound that the solver used, against the slip. */
static inline void assert_solved(const problem *p, double tolerance) {
    assert_balanced(p, tolerance);
    for (int i = 0; i < p->d.constraint_count; i++) {
        const td_direct_constraint *c = &p->contacts[i];
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            const td_direct_row *r = &c->row[k];
            double over = row_speed(p, c, k) - r->target_speed;
            if (r->used) {
                assert_true(over >= -tolerance);
                assert_true(r->impulse >= 0);
                assert_true(fmin(over, r->impulse / r->mass) <= tolerance);
            }
        }
        const td_direct_row *t = &c->row[TD_DIRECT_TANGENT];
        if (t->used) {
            double slip = row_speed(p, c, TD_DIRECT_TANGENT) - t->target_speed;
            double left = t->max_impulse - (slip > 0 ? -t->impulse : t->impulse);
            assert_true(fabs(t->impulse) <= t->max_impulse + tolerance * t->mass);
            assert_true(fmin(fabs(slip), left / t->mass) <= tolerance);
        }
    }
}

/* Asserts that friction impulses stay within 1.02 times friction * normal impulse: the solver may
 * stop while its friction bounds differ from the final normal impulses by 2 %. */
static inline void assert_within_cones(const problem *p, double tolerance) {
    for (int i = 0; i < p->d.constraint_count; i++) {
        const td_direct_constraint *c = &p->contacts[i];
        const td_direct_row *t = &c->row[TD_DIRECT_TANGENT];
        if (t->used) {
            near_to(fmax(fabs(t->impulse) - 1.02 * c->friction * load_of(c), 0), 0,
                    tolerance * t->mass);
        }
    }
}

#endif
