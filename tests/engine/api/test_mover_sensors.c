/* test_mover_sensors.c: the character mover and sensors: the sensors on its way are reported, once
 * and in order, and none stops it. */
#include "engine_support.h"

#include <thud/thud_mover.h>

#define DT (1.0 / 60)

static thud_mover box_mover(double x, double y) {
    return thud_default_mover(
        (thud_geometry){.kind = THUD_SHAPE_AABB, .x = x, .y = y, .c = 1, .hx = 0.3, .hy = 0.5});
}

static thud_shape_id add_sensor(thud_world *world, double x, double y, float hx, float hy) {
    thud_shape_def def = thud_default_shape_def();
    def.sensor = true;
    return add_shape(world, add_body(world, THUD_BODY_STATIC, x, y, 0), hx, hy, true, &def);
}

static bool is_listed(const thud_mover_report *report, thud_shape_id sensor) {
    int count = 0;
    for (int i = 0; i < report->sensor_count; i++) {
        count += memcmp(&report->sensors[i], &sensor, sizeof sensor) == 0;
    }
    assert_true(count < 2);
    return count == 1;
}

/* The coins, which are sensors, see the kinematic body that follows the mover. */
static void hero_s_body_collects_coins(void **state) {
    (void)state;
    enum { COINS = 6 };
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_id coins[COINS];
    int taken[COINS] = {0}, left[COINS] = {0};
    add_floor(world, NULL);
    for (int i = 0; i < COINS; i++) {
        coins[i] = add_sensor(world, 2 + i, 0.5, 0.2f, 0);
    }
    thud_mover mover = box_mover(0, 0.6);
    mover.body = add_body(world, THUD_BODY_KINEMATIC, 0, 0.6, 0);
    thud_shape_id hero = add_shape(world, mover.body, 0.3f, 0.5f, true, NULL);
    for (int step = 0; step < 150; step++) {
        run(world, 1);
        thud_events e = thud_events_of(world);
        for (int i = 0; i < COINS; i++) {
            for (int k = 0; k < e.sensor_begin_count; k++) {
                assert_memory_equal(&e.sensor_begin[k].shape_b, &hero, sizeof hero);
                taken[i] += e.sensor_begin[k].shape_a.index1 == coins[i].index1;
            }
            for (int k = 0; k < e.sensor_end_count; k++) {
                left[i] += e.sensor_end[k].shape_a.index1 == coins[i].index1;
            }
        }
        OK(thud_mover_move(world, &mover, (thud_vec2){4, -1}, DT, NULL));
    }
    assert_true(mover.shape.x > 9.5);
    for (int i = 0; i < COINS; i++) {
        assert_int_equal(taken[i], 1);
        assert_int_equal(left[i], 1);
    }
    thud_world_destroy(world);
}

/* A way with steps, slopes and walls, with or without sensors everywhere. */
static thud_world *make_way(bool sensors) {
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    const thud_pos points[] = {{-20, 0}, {4, 0}, {8, 2}, {12, 2}, {16, 0}, {40, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 6};
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 NULL));
    for (int i = 0; i < 3; i++) {
        add_shape(world, add_body(world, THUD_BODY_STATIC, 2 + 0.5 * i, 0.1 + 0.1 * i, 0), 0.25f,
                  0.1f + 0.1f * (float)i, true, NULL);
    }
    add_shape(world, add_body(world, THUD_BODY_STATIC, 24, 2, 0), 0.5f, 2, true, NULL);
    for (int i = 0; i < 160 && sensors; i++) {
        add_sensor(world, -2 + 0.2 * i, 0.1 * (i % 30), 0.15f, i % 3 ? 0.2f : 0);
    }
    return world;
}

static void sensors_stop_no_mover_whatever_its_filter(void **state) {
    (void)state;
    thud_world *clear = make_way(false), *full = make_way(true);
    for (int wants = 0; wants < 2; wants++) {
        thud_mover one = box_mover(-2, 0.6), other = one;
        thud_vec2 velocity = {0, 0};
        other.filter.sensors = wants;
        for (int i = 0; i < 400; i++) {
            thud_mover_report report, its;
            float jump = i % 90 == 89 ? 6.0f : velocity.y - 20.0f / 60;
            velocity = (thud_vec2){5, jump};
            OK(thud_mover_move(clear, &one, velocity, DT, &report));
            OK(thud_mover_move(full, &other, velocity, DT, &its));
            assert_memory_equal(&one.shape, &other.shape, sizeof one.shape);
            assert_int_equal(one.on_ground, other.on_ground);
            assert_int_equal(report.hit_count, its.hit_count);
            assert_int_equal(report.sensor_count, 0);
            assert_true(wants || its.sensor_count == 0);
            assert_memory_equal(&report.velocity, &its.velocity, sizeof its.velocity);
            velocity = report.velocity;
        }
        near_to(one.shape.x, 23.2 - one.skin, 1e-3); /* stopped by the wall */
    }
    thud_world_destroy(clear);
    thud_world_destroy(full);
}

