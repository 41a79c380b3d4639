/* test_max_error.c: worlds with a maximum error (max_error): islands that exceed it are solved
 * directly, and no others. */
#include "engine_support.h"

#include <thud/thud_make.h>

/* Draft with a direct solver, which is used only as `max_error` requires. */
static thud_quality rough(void) {
    thud_quality q = thud_quality_draft;
    q.islands = &thud_islands_direct;
    q.overlap_limit = INFINITY;
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

/* Without a maximum error a column of ten sinks by more than 5 mm, and nothing is solved
 * directly. */
static void error_without_limit_is_missed(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.0, &q);
    add_column(world, 0, 10);
    run(world, 120);
    assert_true(thud_step_error_of(world).penetration_max > 0.005);
    assert_int_equal(thud_stats_of(world).direct_islands, 0);
    thud_world_destroy(world);
}

/* A column of ten keeps a maximum error of 2 mm and is solved directly; a single box, which does
 * not exceed it, is not. */
static void column_keeps_the_limit_and_the_lone_box_stays_soft(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.002, &q);
    add_column(world, 0, 10);
    add_column(world, 10, 1);
    run(world, 120);
    thud_step_error error = thud_step_error_of(world);
    assert_true(error.penetration_max < 0.002);
    assert_int_equal(error.overlaps, 0);
    assert_int_equal(thud_stats_of(world).direct_islands, 1);
    assert_int_equal(thud_stats_of(world).direct_bodies, 10);
    thud_world_destroy(world);
}

/* Where all boxes but the lowest are destroyed, that is solved softly again. */
static void quality_falls_again_when_the_load_is_gone(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.002, &q);
    thud_body_id boxes[10];
    for (int i = 0; i < 10; i++) {
        boxes[i] = add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    run(world, 120);
    assert_int_equal(thud_stats_of(world).direct_islands, 1);
    for (int i = 1; i < 10; i++) {
        OK(thud_body_destroy(world, boxes[i]));
    }
    run(world, 120);
    assert_int_equal(thud_stats_of(world).direct_islands, 0);
    assert_true(thud_step_error_of(world).penetration_max < 0.002);
    thud_world_destroy(world);
}

/* A maximum error that is set while the world runs takes effect. */
static void limit_set_later_takes_effect(void **state) {
    (void)state;
    thud_quality q = rough();
    thud_world *world = world_with(0.0, &q);
    add_column(world, 0, 10);
    run(world, 200);
    OK(thud_world_set_max_error(world, 0.002));
    run(world, 60);
    assert_true(thud_step_error_of(world).penetration_max < 0.002);
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
    def.quality = &thud_quality_draft; /* it has no island solver, which a maximum error needs */
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

/* ---- columns whose bodies detection stops ---- */

/* A case: a column of boxes of this kind. */
typedef struct column {
    double scale, step; /* length scale; time step in s */
    const thud_quality *quality;
    const thud_detection *detection;
    thud_shape_kind kind;
} column;

enum { COLUMN = 16 };

/* A column of COLUMN boxes at the case's scale. */
static thud_world *make_column(const column *c, double max_error, thud_body_id *boxes) {
    thud_world_def def = thud_default_world_def_of(c->quality);
    float half = (float)(0.5 * c->scale);
    def.detection = c->detection;
    def.length_scale = (float)c->scale;
    def.gravity.y = (float)(-10 * c->scale);
    def.time_step = c->step;
    def.max_error = max_error * c->scale;
    thud_world *world = make_world(def);
    thud_body_make(world, thud_aabb_at(0, -c->scale, 20 * c->scale, c->scale),
                   &(thud_body_options){.kind = THUD_BODY_STATIC});
    for (int i = 0; i < COLUMN; i++) {
        double y = (0.5 + i) * c->scale;
        thud_geometry at = c->kind == THUD_SHAPE_AABB
                               ? thud_aabb_at(0, y, (double)half, (double)half)
                               : thud_obb_at(0, y, (double)half, (double)half, 0);
        boxes[i] = thud_body_make(world, at, &(thud_body_options){.kind = THUD_BODY_DYNAMIC});
        assert_true(boxes[i].index1 > 0);
    }
    return world;
}

/* Checks one case. */
typedef void column_fn(const column *c);

/* Calls the check for columns of all scales, steps, qualities, detections and shapes. */
static void try_columns(column_fn *try_it) {
    static const double scales[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3,
                                    0.7,  1,    3,    10,   1e3,  1e6};
    const thud_quality *const levels[] = {&thud_quality_default, &thud_quality_high,
                                          &thud_quality_exact};
    for (size_t i = 0; i < 2 * 2 * 2 * 3 * sizeof scales / sizeof *scales; i++) {
        try_it(&(column){.step = i & 1 ? 1.0 / 30 : 1.0 / 60,
                         .detection = i & 2 ? &thud_detection_swept : &thud_detection_bisect,
                         .kind = i & 4 ? THUD_SHAPE_OBB : THUD_SHAPE_AABB,
                         .quality = levels[i / 8 % 3],
                         .scale = scales[i / 24]});
    }
}

/* Asserts that no step exceeds a maximum error of 0.0005 length scales. */
static void keeps_max_error(const column *c) {
    thud_body_id boxes[COLUMN];
    const double most = 0.0005;
    thud_world *world = make_column(c, most, boxes);
    for (int k = 0; k < 60; k++) {
        OK(thud_world_step(world));
        double depth = thud_step_error_of(world).penetration_max / c->scale;
        if (depth > most) {
            fail_msg("%s, %s, steps of %g s, length scale %g: %g too deep in step %d",
                     c->quality->name, c->detection == &thud_detection_swept ? "swept" : "bisect",
                     c->step, c->scale, depth, k);
        }
    }
    thud_world_destroy(world);
}

static void column_keeps_the_limit_in_each_step_where_boxes_are_stopped_on_the_way(void **state) {
    (void)state;
    try_columns(keeps_max_error);
}

/* A column that is created touching does not jump: no box gets more velocity than gravity gives in
 * two steps. */
static void stays_on_the_ground(const column *c) {
    thud_body_id boxes[COLUMN];
    thud_world *world = make_column(c, 0, boxes);
    double most = 2 * 10 * c->step;
    for (int k = 0; k < 30; k++) {
        OK(thud_world_step(world));
        for (int i = 0; i < COLUMN; i++) {
            double speed = (double)state_of(world, boxes[i]).velocity.y / c->scale;
            if (speed > most) {
                fail_msg("%s, steps of %g s, length scale %g: box %d rises by %g/s in step %d",
                         c->quality->name, c->step, c->scale, i, speed, k);
            }
        }
    }
    thud_world_destroy(world);
}

static void boxes_that_give_way_to_many_in_a_step_gain_no_speed_by_it(void **state) {
    (void)state;
    try_columns(stays_on_the_ground);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_without_limit_is_missed),
        cmocka_unit_test(column_keeps_the_limit_and_the_lone_box_stays_soft),
        cmocka_unit_test(quality_falls_again_when_the_load_is_gone),
        cmocka_unit_test(limit_set_later_takes_effect),
        cmocka_unit_test(limit_that_cannot_be_kept_is_refused),
        cmocka_unit_test(column_keeps_the_limit_in_each_step_where_boxes_are_stopped_on_the_way),
        cmocka_unit_test(boxes_that_give_way_to_many_in_a_step_gain_no_speed_by_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
