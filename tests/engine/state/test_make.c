/* test_make.c: worlds and bodies created in one expression (thud_make.h): options that are 0 mean
 * the default, and wrong options create nothing. */
#include "engine_support.h"

#include "hostile_memory.h"

#include <thud/thud_make.h>
#include <thud/thud_reads.h>

static int told;

static void count(thud_result result, const char *message, void *context) {
    (void)message;
    *(thud_result *)context = result;
    told++;
}

static thud_shape_state shape_of(const thud_world *world, thud_body_id body) {
    thud_shape_id shape;
    thud_shape_state state;
    int shapes = 0;
    OK(thud_body_get_shapes(world, body, &shape, 1, &shapes));
    assert_int_equal(shapes, 1);
    OK(thud_shape_get_state(world, shape, &state));
    return state;
}

/* thud_world_make sets gravity and quality; NaN and null give no world. */
static void world_has_the_gravity_and_quality_that_were_asked_for(void **state) {
    (void)state;
    thud_step_settings settings;
    thud_world *world = thud_world_make((thud_vec2){1, -3}, &thud_quality_draft);
    assert_non_null(world);
    OK(thud_world_get_step_settings(world, &settings));
    assert_true(settings.gravity.x == 1 && settings.gravity.y == -3);
    assert_int_equal(settings.substeps, thud_quality_draft.substeps);
    thud_world_destroy(world);
    assert_null(thud_world_make((thud_vec2){0, NAN}, &thud_quality_default));
    assert_null(thud_world_make((thud_vec2){0, 0}, NULL));
}

/* A body made without options is static, and its shape has the defaults of
 * thud_default_shape_def. */
static void zero_is_the_default(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id body = thud_body_make(world, thud_circle_at(3, 4, 0.5), NULL);
    thud_body_state plain = state_of(world, body);
    thud_shape_state shape = shape_of(world, body);
    thud_shape_def def = thud_default_shape_def();
    assert_true(plain.kind == THUD_BODY_STATIC && plain.position.x == 3 && plain.position.y == 4);
    assert_true(plain.angle == 0 && plain.gravity_scale == 1 && plain.user_data == 0);
    assert_true(shape.kind == THUD_SHAPE_CIRCLE && shape.half_extents.x == 0.5f);
    assert_true(shape.offset.x == 0 && shape.offset.y == 0);
    assert_true(shape.density == def.density && shape.friction == def.friction);
    assert_true(shape.restitution == 0 && shape.surface_speed == 0 && !shape.sensor);
    assert_true(shape.filter.category == 1 && shape.filter.mask == UINT32_MAX);
    thud_world_destroy(world);
}

static void options_are_those_of_body_and_shape(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_options all = {.kind = THUD_BODY_DYNAMIC,
                             .velocity = {1, 2},
                             .angular_velocity = 3,
                             .weightless = true,
                             .density = 4,
                             .frictionless = true,
                             .restitution = 0.5f,
                             .surface_speed = 6,
                             .category = 8,
                             .mask = 16,
                             .group = -2,
                             .sensor = true,
                             .user_data = 77};
    thud_body_id body = thud_body_make(world, thud_obb_at(1, 2, 3, 4, 0.75), &all);
    thud_body_state made = state_of(world, body);
    thud_shape_state shape = shape_of(world, body);
    assert_true(made.kind == THUD_BODY_DYNAMIC && made.gravity_scale == 0 && made.user_data == 77);
    assert_true(made.velocity.x == 1 && made.velocity.y == 2 && made.angular_velocity == 3);
    near_to(made.angle, 0.75, 1e-8);
    assert_true(shape.kind == THUD_SHAPE_OBB && shape.angle == 0);
    assert_true(shape.half_extents.x == 3 && shape.half_extents.y == 4);
    assert_true(shape.density == 4 && shape.friction == 0 && shape.restitution == 0.5f);
    assert_true(shape.surface_speed == 6 && shape.sensor && shape.user_data == 77);
    assert_true(shape.filter.category == 8 && shape.filter.mask == 16 && shape.filter.group == -2);
    thud_world_destroy(world);
}