static void mover_reports_the_sensors_on_its_way_once_and_in_order(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id gates[3], other;
    for (int i = 2; i >= 0; i--) {
        gates[i] = add_sensor(world, 2 + 2 * i, 0, 0.01f, 2);
    }
    def.sensor = true;
    def.filter.category = 2;
    other = add_shape(world, add_body(world, THUD_BODY_STATIC, 3, 0, 0), 0.5f, 0, false, &def);
    add_shape(world, add_body(world, THUD_BODY_STATIC, 9, 0, 0), 1, 4, true, NULL);
    add_sensor(world, 9, 0, 0.5f, 0.5f); /* behind the wall */
    thud_mover mover = box_mover(0, 0);
    thud_mover_report report;
    mover.body = add_body(world, THUD_BODY_KINEMATIC, 0, 0, 0);
    def.filter.category = 1;
    /* a sensor of the mover's own body is not reported to it */
    add_shape(world, mover.body, 1, 0, false, &def);
    mover.filter.sensors = true;
    mover.filter.mask = 1;
    OK(thud_mover_move(world, &mover, (thud_vec2){20, 0}, 1, &report));
    near_to(mover.shape.x, 7.7 - mover.skin, 1e-6);
    assert_int_equal(report.sensor_count, 3);
    for (int i = 0; i < 3; i++) {
        assert_memory_equal(&report.sensors[i], &gates[i], sizeof gates[i]);
    }
    assert_false(is_listed(&report, other));
    /* A mover that does not move reports the sensors in which it stands. */
    OK(thud_mover_move(world, &mover, (thud_vec2){0, 0}, DT, &report));
    assert_int_equal(report.sensor_count, 0);
    mover.shape.x = 3;
    mover.filter.mask = 2;
    OK(thud_mover_move(world, &mover, (thud_vec2){0, 0}, DT, &report));
    assert_int_equal(report.sensor_count, 1);
    assert_true(is_listed(&report, other));
    thud_world_destroy(world);
}

/* Sensors on a climb that the mover tried and gave up are not reported. */
static void sensor_above_a_step_too_high_is_not_reported(void **state) {
    (void)state;
    for (int high = 0; high < 2; high++) {
        thud_world *world = make_world(weightless());
        thud_mover mover = box_mover(0, 0.52);
        thud_mover_report report;
        mover.filter.sensors = true;
        add_floor(world, NULL);
        add_shape(world, add_body(world, THUD_BODY_STATIC, 1.5, 0, 0), 1, high ? 0.6f : 0.2f, true,
                  NULL);
        thud_shape_id prize = add_sensor(world, 0.4, 1.15, 0.05f, 0.05f);
        bool reported = false;
        for (int i = 0; i < 30; i++) {
            OK(thud_mover_move(world, &mover, (thud_vec2){3, -1}, DT, &report));
            reported = reported || is_listed(&report, prize);
        }
        assert_true(mover.on_ground);
        assert_int_equal(mover.shape.x > 1, !high);
        assert_int_equal(reported, !high);
        thud_world_destroy(world);
    }
}

/* More sensors than a move can report must not hide a wall. */
static void crowd_of_sensors_hides_no_wall(void **state) {
    (void)state;
    for (int wants = 0; wants < 2; wants++) {
        thud_world *world = make_world(weightless());
        thud_mover mover = box_mover(0, 0);
        thud_mover_report report;
        mover.filter.sensors = wants;
        for (int i = 0; i < 60; i++) {
            add_sensor(world, 0.05 * i, 0, 0.5f, 0.5f);
        }
        add_shape(world, add_body(world, THUD_BODY_STATIC, 5, 0, 0), 0.5f, 2, true, NULL);
        OK(thud_mover_move(world, &mover, (thud_vec2){30, 0}, 1, &report));
        near_to(mover.shape.x, 4.2 - mover.skin, 1e-6);
        assert_int_equal(report.sensor_count, wants ? THUD_MOVER_SENSORS : 0);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hero_s_body_collects_coins),
        cmocka_unit_test(sensors_stop_no_mover_whatever_its_filter),
        cmocka_unit_test(mover_reports_the_sensors_on_its_way_once_and_in_order),
        cmocka_unit_test(sensor_above_a_step_too_high_is_not_reported),
        cmocka_unit_test(crowd_of_sensors_hides_no_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
