/* test_direct.c: the direct solver on problems whose impulses and velocities are known by hand. */
#include "direct_support.h"

/* A column of boxes of mass 1, each on the one before, the first on the ground. */
static void make_column(problem *p, int boxes, double friction) {
    begin_problem(p);
    for (int i = 0; i < boxes; i++) {
        add_mass(p, 1, 1.0 / 6);
        stack(p, i - 1, i, friction);
    }
    order_problem(p);
}

static void assert_at_rest(const problem *p, double tolerance) {
    for (int i = 0; i < p->d.body_count; i++) {
        for (int k = 0; k < 3; k++) {
            near_to(p->bodies[i].velocity[k], 0, tolerance);
        }
    }
}

static void direct_column_bears_what_is_above(void **state) {
    (void)state;
    problem p;
    make_column(&p, 30, 0.6);
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    assert_solved(&p, TOLERANCE);
    /* Each contact may close by the tolerance. */
    assert_at_rest(&p, 30 * TOLERANCE);
    for (int i = 0; i < 30; i++) {
        near_to(load_of(&p.contacts[i]), (30 - i) * UNIT_SPEED, 30 * 30 / 2 * TOLERANCE);
    }
    end_problem(&p);
}

/* Warm-started with the impulses of the first solution. */
static void direct_column_at_rest_takes_one_matrix(void **state) {
    (void)state;
    problem p;
    make_column(&p, 30, 0.6);
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    p.d.factorings = 0;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    assert_int_equal(p.d.factorings, 1);
    assert_solved(&p, TOLERANCE);
    end_problem(&p);
}

/* A light box under a heavy one, with mass ratios up to 10^6. The tolerance is a thousandth of the
 * velocity that gravity gives the light one. */
static void direct_heavy_on_light_rests(void **state) {
    (void)state;
    for (double mass = 1; mass <= 1e6; mass *= 10) {
        problem p;
        begin_problem(&p);
        add_mass(&p, 1, 1.0 / 6);
        add_mass(&p, mass, mass / 6);
        stack(&p, GROUND, 0, 0.6);
        stack(&p, 0, 1, 0.6);
        order_problem(&p);
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        assert_solved(&p, TOLERANCE);
        assert_at_rest(&p, 3 * TOLERANCE);
        near_to(load_of(&p.contacts[0]) / ((1 + mass) * UNIT_SPEED), 1, 3e-3);
        end_problem(&p);
    }
}

/* A plank of mass 4 on two boxes of mass 1, at -1 and 1, with its centre at 0.5: by the lever law
 * the left one carries a quarter. */
static void direct_plank_shares_its_load_by_the_lever_law(void **state) {
    (void)state;
    for (int interior = 0; interior < 2; interior++) {
        problem p;
        const double left[2][2] = {{0, 0.5}, {-1.5, -0.5}}, right[2][2] = {{0, 0.5}, {0.5, -0.5}};
        begin_problem(&p);
        add_mass(&p, 1, 1.0 / 6);
        add_mass(&p, 1, 1.0 / 6);
        add_mass(&p, 4, 4);
        stack(&p, GROUND, 0, 0.6);
        stack(&p, GROUND, 1, 0.6);
        add_contact(&p, 0, 2, 0, 1, left, 1, 0, 0.6);
        add_contact(&p, 1, 2, 0, 1, right, 1, 0, 0.6);
        order_problem(&p);
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        if (interior) {
            assert_true(td_direct_solve_interior_point(&p.d, TOLERANCE));
        }
        assert_solved(&p, TOLERANCE);
        near_to(load_of(&p.contacts[2]), 1 * UNIT_SPEED, 8 * TOLERANCE);
        near_to(load_of(&p.contacts[3]), 3 * UNIT_SPEED, 8 * TOLERANCE);
        end_problem(&p);
    }
}

