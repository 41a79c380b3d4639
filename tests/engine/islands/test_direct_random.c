/* test_direct_random.c: the direct solver's two methods on random problems, against the conditions
 * of a solution, and against an exhaustive search through all active sets. */
#include "direct_support.h"

/* ---- problems ---- */

/* How problems are drawn. */
typedef struct mix {
    int bodies, contacts; /* at most */
    double ratio;         /* greatest mass ratio, log10 */
    double friction;      /* greatest coefficient */
    double target_speed;  /* greatest target velocity; 0 may always be drawn */
    int points;           /* points of a contact, at most */
} mix;

/* Contacts between any two bodies, with lever arms and normals of any direction, which is harder
 * than what bodies in a plane can have. Every third one is a copy of another. */
static void make_random(problem *p, mix m, uint64_t *seed) {
    begin_problem(p);
    int bodies = 1 + (int)random_in(seed, 0, m.bodies);
    int contacts = 1 + (int)random_in(seed, 0, m.contacts);
    for (int i = 0; i < bodies; i++) {
        double mass = pow(10, random_in(seed, 0, m.ratio));
        int b = add_mass(p, mass, i % 5 == 4 ? 0 : mass * random_in(seed, 0.1, 1));
        for (int k = 0; k < 3; k++) {
            p->bodies[b].free[k] += random_in(seed, -1, 1);
            p->bodies[b].velocity[k] = random_in(seed, -1, 1);
        }
        p->bodies[b].free[2] *= p->bodies[b].inverse_inertia > 0;
        p->bodies[b].velocity[2] *= p->bodies[b].inverse_inertia > 0;
    }
    for (int i = 0; i < contacts; i++) {
        if (i % 3 == 2) {
            p->contacts[p->d.constraint_count++] = p->contacts[(int)random_in(seed, 0, i)];
            continue;
        }
        int b = (int)random_in(seed, 0, bodies), a = (int)random_in(seed, -1, bodies);
        double angle = random_in(seed, 0, 6.3), arms[2][2];
        for (int k = 0; k < 4; k++) {
            arms[k / 2][k % 2] = random_in(seed, -1, 1);
        }
        td_direct_constraint *c =
            add_contact(p, a == b ? GROUND : a, b, cos(angle), sin(angle), arms,
                        1 + (int)random_in(seed, 0, m.points), random_in(seed, 0.2, 1),
                        random_in(seed, 0, m.friction));
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            r->a[2] *= c->a != GROUND && p->bodies[c->a].inverse_inertia > 0;
            r->b[2] *= p->bodies[b].inverse_inertia > 0;
            r->target_speed =
                r->used ? random_in(seed, k < TD_DIRECT_TANGENT ? -1 : 0, m.target_speed) : 0;
        }
    }
    order_problem(p);
}

/* ---- reference without friction ---- */

enum { ROWS_MOST = 8 };

/* Normal rows of a problem, with their contacts. */
typedef struct normals {
    const td_direct_constraint *contact[ROWS_MOST];
    const td_direct_row *row[ROWS_MOST];
    int count;
} normals;

/* All normal rows of a problem. */
static normals normals_of(const problem *p) {
    normals n = {.count = 0};
    for (int i = 0; i < p->d.constraint_count; i++) {
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            if (p->contacts[i].row[k].used && n.count < ROWS_MOST) {
                n.contact[n.count] = &p->contacts[i];
                n.row[n.count++] = &p->contacts[i].row[k];
            }
        }
    }
    return n;
}

/* The change of row i's velocity by a unit impulse of row k. */
static long double coupling(const problem *p, const normals *n, int i, int k) {
    long double sum = 0;
    for (int body = 0; body < p->d.body_count; body++) {
        const double *ji = n->contact[i]->a == body   ? n->row[i]->a
                           : n->contact[i]->b == body ? n->row[i]->b
                                                      : NULL;
        const double *jk = n->contact[k]->a == body   ? n->row[k]->a
                           : n->contact[k]->b == body ? n->row[k]->b
                                                      : NULL;
        for (int j = 0; j < 3 && ji && jk; j++) {
            const td_direct_body *b = &p->bodies[body];
            sum += (long double)ji[j] * jk[j] * (j < 2 ? b->inverse_mass : b->inverse_inertia);
        }
    }
    return sum;
}

/* The velocity of row i without impulses. */
static long double free_speed(const problem *p, const normals *n, int i) {
    long double sum = n->row[i]->known_speed;
    for (int j = 0; j < 3; j++) {
        int a = n->contact[i]->a, b = n->contact[i]->b;
        sum += a == GROUND ? 0 : (long double)n->row[i]->a[j] * p->bodies[a].free[j];
        sum += b == GROUND ? 0 : (long double)n->row[i]->b[j] * p->bodies[b].free[j];
    }
    return sum;
}

