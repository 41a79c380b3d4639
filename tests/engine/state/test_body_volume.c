/* test_body_volume.c: the bounding volume of a body (thud_body_get_volume) encloses all its shapes
 * at its present pose. */
#include "engine_support.h"

static void body_volume_is_around_all_shapes_wherever_the_body_is(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 1e6, -3, 1.57079632679);
    thud_shape_def def = thud_default_shape_def();
    OK(thud_shape_create_circle(world, body, &def, (thud_vec2){2, 0}, 0.5f, NULL));
    OK(thud_shape_create_obb(world, body, &def, (thud_vec2){-1, 0}, (thud_vec2){1, 0.25f}, 0,
                             NULL));
    thud_pos origin = {1e6, -3};
    thud_volume v;
    /* Rotated by a quarter turn: the circle is 2 above the origin, the box from 0 to 2 below. */
    OK(thud_body_get_volume(world, body, THUD_SHAPE_AABB, origin, &v));
    near_to(v.x, 0, 1e-6);
    near_to(v.y, 0.25, 1e-6);
    near_to(v.hx, 0.5, 1e-6);
    near_to(v.hy, 2.25, 1e-6);
    OK(thud_body_get_volume(world, body, THUD_SHAPE_CIRCLE, origin, &v));
    assert_true(v.hx >= 2.25 && v.hx < 2.4);
    OK(thud_body_get_volume(world, body, THUD_SHAPE_OBB, origin, &v));
    assert_true(v.hx * v.hy >= 1.0 && v.hx * v.hy < 1.2);
    OK(thud_body_set_transform(world, body, (thud_pos){1e6 + 7, -3}, 0));
    OK(thud_body_get_volume(world, body, THUD_SHAPE_AABB, origin, &v));
    near_to(v.x, 7.25, 1e-6);
    near_to(v.hy, 0.5, 1e-6);
    thud_world_destroy(world);
}

static void body_volume_of_a_line_is_the_lines_own(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 10, 5, 0);
    thud_shape_def def = thud_default_shape_def();
    thud_pos points[] = {{0, 1}, {0, 3}, {0, 2}};
    thud_terrain line = {
        .kind = THUD_TERRAIN_UNIFORM, .x0 = -2, .spacing = 2, .points = points, .count = 3};
    OK(thud_shape_create_terrain(world, body, &def, &line, NULL));
    thud_volume v;
    OK(thud_body_get_volume(world, body, THUD_SHAPE_AABB, (thud_pos){0, 0}, &v));
    near_to(v.x, 10, 1e-9);
    near_to(v.y, 7, 1e-9);
    near_to(v.hx, 2, 1e-9);
    near_to(v.hy, 1, 1e-9);
    thud_world_destroy(world);
}

static void body_volume_refuses_bad_input_and_leaves_the_answer(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    thud_body_id empty = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_body_id flat = add_body(world, THUD_BODY_STATIC, 0, 0, 0), ball = add_ball(world, 0, 0, 1);
    thud_terrain endless = {.kind = THUD_TERRAIN_FLAT};
    OK(thud_shape_create_terrain(world, flat, &def, &endless, NULL));
    thud_volume v = {.x = 42};
    thud_pos here = {0, 0}, nowhere = {NAN, 0};
    assert_int_equal(thud_body_get_volume(NULL, ball, THUD_SHAPE_AABB, here, &v), THUD_ERROR_NULL);
    assert_int_equal(thud_body_get_volume(world, ball, THUD_SHAPE_AABB, here, NULL),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_body_get_volume(world, (thud_body_id){0, 0}, THUD_SHAPE_AABB, here, &v),
                     THUD_ERROR_STALE);
    assert_int_equal(thud_body_get_volume(world, empty, THUD_SHAPE_AABB, here, &v),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_body_get_volume(world, flat, THUD_SHAPE_AABB, here, &v),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_body_get_volume(world, ball, THUD_SHAPE_TERRAIN, here, &v),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_body_get_volume(world, ball, THUD_SHAPE_AABB, nowhere, &v),
                     THUD_ERROR_INVALID);
    assert_true(v.x == 42);
    thud_world_destroy(world);
}

/* An epilogue that adds a circle to the body *context. */
static void add_circle(thud_world *world, const thud_contact *contact, void *context) {
    const thud_body_id *body = context;
    (void)contact;
    add_shape(world, *body, 1, 0, false, NULL);
}

/* A shape that was made inside a callback waits for the next step. A body with no other has no
 * volume, and what `out` points to is not written. */
static void body_volume_leaves_out_shapes_that_wait(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_ball(world, 0, 0, 1);
    add_ball(world, 1.9, 0, 1);
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 10, 0, 0);
    set_listeners(world, NULL, add_circle, &body);
    run(world, 1);
    set_listeners(world, NULL, NULL, NULL);
    assert_int_equal(state_of(world, body).shape_count, 1);
    thud_volume v = {.x = 42};
    thud_pos here = {0, 0};
    assert_int_equal(thud_body_get_volume(world, body, THUD_SHAPE_AABB, here, &v),
                     THUD_ERROR_INVALID);
    assert_true(v.x == 42);
    run(world, 1);
    OK(thud_body_get_volume(world, body, THUD_SHAPE_AABB, here, &v));
    near_to(v.x, 10, 1e-6);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(body_volume_is_around_all_shapes_wherever_the_body_is),
        cmocka_unit_test(body_volume_of_a_line_is_the_lines_own),
        cmocka_unit_test(body_volume_refuses_bad_input_and_leaves_the_answer),
        cmocka_unit_test(body_volume_leaves_out_shapes_that_wait),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