/* Friction on a sliding box is the coefficient times its weight, against the motion. */
static void direct_slider_loses_what_friction_takes(void **state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        problem p;
        make_column(&p, 1, 0.3);
        p.bodies[0].free[0] = 2.0 * side;
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        p.bodies[0].free[0] = 2.0 * side;
        assert_solved(&p, TOLERANCE);
        assert_within_cones(&p, TOLERANCE);
        near_to(p.bodies[0].velocity[0], side * (2 - 0.3 * UNIT_SPEED), 0.02 * UNIT_SPEED);
        end_problem(&p);
    }
}

/* A box that is slow enough stops, and one that is pushed by less than the friction bound does not
 * move. */
static void direct_box_sticks_below_the_bound_of_friction(void **state) {
    (void)state;
    problem p;
    make_column(&p, 1, 0.3);
    p.bodies[0].free[0] = 0.25 * UNIT_SPEED;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    near_to(p.bodies[0].velocity[0], 0, TOLERANCE);
    end_problem(&p);
}

/* A belt at 0.1 takes along a slow box at once, with enough friction. */
static void direct_belt_takes_a_box_along(void **state) {
    (void)state;
    problem p;
    make_column(&p, 1, 10);
    p.contacts[0].row[TD_DIRECT_TANGENT].target_speed = 0.1;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    near_to(p.bodies[0].velocity[0], 0.1, TOLERANCE);
    assert_solved(&p, TOLERANCE);
    end_problem(&p);
}

/* The ground rises at 3, and the column with it. */
static void direct_known_speed_of_the_ground_is_taken_on(void **state) {
    (void)state;
    problem p;
    make_column(&p, 5, 0.6);
    p.contacts[0].row[0].known_speed = p.contacts[0].row[1].known_speed = -3;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    for (int i = 0; i < 5; i++) {
        near_to(p.bodies[i].velocity[1], 3, 10 * TOLERANCE);
    }
    end_problem(&p);
}

static void direct_contacts_that_part_do_not_push(void **state) {
    (void)state;
    problem p;
    make_column(&p, 3, 0.6);
    p.bodies[2].free[1] = 5;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    assert_solved(&p, TOLERANCE);
    near_to(load_of(&p.contacts[2]), 0, 0);
    near_to(p.bodies[2].velocity[1], 5, 1e-12);
    end_problem(&p);
}

/* Two more contacts at the same points. */
static void direct_redundant_contacts_change_nothing(void **state) {
    (void)state;
    problem p;
    make_column(&p, 4, 0.6);
    stack(&p, GROUND, 0, 0.6);
    stack(&p, 1, 2, 0.6);
    order_problem(&p);
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    assert_solved(&p, TOLERANCE);
    assert_at_rest(&p, 20 * TOLERANCE);
    near_to(load_of(&p.contacts[0]) + load_of(&p.contacts[4]), 4 * UNIT_SPEED, 10 * TOLERANCE);
    forget_impulses(&p);
    assert_true(td_direct_solve_interior_point(&p.d, TOLERANCE));
    assert_solved(&p, TOLERANCE);
    end_problem(&p);
}

/* Two walls press a box from both sides and both have the target velocity 1: there is no solution,
 * and the residual says so. */
static void direct_wedge_that_cannot_be_says_so(void **state) {
    (void)state;
    problem p;
    const double left[2][2] = {{0, 0}, {-0.5, 0}}, right[2][2] = {{0, 0}, {0.5, 0}};
    begin_problem(&p);
    add_mass(&p, 1, 1);
    add_contact(&p, GROUND, 0, 1, 0, left, 1, 0, 0.6)->row[0].target_speed = 1;
    add_contact(&p, GROUND, 0, -1, 0, right, 1, 0, 0.6)->row[0].target_speed = 1;
    order_problem(&p);
    double miss = td_direct_solve(&p.d, TOLERANCE);
    assert_true(miss >= 1 - TOLERANCE);
    assert_true(p.d.factorings <= p.d.factoring_budget);
    end_problem(&p);
}

