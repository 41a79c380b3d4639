/* test_error.c: the errors that every step reports (penetration, residual), against values derived
 * by hand and thud_measure_of. */
#include "error_support.h"

#include "build_thud.h"
#include "solver/error.h"
#include "some_threads.h"
#include "scenes.h"

#include <thud/thud_testing.h>

static void error_before_the_first_step_and_without_a_world_is_zero(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_ball(world, 0, 0, 1);
    const thud_world *asked[] = {world, NULL};
    for (int i = 0; i < 2; i++) {
        thud_step_error e = thud_step_error_of(asked[i]);
        assert_true(e.penetration_max == 0 && e.penetration_mean == 0 && e.residual == 0);
        assert_true(e.energy_change == 0 && e.overlaps == 0);
    }
    thud_world_destroy(world);
}

/* The reported penetration is the depth that the ball has at the end of the step. */
static void penetration_of_a_sunk_ball_is_how_deep_it_ends(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 0.5 - 0.2, 0.5f);
    thud_step_error e = error_of_step(world);
    double depth = 0.5 - state_of(world, ball).position.y;
    assert_true(depth > 0.1 && depth < 0.2);
    near_to(e.penetration_max, depth, 1e-6);
    near_to(e.penetration_mean, depth, 1e-6);
    assert_int_equal(e.overlaps, 1);
    thud_world_destroy(world);
}

/* The mean penetration counts all touching points, also those that do not overlap. */
static void mean_counts_points_that_do_not_overlap(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_floor(world, NULL);
    add_ball(world, 0, 0.5 - 0.1, 0.5f);
    add_ball(world, 5, 0.5 + 0.01, 0.5f);
    thud_step_error e = error_of_step(world);
    assert_true(e.penetration_max > 0.05);
    near_to(e.penetration_mean, e.penetration_max / 2, 1e-6);
    assert_int_equal(e.overlaps, 1);
    thud_world_destroy(world);
}

static thud_world *world_of(const char *name, int size, thud_world_def def) {
    scene s;
    thud_world *world;
    assert_true(scenes_fill(scenes_find(name), size, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    scene_free(&s);
    return world;
}

static void penetration_agrees_with_the_measure_in_every_scene(void **state) {
    (void)state;
    static const struct {
        const char *name;
        int size;
    } scenes[] = {{"pyramid", 20},      {"circle_pit", 300}, {"mixed_terrain", 300},
                  {"tumbler", 100},     {"platformer", 100}, {"gas", 200},
                  {"heavy_on_light", 4}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        thud_world_def def = thud_default_world_def();
        def.sleeping = false;
        def.detection = i % 2 ? &thud_detection_swept : &thud_detection_overlap;
        thud_world *world = world_of(scenes[i].name, scenes[i].size, def);
        for (int k = 0; k < 100; k++) {
            thud_step_error e = error_of_step(world);
            thud_measure m = thud_measure_of(world);
            near_to(e.penetration_max, m.penetration_max, 1e-7 + 1e-6 * m.penetration_max);
            near_to(e.penetration_mean, m.penetration_mean, 1e-7 + 1e-5 * m.penetration_mean);
        }
        thud_world_destroy(world);
    }
}

/* td_errors_recount, which computes the report from the final state, agrees with what the step has
 * counted. */
static void recount_finds_what_the_step_found(void **state) {
    (void)state;
    static const char *const names[] = {"pyramid", "circle_pit"};
    for (int i = 0; i < 2; i++) {
        thud_world_def def = thud_default_world_def();
        def.sleeping = false;
        thud_world *world = world_of(names[i], i ? 300 : 20, def);
        run(world, 100);
        thud_step_error step = error_of_step(world);
        td_errors_recount(world);
        thud_step_error again = thud_step_error_of(world);
        assert_true(again.penetration_max == step.penetration_max);
        near_to(again.penetration_mean, step.penetration_mean, 1e-7);
        assert_int_equal(again.overlaps, step.overlaps);
        assert_true(again.energy_change == step.energy_change);
        assert_true(again.residual > 0 && again.residual < 2 * step.residual);
        thud_world_destroy(world);
    }
}

static bool never(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)world, (void)contact, (void)settings, (void)context;
    return false;
}

static void contacts_of_sleepers_and_vetoed_ones_do_not_count(void **state) {
    (void)state;
    for (int vetoed = 0; vetoed < 2; vetoed++) {
        thud_world_def def = thud_default_world_def();
        thud_world *world = make_world(def);
        set_listeners(world, vetoed ? never : NULL, NULL, NULL);
        add_floor(world, NULL);
        add_box(world, 0, 0.49, 0.5f, 0.5f);
        thud_step_error e = error_of_step(world);
        assert_int_equal(e.penetration_max > 0, !vetoed);
        run(world, vetoed ? 1 : 120);
        e = thud_step_error_of(world);
        assert_true(e.penetration_max == 0 && e.penetration_mean == 0 && e.residual == 0);
        assert_int_equal(e.overlaps, 0);
        assert_int_equal(thud_stats_of(world).awake_bodies, vetoed);
        thud_world_destroy(world);
    }
}

/* In the step in which a body is quarantined, the errors of islands that are solved directly are
 * counted again. */
static void body_that_is_no_number_leaves_no_trace_in_the_errors(void **state) {
    (void)state;
    for (int which = 0; which < 4; which++) {
        thud_world *world = make_world(thud_default_world_def_of(&thud_quality_high));
        thud_body_id box[4];
        add_floor(world, NULL);
        for (int i = 0; i < 4; i++) {
            box[i] = add_box(world, 5 * (i / 2), 0.5 + i % 2, 0.5f, 0.5f);
        }
        run(world, 5);
        for (int i = 0; i < 2; i++) {
            OK(thud_body_apply_center_force(world, box[which], (thud_vec2){3e38f, -3e38f}));
        }
        thud_step_error e = error_of_step(world);
        assert_int_equal(thud_events_of(world).quarantined_count, 1);
        assert_true(isfinite(e.penetration_max) && isfinite(e.penetration_mean));
        assert_true(isfinite(e.residual) && isfinite(e.energy_change));
        thud_world_destroy(world);
    }
}

/* At draft, the residual is small under a box of the same mass and large under one of 10^4 times
 * its mass. */
static void residual_is_large_where_the_solver_does_not_get_done(void **state) {
    (void)state;
    double residual[2];
    for (int hard = 0; hard < 2; hard++) {
        thud_world_def def = thud_default_world_def();
        def.sleeping = false;
        def.quality = &thud_quality_draft;
        thud_world *world = make_world(def);
        thud_shape_def heavy = thud_default_shape_def();
        heavy.density = hard ? 1e4f : 1;
        add_floor(world, NULL);
        add_box(world, 0, 0.5, 0.5f, 0.5f);
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, 0, 1.5, 0), 0.5f, 0.5f, false, &heavy);
        run(world, 20);
        residual[hard] = thud_step_error_of(world).residual;
        thud_world_destroy(world);
    }
    assert_true(residual[0] < 0.02);
    assert_true(residual[1] > 0.1);
}