/* Options that no state contains are seen in the motion. */
static void dampings_rotation_and_detection_are_as_of_a_def(void **state) {
    (void)state;
    thud_body_options options = {.kind = THUD_BODY_DYNAMIC,
                                 .velocity = {100, 0},
                                 .angular_velocity = 2,
                                 .linear_damping = 0.5f,
                                 .angular_damping = 0.25f,
                                 .detection = &thud_detection_swept};
    thud_body_def def = thud_default_body_def();
    thud_world *here = make_world(weightless()), *there = make_world(weightless());
    thud_body_make(here, thud_circle_at(0, 0, 0.5), &options);
    def.kind = THUD_BODY_DYNAMIC;
    def.velocity = options.velocity;
    def.angular_velocity = 2;
    def.linear_damping = 0.5f;
    def.angular_damping = 0.25f;
    def.detection = &thud_detection_swept;
    thud_body_id ball;
    OK(thud_body_create(there, &def, &ball));
    add_shape(there, ball, 0.5f, 0, false, NULL);
    for (int i = 0; i < 2; i++) {
        thud_world *world = i ? there : here;
        add_shape(world, add_body(world, THUD_BODY_STATIC, 9, 0, 0), 0.01f, 5, true, NULL);
        run(world, 60);
    }
    assert_true(thud_hash_of(here) == thud_hash_of(there));
    options.fixed_rotation = true;
    options.angular_velocity = 0;
    thud_body_id fixed = thud_body_make(here, thud_circle_at(0, 5, 0.5), &options);
    assert_true(state_of(here, fixed).inertia == 0);
    thud_world_destroy(here);
    thud_world_destroy(there);
}

static void refused_options_make_nothing(void **state) {
    (void)state;
    thud_result heard = THUD_OK;
    thud_world_def def = thud_default_world_def();
    def.log = count;
    def.log_context = &heard;
    thud_world *world = make_world(def);
    thud_geometry ball = thud_circle_at(0, 0, 0.5), line = {.kind = THUD_SHAPE_TERRAIN, .hx = 1};
    const thud_body_options wrong[] = {{.kind = (thud_body_kind)3},
                                       {.kind = THUD_BODY_STATIC, .velocity = {1, 0}},
                                       {.density = -1},
                                       {.density = NAN},
                                       {.friction = -1},
                                       {.friction = INFINITY},
                                       {.restitution = 1.5f},
                                       {.surface_speed = NAN},
                                       {.linear_damping = -1},
                                       {.frictionless = true, .friction = 1},
                                       {.kind = THUD_BODY_DYNAMIC, .angular_velocity = NAN}};
    enum { WRONG = sizeof wrong / sizeof *wrong };
    told = 0;
    for (int i = 0; i < WRONG; i++) {
        assert_int_equal(thud_body_make(world, ball, &wrong[i]).index1, 0);
        assert_int_equal(heard, THUD_ERROR_INVALID);
    }
    const thud_geometry shapes[] = {line,
                                    thud_circle_at(NAN, 0, 1),
                                    thud_circle_at(1e10, 0, 1),
                                    thud_circle_at(0, 0, 0),
                                    thud_aabb_at(0, 0, 1, -1),
                                    thud_obb_at(0, 0, 1, 1, 1e9),
                                    {.kind = (thud_shape_kind)9}};
    enum { SHAPES = sizeof shapes / sizeof *shapes };
    for (int i = 0; i < SHAPES; i++) {
        assert_int_equal(thud_body_make(world, shapes[i], NULL).index1, 0);
        assert_int_equal(heard, THUD_ERROR_INVALID);
    }
    assert_int_equal(told, WRONG + SHAPES);
    assert_int_equal(thud_stats_of(world).bodies, 0);
    assert_int_equal(thud_body_make(NULL, ball, NULL).index1, 0);
    thud_world_destroy(world);
}

static void without_memory_nothing_is_made(void **state) {
    (void)state;
    thud_result heard = THUD_OK;
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    def.log = count;
    def.log_context = &heard;
    thud_world *world = make_world(def);
    memory_allowed = 0;
    assert_int_equal(thud_body_make(world, thud_circle_at(0, 0, 1), NULL).index1, 0);
    memory_allowed = -1;
    assert_int_equal(heard, THUD_ERROR_MEMORY);
    assert_int_equal(thud_stats_of(world).bodies, 0);
    assert_int_not_equal(thud_body_make(world, thud_circle_at(0, 0, 1), NULL).index1, 0);
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

static void reads_by_value_give_nothing_of_what_is_gone(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_options moving = {.kind = THUD_BODY_DYNAMIC, .velocity = {5, 6}};
    thud_body_id body = thud_body_make(world, thud_circle_at(3, 4, 0.5), &moving);
    assert_true(thud_position_of(world, body).x == 3 && thud_position_of(world, body).y == 4);
    assert_true(thud_velocity_of(world, body).x == 5 && thud_velocity_of(world, body).y == 6);
    OK(thud_body_destroy(world, body));
    assert_true(thud_position_of(world, body).x == 0 && thud_position_of(NULL, body).y == 0);
    assert_true(thud_velocity_of(world, body).x == 0 && thud_velocity_of(NULL, body).y == 0);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(world_has_the_gravity_and_quality_that_were_asked_for),
        cmocka_unit_test(zero_is_the_default),
        cmocka_unit_test(options_are_those_of_body_and_shape),
        cmocka_unit_test(dampings_rotation_and_detection_are_as_of_a_def),
        cmocka_unit_test(refused_options_make_nothing),
        cmocka_unit_test(without_memory_nothing_is_made),
        cmocka_unit_test(reads_by_value_give_nothing_of_what_is_gone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
