/* test_catalogue.c: tests what the figures of thud-catalogue rely on: counts of pairs are compared
 * with counts by hand, and the inputs have the properties that docs/catalogue.md states. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "catalogue/call_timer.h"
#include "catalogue/crowd.h"
#include "lab/lab_turns.h"
#include "catalogue/levels.h"
#include "catalogue/sample_pairs.h"

#include <math.h>
#include <string.h>

/* ---- levels ---- */

static thud_geometry circle(double x, double y, double radius) {
    return (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1, .hx = radius};
}

/* An OBB turned by 45 degrees. */
static thud_geometry bar(double x, double y, double hx, double hy) {
    double half = sqrt(0.5);
    return (thud_geometry){THUD_SHAPE_OBB, x, y, half, half, hx, hy};
}

static levels count_pair(thud_geometry a, thud_geometry b) {
    thud_geometry shapes[] = {a, b};
    bool movable[] = {true, false};
    levels sum = {0};
    assert_true(levels_count(shapes, movable, 2, 0.02, &sum));
    return sum;
}

static void assert_levels(levels found, levels wanted) {
    if (memcmp(&found, &wanted, sizeof found) != 0)
        fail_msg("%ld %ld %ld %ld %ld, %ld %ld instead of %ld %ld %ld %ld %ld, %ld %ld",
                 found.pairs, found.circles, found.boxes, found.oriented, found.exact, found.sieved,
                 found.near, wanted.pairs, wanted.circles, wanted.boxes, wanted.oriented,
                 wanted.exact, wanted.sieved, wanted.near);
}

static void levels_count_a_pair_up_to_the_volume_that_parts_it(void **state) {
    (void)state;
    /* In this order: far apart; long bars side by side, of which only the bounding circles overlap;
     * parallel slanted bars 0.6 apart, whose AABBs overlap too; a circle and a box whose OBBs
     * overlap but not they themselves; two circles that overlap. */
    assert_levels(count_pair(circle(0, 0, 1), circle(9, 0, 1)), (levels){1, 0, 0, 0, 0, 0, 0});
    assert_levels(count_pair((thud_geometry){THUD_SHAPE_AABB, 0, 0, 1, 0, 2, 0.1},
                             (thud_geometry){THUD_SHAPE_AABB, 0, 1, 1, 0, 2, 0.1}),
                  (levels){1, 1, 0, 0, 0, 0, 0});
    assert_levels(count_pair(bar(0, 0, 2, 0.1), bar(0.6, -0.6, 2, 0.1)),
                  (levels){1, 1, 1, 0, 0, 0, 0});
    /* A circle's OBB is the square around it; the box's corner is in the square and not in the
     * circle. */
    assert_levels(count_pair(circle(0, 0, 1),
                             (thud_geometry){THUD_SHAPE_AABB, 3.75, 1.25, 1, 0, 3, 0.5}),
                  (levels){1, 1, 1, 1, 0, 0, 0});
    assert_levels(count_pair(circle(0, 0, 1), circle(1, 0, 1)), (levels){1, 1, 1, 1, 1, 1, 1});
}

static void levels_near_pairs_pass_the_sieve_and_corners_do_not_pass_the_exact_test(void **state) {
    (void)state;
    thud_geometry box = {THUD_SHAPE_AABB, 0, 0, 1, 0, 1, 1};
    thud_geometry beside = {THUD_SHAPE_AABB, 2.019, 0, 1, 0, 1, 1};
    /* 0.019 apart along each axis, and 0.027 from corner to corner. */
    thud_geometry across = {THUD_SHAPE_AABB, 2.019, 2.019, 1, 0, 1, 1};
    assert_levels(count_pair(box, beside), (levels){1, 1, 0, 0, 0, 1, 1});
    assert_levels(count_pair(box, across), (levels){1, 0, 0, 0, 0, 1, 0});
    assert_levels(count_pair(circle(0, 0, 1), circle(2.021, 0, 1)), (levels){1, 0, 0, 0, 0, 0, 0});
    assert_levels(count_pair(circle(0, 0, 1), circle(2.019, 0, 1)), (levels){1, 0, 0, 0, 0, 1, 1});
}