/* A wedge so narrow that a small velocity of its sides means a great one of the box. */
static void direct_narrow_wedge_is_pushed_out(void **state) {
    (void)state;
    for (double angle = 0.1; angle >= 1e-3; angle *= 0.1) {
        problem p;
        const double left[2][2] = {{0, 0}, {-0.5, 0}}, right[2][2] = {{0, 0}, {0.5, 0}};
        begin_problem(&p);
        add_mass(&p, 1, 1);
        add_contact(&p, GROUND, 0, cos(angle), sin(angle), left, 1, 0, 0)->row[0].target_speed =
            0.1;
        add_contact(&p, GROUND, 0, -cos(angle), sin(angle), right, 1, 0, 0)->row[0].target_speed =
            0.1;
        order_problem(&p);
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        assert_solved(&p, TOLERANCE);
        near_to(p.bodies[0].velocity[1] * sin(angle), 0.1, 2 * TOLERANCE);
        end_problem(&p);
    }
}

static void direct_solver_takes_no_more_matrices_than_it_may(void **state) {
    (void)state;
    for (int factoring_budget = 0; factoring_budget < 30; factoring_budget++) {
        problem p;
        make_column(&p, 20, 0.6);
        for (int i = 0; i < 20; i++) {
            p.bodies[i].free[1] = i % 3 - 1.0;
            p.bodies[i].free[2] = i % 2;
        }
        p.d.factoring_budget = factoring_budget;
        double miss = td_direct_solve(&p.d, TOLERANCE);
        assert_true(miss >= 0);
        assert_true(p.d.factorings <= factoring_budget);
        end_problem(&p);
    }
}

/* With twice the velocities, the same matrix gives twice the impulses, and no further factorisation
 * is needed. */
static void direct_same_rows_again_take_no_matrix(void **state) {
    (void)state;
    problem p;
    make_column(&p, 10, 0.6);
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    td_direct_update_friction(&p.d); /* friction bounds now follow from the impulses */
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    int factorings = p.d.factorings;
    for (int i = 0; i < 10; i++) {
        p.bodies[i].free[1] *= 2;
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            p.contacts[i].row[k].impulse *= 2;
        }
    }
    td_direct_update_friction(&p.d);
    td_direct_update_speeds(&p.d);
    assert_true(td_direct_solve_same_active_set(&p.d, TOLERANCE));
    assert_int_equal(p.d.factorings, factorings);
    assert_solved(&p, TOLERANCE);
    near_to(load_of(&p.contacts[0]), 20 * UNIT_SPEED, 20 * TOLERANCE);
    end_problem(&p);
}

/* The top of the column flies off, so that the active set changes. */
static void direct_other_rows_are_not_solved_again(void **state) {
    (void)state;
    problem p;
    make_column(&p, 10, 0.6);
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    p.bodies[9].free[1] = 3;
    assert_false(td_direct_solve_same_active_set(&p.d, TOLERANCE));
    end_problem(&p);
}

/* Loads, and so friction bounds, differ a little from step to step. */
static void direct_slider_whose_bound_grows_a_little_takes_one_matrix(void **state) {
    (void)state;
    problem p;
    make_column(&p, 1, 0.3);
    p.bodies[0].free[0] = 2;
    for (int n = 0; n < 3; n++) {
        p.d.factorings = 0;
        p.contacts[0].friction *= 1.005;
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    }
    assert_int_equal(p.d.factorings, 1);
    assert_solved(&p, TOLERANCE);
    end_problem(&p);
}

/* A wall pushes a row of boxes over the ground at 1: one factorisation a step from the second step
 * on. */
