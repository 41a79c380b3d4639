/* test_mover.c: the character mover on slopes, steps, platforms, walls and one-way platforms: it
 * climbs, rides and stops as its settings say. */
#include "mover_support.h"

static void slope_of_30_degrees_is_walked_up_and_down_and_60_is_a_wall(void **state) {
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        thud_world *gentle = world_with_slope(tan(0.5236)), *steep = world_with_slope(tan(1.0472));
        thud_mover mover = mover_of(kind, -2, 0.7);
        go_on(gentle, &mover, 5, 180);
        assert_true(mover.on_ground);
        assert_true(mover.shape.x > 8);
        near_to(mover.shape.y, 8 * tan(0.5236) + 0.5 + mover.skin, 1e-3);
        /* It stays on the ground on its way down, where each move descends by 0.05. */
        thud_vec2 velocity = {0, 0};
        for (int i = 0; i < 180; i++) {
            go(gentle, &mover, &velocity, -5);
            assert_true(mover.on_ground);
        }
        near_to(mover.shape.y, 0.5 + mover.skin, 1e-3);
        mover = mover_of(kind, -2, 0.7);
        go_on(steep, &mover, 5, 240);
        assert_true(mover.on_ground);
        assert_true(mover.shape.x < 0.1 && mover.shape.y < 0.6);
        thud_world_destroy(gentle);
        thud_world_destroy(steep);
    }
}

static void step_of_0_3_is_climbed_and_one_of_0_6_is_not(void **state) {
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        for (int high = 0; high < 2; high++) {
            thud_world *world = make_world(weightless());
            float height = high ? 0.6f : 0.3f;
            add_floor(world, NULL);
            add_block(world, 5, (double)height / 2, 2, height / 2);
            thud_mover mover = mover_of(kind, 0, 0.6);
            go_on(world, &mover, 4, 60);
            assert_true(mover.on_ground);
            near_to(mover.shape.y, (high ? 0 : 0.3) + 0.5 + mover.skin, 1e-3);
            assert_true(high ? mover.shape.x < 3 : mover.shape.x > 3.5);
            go_on(world, &mover, 4, 60);
            assert_true(mover.on_ground);
            near_to(mover.shape.y, 0.5 + mover.skin, 1e-3);
            assert_true(high ? mover.shape.x < 3 : mover.shape.x > 7);
            thud_world_destroy(world);
        }
    }
}

/* The mover stands on a platform with this velocity and spin; asserts that it stays at its place on
 * it. */
static void ride_platform(int kind, thud_vec2 platform, float spin) {
    thud_world *world = make_world(weightless());
    thud_body_id body = add_body(world, THUD_BODY_KINEMATIC, 0, 0, 0);
    add_shape(world, body, 2, 0.25f, spin == 0, NULL);
    OK(thud_body_set_velocity(world, body, platform, spin));
    thud_mover mover = mover_of(kind, 0.5, 0.8);
    thud_vec2 velocity = {0, 0};
    for (int i = 0; i < 60; i++) { /* until it stands */
        go(world, &mover, &velocity, 0);
    }
    assert_true(mover.on_ground);
    double x = mover.shape.x - state_of(world, body).position.x;
    double y = mover.shape.y - state_of(world, body).position.y;
    for (int i = 0; i < 120; i++) {
        run(world, 1);
        thud_mover_report report = go(world, &mover, &velocity, 0);
        assert_true(mover.on_ground);
        thud_body_state at = state_of(world, body);
        if (spin == 0) {
            near_to(mover.shape.x - at.position.x, x, 1e-4);
            near_to(mover.shape.y - at.position.y, y, 1e-4);
            near_to((double)report.ground_velocity.x, (double)platform.x, 1e-5);
        }
    }
    near_to(state_of(world, body).position.x, 2 * (double)platform.x, 1e-3);
    thud_world_destroy(world);
}

/* Platforms that move up, down and sideways, and one that rotates slowly, carry the mover. */
static void platform_is_ridden_up_down_and_sideways_without_sinking_or_hopping(void **state) {
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        ride_platform(kind, (thud_vec2){0, 3}, 0);
        ride_platform(kind, (thud_vec2){0, -6}, 0);
        ride_platform(kind, (thud_vec2){4, 0}, 0);
        ride_platform(kind, (thud_vec2){-3, 2}, 0);
        ride_platform(kind, (thud_vec2){0, 0}, 0.1f);
    }
}

/* A mover that flies into a wall loses the velocity along the wall's normal, and keeps the rest. */
static void wall_takes_only_the_normal_part_of_a_flight(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_block(world, 3, 0, 1, 50);
    thud_mover mover = box_mover(0, 0);
    thud_mover_report report;
    for (int i = 0; i < 60; i++) {
        OK(thud_mover_move(world, &mover, (thud_vec2){6, 9}, DT, &report));
    }
    near_to(mover.shape.y, 9, 1e-6);
    near_to(mover.shape.x, 1.7 - mover.skin, 1e-6);
    near_to((double)report.velocity.x, 0, 1e-6);
    near_to((double)report.velocity.y, 9, 1e-6);
    assert_true(report.hit_count > 0 && (double)report.hits[0].normal.x < -0.999);
    thud_world_destroy(world);
}

