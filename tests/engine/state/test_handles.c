/* test_handles.c: stale handles and wrong input are refused with a result and a log message, and
 * change nothing. */
#include "engine_support.h"

static int logged;

static void count_log(thud_result result, const char *message, void *context) {
    (void)context;
    assert_int_not_equal(result, THUD_OK);
    assert_non_null(message);
    logged++;
}

static thud_world *logging_world(void) {
    thud_world_def def = thud_default_world_def();
    def.log = count_log;
    logged = 0;
    return make_world(def);
}

static void handle_of_destroyed_body_is_stale_even_when_its_slot_lives_again(void **state) {
    (void)state;
    thud_world *world = logging_world();
    thud_body_id old = add_ball(world, 0, 0, 1);
    OK(thud_body_destroy(world, old));
    assert_false(thud_body_is_valid(world, old));
    run(world, 1);
    thud_body_id new = add_ball(world, 0, 0, 1);
    assert_int_equal(new.index1, old.index1);
    assert_int_equal(thud_body_get_state(world, old, NULL), THUD_ERROR_STALE);
    assert_int_equal(thud_body_destroy(world, old), THUD_ERROR_STALE);
    assert_true(thud_body_is_valid(world, new));
    assert_int_equal(logged, 2);
    thud_world_destroy(world);
}

static void handle_of_another_world_is_refused(void **state) {
    (void)state;
    thud_world *one = logging_world(), *two = logging_world();
    thud_body_id body = add_ball(one, 0, 0, 1);
    add_ball(two, 0, 0, 1);
    assert_false(thud_body_is_valid(two, body));
    assert_int_equal(thud_body_set_velocity(two, body, (thud_vec2){1, 0}, 0), THUD_ERROR_STALE);
    assert_int_equal(thud_body_get_state(two, (thud_body_id){0, 0}, NULL), THUD_ERROR_STALE);
    thud_world_destroy(one);
    thud_world_destroy(two);
}

/* A handle is not valid in any of 20,000 worlds created after its own. */
static void handle_is_refused_however_many_worlds_are_made_after_its_own(void **state) {
    (void)state;
    thud_world *one = make_world(thud_default_world_def());
    thud_body_id body = add_ball(one, 0, 0, 1);
    for (int i = 0; i < 20000; i++) {
        thud_world *other = make_world(thud_default_world_def());
        thud_body_id same = add_body(other, THUD_BODY_STATIC, 0, 0, 0);
        assert_int_equal(same.index1, body.index1);
        assert_false(thud_body_is_valid(other, body));
        assert_false(thud_body_is_valid(one, same));
        thud_world_destroy(other);
    }
    thud_world_destroy(one);
}

static void static_body_with_a_velocity_is_refused(void **state) {
    (void)state;
    thud_world *world = logging_world();
    thud_body_def def = thud_default_body_def();
    def.velocity = (thud_vec2){0, -1};
    assert_int_equal(thud_body_create(world, &def, NULL), THUD_ERROR_INVALID);
    def.velocity = (thud_vec2){-0.0f, 0};
    OK(thud_body_create(world, &def, NULL));
    def.angular_velocity = 1;
    assert_int_equal(thud_body_create(world, &def, NULL), THUD_ERROR_INVALID);
    def.kind = THUD_BODY_KINEMATIC;
    OK(thud_body_create(world, &def, NULL));
    assert_int_equal(logged, 2);
    assert_int_equal(thud_stats_of(world).bodies, 2);
    thud_world_destroy(world);
}

static void note_zero_filter(thud_result result, const char *message, void *context) {
    assert_int_equal(result, THUD_OK);
    assert_non_null(strstr(message, "meets nothing"));
    ++*(int *)context;
}

static void shape_whose_filter_is_zeroed_is_made_and_told_to_meet_nothing(void **state) {
    (void)state;
    int told = 0;
    thud_world_def def = thud_default_world_def();
    def.log = note_zero_filter;
    def.log_context = &told;
    thud_world *world = make_world(def);
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_shape_def zeroed = thud_default_shape_def();
    zeroed.filter = (thud_filter){0};
    thud_shape_def grouped = zeroed, shy = zeroed;
    grouped.filter.group = 3;
    shy.filter.category = 1;
    add_shape(world, body, 1, 0, false, &zeroed);
    assert_int_equal(told, 1);
    add_shape(world, body, 1, 0, false, &grouped);
    add_shape(world, body, 1, 0, false, &shy);
    add_shape(world, body, 1, 0, false, NULL);
    assert_int_equal(told, 1);
    assert_int_equal(thud_stats_of(world).shapes, 4);
    thud_world_destroy(world);
}

