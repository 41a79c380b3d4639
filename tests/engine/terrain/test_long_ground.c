/* test_long_ground.c: a single box as the ground of a whole level, 40,000 length scales long: far
 * from its centre, contacts, stacks, detection and queries are as precise as on a small box. */
#include "engine_support.h"

/* Half of the ground's length, and a place near its end. */
#define HALF 20000.0f
#define FAR 19700.0

static const thud_broadphase *const broadphases[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                     &thud_broadphase_all};

typedef enum shape_of_test { BALL, UPRIGHT, ORIENTED, SHAPES } shape_of_test;

/* A ground with its top at y = 0. */
static thud_world *make_ground(thud_world_def def, float half_x, bool oriented,
                               const thud_shape_def *shape) {
    thud_world *world = make_world(def);
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    add_shape(world, ground, half_x, 1, !oriented, shape);
    return world;
}

static thud_body_id add(thud_world *world, shape_of_test kind, double x, double y,
                        const thud_shape_def *shape) {
    thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, x, y, 0);
    add_shape(world, id, 0.5f, kind == BALL ? 0 : 0.5f, kind == UPRIGHT, shape);
    return id;
}

static void bodies_rest_far_from_the_middle_as_on_a_small_box(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        for (int kind = 0; kind < SHAPES; kind++) {
            for (int oriented = 0; oriented < 2; oriented++) {
                thud_world_def def = thud_default_world_def_of(qualities[q]);
                thud_world *small = make_ground(def, 20, oriented, NULL);
                thud_world *large = make_ground(def, HALF, oriented, NULL);
                thud_body_id a = add(small, (shape_of_test)kind, 0.12, 0.7, NULL);
                thud_body_id b = add(large, (shape_of_test)kind, FAR + 0.12, 0.7, NULL);
                run(small, 300);
                run(large, 300);
                thud_body_state on_small = state_of(small, a), on_large = state_of(large, b);
                near_to(on_large.position.y, on_small.position.y, 2e-4);
                near_to(on_large.position.x - FAR, on_small.position.x, 1e-3);
                near_to(on_large.angle, on_small.angle, 1e-3);
                assert_int_equal(on_large.awake, on_small.awake);
                thud_world_destroy(small);
                thud_world_destroy(large);
            }
        }
    }
}

static void stack_stands_at_the_end_as_on_a_small_box(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *small = make_ground(thud_default_world_def_of(qualities[q]), 20, false, NULL);
        thud_world *large = make_ground(thud_default_world_def_of(qualities[q]), HALF, false, NULL);
        thud_body_id a[10], b[10];
        for (int i = 0; i < 10; i++) {
            a[i] = add(small, ORIENTED, -19, 0.5 + 1.0 * i, NULL);
            b[i] = add(large, ORIENTED, -19999, 0.5 + 1.0 * i, NULL);
        }
        run(small, 300);
        run(large, 300);
        for (int i = 0; i < 10; i++) {
            thud_body_state on_small = state_of(small, a[i]), on_large = state_of(large, b[i]);
            near_to(on_large.position.y, on_small.position.y, 1e-3);
            near_to(on_large.position.x + 19999, on_small.position.x + 19, 5e-3);
        }
        thud_world_destroy(small);
        thud_world_destroy(large);
    }
}

/* A bullet does not pass the ground far from its centre, and a ball beyond its end falls. */
static void nothing_fast_passes_and_what_leaves_the_end_falls(void **state) {
    (void)state;
    const thud_detection *const detections[] = {&thud_detection_continuous, &thud_detection_swept};
    for (int d = 0; d < 2; d++) {
        for (int p = 0; p < 3; p++) {
            thud_world_def def = thud_default_world_def();
            def.detection = detections[d];
            def.broadphase = broadphases[p];
            thud_world *world = make_ground(def, HALF, p == 1, NULL);
            thud_body_id bullet = add(world, BALL, 17003.4, 40, NULL);
            thud_body_id outside = add(world, BALL, 20001, 2, NULL);
            OK(thud_body_set_velocity(world, bullet, (thud_vec2){100, -900}, 0));
            run(world, 60);
            assert_true(state_of(world, bullet).position.y > 0.3);
            assert_true(state_of(world, outside).position.y < -2);
            thud_world_destroy(world);
        }
    }
}

static void body_slides_from_one_long_box_to_the_next(void **state) {
    (void)state;
    thud_shape_def ice = thud_default_shape_def();
    ice.friction = 0;
    for (int q = 0; q < 2; q++) {
        for (int kind = 0; kind < SHAPES; kind++) {
            thud_world *world =
                make_ground(thud_default_world_def_of(qualities[q]), HALF, false, &ice);
            add_shape(world, add_body(world, THUD_BODY_STATIC, 2.0 * HALF, -1, 0), HALF, 1, true,
                      &ice);
            thud_body_id body = add(world, (shape_of_test)kind, HALF - 10, 0.5, &ice);
            OK(thud_body_set_velocity(world, body, (thud_vec2){8, 0}, 0));
            for (int i = 0; i < 180; i++) {
                run(world, 1);
                near_to(state_of(world, body).position.y, 0.5, 2e-3);
            }
            near_to(state_of(world, body).velocity.x, 8, 0.01);
            assert_true(state_of(world, body).position.x > HALF + 10);
            thud_world_destroy(world);
        }
    }
}

/* Rays and closest points find the ground along its whole length. */
static void queries_find_it_all_along(void **state) {
    (void)state;
    for (int p = 0; p < 3; p++) {
        thud_world_def def = thud_default_world_def();
        def.broadphase = broadphases[p];
        thud_world *world = make_ground(def, HALF, p == 2, NULL);
        for (int i = -20; i <= 20; i++) {
            thud_ray_hit ray = {0};
            thud_closest_hit closest = {0};
            bool hit = false;
            double x = i * 999.7;
            OK(thud_world_cast_ray(world, &(thud_ray){(thud_pos){x, 4}, 0, -8, NULL}, &hit, &ray));
            assert_true(hit);
            near_to(ray.fraction, 0.5, 1e-6);
            OK(thud_world_closest(world, (thud_pos){x, 3}, 10, NULL, &hit, &closest));
            assert_true(hit);
            near_to(closest.distance, 3, 1e-6);
        }
        thud_world_destroy(world);
    }
}

static void sizes_beyond_the_limits_are_refused(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def def = thud_default_shape_def();
    thud_body_id rests = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                 moves = add_ball(world, 0, 0, 1);
    thud_vec2 zero = {0, 0}, most = {32000, 32000}, more = {32001, 1}, dynamic = {16385, 1};
    OK(thud_shape_create_aabb(world, rests, &def, zero, most, NULL));
    OK(thud_shape_create_obb(world, rests, &def, zero, most, 1, NULL));
    OK(thud_shape_create_circle(world, rests, &def, zero, 32000, NULL));
    assert_int_equal(thud_shape_create_aabb(world, rests, &def, zero, more, NULL),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_shape_create_obb(world, moves, &def, zero, dynamic, 0, NULL),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_shape_create_circle(world, moves, &def, zero, 16385, NULL),
                     THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_rest_far_from_the_middle_as_on_a_small_box),
        cmocka_unit_test(stack_stands_at_the_end_as_on_a_small_box),
        cmocka_unit_test(nothing_fast_passes_and_what_leaves_the_end_falls),
        cmocka_unit_test(body_slides_from_one_long_box_to_the_next),
        cmocka_unit_test(queries_find_it_all_along),
        cmocka_unit_test(sizes_beyond_the_limits_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
