/* Worlds with a greatest error: quality rises where it is missed, and nowhere else. */
#include "engine_support.h"

/* Draft, but for what `max_error` asks of it. */
static thud_quality rough(void) {
    thud_quality q = thud_quality_draft;
    q.islands = &thud_islands_direct;
    q.sag_limit = INFINITY;
    q.island_limit = 100;
    q.island_work = 100000;
    return q;
}

static thud_world *world_with(double max_error, const thud_quality *quality) {
    thud_world_def def = thud_default_world_def();
    def.quality = quality;
    def.max_error = max_error;
    def.sleeping = false;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    return world;
}

static void add_column(thud_world *world, double x, int boxes) {
    for (int i = 0; i < boxes; i++) {
        add_box(world, x, 0.5 + i, 0.5f, 0.5f);
    }
}

static void error_without_limit_is_missed(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.0, &q);
    add_column(world, 0, 10);
    run(world, 120);
    assert_true(thud_world_error(world).penetration_max > 0.005);
    assert_int_equal(thud_world_stats(world).direct_islands, 0);
    thud_world_destroy(world);
}

static void column_keeps_the_limit_and_the_lone_box_stays_soft(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.002, &q);
    add_column(world, 0, 10);
    add_column(world, 10, 1);
    run(world, 120);
    thud_step_error error = thud_world_error(world);
    assert_true(error.penetration_max < 0.002);
    assert_int_equal(error.overlaps, 0);
    assert_int_equal(thud_world_stats(world).direct_islands, 1);
    assert_int_equal(thud_world_stats(world).direct_bodies, 10);
    thud_world_destroy(world);
}

static void quality_falls_again_when_the_load_is_gone(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.002, &q);
    thud_body_id boxes[10];
    for (int i = 0; i < 10; i++) {
        boxes[i] = add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    run(world, 120);
    assert_int_equal(thud_world_stats(world).direct_islands, 1);
    for (int i = 1; i < 10; i++) {
        OK(thud_body_destroy(world, boxes[i]));
    }
    run(world, 120);
    assert_int_equal(thud_world_stats(world).direct_islands, 0);
    assert_true(thud_world_error(world).penetration_max < 0.002);
    thud_world_destroy(world);
}

static void limit_set_later_takes_effect(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.0, &q);
    add_column(world, 0, 10);
    run(world, 200);
    OK(thud_world_set_max_error(world, 0.002));
    run(world, 60);
    assert_true(thud_world_error(world).penetration_max < 0.002);
    thud_world_destroy(world);
}

static void limit_that_cannot_be_kept_is_refused(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    thud_world *world = NULL;
    const double bad[] = {-1.0, NAN, INFINITY};
    for (int i = 0; i < 3; i++) {
        def.max_error = bad[i];
        assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    }
    def.max_error = 0.01;
    def.quality = &thud_quality_draft; /* has no solver that could */
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    def.quality = &thud_quality_default;
    world = make_world(def);
    assert_int_equal(thud_world_set_max_error(world, NAN), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_set_max_error(NULL, 0.1), THUD_ERROR_NULL);
    assert_int_equal(thud_world_set_quality(world, &thud_quality_draft), THUD_ERROR_INVALID);
    OK(thud_world_set_max_error(world, 0.0));
    OK(thud_world_set_quality(world, &thud_quality_draft));
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_without_limit_is_missed),
        cmocka_unit_test(column_keeps_the_limit_and_the_lone_box_stays_soft),
        cmocka_unit_test(quality_falls_again_when_the_load_is_gone),
        cmocka_unit_test(limit_set_later_takes_effect),
        cmocka_unit_test(limit_that_cannot_be_kept_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
