/* test_oracle_rest.c: compares forces of the reference simulation at rest with statics, and tests
 * toppling, braking and a pile. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "oracle_support.h"
#include "scenes.h"

#include <stdlib.h>

static const double G = 10;

static oracle *run_on(const scene *s, double seconds) {
    oracle *o = oracle_create(s, &(oracle_settings){1.0 / 240, 0.01});
    assert_non_null(o);
    assert_true(oracle_advance(o, seconds));
    assert_true(oracle_get_report(o).residual_max < 1e-7);
    return o;
}

/* The normal force of body a on body b, N. */
static double normal_force(oracle *o, int body_a, int body_b) {
    int count;
    const oracle_force *forces = oracle_forces(o, &count);
    double sum = 0;
    assert_non_null(forces);
    for (int i = 0; i < count; i++)
        if (forces[i].body_a == body_a && forces[i].body_b == body_b)
            sum += forces[i].normal;
    return sum;
}

static double farthest_from_start(const scene *s, const oracle *o) {
    engine_body *bodies = calloc((size_t)s->body_count, sizeof *bodies);
    assert_non_null(bodies);
    oracle_read(o, bodies);
    double most = 0;
    for (int i = 0; i < s->body_count; i++)
        most = fmax(most, hypot(bodies[i].x - s->bodies[i].x, bodies[i].y - s->bodies[i].y));
    free(bodies);
    return most;
}

static void oracle_column_of_thirty_bears_what_is_above(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(&scene_tall_stack, 30, &s));
    oracle *o = run_on(&s, 2);
    for (int i = 0; i < 30; i++)
        assert_near(normal_force(o, i, i + 1), (30 - i) * G, 1e-7);
    assert_near(farthest_from_start(&s, o), 0, 1e-9);
    oracle_destroy(o);
    scene_free(&s);
}

/* One and ten light boxes under a box of ten to 10^5 times the weight. */
static void oracle_heavy_on_light_does_not_sink(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(&scene_heavy_on_light, 5, &s));
    oracle *o = run_on(&s, 1);
    assert_near(farthest_from_start(&s, o), 0, 1e-9);
    int heaviest_alone = 10, under_it = 9;
    assert_near(normal_force(o, under_it, heaviest_alone), 1e5 * G, 1);
    assert_near(normal_force(o, 0, under_it), (1e5 + 1) * G, 1);
    oracle_destroy(o);
    scene_free(&s);
}

/* A plank of 4 kg from -2 to 2 m on balls at -1 and 1.5, with 3 kg on it at 0.75: the forces follow
 * from the moments about each ball. */
static void oracle_plank_shares_its_load_by_the_lever_law(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_add_body(&s, SCENE_STATIC, -1, -0.5);
    scene_add_circle(&s, 0.5);
    scene_add_body(&s, SCENE_STATIC, 1.5, -0.5);
    scene_add_circle(&s, 0.5);
    scene_dynamic_box(&s, 0, 0.5, 2, 0.5);
    scene_dynamic_box(&s, 0.75, 1.5, 0.5, 0.5);
    s.shapes[3].material.density = 3;
    oracle *o = run_on(&s, 1);
    double right = (4 * G * 1 + 3 * G * 1.75) / 2.5;
    assert_near(normal_force(o, 1, 2), right, 1e-7);
    assert_near(normal_force(o, 0, 2), 7 * G - right, 1e-7);
    assert_near(normal_force(o, 2, 3), 3 * G, 1e-7);
    assert_near(farthest_from_start(&s, o), 0, 1e-7);
    oracle_destroy(o);
    scene_free(&s);
}

/* A ball in a groove of 90 degrees: each wall carries its weight over sqrt(2). */
static void oracle_ball_in_groove_presses_on_both_walls(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    s.material.friction = 0;
    const scene_point groove[] = {{-5, 5}, {0, 0}, {5, 5}};
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_irregular(&s, groove, 3);
    scene_dynamic_circle(&s, 0, sqrt(2), 1);
    s.bodies[1].y = sqrt(2);
    oracle *o = run_on(&s, 1);
    double weight = 3.14159265358979323846 * G;
    int count;
    const oracle_force *forces = oracle_forces(o, &count);
    assert_int_equal(count, 2);
    for (int i = 0; i < 2; i++) {
        assert_near(forces[i].normal, weight / sqrt(2), 1e-6);
        assert_near(forces[i].normal_y, sqrt(0.5), 1e-9);
    }
    oracle_destroy(o);
    scene_free(&s);
}

/* A plank whose centre is d beyond the edge of a table starts to turn about the edge with the
 * angular acceleration m g d / (I + m d^2); for a short time its angle is half of this times t^2.
 */