/* The impulses with which the rows of the set have exactly their target velocities; false where
 * they are linearly dependent. `full` holds the couplings of all rows, and `lack` their target
 * velocities less those without impulses. */
static bool solve_set(const long double full[ROWS_MOST][ROWS_MOST], const long double *lack,
                      int count, unsigned set, long double *impulse) {
    long double m[ROWS_MOST][ROWS_MOST + 1];
    int rows[ROWS_MOST], size = 0;
    for (int i = 0; i < count; i++) {
        impulse[i] = 0;
        if (set >> i & 1) {
            rows[size++] = i;
        }
    }
    for (int i = 0; i < size; i++) {
        for (int k = 0; k < size; k++) {
            m[i][k] = full[rows[i]][rows[k]];
        }
        m[i][size] = lack[rows[i]];
    }
    for (int i = 0; i < size; i++) {
        if (m[i][i] < 1e-9L * full[rows[i]][rows[i]]) {
            return false;
        }
        for (int k = 0; k < size; k++) {
            long double share = k == i ? 0 : m[k][i] / m[i][i];
            for (int j = i; j <= size; j++) {
                m[k][j] -= share * m[i][j];
            }
        }
    }
    for (int i = 0; i < size; i++) {
        impulse[rows[i]] = m[i][size] / m[i][i];
    }
    return true;
}

/* The impulses of the set of which no active row pulls and no other row closes: among all sets
 * there is one with these velocities. False where rounding hides it. */
static bool search(const problem *p, long double *impulse) {
    normals n = normals_of(p);
    long double full[ROWS_MOST][ROWS_MOST], lack[ROWS_MOST];
    for (int i = 0; i < n.count; i++) {
        lack[i] = n.row[i]->target_speed - free_speed(p, &n, i);
        for (int k = 0; k < n.count; k++) {
            full[i][k] = coupling(p, &n, i, k);
        }
    }
    for (unsigned set = 0; set < 1u << n.count; set++) {
        bool right = solve_set(full, lack, n.count, set, impulse);
        for (int i = 0; i < n.count && right; i++) {
            long double left = lack[i];
            for (int k = 0; k < n.count; k++) {
                left -= full[i][k] * impulse[k];
            }
            right = impulse[i] >= 0 && (set >> i & 1 || left <= 1e-12L);
        }
        if (right) {
            return true;
        }
    }
    return false;
}

/* Asserts that the problem's velocities are those of these impulses. */
static void assert_same_velocities(const problem *p, const long double *impulse, double tolerance) {
    normals n = normals_of(p);
    for (int body = 0; body < p->d.body_count; body++) {
        const td_direct_body *b = &p->bodies[body];
        for (int j = 0; j < 3; j++) {
            long double v = b->free[j], inverse = j < 2 ? b->inverse_mass : b->inverse_inertia;
            for (int i = 0; i < n.count; i++) {
                v += n.contact[i]->a == body ? inverse * n.row[i]->a[j] * impulse[i] : 0;
                v += n.contact[i]->b == body ? inverse * n.row[i]->b[j] * impulse[i] : 0;
            }
            near_to(b->velocity[j], (double)v, tolerance);
        }
    }
}

/* ---- tests ---- */

static const mix FEW = {.bodies = 4, .contacts = 4, .ratio = 1, .points = 2};

static void direct_velocities_are_those_of_a_search(void **state) {
    (void)state;
    uint64_t seed = 21;
    int found = 0;
    for (int i = 0; i < 2000; i++) {
        problem p;
        long double impulse[ROWS_MOST];
        make_random(&p, FEW, &seed);
        if (search(&p, impulse)) {
            const double tight = 1e-3 * TOLERANCE;
            assert_true(td_direct_solve(&p.d, tight) <= tight);
            assert_same_velocities(&p, impulse, 100 * tight);
            found++;
        }
        end_problem(&p);
    }
    assert_true(found > 1900);
}

static const mix MANY = {.bodies = 20, .contacts = 40, .ratio = 1, .points = 2};

static mix many(double ratio, double friction) {
    mix m = MANY;
    m.ratio = ratio;
    m.friction = friction;
    return m;
}

/* Computes the effective masses of rows, and friction bounds for the present impulses. */
static void weigh(problem *p) {
    p->d.factoring_budget = 0;
    assert_true(td_direct_solve(&p->d, TOLERANCE) > TOLERANCE);
    p->d.factoring_budget = 200;
}

static void direct_interior_point_solves_from_nothing(void **state) {
    (void)state;
    uint64_t seed = 22;
    for (int i = 0; i < 600; i++) {
        problem p;
        make_random(&p, many(i % 6, 0), &seed);
        weigh(&p);
        assert_true(td_direct_solve_interior_point(&p.d, TOLERANCE));
        assert_solved(&p, TOLERANCE);
        end_problem(&p);
    }
}

/* Friction bounds between almost zero and a thousand times the momentum. A few per cent of the
 * problems may not be solved, and then the solver has to say so. */