static void shapes_die_with_their_body(void **state) {
    (void)state;
    thud_world *world = logging_world();
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_shape_id shape = add_shape(world, body, 1, 0, false, NULL);
    OK(thud_body_destroy(world, body));
    assert_false(thud_shape_is_valid(world, shape));
    assert_int_equal(thud_shape_get_state(world, shape, NULL), THUD_ERROR_STALE);
    thud_world_destroy(world);
}

static void bad_worlds_are_refused(void **state) {
    (void)state;
    thud_world *world = NULL;
    thud_world_def good = thud_default_world_def(), def;
    assert_int_equal(thud_world_create(NULL, &world), THUD_ERROR_NULL);
    assert_int_equal(thud_world_create(&good, NULL), THUD_ERROR_NULL);
#define REFUSED(field, value)                                              \
    def = good;                                                            \
    def.field = value;                                                     \
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID); \
    assert_null(world)
    REFUSED(gravity.x, NAN);
    REFUSED(gravity.y, INFINITY);
    REFUSED(time_step, 0);
    REFUSED(time_step, -1);
    REFUSED(time_step, NAN);
    REFUSED(time_step, 2);
    REFUSED(length_scale, 0);
    REFUSED(length_scale, NAN);
    thud_quality none = thud_quality_default;
    none.substeps = 0;
    REFUSED(quality, &none);
    none = thud_quality_default;
    none.detection = NULL;
    REFUSED(quality, &none);
    none = thud_quality_default;
    none.overlap_limit = NAN;
    REFUSED(quality, &none);
    REFUSED(substeps, -1);
    REFUSED(substeps, 65);
    REFUSED(contact_stiffness, 0.6f);
    REFUSED(contact_damping, -1);
    REFUSED(push_speed, NAN);
    REFUSED(maximum_speed, 0);
#undef REFUSED
}