static void levels_leave_out_pairs_of_which_none_moves_and_add_up(void **state) {
    (void)state;
    thud_geometry shapes[] = {circle(0, 0, 1), circle(1, 0, 1), circle(0, 1, 1)};
    bool movable[] = {false, false, true};
    levels sum = {0};
    assert_true(levels_count(shapes, movable, 3, 0.02, &sum));
    assert_true(levels_count(shapes, movable, 3, 0.02, &sum));
    assert_levels(sum, (levels){4, 4, 4, 4, 4, 4, 4});
}

static void levels_refuse_a_shape_that_is_not_valid(void **state) {
    (void)state;
    thud_geometry shapes[] = {circle(0, 0, 1), circle(NAN, 0, 1)};
    bool movable[] = {true, true};
    levels sum = {0};
    assert_false(levels_count(shapes, movable, 2, 0.02, &sum));
}

/* ---- crowds ---- */

static void crowd_overlaps_are_counted_once_each(void **state) {
    (void)state;
    scene s;
    crowd none = {.bodies = 0, .area = 1, .least = 0.5, .most = 0.5};
    scene_init(&s);
    crowd_fill(&none, &s);
    assert_int_equal(crowd_overlaps(&s), 0);
    scene_dynamic_circle(&s, 0, 0, 1);
    scene_dynamic_circle(&s, 2, 0, 1); /* touches the first */
    scene_dynamic_circle(&s, 0, 2.1, 1);
    scene_dynamic_circle(&s, 0, 1, 0.2); /* overlaps the first, and the third */
    assert_int_equal(crowd_overlaps(&s), 3);
    scene_free(&s);
}

static void crowd_has_the_share_speed_sizes_and_fill_that_were_asked_for(void **state) {
    (void)state;
    crowd c = {.bodies = 1000, .least = 0.025, .most = 10, .moving = 0.1, .speed = 7};
    c.area = crowd_area_filled(&c, 0.3);
    scene s;
    scene_init(&s);
    crowd_fill(&c, &s);
    int moving = 0, octave = 0;
    double filled = 0;
    for (int i = s.body_count - c.bodies; i < s.body_count; i++) {
        double speed = hypot(s.bodies[i].vx, s.bodies[i].vy);
        double radius = s.shapes[s.bodies[i].first_shape].hx;
        assert_true(speed == 0 || fabs(speed - 7) < 1e-12);
        assert_true(radius >= 0.025 && radius <= 10);
        moving += speed > 0;
        octave += radius < 0.05;
        filled += 3.14159265358979 * radius * radius;
    }
    assert_int_equal(moving, 100);
    assert_in_range(octave, 450, 550); /* half of them are in the first octave */
    assert_true(fabs(filled / (c.area * c.bodies) - 0.3) < 1e-9);
    scene_free(&s);
}

static void crowd_passes_through_itself_but_not_through_walls(void **state) {
    (void)state;
    crowd c = {.bodies = 50, .area = 0.5, .least = 0.25, .most = 0.25, .moving = 1, .speed = 5};
    lab_world lab = {0};
    thud_world_def def = lab_settings();
    scene_init(&lab.scene);
    crowd_fill(&c, &lab.scene);
    assert_true(lab_open(&lab, &def));
    crowd_passes_through(lab.world);
    double before = thud_measure_of(lab.world).kinetic_energy;
    bool met = false;
    for (int i = 0; i < 300; i++) {
        assert_true(lab_run(&lab, 1, NULL));
        met |= thud_stats_of(lab.world).contacts > 10;
    }
    assert_true(met);
    /* If circles, which overlap deeply, had collided, their energy would have changed. */
    assert_true(fabs(thud_measure_of(lab.world).kinetic_energy / before - 1) < 0.01);
    double half = 0.5 * sqrt(c.area * c.bodies) + 2 * c.most;
    int count;
    const thud_pose *poses = thud_poses_of(lab.world, (thud_pos){0, 0}, 1, &count);
    for (int i = count - c.bodies; i < count; i++)
        assert_true(fabsf(poses[i].x) < half && fabsf(poses[i].y) < half);
    lab_close(&lab);
}

/* ---- inputs of calls ---- */