/* `overlaps` counts points deeper than 0.005 length scales: none in a stack under a light box,
 * several under a heavy one. */
static void points_of_a_stack_overlap_under_a_weight_that_crushes_it(void **state) {
    (void)state;
    int overlaps[2];
    for (int crushed = 0; crushed < 2; crushed++) {
        thud_world_def def = thud_default_world_def();
        def.sleeping = false;
        def.quality = &thud_quality_draft;
        thud_world *world = make_world(def);
        thud_shape_def heavy = thud_default_shape_def();
        heavy.density = crushed ? 1000 : 0.1f;
        add_floor(world, NULL);
        for (int i = 0; i < 3; i++) {
            add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
        }
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, 0, 3.5, 0), 0.5f, 0.5f, false, &heavy);
        run(world, 30);
        overlaps[crushed] = thud_step_error_of(world).overlaps;
        thud_world_destroy(world);
    }
    assert_int_equal(overlaps[0], 0);
    assert_in_range(overlaps[1], 4, 8);
}

static void report_of_a_step_that_quarantines_is_finite(void **state) {
    (void)state;
    thud_world_def def = weightless();
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    add_ball(world, 0, 1.5, 0.5f);
    for (int i = 0; i < 40; i++) {
        OK(thud_body_apply_impulse(world, ball, (thud_vec2){3e38f, -3e38f}, (thud_pos){0, 1}));
    }
    for (int i = 0; i < 3; i++) {
        thud_step_error e = error_of_step(world);
        assert_true(isfinite(e.penetration_max) && isfinite(e.penetration_mean));
        assert_true(isfinite(e.residual) && isfinite(e.energy_change));
    }
    thud_world_destroy(world);
}

/* ---- the same report with any workers and SIMD ---- */

static void same_as(thud_step_error a, thud_step_error b) {
    assert_true(a.penetration_max == b.penetration_max);
    assert_true(a.penetration_mean == b.penetration_mean);
    assert_true(a.residual == b.residual);
    assert_true(a.energy_change == b.energy_change);
    assert_int_equal(a.overlaps, b.overlaps);
}

static void report_is_the_same_with_any_workers_and_any_simd(void **state) {
    (void)state;
    static const struct {
        const char *name;
        int size;
    } scenes[] = {{"pyramid", 40}, {"circle_pit", 3000}, {"mixed_terrain", 2000}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        thud_world *world[5];
        thud_threads *threads[5] = {0};
        for (int k = 0; k < 5; k++) {
            thud_world_def def = thud_default_world_def();
            threads[k] = k > 0 && k < 4 ? some_threads(k + 1) : NULL;
            if (threads[k]) {
                def.job_system = jobs_of_small_steps(threads[k]);
            }
            thud_world_def_set_baseline_simd(&def, k == 4);
            world[k] = world_of(scenes[i].name, scenes[i].size, def);
        }
        bool overlaps = false;
        for (int step = 0; step < 60; step++) {
            thud_step_error first = error_of_step(world[0]);
            overlaps |= first.overlaps > 0;
            for (int k = 1; k < 5; k++) {
                same_as(first, error_of_step(world[k]));
            }
        }
        assert_true(overlaps);
        for (int k = 0; k < 5; k++) {
            thud_world_destroy(world[k]);
            thud_threads_destroy(threads[k]);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_before_the_first_step_and_without_a_world_is_zero),
        cmocka_unit_test(penetration_of_a_sunk_ball_is_how_deep_it_ends),
        cmocka_unit_test(mean_counts_points_that_do_not_overlap),
        cmocka_unit_test(penetration_agrees_with_the_measure_in_every_scene),
        cmocka_unit_test(recount_finds_what_the_step_found),
        cmocka_unit_test(contacts_of_sleepers_and_vetoed_ones_do_not_count),
        cmocka_unit_test(body_that_is_no_number_leaves_no_trace_in_the_errors),
        cmocka_unit_test(residual_is_large_where_the_solver_does_not_get_done),
        cmocka_unit_test(points_of_a_stack_overlap_under_a_weight_that_crushes_it),
        cmocka_unit_test(report_of_a_step_that_quarantines_is_finite),
        cmocka_unit_test(report_is_the_same_with_any_workers_and_any_simd),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
