/* test_score.c: tests the meter on states with known overlap, approach, energy and momentum. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "oracle_support.h"

#include <stdlib.h>

static const double PI = 3.14159265358979323846;

static oracle_score score_of(const scene *s, const engine_body *bodies) {
    oracle_score score;
    oracle_meter *meter = oracle_meter_create(s);
    assert_non_null(meter);
    assert_true(oracle_measure(meter, bodies, &score));
    oracle_meter_destroy(meter);
    return score;
}

static oracle_score score_at_start(const scene *s) {
    engine_body *bodies = calloc((size_t)s->body_count, sizeof *bodies);
    assert_non_null(bodies);
    for (int i = 0; i < s->body_count; i++)
        bodies[i] = body_at_start(s, i);
    oracle_score score = score_of(s, bodies);
    free(bodies);
    return score;
}

static void score_two_overlaps_gives_worst_and_mean(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -1, 10, 1);
    scene_dynamic_box(&s, 0, 0.375, 1, 0.5);   /* 0.125 deep, shorter side 1 */
    scene_dynamic_circle(&s, 5, 0.1875, 0.25); /* 0.0625 deep, diameter 0.5 */
    oracle_score score = score_at_start(&s);
    assert_int_equal(score.touching, 2);
    assert_near(score.penetration_max, 0.125, 1e-12);
    assert_near(score.penetration_mean, 0.09375, 1e-12);
    assert_near(score.relative_max, 0.125, 1e-12);
    assert_near(score.relative_mean, 0.125, 1e-12);
    scene_free(&s);
}

static void score_body_above_ground_touches_only_within_tolerance(void **state) {
    (void)state;
    for (int close = 0; close < 2; close++) {
        scene s;
        scene_init(&s);
        scene_add_body(&s, SCENE_STATIC, 0, 0);
        scene_add_flat(&s, 0);
        scene_dynamic_circle(&s, 0, 0.5, 0.5);
        s.bodies[1].y += close ? 0.9e-3 : 1.1e-3;
        oracle_score score = score_at_start(&s);
        assert_int_equal(score.touching, close);
        assert_near(score.penetration_max, 0, 0);
        scene_free(&s);
    }
}

/* The lower right corner of a box that rotates at 2 rad/s moves up, the lower left one down, at 2 *
 * 0.5 m/s; the box falls at 3 m/s. Two points that approach at 4 and 2 m/s. */
static void score_approach_of_turning_box_is_that_of_its_corners(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -1, 10, 1);
    scene_body *box = scene_dynamic_box(&s, 0, 0.25, 0.5, 0.25);
    box->vy = -3;
    box->angular_velocity = 2;
    oracle_score score = score_at_start(&s);
    assert_near(score.approach_max, 4, 1e-12);
    assert_near(score.approach_rms, sqrt((16 + 4) / 2.0), 1e-12);
    s.bodies[1].vy = 3; /* separating is no approach */
    s.bodies[1].angular_velocity = 0;
    assert_near(score_at_start(&s).approach_max, 0, 0);
    scene_free(&s);
}

/* A disc of density 2 and radius 0.5: m = pi / 2, I = m / 8. A box of 2 by 1: m = 4, I = 5/3. */
static void score_energy_and_momentum_are_the_textbooks(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    s.material.density = 2;
    scene_body *disc = scene_dynamic_circle(&s, 1, 3, 0.5);
    disc->vx = 2;
    disc->vy = -1;
    disc->angular_velocity = 4;
    scene_body *box = scene_dynamic_box(&s, -5, 7, 1, 0.5);
    box->vy = 3;
    box->angular_velocity = -2;
    box->gravity_scale = 0.5;
    oracle_score score = score_at_start(&s);
    double m = PI / 2;
    assert_near(score.kinetic_energy, 0.5 * (m * 5 + m / 8 * 16) + 0.5 * (4 * 9 + 5.0 / 3 * 4),
                1e-12);
    assert_near(score.potential_energy, m * 10 * 3 + 4 * 5 * 7, 1e-12);
    assert_near(score.energy, score.kinetic_energy + score.potential_energy, 0);
    assert_near(score.momentum_x, 2 * m, 1e-12);
    assert_near(score.momentum_y, 12 - m, 1e-12);
    assert_near(score.angular_momentum,
                m * (1 * -1 - 3 * 2) + m / 8 * 4 + 4 * (-5 * 3) + 5.0 / 3 * -2, 1e-12);
    assert_near(score.height, 7, 0);
    assert_near(score.speed_max, 3, 0);
    scene_free(&s);
}