static void sample_pairs_are_apart_and_meet_on_their_way_whatever_their_kinds(void **state) {
    (void)state;
    static sample_pairs p;
    for (int a = THUD_SHAPE_CIRCLE; a <= THUD_SHAPE_OBB; a++)
        for (int b = a; b <= THUD_SHAPE_OBB; b++) {
            sample_pairs_make((thud_shape_kind)a, (thud_shape_kind)b, &p);
            int overlapping = 0;
            for (int i = 0; i < SAMPLE_PAIRS; i++) {
                bool hit = false, collided = false;
                double impact, collision;
                thud_motion still = {0, 0, 0};
                overlapping += thud_geometry_overlap(&p.a[i], &p.b[i]);
                assert_false(thud_geometry_overlap(&p.a[i], &p.far_b[i]));
                assert_int_equal(thud_geometry_time_of_impact(&p.a[i], still, &p.far_b[i],
                                                              p.motion[i], 0, &hit, &impact),
                                 THUD_OK);
                assert_int_equal(thud_geometry_time_of_collision(&p.a[i], still, &p.far_b[i],
                                                                 p.motion[i], p.tolerance,
                                                                 &collided, &collision),
                                 THUD_OK);
                assert_true(hit && collided && impact > 0 && impact < 1);
            }
            assert_in_range(overlapping, SAMPLE_PAIRS / 8, SAMPLE_PAIRS * 7 / 8);
        }
}

/* ---- clocks ---- */

static int calls_made;

static double count_calls(const void *inputs, int count) {
    calls_made += count;
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += sqrt(*(const double *)inputs + i);
    return sum;
}

static void call_timer_makes_enough_calls_for_its_clock(void **state) {
    (void)state;
    double input = 2;
    calls_made = 0;
    double ns = call_timer_ns(count_calls, &input, true);
    assert_true(isfinite(ns) && ns > 0);
    assert_true(calls_made >= 1024);
}

static lab_turns_times take_turns(double too_dear, int repetitions) {
    lab_turns_plan plan = {.warm_up = 3, .steps = 12, .seconds = 60, .too_dear = too_dear};
    lab_turns_times times;
    for (int i = 0; i < repetitions; i++) {
        thud_world_def def = lab_settings();
        def.clock = lab_now;
        lab_world lab;
        assert_true(lab_open_scene(&lab, scenes_find("gas"), 20, &def));
        assert_true(lab_take_turns("", &lab, 1, &plan, i, &times));
        lab_close(&lab);
    }
    return times;
}

static void turns_time_the_steps_that_were_planned(void **state) {
    (void)state;
    lab_turns_times once = take_turns(60, 1), again = take_turns(60, 3);
    assert_false(once.dropped);
    assert_int_equal(once.count, 12);
    assert_int_equal(again.count, 12);
    for (int i = 0; i < again.count; i++) {
        assert_true(again.step[i] > 0);
        assert_true(again.broadphase[i] >= 0 && again.broadphase[i] <= again.step[i]);
    }
    assert_int_equal(again.stats.bodies, 24);
}

static void turns_drop_a_world_that_is_too_dear(void **state) {
    (void)state;
    lab_turns_times times = take_turns(0, 2);
    assert_true(times.dropped);
    assert_int_equal(times.count, 0);
}

static void turns_mean_is_the_sum_over_the_count(void **state) {
    (void)state;
    double values[] = {1, 2, 6};
    assert_true(lab_turns_mean(values, 3) == 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_count_a_pair_up_to_the_volume_that_parts_it),
        cmocka_unit_test(levels_near_pairs_pass_the_sieve_and_corners_do_not_pass_the_exact_test),
        cmocka_unit_test(levels_leave_out_pairs_of_which_none_moves_and_add_up),
        cmocka_unit_test(levels_refuse_a_shape_that_is_not_valid),
        cmocka_unit_test(crowd_overlaps_are_counted_once_each),
        cmocka_unit_test(crowd_has_the_share_speed_sizes_and_fill_that_were_asked_for),
        cmocka_unit_test(crowd_passes_through_itself_but_not_through_walls),
        cmocka_unit_test(sample_pairs_are_apart_and_meet_on_their_way_whatever_their_kinds),
        cmocka_unit_test(call_timer_makes_enough_calls_for_its_clock),
        cmocka_unit_test(turns_time_the_steps_that_were_planned),
        cmocka_unit_test(turns_drop_a_world_that_is_too_dear),
        cmocka_unit_test(turns_mean_is_the_sum_over_the_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
