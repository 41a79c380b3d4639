/* test_joint_tree.c: trees of joints are solved as by the methods for any island, exactly, and what
 * is no such tree is refused with nothing changed. */
#include "direct_support.h"

#include "direct/joint_tree.h"

static const double none[2] = {0, 0};

/* A row along (x, y), or of turn where both are 0, of one of the kinds of direct.h. */
static td_direct_row *set_row(td_direct_row *r, td_row_kind kind, double x, double y,
                              const double arm_a[2], const double arm_b[2]) {
    put_row(r, x, y, arm_a, arm_b);
    r->a[2] -= x == 0 && y == 0;
    r->b[2] += x == 0 && y == 0;
    r->kind = kind;
    return r;
}

/* A hinge: both directions are locked. */
static td_direct_constraint *hinge(problem *p, int a, int b, const double arm_a[2],
                                   const double arm_b[2]) {
    td_direct_constraint *c = &p->contacts[p->d.constraint_count++];
    *c = (td_direct_constraint){.a = a, .b = b};
    set_row(&c->row[0], TD_ROW_EQUALITY, 1, 0, arm_a, arm_b);
    set_row(&c->row[1], TD_ROW_EQUALITY, 0, 1, arm_a, arm_b);
    return c;
}

/* A limit of turn between two bodies, or a spring against it. */
static td_direct_constraint *drive(problem *p, int a, int b, td_row_kind kind) {
    td_direct_constraint *c = &p->contacts[p->d.constraint_count++];
    *c = (td_direct_constraint){.a = a, .b = b};
    set_row(&c->row[0], kind, 0, 0, none, none);
    c->row[0].max_impulse = INFINITY;
    return c;
}

/* A tree of hinges, each with a lock, limit or spring of turn besides or none; bodies are numbered
 * in an order that has nothing to do with the tree, and one of them may be joined to the ground. */
static void grow(problem *p, uint64_t *seed) {
    int number[BODIES_MOST / 2], count = 2 + (int)random_in(seed, 0, BODIES_MOST / 2 - 2);
    begin_problem(p);
    for (int i = 0; i < count; i++) {
        add_mass(p, pow(10, random_in(seed, -2, 2)), pow(10, random_in(seed, -2, 2)));
        int k = (int)random_in(seed, 0, i + 1);
        number[i] = number[k];
        number[k] = i;
    }
    for (int i = (int)random_in(seed, 0, 2); i < count; i++) {
        double arm_a[2] = {random_in(seed, -1, 1), random_in(seed, -1, 1)};
        double arm_b[2] = {random_in(seed, -1, 1), random_in(seed, -1, 1)};
        int a = i ? number[(int)random_in(seed, 0, i)] : GROUND, b = number[i];
        td_direct_constraint *c = hinge(p, a, b, arm_a, arm_b);
        c->row[0].target_speed = random_in(seed, -0.1, 0.1);
        c->row[1].known_speed = i ? 0 : random_in(seed, -1, 1);
        int more = (int)random_in(seed, 0, 4);
        if (more == 1) {
            set_row(&c->row[2], TD_ROW_EQUALITY, 0, 0, none, none);
        } else if (more > 1) {
            td_direct_row *r = drive(p, b, a, more == 2 ? TD_ROW_SOFT : TD_ROW_UNILATERAL)->row;
            r->weight = random_in(seed, 0.1, 10);
            r->target_speed = random_in(seed, -1, 1);
        }
    }
    order_problem(p);
}

