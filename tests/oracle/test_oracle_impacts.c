/* test_oracle_impacts.c: compares impacts of the reference simulation with the laws of Newton and
 * Coulomb and with conservation of momentum and energy. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "oracle_support.h"
#include "scenes.h"

#include <stdlib.h>

static const double PI = 3.14159265358979323846;

/* Initialises a scene without gravity. */
static void begin(scene *s, double restitution, double friction) {
    scene_init(s);
    s->gravity_y = 0;
    s->material.restitution = restitution;
    s->material.friction = friction;
}

static void run(const scene *s, double time, engine_body *bodies) {
    oracle_report report;
    assert_true(oracle_run(s, NULL, &time, 1, bodies, &report));
    assert_true(report.residual_max < 1e-9);
}

/* Masses 1 : 4, speeds 3 and -1 m/s, e = 0.5: Newton's law and the momentum give both speeds. */
static void oracle_head_on_impact_obeys_newton_and_momentum(void **state) {
    (void)state;
    scene s;
    begin(&s, 0.5, 0);
    scene_dynamic_circle(&s, -3, 0, 0.5)->vx = 3;
    scene_dynamic_circle(&s, 3, 0, 1)->vx = -1;
    engine_body end[2];
    run(&s, 2, end);
    assert_near(end[0].vx, 3 - 4.0 / 5 * 1.5 * 4, 1e-12);
    assert_near(end[1].vx, -1 + 1.0 / 5 * 1.5 * 4, 1e-12);
    double met = 4.5 / 4; /* s until the gap of 4.5 m is closed */
    assert_near(end[0].x, -3 + 3 * met + end[0].vx * (2 - met), 1e-8);
    scene_free(&s);
}

/* Equal elastic discs whose line of centres at the impact has sin = 0.6: the velocity along this
 * line is exchanged, the velocity across it stays. */
static void oracle_oblique_elastic_impact_exchanges_the_normal_part(void **state) {
    (void)state;
    scene s;
    begin(&s, 1, 0);
    scene_dynamic_circle(&s, -3, 0.6, 0.5)->vx = 5;
    scene_dynamic_circle(&s, 0, 0, 0.5);
    s.bodies[0].y = 0.6;
    engine_body end[2];
    run(&s, 1, end);
    assert_near(end[1].vx, 5 * 0.64, 1e-8);
    assert_near(end[1].vy, -5 * 0.48, 1e-8);
    assert_near(end[0].vx, 5 * 0.36, 1e-8);
    assert_near(end[0].vy, 5 * 0.48, 1e-8);
    scene_free(&s);
}

/* A disc hits a wall with the tangential speed u. Its surface stops, and it loses u / 3, if
 * friction suffices: mu (1 + e) v >= u / 3. Otherwise it loses mu (1 + e) v and keeps slipping. */
static void oracle_disc_against_rough_wall_gains_the_spin_of_coulomb(void **state) {
    (void)state;
    const double e = 0.5, normal = 4, tangent = 3;
    for (int rough = 0; rough < 2; rough++) {
        double friction = rough ? 0.5 : 0.1;
        scene s;
        begin(&s, e, friction);
        scene_static_box(&s, 0, -1, 20, 1);
        scene_body *disc = scene_dynamic_circle(&s, 0, 2, 0.5);
        disc->vx = tangent;
        disc->vy = -normal;
        engine_body end[2];
        run(&s, 1, end);
        double lost = fmin(tangent / 3, friction * (1 + e) * normal);
        assert_near(end[1].vy, e * normal, 1e-12);
        assert_near(end[1].vx, tangent - lost, 1e-12);
        /* The lost impulse m at the arm r, with I = m r^2 / 2. */
        assert_near(end[1].angular_velocity, -2 * lost / 0.5, 1e-12);
        scene_free(&s);
    }
}

/* A horizontal rod falls with one end on a post: e and the inertia determine its velocity and
 * angular velocity. */
