/* test_direct_equalities.c: equality rows of the direct solver, which joints have, by both of its
 * methods: active set and interior point. */
#include "direct_support.h"

/* A row of masses of 1 and of 1000, each joined by an equality row to the one before and the first
 * to the ground; one of the rows has a target velocity. Each row carries all masses after it.
 * Beside them a box stands on the ground, so that there are unilateral rows as well. */
static void direct_equalities_hold_by_both_methods(void **state) {
    (void)state;
    enum { HUNG = 4 };
    static const double none[2][2] = {{0, 0}, {0, 0}};
    bool (*const methods[])(td_direct *, double) = {td_direct_solve_active_set,
                                                    td_direct_solve_interior_point};
    for (int m = 0; m < 2; m++) {
        problem p;
        double mass = HUNG - 1 + 1000;
        begin_problem(&p);
        for (int i = 0; i < HUNG; i++) {
            add_mass(&p, i == HUNG - 1 ? 1000 : 1, 0);
            add_contact(&p, i - 1, i, 0, 1, none, 1, 0, 0)->row[0].kind = TD_ROW_EQUALITY;
        }
        p.contacts[2].row[0].target_speed = 0.01;
        add_mass(&p, 1, 1.0 / 6);
        stack(&p, GROUND, HUNG, 0.6);
        order_problem(&p);
        td_direct_solve(&p.d, TOLERANCE); /* computes the effective masses of rows */
        forget_impulses(&p);
        for (int i = 0; i < p.d.body_count; i++) {
            memcpy(p.bodies[i].velocity, p.bodies[i].free, sizeof p.bodies[i].velocity);
        }
        assert_true(methods[m](&p.d, TOLERANCE));
        td_direct_update_speeds(&p.d);
        assert_true(td_direct_residual(&p.d) <= TOLERANCE);
        near_to(p.bodies[1].velocity[1], 0, 2 * TOLERANCE);
        near_to(p.bodies[3].velocity[1], 0.01, 4 * TOLERANCE);
        near_to(p.bodies[HUNG].velocity[1], 0, TOLERANCE);
        near_to(p.contacts[0].row[0].impulse, mass * UNIT_SPEED + 1001 * 0.01, mass * TOLERANCE);
        mass--;
        near_to(p.contacts[1].row[0].impulse, mass * UNIT_SPEED + 1001 * 0.01, mass * TOLERANCE);
        end_problem(&p);
    }
}

/* A unilateral row would let the body fly off; an equality row holds it. */
static void direct_equality_holds_what_flies_off(void **state) {
    (void)state;
    problem p;
    static const double none[2][2] = {{0, 0}, {0, 0}};
    begin_problem(&p);
    add_mass(&p, 1, 0);
    add_contact(&p, GROUND, 0, 0, 1, none, 1, 0, 0)->row[0].kind = TD_ROW_EQUALITY;
    order_problem(&p);
    p.bodies[0].free[1] = 5;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    near_to(p.bodies[0].velocity[1], 0, TOLERANCE);
    near_to(p.contacts[0].row[0].impulse, -5, TOLERANCE);
    end_problem(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(direct_equalities_hold_by_both_methods),
        cmocka_unit_test(direct_equality_holds_what_flies_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