static void direct_pushed_row_takes_one_matrix_a_step(void **state) {
    (void)state;
    problem p;
    const double arms[2][2] = {{0.5, 0.5}, {-0.5, 0.5}};
    begin_problem(&p);
    for (int i = 0; i < 5; i++) {
        add_mass(&p, 1, 1.0 / 6);
        stack(&p, GROUND, i, 0.6);
        td_direct_constraint *c = add_contact(&p, i - 1, i, 1, 0, arms, 2, 1, 0.6);
        c->row[0].known_speed = c->row[1].known_speed = i == 0 ? -1 : 0;
        p.bodies[i].velocity[0] = p.bodies[i].free[0] = 1;
    }
    order_problem(&p);
    for (int n = 0; n < 5; n++) {
        p.d.factorings = 0;
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        assert_true(n == 0 || p.d.factorings == 1);
    }
    assert_solved(&p, TOLERANCE);
    assert_within_cones(&p, TOLERANCE);
    end_problem(&p);
}

/* A box is thrown sideways and, by less than the tolerance, up: its contact has no load, and so no
 * friction. */
static void direct_contact_without_load_slides_without_friction(void **state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        problem p;
        make_column(&p, 1, 0.6);
        p.bodies[0].free[0] = side;
        p.bodies[0].free[1] = 0.02 * TOLERANCE;
        assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
        assert_in_range(p.d.factorings, 1, 2);
        near_to(p.bodies[0].velocity[0], side, TOLERANCE);
        end_problem(&p);
    }
}

/* Where the quick solution with the old matrix fails, it leaves the impulses unchanged: friction
 * must not be bounded by its intermediate ones. A box that did not touch touches now, and
 * slides. */
static void direct_rows_not_solved_again_keep_their_impulses(void **state) {
    (void)state;
    problem p;
    make_column(&p, 1, 0.4);
    p.bodies[0].inverse_inertia = 0; /* so that it does not tip over */
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        p.contacts[0].row[k].b[2] = 0;
    }
    p.bodies[0].free[0] = 8;
    p.contacts[0].row[0].target_speed = p.contacts[0].row[1].target_speed = -1;
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    p.contacts[0].row[0].target_speed = p.contacts[0].row[1].target_speed = 0;
    td_direct_update_friction(&p.d);
    td_direct_update_speeds(&p.d);
    assert_false(td_direct_solve_same_active_set(&p.d, TOLERANCE));
    near_to(load_of(&p.contacts[0]), 0, 0);
    assert_true(td_direct_solve(&p.d, TOLERANCE) <= TOLERANCE);
    near_to(p.bodies[0].velocity[0], 8 - 0.4 * UNIT_SPEED, 0.02 * UNIT_SPEED);
    end_problem(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(direct_column_bears_what_is_above),
        cmocka_unit_test(direct_column_at_rest_takes_one_matrix),
        cmocka_unit_test(direct_heavy_on_light_rests),
        cmocka_unit_test(direct_plank_shares_its_load_by_the_lever_law),
        cmocka_unit_test(direct_slider_loses_what_friction_takes),
        cmocka_unit_test(direct_box_sticks_below_the_bound_of_friction),
        cmocka_unit_test(direct_belt_takes_a_box_along),
        cmocka_unit_test(direct_known_speed_of_the_ground_is_taken_on),
        cmocka_unit_test(direct_contacts_that_part_do_not_push),
        cmocka_unit_test(direct_redundant_contacts_change_nothing),
        cmocka_unit_test(direct_wedge_that_cannot_be_says_so),
        cmocka_unit_test(direct_narrow_wedge_is_pushed_out),
        cmocka_unit_test(direct_solver_takes_no_more_matrices_than_it_may),
        cmocka_unit_test(direct_same_rows_again_take_no_matrix),
        cmocka_unit_test(direct_other_rows_are_not_solved_again),
        cmocka_unit_test(direct_slider_whose_bound_grows_a_little_takes_one_matrix),
        cmocka_unit_test(direct_pushed_row_takes_one_matrix_a_step),
        cmocka_unit_test(direct_contact_without_load_slides_without_friction),
        cmocka_unit_test(direct_rows_not_solved_again_keep_their_impulses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