static void oracle_rod_hit_at_its_end_turns_as_rigid_bodies_do(void **state) {
    (void)state;
    scene s;
    begin(&s, 1, 0);
    scene_add_body(&s, SCENE_STATIC, 0.75, -1);
    scene_add_circle(&s, 0.5);
    scene_dynamic_box(&s, 0, 0, 1, 0.125)->vy = -2;
    engine_body end[2];
    run(&s, 0.25, end);
    double m = 0.5, inertia = m * (4 + 0.0625) / 12, arm = 0.75;
    double impulse = 2 * 2 / (1 / m + arm * arm / inertia);
    assert_near(end[1].vy, -2 + impulse / m, 1e-12);
    assert_near(end[1].angular_velocity, arm * impulse / inertia, 1e-12);
    scene_free(&s);
}

/* One, two and three balls fly in: as many leave at the same speed, and the others are at rest. */
static void oracle_cradle_hands_on_all_of_its_momentum(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(&scene_cradle, 5, &s));
    engine_body *end = calloc((size_t)s.body_count, sizeof *end);
    assert_non_null(end);
    run(&s, 2, end);
    for (int row = 1; row <= 3; row++)
        for (int i = 0; i < 5; i++)
            assert_near(end[2 + 5 * (row - 1) + i].vx, i >= 5 - row ? 5 : 0, 1e-12);
    free(end);
    scene_free(&s);
}

/* The same on a floor under gravity: four balls at rest, and one slides in. */
static void oracle_cradle_on_a_floor_hands_on_all_of_its_momentum(void **state) {
    (void)state;
    scene s;
    begin(&s, 1, 0);
    s.gravity_y = -10;
    scene_static_box(&s, 0, -1, 50, 1);
    for (int i = 0; i < 5; i++)
        scene_dynamic_circle(&s, i == 0 ? -3 : i, 0.5, 0.5);
    s.bodies[1].vx = 5;
    engine_body end[6];
    run(&s, 1, end);
    for (int i = 1; i < 6; i++) {
        assert_near(end[i].vx, i == 5 ? 5 : 0, 1e-12);
        assert_near(end[i].y, 0.5, 1e-12);
    }
    scene_free(&s);
}

/* Each ball has half the mass of the one before, and gets 4/3 of its speed. */
static void oracle_row_of_lighter_balls_multiplies_the_speed(void **state) {
    (void)state;
    scene s;
    begin(&s, 1, 0);
    double density = 1;
    for (int i = 0; i < 5; i++, density /= 2)
        scene_add_body(&s, SCENE_DYNAMIC, i == 0 ? -2 : i, 0),
            scene_add_circle(&s, 0.5)->material.density = density;
    s.bodies[0].vx = 3;
    engine_body end[5];
    run(&s, 1.5, end);
    for (int i = 0; i < 5; i++)
        assert_near(end[i].vx, 3 * pow(4.0 / 3, i) * (i < 4 ? 1.0 / 3 : 1), 1e-12);
    scene_free(&s);
}

/* A hundred elastic balls, with and without gravity, for three seconds and hundreds of impacts. */
static void oracle_elastic_gas_keeps_its_energy(void **state) {
    (void)state;
    for (int gravity = 0; gravity < 2; gravity++) {
        scene s;
        assert_true(scenes_fill(&scene_gas, 100, &s));
        s.gravity_y = -10.0 * gravity;
        for (int i = 0; i < s.body_count; i++)
            s.bodies[i].gravity_scale = gravity;
        oracle *o = oracle_create(&s, &(oracle_settings){1.0 / 240, 0});
        oracle_meter *meter = oracle_meter_create(&s);
        engine_body *bodies = calloc((size_t)s.body_count, sizeof *bodies);
        assert_true(o && meter && bodies);
        oracle_score before, after;
        oracle_read(o, bodies);
        assert_true(oracle_measure(meter, bodies, &before));
        assert_true(oracle_advance(o, 3));
        oracle_read(o, bodies);
        assert_true(oracle_measure(meter, bodies, &after));
        assert_true(oracle_get_report(o).impacts > 500);
        assert_near(after.energy, before.energy, 1e-9 * before.energy);
        assert_near(after.penetration_max, 0, 1e-8);
        free(bodies);
        oracle_meter_destroy(meter);
        oracle_destroy(o);
        scene_free(&s);
    }
}