/* Two equal squares side by side on one body have the mass, centre and inertia of one box. */
static void score_body_of_two_shapes_weighs_as_the_box_they_make(void **state) {
    (void)state;
    double energy[2];
    for (int whole = 0; whole < 2; whole++) {
        scene s;
        scene_init(&s);
        scene_body *body = scene_dynamic_box(&s, whole ? 0.5 : 0, 2, whole ? 1 : 0.5, 0.5);
        body->vx = 1;
        body->angular_velocity = 3;
        if (!whole)
            scene_add_obb(&s, 0.5, 0.5)->x = 1;
        energy[whole] = score_at_start(&s).energy;
        scene_free(&s);
    }
    assert_near(energy[0], energy[1], 1e-12);
}

static void score_lost_body_is_counted_and_harms_nothing(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    for (int i = 0; i < 3; i++)
        scene_dynamic_circle(&s, 0.75 * i, 0, 0.5)->vx = 1;
    engine_body bodies[3];
    for (int i = 0; i < 3; i++)
        bodies[i] = body_at_start(&s, i);
    bodies[0].vy = NAN;
    oracle_score score = score_of(&s, bodies);
    assert_int_equal(score.lost, 1);
    assert_int_equal(score.touching, 1);
    assert_near(score.penetration_max, 0.25, 1e-12);
    assert_near(score.momentum_x, 2 * PI / 4, 1e-12);
    scene_free(&s);
}

static void score_pairs_that_cannot_collide_do_not_count(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, 0, 1, 1);
    scene_static_box(&s, 0.5, 0, 1, 1);
    scene_dynamic_circle(&s, 10, 0, 1);
    scene_add_circle(&s, 1)->x = 0.5;
    for (int i = 0; i < 2; i++) {
        scene_dynamic_circle(&s, 20 + 0.5 * i, 0, 1);
        s.shapes[s.shape_count - 1].group = -1;
        scene_dynamic_circle(&s, 30 + 0.5 * i, 0, 1);
        s.shapes[s.shape_count - 1].mask = 2;
        scene_dynamic_circle(&s, 40 + 0.5 * i, 0, 1);
        s.shapes[s.shape_count - 1].sensor = i == 0;
    }
    scene_dynamic_circle(&s, 50, 0, 1);
    scene_dynamic_circle(&s, 50.5, 0, 1);
    scene_joint *tie = scene_tie(&s, SCENE_HINGE, s.body_count - 2, s.body_count - 1, 50, 0, 0);
    assert_int_equal(score_at_start(&s).touching, 0);
    tie->x[1] += 0.125;
    assert_near(score_at_start(&s).gap_max, 0.125, 1e-12);
    s.bodies[1].kind =
        SCENE_DYNAMIC; /* counter-check: the same pair counts once a body is dynamic */
    assert_int_equal(score_at_start(&s).touching, 1);
    scene_free(&s);
}

static void compare_shifted_and_turned_body_gives_both(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -1, 10, 1);
    scene_dynamic_box(&s, 0, 0.5, 0.5, 0.5);
    scene_dynamic_box(&s, 3, 0.5, 0.5, 0.5);
    engine_body expected[3], actual[3];
    for (int i = 0; i < 3; i++)
        expected[i] = actual[i] = body_at_start(&s, i);
    actual[1].x += 3;
    actual[1].y += 4;
    actual[2].cosine = cos(-0.25);
    actual[2].sine = sin(-0.25);
    actual[2].vx = 2;
    oracle_deviation d = oracle_compare(&s, expected, actual);
    assert_near(d.position_max, 5, 1e-12);
    assert_near(d.position_rms, 5 / sqrt(2), 1e-12);
    assert_near(d.angle_max, 0.25, 1e-12);
    assert_near(d.velocity_max, 2, 1e-12);
    actual[1].x = NAN;
    assert_true(isinf(oracle_compare(&s, expected, actual).position_max));
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(score_two_overlaps_gives_worst_and_mean),
        cmocka_unit_test(score_body_above_ground_touches_only_within_tolerance),
        cmocka_unit_test(score_approach_of_turning_box_is_that_of_its_corners),
        cmocka_unit_test(score_energy_and_momentum_are_the_textbooks),
        cmocka_unit_test(score_body_of_two_shapes_weighs_as_the_box_they_make),
        cmocka_unit_test(score_lost_body_is_counted_and_harms_nothing),
        cmocka_unit_test(score_pairs_that_cannot_collide_do_not_count),
        cmocka_unit_test(compare_shifted_and_turned_body_gives_both),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
