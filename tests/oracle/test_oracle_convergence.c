/* test_oracle_convergence.c: measures the error of the reference simulation over its step where it
 * is not exact: halving the step must halve the error of rotation about a corner (first order), and
 * quarter it otherwise (second order). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "oracle_support.h"

static const double G = 10;

enum { HALVINGS = 5 };

/* Solves angle'' = rate sin(angle) from rest by the Runge-Kutta rule with steps of 10 us, as the
 * exact solution. */
static double fallen_angle(double start, double rate, double time) {
    const int steps = (int)(time * 1e5 + 0.5);
    const double h = time / steps;
    double angle = start, speed = 0;
    for (int i = 0; i < steps; i++) {
        double a1 = speed, b1 = rate * sin(angle);
        double a2 = speed + h / 2 * b1, b2 = rate * sin(angle + h / 2 * a1);
        double a3 = speed + h / 2 * b2, b3 = rate * sin(angle + h / 2 * a2);
        double a4 = speed + h * b3, b4 = rate * sin(angle + h * a3);
        angle += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        speed += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
    }
    return angle;
}

static engine_body state_after(const scene *s, int body, double step, double time) {
    engine_body bodies[4];
    assert_true(s->body_count <= 4);
    oracle_settings settings = oracle_default_settings();
    settings.step = step;
    oracle_report report;
    assert_true(oracle_run(s, &settings, &time, 1, bodies, &report));
    assert_true(report.residual_max < 1e-9);
    return bodies[body];
}

static void assert_order(const double *errors, double order) {
    for (int i = 1; i < HALVINGS; i++) {
        double reached = log2(errors[i - 1] / errors[i]);
        if (!(fabs(reached - order) < 0.15))
            fail_msg("halving %d: error from %.3g to %.3g, order %.3f instead of %g", i,
                     errors[i - 1], errors[i], reached, order);
    }
}

/* A box of 1 by 2 m that stands on its lower right corner, with its centre a little to the right of
 * it, topples about this corner, which friction holds. */
static void oracle_toppling_box_converges_at_first_order(void **state) {
    (void)state;
    const double arm = hypot(0.5, 1), start = 0.1, time = 0.6;
    const double rate = G * arm / ((1 + 4) / 12.0 + arm * arm);
    scene s;
    scene_init(&s);
    s.material.friction = 10;
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_flat(&s, 0);
    scene_dynamic_box(&s, 0, 0, 0.5, 1);
    s.bodies[1].x = arm * sin(start);
    s.bodies[1].y = arm * cos(start);
    s.bodies[1].angle = -start - atan(0.5);
    double expected = fallen_angle(start, rate, time), errors[HALVINGS];
    for (int i = 0; i < HALVINGS; i++) {
        engine_body end = state_after(&s, 1, 1 / (120.0 * (1 << i)), time);
        errors[i] = fabs(-atan2(end.sine, end.cosine) - atan(0.5) - expected);
    }
    assert_order(errors, 1);
    assert_true(errors[HALVINGS - 1] < 1e-5);
    scene_free(&s);
}

/* A disc of radius r rolls off the top of a fixed disc of radius R: its angular acceleration is two
 * thirds of that of a point mass on a massless arm of length R + r. */
static void oracle_disc_rolling_on_disc_converges_at_second_order(void **state) {
    (void)state;
    const double big = 2, small = 0.5, start = 0.2, time = 0.5;
    const double rate = 2 * G / 3 / (big + small);
    scene s;
    scene_init(&s);
    s.material.friction = 10;
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_circle(&s, big);
    scene_dynamic_circle(&s, 0, 0, small);
    s.bodies[1].x = (big + small) * sin(start);
    s.bodies[1].y = (big + small) * cos(start);
    double expected = fallen_angle(start, rate, time), errors[HALVINGS];
    for (int i = 0; i < HALVINGS; i++) {
        engine_body end = state_after(&s, 1, 1 / (120.0 * (1 << i)), time);
        errors[i] = fabs(atan2(end.x, end.y) - expected);
    }
    assert_order(errors, 2);
    assert_true(errors[HALVINGS - 1] < 1e-8);
    scene_free(&s);
}

/* Linear damping: the speed is exact, and the position has the error of the midpoint rule. */
static void oracle_damped_way_converges_at_second_order(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    s.gravity_y = 0;
    scene_body *ball = scene_dynamic_circle(&s, 0, 0, 0.5);
    ball->vx = 5;
    ball->linear_damping = 2;
    double errors[HALVINGS];
    for (int i = 0; i < HALVINGS; i++) {
        engine_body end = state_after(&s, 0, 1 / (30.0 * (1 << i)), 1);
        errors[i] = fabs(end.x - 2.5 * (1 - exp(-2)));
    }
    assert_order(errors, 2);
    scene_free(&s);
}

/* A disc thrown without spin slips for v / (3 mu g) seconds and then rolls at two thirds of its
 * speed; only the step in which it begins to roll has an error. */
static void oracle_disc_that_begins_to_roll_is_wrong_by_less_than_a_step_allows(void **state) {
    (void)state;
    const double speed = 6, friction = 0.2, time = 2;
    scene s;
    scene_init(&s);
    s.material.friction = friction;
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_flat(&s, 0);
    scene_dynamic_circle(&s, 0, 0.5, 0.5)->vx = speed;
    double slips = speed / (3 * friction * G);
    double expected =
        speed * slips - friction * G * slips * slips / 2 + 2.0 / 3 * speed * (time - slips);
    for (int i = 0; i < HALVINGS; i++) {
        double step = 1 / (100.0 * (1 << i));
        engine_body end = state_after(&s, 1, step, time);
        assert_near(end.vx, 2.0 / 3 * speed, 1e-9);
        assert_near(end.x, expected, friction * G * step * step);
    }
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oracle_toppling_box_converges_at_first_order),
        cmocka_unit_test(oracle_disc_rolling_on_disc_converges_at_second_order),
        cmocka_unit_test(oracle_damped_way_converges_at_second_order),
        cmocka_unit_test(oracle_disc_that_begins_to_roll_is_wrong_by_less_than_a_step_allows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