/* A mover without an up direction, as in a game seen from above, slides along a wall at an angle
 * and is never on the ground. */
static void mover_seen_from_above_slides_along_slanting_walls_and_has_no_ground(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_shape(world, add_body(world, THUD_BODY_STATIC, 0, -1, 0.4), 40, 1, false, NULL);
    thud_mover mover = circle_mover(0, 3);
    mover.up = (thud_vec2){0, 0};
    thud_mover_report report;
    for (int i = 0; i < 120; i++) {
        OK(thud_mover_move(world, &mover, (thud_vec2){3, -4}, DT, &report));
        assert_false(mover.on_ground);
    }
    /* The velocity that is left is the part along the wall. */
    double along = 3 * cos(0.4) - 4 * sin(0.4);
    near_to((double)report.velocity.x, along * cos(0.4), 1e-5);
    near_to((double)report.velocity.y, along * sin(0.4), 1e-5);
    thud_world_destroy(world);
}

static void mover_on_a_slope_stands_still_for_10_seconds(void **state) {
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        thud_world *world = world_with_slope(tan(0.5236));
        thud_mover mover = mover_of(kind, 3, 3);
        go_on(world, &mover, 0, 60);
        double x = mover.shape.x, y = mover.shape.y;
        go_on(world, &mover, 0, 600);
        assert_true(mover.on_ground);
        near_to(mover.shape.x, x, 1e-6);
        near_to(mover.shape.y, y, 1e-6);
        thud_world_destroy(world);
    }
}

static void slope_too_steep_to_stand_on_is_slid_down(void **state) {
    (void)state;
    thud_world *world = world_with_slope(tan(1.0472));
    thud_mover mover = circle_mover(4, 9);
    go_on(world, &mover, 0, 40);
    assert_false(mover.on_ground);
    go_on(world, &mover, 0, 600);
    assert_true(mover.on_ground);
    assert_true(mover.shape.x < 0.5 && mover.shape.y < 0.6);
    thud_world_destroy(world);
}

/* A mover that jumps against a slope too steep to stand on rises no higher than the jump itself,
 * and lands on the ground. */
static void jump_against_a_steep_slope_gains_no_height(void **state) {
    (void)state;
    thud_world *world = world_with_slope(tan(1.0472));
    thud_mover mover = box_mover(-0.5, 0.6);
    thud_vec2 velocity = {0, 0};
    go(world, &mover, &velocity, 0);
    velocity.y = 6;
    double highest = 0;
    for (int i = 0; i < 180; i++) {
        go(world, &mover, &velocity, 6);
        highest = fmax(highest, mover.shape.y);
    }
    assert_true(highest < 0.6 + 6 * 6 / 40.0);
    assert_true(mover.on_ground && mover.shape.y < 0.6);
    thud_world_destroy(world);
}

/* With thud_mover_passes_one_way the mover rises through a platform and stands on it, and `drop`
 * lets it fall through. */
static void one_way_platform_is_passed_from_below_and_carries_from_above(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_floor(world, NULL);
    thud_shape_def def = thud_default_shape_def();
    def.filter.category = 2;
    thud_body_id platform = add_body(world, THUD_BODY_STATIC, 0, 1.5, 0);
    add_shape(world, platform, 3, 0.1f, true, &def);
    thud_one_way one_way = {.categories = 2};
    thud_mover mover = box_mover(0, 0.6);
    mover.pass = thud_mover_passes_one_way;
    mover.context = &one_way;
    thud_vec2 velocity = {0, 0};
    go(world, &mover, &velocity, 0);
    velocity.y = 9.5f;
    for (int i = 0; i < 90; i++) {
        go(world, &mover, &velocity, 0);
    }
    assert_true(mover.on_ground);
    near_to(mover.shape.y, 1.6 + 0.5 + mover.skin, 1e-4);
    assert_int_equal(mover.ground_body.index1, platform.index1);
    one_way.drop = true;
    go_on(world, &mover, 0, 60);
    assert_true(mover.on_ground);
    near_to(mover.shape.y, 0.5 + mover.skin, 1e-4);
    mover.pass = NULL; /* without `pass` it is a ceiling */
    velocity = (thud_vec2){0, 9.5f};
    for (int i = 0; i < 90; i++) {
        go(world, &mover, &velocity, 0);
        assert_true(mover.shape.y < 1);
    }
    thud_world_destroy(world);
}

/* ---- the same everywhere ---- */