/* Every call of the table must be refused, logged, and leave the world unchanged. */
static void bad_calls_change_nothing(void **state) {
    (void)state;
    thud_world *world = logging_world();
    thud_body_id ball = add_ball(world, 0, 5, 1), floor = add_floor(world, NULL);
    thud_body_id turned = add_body(world, THUD_BODY_DYNAMIC, 9, 9, 1);
    run(world, 3);
    uint64_t hash = thud_hash_of(world);
    thud_stats stats = thud_stats_of(world);
    thud_body_def body = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_vec2 zero = {0, 0}, one = {1, 1};
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT, .slope = NAN};
    thud_pos unsorted[3] = {{0, 0}, {2, 0}, {1, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = unsorted, .count = 3};
    int refused = 0;
#define INVALID(call)                             \
    assert_int_equal((call), THUD_ERROR_INVALID); \
    refused++
#define BAD_BODY(field, value)                     \
    body.field = value;                            \
    INVALID(thud_body_create(world, &body, NULL)); \
    body = thud_default_body_def()
#define BAD_SHAPE(field, value)                                            \
    shape.field = value;                                                   \
    INVALID(thud_shape_create_circle(world, ball, &shape, zero, 1, NULL)); \
    shape = thud_default_shape_def()
    BAD_BODY(kind, THUD_BODY_KIND_COUNT);
    BAD_BODY(position.x, NAN);
    BAD_BODY(position.y, 1e10);
    BAD_BODY(angle, INFINITY);
    BAD_BODY(velocity.x, NAN);
    BAD_BODY(angular_velocity, INFINITY);
    BAD_BODY(gravity_scale, NAN);
    BAD_BODY(linear_damping, -1);
    BAD_BODY(angular_damping, NAN);
    BAD_SHAPE(density, -1);
    BAD_SHAPE(density, NAN);
    BAD_SHAPE(friction, -1);
    BAD_SHAPE(restitution, 1.5f);
    BAD_SHAPE(restitution, NAN);
    INVALID(thud_shape_create_circle(world, ball, &shape, zero, 0, NULL));
    INVALID(thud_shape_create_circle(world, ball, &shape, zero, -1, NULL));
    INVALID(thud_shape_create_circle(world, ball, &shape, zero, NAN, NULL));
    INVALID(thud_shape_create_circle(world, ball, &shape, (thud_vec2){NAN, 0}, 1, NULL));
    INVALID(thud_shape_create_circle(world, ball, &shape, zero, 1e6f, NULL));
    INVALID(thud_shape_create_aabb(world, ball, &shape, zero, (thud_vec2){1, 0}, NULL));
    INVALID(thud_shape_create_aabb(world, turned, &shape, zero, one, NULL));
    INVALID(thud_shape_create_obb(world, ball, &shape, zero, (thud_vec2){-1, 1}, 0, NULL));
    INVALID(thud_shape_create_obb(world, ball, &shape, zero, one, NAN, NULL));
    INVALID(thud_shape_create_terrain(world, floor, &shape, &flat, NULL));
    INVALID(thud_shape_create_terrain(world, floor, &shape, &line, NULL));
    flat.slope = 0;
    INVALID(thud_shape_create_terrain(world, ball, &shape, &flat, NULL));
    INVALID(thud_body_set_transform(world, ball, (thud_pos){NAN, 0}, 0));
    INVALID(thud_body_set_transform(world, ball, (thud_pos){0, 0}, INFINITY));
    INVALID(thud_body_set_transform(world, floor, (thud_pos){0, 0}, 1));
    INVALID(thud_body_set_velocity(world, ball, (thud_vec2){NAN, 0}, 0));
    INVALID(thud_body_set_velocity(world, floor, zero, 0));
    INVALID(thud_body_apply_impulse(world, ball, (thud_vec2){0, INFINITY}, (thud_pos){0, 0}));
    INVALID(thud_body_apply_impulse(world, ball, one, (thud_pos){NAN, 0}));
    INVALID(thud_body_apply_impulse(world, floor, one, (thud_pos){0, 0}));
    INVALID(thud_body_apply_center_force(world, ball, (thud_vec2){NAN, 0}));
    INVALID(thud_body_apply_center_force(world, floor, one));
    INVALID(thud_body_set_awake(world, floor, true));
    INVALID(thud_world_set_gravity(world, (thud_vec2){NAN, 0}));
    INVALID(thud_world_set_time_step(world, 0));
    thud_quality stiff = thud_quality_default;
    stiff.contact_stiffness = 0.6f;
    INVALID(thud_world_set_quality(world, &stiff));
    INVALID(thud_world_advance(world, -1, 1, NULL, NULL));
    INVALID(thud_world_advance(world, NAN, 1, NULL, NULL));
    INVALID(thud_world_advance(world, 1, 0, NULL, NULL));
    INVALID(thud_world_cast_ray(world, &(thud_ray){(thud_pos){NAN, 0}, 1, 0, NULL}, NULL, NULL));
    INVALID(
        thud_world_cast_ray(world, &(thud_ray){(thud_pos){0, 0}, INFINITY, 0, NULL}, NULL, NULL));
    assert_int_equal(thud_body_create(world, NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_shape_create_circle(world, ball, NULL, zero, 1, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_shape_create_terrain(world, floor, &shape, NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(logged, refused + 3);
    assert_int_equal(thud_world_step(NULL), THUD_ERROR_NULL);
    assert_true(thud_hash_of(world) == hash);
    assert_int_equal(thud_stats_of(world).bodies, stats.bodies);
    assert_int_equal(thud_stats_of(world).shapes, stats.shapes);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(handle_of_destroyed_body_is_stale_even_when_its_slot_lives_again),
        cmocka_unit_test(handle_of_another_world_is_refused),
        cmocka_unit_test(handle_is_refused_however_many_worlds_are_made_after_its_own),
        cmocka_unit_test(static_body_with_a_velocity_is_refused),
        cmocka_unit_test(shape_whose_filter_is_zeroed_is_made_and_told_to_meet_nothing),
        cmocka_unit_test(shapes_die_with_their_body),
        cmocka_unit_test(bad_worlds_are_refused),
        cmocka_unit_test(bad_calls_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