static void direct_interior_point_heeds_bounds_of_friction(void **state) {
    (void)state;
    uint64_t seed = 25;
    int solved = 0;
    for (int i = 0; i < 600; i++) {
        problem p;
        make_random(&p, many(i % 6, 1), &seed);
        for (int n = 0; n < p.d.constraint_count; n++) {
            p.contacts[n].row[0].impulse = pow(10, random_in(&seed, -3, 3));
        }
        weigh(&p);
        if (td_direct_solve_interior_point(&p.d, TOLERANCE)) {
            assert_solved(&p, TOLERANCE);
            solved++;
        }
        end_problem(&p);
    }
    assert_true(solved >= 600 * 97 / 100);
}

/* The first guess is the solution of a problem with slightly different free velocities. */
static void direct_active_set_solves_from_a_good_guess(void **state) {
    (void)state;
    uint64_t seed = 23;
    int solved = 0;
    for (int i = 0; i < 600; i++) {
        problem p;
        make_random(&p, many(i % 6, 0), &seed);
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        for (int n = 0; n < p.d.body_count; n++) {
            p.bodies[n].free[0] += random_in(&seed, -1, 1) * TOLERANCE;
            p.bodies[n].free[1] += random_in(&seed, -1, 1) * TOLERANCE;
        }
        p.d.factorings = 0;
        if (td_direct_solve_active_set(&p.d, TOLERANCE)) {
            assert_solved(&p, TOLERANCE);
            solved++;
        }
        assert_in_range(p.d.factorings, 1, 6);
        end_problem(&p);
    }
    assert_true(solved >= 600 * 97 / 100);
}

/* A pyramid of boxes of edge 1 with random masses. */
static void make_heap(problem *p, int height, double ratio, uint64_t *seed) {
    int below[BODIES_MOST] = {0}, above[BODIES_MOST] = {0};
    begin_problem(p);
    for (int level = 0; level < height; level++) {
        for (int i = 0; i < height - level; i++) {
            double mass = pow(10, random_in(seed, 0, ratio)), friction = random_in(seed, 0.3, 1);
            above[i] = add_mass(p, mass, mass / 6);
            if (level == 0) {
                stack(p, GROUND, above[i], friction);
                continue;
            }
            const double left[2][2] = {{0, 0.5}, {-0.5, -0.5}};
            const double right[2][2] = {{-0.5, 0.5}, {0, -0.5}};
            add_contact(p, below[i], above[i], 0, 1, left, 2, 0.5, friction);
            add_contact(p, below[i + 1], above[i], 0, 1, right, 2, 0.5, friction);
        }
        memcpy(below, above, sizeof below);
    }
    order_problem(p);
}

/* As in successive steps: each solution is warm-started with the impulses of the one before. */
static void direct_heaps_come_to_rest_within_their_cones(void **state) {
    (void)state;
    uint64_t seed = 26;
    for (int i = 0; i < 100; i++) {
        problem p;
        make_heap(&p, 2 + i % 5, i % 4, &seed);
        for (int n = 0; n < 10; n++) {
            p.d.factorings = 0;
            assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        }
        assert_in_range(p.d.factorings, 1, 2);
        assert_solved(&p, TOLERANCE);
        assert_within_cones(&p, TOLERANCE);
        end_problem(&p);
    }
}

/* With friction and walls whose targets contradict each other: the solver returns an infinite
 * residual, or the true one, and never NaN. */
static void direct_solver_tells_what_is_missing(void **state) {
    (void)state;
    uint64_t seed = 24;
    int solved = 0;
    for (int i = 0; i < 600; i++) {
        problem p;
        mix m = many(i % 7, 1);
        m.target_speed = i % 2;
        make_random(&p, m, &seed);
        double miss = td_direct_solve(&p.d, TOLERANCE), worst = 0;
        assert_true(miss >= 0);
        if (miss <= TOLERANCE) {
            for (int n = 0; n < p.d.constraint_count; n++) {
                const td_direct_constraint *c = &p.contacts[n];
                for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
                    assert_true(!c->row[k].used || c->row[k].impulse >= 0);
                    worst = fmax(worst,
                                 c->row[k].used * (c->row[k].target_speed - row_speed(&p, c, k)));
                }
            }
            near_to(worst, miss, 1e-9);
            assert_balanced(&p, TOLERANCE);
            solved++;
        }
        end_problem(&p);
    }
    assert_true(solved > 300); /* of 600; about as many have a solution */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(direct_velocities_are_those_of_a_search),
        cmocka_unit_test(direct_interior_point_solves_from_nothing),
        cmocka_unit_test(direct_interior_point_heeds_bounds_of_friction),
        cmocka_unit_test(direct_active_set_solves_from_a_good_guess),
        cmocka_unit_test(direct_heaps_come_to_rest_within_their_cones),
        cmocka_unit_test(direct_solver_tells_what_is_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
