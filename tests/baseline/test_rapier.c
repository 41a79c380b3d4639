/* test_rapier.c: tests that the adapter gives Rapier the same scene as the other engines: the same
 * bodies in the same order, the same ground and materials, and sleep only if it is asked for. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "engine.h"

#include <math.h>

enum { MOST = 8 };

static void assert_near(double actual, double expected, double tolerance) {
    if (!(fabs(actual - expected) <= tolerance))
        fail_msg("%.6g is not within %.3g of %.6g", actual, tolerance, expected);
}

/* Runs the scene, reads the bodies, and frees the scene. */
static void run(const physics_engine *engine, scene *s, bool sleeping, int steps,
                engine_body *out) {
    assert_false(s->failed);
    assert_true(s->body_count <= MOST);
    void *world = engine_create(engine, s, (engine_settings){.sleeping = sleeping});
    assert_non_null(world);
    for (int i = 0; i < steps; i++)
        assert_true(engine->step(world));
    engine->read(world, out);
    engine->destroy(world);
    scene_free(s);
}

static void body_of_each_kind_reads_back_in_the_order_of_creation(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_static_box(&s, 1, 2, 3, 4);
    scene_dynamic_circle(&s, 10, 20, 0.5)->vx = 7;
    scene_body *box = scene_dynamic_box(&s, 30, 40, 0.5, 0.25);
    box->angle = 0.5;
    box->angular_velocity = -2;
    engine_body b[MOST];
    run(&engine_rapier, &s, false, 0, b);
    assert_near(b[0].x, 1, 0);
    assert_near(b[1].vx, 7, 0);
    assert_near(b[1].mass, acos(-1) * 0.25, 1e-6);
    assert_near(b[1].inertia, b[1].mass * 0.125, 1e-6);
    assert_near(b[2].y, 40, 0);
    assert_near(b[2].cosine, cos(0.5), 1e-6);
    assert_near(b[2].sine, sin(0.5), 1e-6);
    assert_near(b[2].angular_velocity, -2, 0);
    assert_near(b[2].mass, 0.5, 1e-6);
}

static void balls_on_every_kind_of_ground_rest_at_their_radius(void **state) {
    (void)state;
    const double heights[] = {5, 5, 5, 5};
    const scene_point points[] = {{100, 9}, {101, 9}, {104, 9}};
    scene s;
    scene_init(&s);
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_flat(&s, 0);
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_uniform(&s, 50, 1, heights, 4);
    scene_add_body(&s, SCENE_STATIC, 0, 0);
    scene_add_irregular(&s, points, 3);
    scene_dynamic_circle(&s, -20, 1, 0.5);
    scene_dynamic_circle(&s, 51.5, 6, 0.5);
    scene_dynamic_circle(&s, 102, 10, 0.5);
    engine_body b[MOST];
    run(&engine_rapier, &s, false, 180, b);
    assert_near(b[3].y, 0.5, 0.01);
    assert_near(b[4].y, 5.5, 0.01);
    assert_near(b[5].y, 9.5, 0.01);
    for (int i = 3; i < 6; i++)
        assert_true(b[i].awake);
}

static void sleep_comes_only_where_it_is_asked_for(void **state) {
    (void)state;
    for (int sleeping = 0; sleeping < 2; sleeping++) {
        scene s;
        scene_init(&s);
        scene_static_box(&s, 0, -1, 10, 1);
        scene_dynamic_box(&s, 0, 0.5, 0.5, 0.5);
        engine_body b[MOST];
        run(&engine_rapier, &s, sleeping, 300, b);
        assert_int_equal(b[1].awake, !sleeping);
    }
}

/* On a slope of 0.5 with friction combined as the geometric mean: 0.9 and 0.1 give 0.3. */
static void box_on_a_slope_slides_as_in_thud(void **state) {
    (void)state;
    const physics_engine *engines[] = {&engine_thud, &engine_rapier};
    double speed[2];
    for (int e = 0; e < 2; e++) {
        scene s;
        scene_init(&s);
        scene_add_body(&s, SCENE_STATIC, 0, 0);
        s.material.friction = 0.9;
        scene_add_flat(&s, -0.5);
        s.material.friction = 0.1;
        scene_body *box = scene_dynamic_box(&s, 0, 0.5 * sqrt(1.25), 0.5, 0.5);
        box->angle = -atan(0.5);
        engine_body b[MOST];
        run(engines[e], &s, false, 60, b);
        speed[e] = b[1].vx;
    }
    double along = 10 * (0.5 - 0.3) / sqrt(1.25); /* m/s^2 along the slope; vx is its horizontal
                                                     component */
    assert_near(speed[1], along / sqrt(1.25), 0.05);
    assert_near(speed[1], speed[0], 0.05);
}

static void bytes_grow_with_the_world_and_go_with_it(void **state) {
    (void)state;
    uint64_t before = engine_rapier.bytes(NULL);
    scene s;
    scene_init(&s);
    for (int i = 0; i < 1000; i++)
        scene_dynamic_circle(&s, 2.0 * i, 0, 0.5);
    void *world = engine_create(&engine_rapier, &s, (engine_settings){0});
    assert_non_null(world);
    assert_true(engine_rapier.step(world));
    assert_true(engine_rapier.bytes(world) > before + 1000 * 100);
    engine_rapier.destroy(world);
    assert_true(engine_rapier.bytes(NULL) < before + 1000);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(body_of_each_kind_reads_back_in_the_order_of_creation),
        cmocka_unit_test(balls_on_every_kind_of_ground_rest_at_their_radius),
        cmocka_unit_test(sleep_comes_only_where_it_is_asked_for),
        cmocka_unit_test(box_on_a_slope_slides_as_in_thud),
        cmocka_unit_test(bytes_grow_with_the_world_and_go_with_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
