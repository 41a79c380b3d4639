/* test_oracle_motion.c: compares the reference simulation with formulas for flight, bounces and
 * motion on slopes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "oracle_support.h"

static const double G = 10;

/* The midpoint rule is exact for constant acceleration. */
static void oracle_body_in_flight_follows_the_parabola(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_body *box = scene_dynamic_box(&s, 1, 2, 0.5, 0.25);
    box->vx = 3;
    box->vy = 4;
    box->angular_velocity = 2;
    engine_body end;
    double time = 1;
    assert_true(oracle_run(&s, NULL, &time, 1, &end, NULL));
    assert_near(end.x, 4, 1e-11);
    assert_near(end.y, 2 + 4 - G / 2, 1e-11);
    assert_near(end.vy, 4 - G, 1e-11);
    assert_near(atan2(end.sine, end.cosine), 2, 1e-11);
    scene_free(&s);
}

/* x(t) = v/c (1 - exp(-c t)): the speed is exact, and the position is of second order. */
static void oracle_damped_body_slows_exponentially(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    s.gravity_y = 0;
    scene_body *ball = scene_dynamic_circle(&s, 0, 0, 0.5);
    ball->vx = 5;
    ball->linear_damping = 2;
    engine_body end;
    double time = 1;
    assert_true(oracle_run(&s, NULL, &time, 1, &end, NULL));
    assert_near(end.vx, 5 * exp(-2), 1e-12);
    assert_near(end.x, 2.5 * (1 - exp(-2)), 1e-6);
    scene_free(&s);
}

/* Dropped from h with restitution e: the fall takes T = sqrt(2h/g), then bounces take 2 e^k T and
 * reach e^2k h. In the middle of each the ball is at rest at that height. */
static void oracle_ball_bounces_to_the_heights_of_newton(void **state) {
    (void)state;
    const double e = 0.8, h = 2, fall = sqrt(2 * h / G);
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -1, 10, 1);
    scene_dynamic_circle(&s, 0, 0.5 + h, 0.5);
    s.shapes[1].material.restitution = e;
    double times[6], power = 1, now = 0;
    for (int i = 0; i < 6; i++) {
        now += power * fall;
        power *= e;
        times[i] = now += power * fall;
    }
    engine_body samples[6][2];
    oracle_report report;
    assert_true(oracle_run(&s, NULL, times, 6, samples[0], &report));
    for (int i = 0; i < 6; i++) {
        assert_near(samples[i][1].y, 0.5 + h * pow(e, 2 * (i + 1)), 1e-7);
        assert_near(samples[i][1].vy, 0, 1e-6);
    }
    assert_int_equal(report.impacts, 6);
    scene_free(&s);
}

/* A line of slope -1/2, on which a body begins in contact; gravity along it is g / sqrt(5), across
 * it 2 g / sqrt(5). Returns the mean acceleration along the line over two seconds. */
static double acceleration_on_slope(bool disc, double friction) {
    const double c = 2 / sqrt(5), sine = 1 / sqrt(5);
    scene s;
    scene_init(&s);
    s.material.friction = friction;
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_flat(&s, -0.5);
    if (disc)
        scene_dynamic_circle(&s, 0, 0, 0.5);
    else
        scene_dynamic_box(&s, 0, 0, 1, 0.5)->angle = -atan(0.5);
    s.bodies[1].x = sine * 0.5;
    s.bodies[1].y = c * 0.5;
    engine_body end[2];
    double time = 2;
    oracle_report report;
    assert_true(oracle_run(&s, NULL, &time, 1, end, &report));
    assert_near(report.residual_max, 0, 1e-9);
    double along = (end[1].x - s.bodies[1].x) * c - (end[1].y - s.bodies[1].y) * sine;
    double across = (end[1].x - s.bodies[1].x) * sine + (end[1].y - s.bodies[1].y) * c;
    assert_near(across, 0, 1e-8);
    scene_free(&s);
    return 2 * along / (time * time);
}

static void oracle_box_on_slope_slides_at_coulombs_rate(void **state) {
    (void)state;
    const double frictions[] = {0, 0.1, 0.2, 0.4};
    for (int i = 0; i < 4; i++)
        assert_near(acceleration_on_slope(false, frictions[i]),
                    G * (1 - 2 * frictions[i]) / sqrt(5), 1e-8);
}

/* The angle is 26.57 degrees, whose tangent is 1/2. */
static void oracle_box_on_slope_slides_above_the_friction_angle_only(void **state) {
    (void)state;
    assert_near(acceleration_on_slope(false, 0.501), 0, 1e-9);
    assert_near(acceleration_on_slope(false, 0.499), G * 0.002 / sqrt(5), 1e-8);
}

/* A disc rolls with 2/3 g sin if friction > tan / 3; otherwise it slips, with g (sin - friction
 * cos). */
static void oracle_disc_on_slope_rolls_or_slips(void **state) {
    (void)state;
    assert_near(acceleration_on_slope(true, 0.9), G * 2 / 3 / sqrt(5), 1e-8);
    assert_near(acceleration_on_slope(true, 0.168), G * 2 / 3 / sqrt(5), 1e-8);
    assert_near(acceleration_on_slope(true, 0.1), G * (1 - 2 * 0.1) / sqrt(5), 1e-8);
}

/* It slides v^2 / (2 mu g), then it stays. The last step brakes too long by at most its length. */
static void oracle_sliding_box_stops_after_the_known_way(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    s.material.friction = 0.5;
    scene_static_box(&s, 0, -1, 20, 1);
    scene_dynamic_box(&s, 0, 0.5, 0.5, 0.5)->vx = 6;
    engine_body end[2];
    double time = 2;
    assert_true(oracle_run(&s, NULL, &time, 1, end, NULL));
    assert_near(end[1].x, 3.6, 1e-6);
    assert_near(end[1].vx, 0, 1e-12);
    scene_free(&s);
}

/* Programs pass settings from their users to the oracle. */
static void oracle_bad_settings_and_times_are_refused(void **state) {
    (void)state;
    const oracle_settings bad[] = {{0, 0}, {-1, 0}, {NAN, 0}, {1.0 / 60, -1}, {1.0 / 60, INFINITY}};
    scene s;
    scene_init(&s);
    scene_dynamic_circle(&s, 0, 0, 0.5);
    for (int i = 0; i < 5; i++)
        assert_null(oracle_create(&s, &bad[i]));
    oracle *o = oracle_create(&s, NULL);
    assert_non_null(o);
    assert_false(oracle_advance(o, -1));
    assert_false(oracle_advance(o, NAN));
    assert_true(oracle_advance(o, 0));
    assert_near(oracle_get_report(o).time, 0, 0);
    oracle_destroy(o);
    const double backwards[] = {1, 0.5};
    engine_body samples[2];
    assert_false(oracle_run(&s, NULL, backwards, 2, samples, NULL));
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oracle_body_in_flight_follows_the_parabola),
        cmocka_unit_test(oracle_damped_body_slows_exponentially),
        cmocka_unit_test(oracle_ball_bounces_to_the_heights_of_newton),
        cmocka_unit_test(oracle_box_on_slope_slides_at_coulombs_rate),
        cmocka_unit_test(oracle_box_on_slope_slides_above_the_friction_angle_only),
        cmocka_unit_test(oracle_disc_on_slope_rolls_or_slips),
        cmocka_unit_test(oracle_sliding_box_stops_after_the_known_way),
        cmocka_unit_test(oracle_bad_settings_and_times_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