static void oracle_plank_beyond_the_edge_tips_at_the_known_rate(void **state) {
    (void)state;
    const double d = 0.5, time = 0.05;
    scene s;
    scene_init(&s);
    s.material.friction = 1;
    scene_static_box(&s, -5, -1, 5, 1);
    scene_dynamic_box(&s, d, 0.0625, 2, 0.0625);
    oracle *o = oracle_create(&s, NULL);
    assert_true(oracle_advance(o, time));
    engine_body bodies[2];
    oracle_read(o, bodies);
    double gyration = (4 * 4 + 0.125 * 0.125) / 12 + d * d + 0.0625 * 0.0625;
    double rate = G * d / gyration;
    assert_near(atan2(bodies[1].sine, bodies[1].cosine), -0.5 * rate * time * time,
                2e-3 * rate * time * time);
    oracle_destroy(o);
    scene_free(&s);
}

/* On a slope of 45 degrees with sufficient friction, a box of half its width in height stays, and
 * one of twice its width topples. */
static void oracle_box_on_steep_slope_topples_only_if_tall(void **state) {
    (void)state;
    for (int tall = 0; tall < 2; tall++) {
        scene s;
        scene_init(&s);
        s.material.friction = 2;
        scene_add_body(&s, SCENE_STATIC, 0, 0);
        scene_add_flat(&s, -1);
        double half_width = tall ? 0.25 : 0.5, half_height = tall ? 0.5 : 0.25;
        scene_dynamic_box(&s, 0, 0, half_width, half_height)->angle = -atan(1);
        s.bodies[1].x = s.bodies[1].y = half_height * sqrt(0.5);
        oracle *o = run_on(&s, 1);
        double moved = farthest_from_start(&s, o);
        assert_true(tall ? moved > 0.1 : moved < 1e-9);
        oracle_destroy(o);
        scene_free(&s);
    }
}

/* A box of 1 kg is thrown onto a plank of 3 kg that slides without friction: both end at a quarter
 * of its speed. */
static void oracle_box_and_plank_reach_their_common_speed(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, -1, 50, 1);
    s.shapes[0].material.friction = 0;
    s.material.friction = 0.5;
    scene_dynamic_box(&s, 0, 0.25, 3, 0.25);
    scene_dynamic_box(&s, -2, 1, 0.5, 0.5)->vx = 4;
    oracle *o = run_on(&s, 2);
    engine_body bodies[3];
    oracle_read(o, bodies);
    assert_near(bodies[1].vx, 1, 1e-9);
    assert_near(bodies[2].vx, 1, 1e-9);
    /* The box decelerates by 5 m/s^2 and the plank accelerates by 5/3: the same speed after 0.6 s,
     * and 1.2 m of sliding. */
    assert_near(bodies[2].x - bodies[1].x, -2 + 1.2, 1e-4);
    oracle_destroy(o);
    scene_free(&s);
}

/* Circles and boxes without restitution fall on hills and come to rest; their energy never grows.
 */
static void oracle_pile_on_terrain_loses_energy_and_does_not_overlap(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(&scene_mixed_terrain, 20, &s));
    oracle *o = oracle_create(&s, &(oracle_settings){1.0 / 240, 0.01});
    oracle_meter *meter = oracle_meter_create(&s);
    engine_body *bodies = calloc((size_t)s.body_count, sizeof *bodies);
    assert_true(o && meter && bodies);
    double energy = HUGE_VAL;
    for (int i = 0; i < 12; i++) {
        oracle_score score;
        assert_true(oracle_advance(o, 0.25));
        oracle_read(o, bodies);
        assert_true(oracle_measure(meter, bodies, &score));
        assert_true(score.energy < energy + 1e-9);
        assert_near(score.penetration_max, 0, 1e-3);
        energy = score.energy;
    }
    assert_true(oracle_get_report(o).residual_max < 1e-4);
    assert_true(oracle_get_report(o).impacts > 50);
    free(bodies);
    oracle_meter_destroy(meter);
    oracle_destroy(o);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oracle_column_of_thirty_bears_what_is_above),
        cmocka_unit_test(oracle_heavy_on_light_does_not_sink),
        cmocka_unit_test(oracle_plank_shares_its_load_by_the_lever_law),
        cmocka_unit_test(oracle_ball_in_groove_presses_on_both_walls),
        cmocka_unit_test(oracle_plank_beyond_the_edge_tips_at_the_known_rate),
        cmocka_unit_test(oracle_box_on_steep_slope_topples_only_if_tall),
        cmocka_unit_test(oracle_box_and_plank_reach_their_common_speed),
        cmocka_unit_test(oracle_pile_on_terrain_loses_energy_and_does_not_overlap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