static void tree_is_solved_as_any_island_but_to_rounding(void **state) {
    (void)state;
    uint64_t seed = 1;
    int solved = 0, pushing = 0;
    enum { TREES = 2000 };
    for (int n = 0; n < TREES; n++) {
        problem p;
        td_tree_body scratch[BODIES_MOST];
        double residual = 1, velocity[BODIES_MOST][3];
        grow(&p, &seed);
        if (td_joint_tree_solve(&p.d, scratch, TOLERANCE, &residual)) {
            solved++;
            assert_true(residual <= 0.1 * TOLERANCE);
            assert_balanced(&p, 0);
            for (int i = 0; i < p.d.constraint_count; i++) {
                for (int k = 0; k < TD_DIRECT_ROWS; k++) {
                    const td_direct_row *r = &p.contacts[i].row[k];
                    double over = row_speed(&p, &p.contacts[i], k) - r->target_speed;
                    if (r->used && r->kind == TD_ROW_EQUALITY) {
                        near_to(over, 0, 1e-9);
                    } else if (r->used && r->kind == TD_ROW_UNILATERAL) {
                        assert_true(r->impulse >= 0);
                        assert_true(r->impulse == 0 || fabs(over) < 1e-9);
                        pushing += r->impulse > 0;
                    } else if (r->used) {
                        near_to(r->impulse, -r->weight * over, 1e-9 * (1 + fabs(r->impulse)));
                    }
                }
            }
            for (int i = 0; i < p.d.body_count; i++) {
                memcpy(velocity[i], p.bodies[i].velocity, sizeof velocity[i]);
                memset(p.bodies[i].velocity, 0, sizeof p.bodies[i].velocity);
            }
            forget_impulses(&p);
            double missing = td_direct_solve(&p.d, 1e-3 * TOLERANCE);
            for (int i = 0; i < p.d.body_count && missing <= 1e-3 * TOLERANCE; i++) {
                for (int k = 0; k < 3; k++) {
                    near_to(p.bodies[i].velocity[k], velocity[i][k], 20 * TOLERANCE);
                }
            }
        }
        end_problem(&p);
    }
    assert_true(solved > 0.95 * TREES); /* the others have limits that do not settle */
    assert_true(pushing > TREES / 4);
}

/* Three bodies in a row, of which the first is held, joined by hinges, or by a row each; the rest
 * of each test spoils it. */
static void hang(problem *p, bool hinges) {
    begin_problem(p);
    for (int i = 0; i < 3; i++) {
        add_mass(p, 1, 1);
        hinge(p, i - 1, i, (double[]){0.5, 0}, (double[]){-0.5, 0})->row[0].used = hinges;
        p->bodies[i].velocity[0] = 0.25;
        p->contacts[i].row[1].impulse = 0.5;
    }
}

static void assert_refused(problem *p) {
    td_tree_body scratch[BODIES_MOST];
    double residual = -1;
    order_problem(p);
    assert_false(td_joint_tree_solve(&p->d, scratch, TOLERANCE, &residual));
    near_to(residual, -1, 0);
    for (int i = 0; i < 3; i++) {
        near_to(p->bodies[i].velocity[0], 0.25, 0);
        near_to(p->contacts[i].row[1].impulse, 0.5, 0);
    }
    end_problem(p);
}

static void what_is_no_tree_is_refused_and_nothing_changes(void **state) {
    (void)state;
    problem p;
    td_tree_body scratch[BODIES_MOST];
    double residual = -1;
    hang(&p, true);
    order_problem(&p);
    assert_true(td_joint_tree_solve(&p.d, scratch, TOLERANCE, &residual));
    end_problem(&p);

    hang(&p, false); /* a loop of three bodies */
    drive(&p, 2, 0, TD_ROW_EQUALITY);
    assert_refused(&p);

    hang(&p, false); /* a loop through the ground */
    drive(&p, GROUND, 2, TD_ROW_EQUALITY);
    assert_refused(&p);

    hang(&p, true);
    drive(&p, 1, 2, TD_ROW_FRICTION)->row[0].max_impulse = 1;
    assert_refused(&p);

    hang(&p, true); /* a spring that would have to push harder than it can */
    td_direct_row *spring = drive(&p, 1, 2, TD_ROW_SOFT)->row;
    *spring = (td_direct_row){.kind = TD_ROW_SOFT,
                              .a = {0, 0, -1},
                              .b = {0, 0, 1},
                              .used = true,
                              .weight = 10,
                              .target_speed = 5,
                              .max_impulse = 1};
    assert_refused(&p);

    hang(&p, true); /* more rows than three */
    drive(&p, 1, 2, TD_ROW_EQUALITY);
    drive(&p, 1, 2, TD_ROW_EQUALITY);
    assert_refused(&p);

    hang(&p, true); /* nearly the same row twice */
    p.contacts[1].row[2] = p.contacts[1].row[0];
    p.contacts[1].row[2].b[2] += 1e-7;
    assert_refused(&p);

    hang(&p, true);
    p.d.effort = 10;
    assert_refused(&p);

    hang(&p, true);
    p.d.factoring_budget = 0;
    assert_refused(&p);

    hang(&p, true);
    p.bodies[1].free[0] = NAN;
    assert_refused(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tree_is_solved_as_any_island_but_to_rounding),
        cmocka_unit_test(what_is_no_tree_is_refused_and_nothing_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