static void scripted_walk_ends_at_the_same_bits_on_every_machine(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    const thud_pos points[] = {{-10, 0}, {2, 0.5}, {5, 3}, {9, 2}, {30, 4}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 5};
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 NULL));
    add_shape(world, add_body(world, THUD_BODY_STATIC, 12, 3, 0.3), 1, 0.5f, false, NULL);
    add_shape(world, add_body(world, THUD_BODY_STATIC, 17, 4, 0), 1, 0, false, NULL);
    thud_mover mover = circle_mover(0, 2);
    for (int i = 0; i < 300; i++) {
        thud_vec2 velocity = {i % 100 < 80 ? 6 : -4, i % 50 < 10 ? 7 : -5};
        OK(thud_mover_move(world, &mover, velocity, 0.015625, NULL));
    }
    /* tests/web/package/query.test.mjs makes the same walk, with the same end. */
    assert_true(mover.shape.x == WALK_END_X && mover.shape.y == WALK_END_Y);
    thud_world_destroy(world);
}

/* ---- bad input ---- */

static void bad_input_is_refused_and_changes_nothing(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_floor(world, NULL);
    thud_body_id crate = add_box(world, 1, 0.52, 0.5f, 0.5f), gone = add_ball(world, 50, 50, 1);
    OK(thud_body_destroy(world, gone));
    thud_mover_report report, untouched;
    memset(&report, 5, sizeof report);
    untouched = report;
    thud_vec2 velocity = {1, 0};
    thud_mover good = box_mover(0, 0.6);
    thud_mover brief = good;
    thud_mover_report told;
    OK(thud_mover_move(world, &brief, velocity, 5e-324, &told));
    assert_true(told.velocity.x == velocity.x && told.velocity.y == velocity.y);
    assert_int_equal(thud_mover_move(NULL, &good, velocity, DT, &report), THUD_ERROR_NULL);
    assert_int_equal(thud_mover_move(world, NULL, velocity, DT, &report), THUD_ERROR_NULL);
    const double times[] = {0, -1, NAN, INFINITY, 1.5};
    for (int i = 0; i < 5; i++) {
        assert_int_equal(thud_mover_move(world, &good, velocity, times[i], &report),
                         THUD_ERROR_INVALID);
    }
    const thud_vec2 velocities[] = {{NAN, 0}, {0, INFINITY}, {1e30f, 0}};
    for (int i = 0; i < 3; i++) {
        assert_int_equal(thud_mover_move(world, &good, velocities[i], DT, &report),
                         THUD_ERROR_INVALID);
    }
    for (int i = 0; i < 14; i++) {
        thud_mover bad = good, before;
        switch (i) {
        case 0:
            bad.shape.hx = 0;
            break;
        case 1:
            bad.shape.hy = NAN;
            break;
        case 2:
            bad.shape.x = INFINITY;
            break;
        case 3:
            bad.shape.x = 2e9;
            break;
        case 4:
            bad.shape.kind = THUD_SHAPE_TERRAIN;
            break;
        case 5:
            bad.up = (thud_vec2){0, 2};
            break;
        case 6:
            bad.skin = 0;
            break;
        case 7:
            bad.skin = 10;
            break;
        case 8:
            bad.max_slope = 1.57;
            break;
        case 9:
            bad.max_slope = NAN;
            break;
        case 10:
            bad.step_height = -1;
            break;
        case 11:
            bad.snap_distance = NAN;
            break;
        case 12:
            bad.push_force = -1;
            break;
        case 13:
            bad.body = crate;
            break;
        }
        before = bad;
        assert_int_equal(thud_mover_move(world, &bad, velocity, DT, &report), THUD_ERROR_INVALID);
        assert_memory_equal(&bad, &before, sizeof bad);
    }
    thud_mover stale = good, before;
    stale.body = gone;
    before = stale;
    assert_int_equal(thud_mover_move(world, &stale, velocity, DT, &report), THUD_ERROR_STALE);
    assert_memory_equal(&stale, &before, sizeof stale);
    assert_memory_equal(&report, &untouched, sizeof report);
    OK(thud_mover_move(world, &good, velocity, DT, NULL));
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slope_of_30_degrees_is_walked_up_and_down_and_60_is_a_wall),
        cmocka_unit_test(step_of_0_3_is_climbed_and_one_of_0_6_is_not),
        cmocka_unit_test(platform_is_ridden_up_down_and_sideways_without_sinking_or_hopping),
        cmocka_unit_test(wall_takes_only_the_normal_part_of_a_flight),
        cmocka_unit_test(mover_seen_from_above_slides_along_slanting_walls_and_has_no_ground),
        cmocka_unit_test(mover_on_a_slope_stands_still_for_10_seconds),
        cmocka_unit_test(slope_too_steep_to_stand_on_is_slid_down),
        cmocka_unit_test(jump_against_a_steep_slope_gains_no_height),
        cmocka_unit_test(one_way_platform_is_passed_from_below_and_carries_from_above),
        cmocka_unit_test(scripted_walk_ends_at_the_same_bits_on_every_machine),
        cmocka_unit_test(bad_input_is_refused_and_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