/* Up to 10^5 m/s against walls of 2 cm, ten times through the room: no bullet leaves, and each has
 * the speed that restitution 0.9 gives. */
static void oracle_bullets_stay_in_their_rooms(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(&scene_bullets, 15, &s));
    engine_body *end = calloc((size_t)s.body_count, sizeof *end);
    assert_non_null(end);
    double time = 0.05;
    oracle_report report;
    assert_true(oracle_run(&s, NULL, &time, 1, end, &report));
    assert_true(report.impacts > 100);
    for (int lane = 0; lane < 15; lane++) {
        const engine_body *bullet = &end[5 * lane + 4];
        assert_true(fabs(bullet->x) < 12);
        assert_true(fabs(bullet->y - s.bodies[5 * lane + 4].y) < 0.9);
    }
    free(end);
    scene_free(&s);
}

/* A fast circle hits a wall turned by 45 degrees; the place of the impact is known. */
static void oracle_fast_circle_meets_slanted_wall_at_the_exact_place(void **state) {
    (void)state;
    const double speed = 1e4;
    scene s;
    begin(&s, 1, 0);
    scene_add_body(&s, SCENE_STATIC, 0, 0)->angle = PI / 4;
    scene_add_obb(&s, 0.01, 5);
    scene_dynamic_circle(&s, -10, 0, 0.1)->vx = speed;
    engine_body end[2];
    run(&s, 2e-3, end);
    /* It is reflected downwards at x = -(0.1 + 0.01) sqrt(2). */
    double x = -0.11 * sqrt(2), met = (10 + x) / speed;
    assert_near(end[1].vx, 0, 1e-7);
    assert_near(end[1].x, x, 1e-7);
    assert_near(fabs(end[1].vy), speed, 1e-7);
    assert_near(fabs(end[1].y), speed * (2e-3 - met), 1e-6);
    scene_free(&s);
}

/* A box without restitution falls flat on a column at rest, and everything stays in place. */
static void oracle_box_dropped_on_column_comes_to_rest_at_once(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -1, 10, 1);
    for (int i = 0; i < 6; i++)
        scene_dynamic_box(&s, 0, i + 0.5 + (i == 5), 0.5, 0.5);
    engine_body end[7];
    run(&s, 1, end);
    for (int i = 1; i < 7; i++) {
        assert_near(end[i].y, i - 0.5, 1e-8);
        assert_near(hypot(end[i].vx, end[i].vy), 0, 1e-9);
    }
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oracle_head_on_impact_obeys_newton_and_momentum),
        cmocka_unit_test(oracle_oblique_elastic_impact_exchanges_the_normal_part),
        cmocka_unit_test(oracle_disc_against_rough_wall_gains_the_spin_of_coulomb),
        cmocka_unit_test(oracle_rod_hit_at_its_end_turns_as_rigid_bodies_do),
        cmocka_unit_test(oracle_cradle_hands_on_all_of_its_momentum),
        cmocka_unit_test(oracle_cradle_on_a_floor_hands_on_all_of_its_momentum),
        cmocka_unit_test(oracle_row_of_lighter_balls_multiplies_the_speed),
        cmocka_unit_test(oracle_elastic_gas_keeps_its_energy),
        cmocka_unit_test(oracle_bullets_stay_in_their_rooms),
        cmocka_unit_test(oracle_fast_circle_meets_slanted_wall_at_the_exact_place),
        cmocka_unit_test(oracle_box_dropped_on_column_comes_to_rest_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
