/* test_penetration.c: compares the meter with a test of all pairs, and tests that it leaves out
 * pairs that cannot collide. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "depth.h"
#include "penetration.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

/* The poses of the scene's start. */
static engine_body *poses_of(const scene *s) {
    engine_body *bodies = calloc((size_t)s->body_count, sizeof *bodies);
    assert_non_null(bodies);
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *body = &s->bodies[i];
        bodies[i] = (engine_body){.x = body->x,
                                  .y = body->y,
                                  .cosine = cos(body->angle),
                                  .sine = sin(body->angle)};
    }
    return bodies;
}

static penetration measure(const scene *s, const engine_body *bodies) {
    penetration seen = {0};
    penetration_meter *meter = penetration_meter_create(s);
    assert_non_null(meter);
    penetration_sample(meter, bodies, &seen);
    penetration_meter_destroy(meter);
    return seen;
}

static penetration measure_at_start(const scene *s) {
    engine_body *bodies = poses_of(s);
    penetration seen = measure(s, bodies);
    free(bodies);
    return seen;
}

static depth_shape placed(const scene *s, int body) {
    const scene_body *b = &s->bodies[body];
    const scene_shape *shape = &s->shapes[b->first_shape];
    return (depth_shape){shape->kind == SCENE_CIRCLE,
                         b->x,
                         b->y,
                         cos(b->angle),
                         sin(b->angle),
                         shape->hx,
                         shape->hy};
}

/* Sizes differ by a factor of 1,000, so that some shapes are larger than a cell. */
static void meter_random_sizes_agrees_with_all_pairs(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_random random = {11};
    for (int i = 0; i < 700; i++) {
        double x = scene_random_range(&random, -20, 20), y = scene_random_range(&random, -20, 20);
        double size = 0.01 * pow(1000, pow(scene_random_range(&random, 0, 1), 4));
        if (i % 2 == 0)
            scene_dynamic_circle(&s, x, y, size);
        else
            scene_dynamic_box(&s, x, y, size, size * scene_random_range(&random, 0.3, 1))->angle =
                scene_random_range(&random, -3, 3);
    }
    penetration expected = {0};
    for (int a = 0; a < s.body_count; a++)
        for (int b = 0; b < a; b++) {
            depth_shape one = placed(&s, a), other = placed(&s, b);
            double depth = depth_of_pair(&one, &other);
            expected.pairs += depth > 0;
            expected.sum += depth > 0 ? depth : 0;
            expected.worst = fmax(expected.worst, depth);
        }
    penetration seen = measure_at_start(&s);
    assert_true(expected.pairs > 500);
    assert_int_equal(seen.pairs, expected.pairs);
    assert_true(fabs(seen.worst - expected.worst) < 1e-12);
    assert_true(fabs(seen.sum - expected.sum) < 1e-9 * expected.sum);
    scene_free(&s);
}

static void meter_pairs_that_cannot_collide_do_not_count(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 0, 0, 1, 1);
    scene_static_box(&s, 0.5, 0, 1, 1); /* two static bodies */
    scene_dynamic_circle(&s, 10, 0, 1);
    scene_add_circle(&s, 1)->x = 0.5; /* two shapes of one body */
    scene_dynamic_circle(&s, 20, 0, 1);
    s.shapes[s.shape_count - 1].group = -1;
    scene_dynamic_circle(&s, 20, 0.5, 1);
    s.shapes[s.shape_count - 1].group = -1;
    scene_dynamic_circle(&s, 30, 0, 1);
    s.shapes[s.shape_count - 1].mask = 2;
    scene_dynamic_circle(&s, 30, 0.5, 1);
    scene_dynamic_circle(&s, 40, 0, 1);
    s.shapes[s.shape_count - 1].sensor = true;
    scene_dynamic_circle(&s, 40, 0.5, 1);
    scene_dynamic_circle(&s, 50, 0, 1);
    scene_dynamic_circle(&s, 50, 0.5, 1);
    scene_joint *tie = scene_tie(&s, SCENE_FILTER, s.body_count - 1, s.body_count - 2, 50, 0, 0);
    assert_int_equal(measure_at_start(&s).pairs, 0);
    tie->collide_connected = true;
    assert_int_equal(measure_at_start(&s).pairs, 1);
    tie->collide_connected = false;
    s.bodies[1].kind =
        SCENE_DYNAMIC; /* counter-check: the same pair counts once a body is dynamic */
    assert_int_equal(measure_at_start(&s).pairs, 1);
    scene_free(&s);
}

static void meter_ball_in_each_terrain_reports_its_depth(void **state) {
    (void)state;
    static const double heights[] = {3, 3, 3, 3};
    static const scene_point line[] = {{0, 3}, {1, 3}, {9, 3}};
    for (int kind = 0; kind < 3; kind++) {
        scene s;
        scene_init(&s);
        scene_add_body(&s, SCENE_STATIC, 100, kind == 0 ? 10 : 7);
        if (kind == 0)
            scene_add_flat(&s, 0);
        else if (kind == 1)
            scene_add_uniform(&s, 0, 2, heights, 4);
        else
            scene_add_irregular(&s, line, 3);
        scene_dynamic_circle(&s, 104, 10.25, 0.5);
        penetration seen = measure_at_start(&s);
        assert_int_equal(seen.pairs, 1);
        assert_true(fabs(seen.worst - 0.25) < 1e-9);
        scene_free(&s);
    }
}

static void meter_body_without_finite_pose_is_lost_and_harms_nothing(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    for (int i = 0; i < 3; i++)
        scene_dynamic_circle(&s, 0.75 * i, 0, 0.5);
    engine_body *bodies = poses_of(&s);
    bodies[0].x = NAN;
    penetration seen = measure(&s, bodies);
    free(bodies);
    assert_int_equal(seen.lost, 1);
    assert_int_equal(seen.pairs, 1);
    assert_true(fabs(seen.worst - 0.25) < 1e-12);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meter_random_sizes_agrees_with_all_pairs),
        cmocka_unit_test(meter_pairs_that_cannot_collide_do_not_count),
        cmocka_unit_test(meter_ball_in_each_terrain_reports_its_depth),
        cmocka_unit_test(meter_body_without_finite_pose_is_lost_and_harms_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
