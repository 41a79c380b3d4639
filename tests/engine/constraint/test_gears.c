/* test_gears.c: gear joints (their ratio, momentum, life time and input), filter joints, which
 * switch collisions of two bodies off, and joints that break at a force or a torque. */
#include "joint_support.h"
#include "snapshot_support.h"

#include "state/world.h"

static const thud_vec2 middle = {0, 0};

/* ---- gears ---- */

/* Two wheels on axles, coupled by a gear. */
typedef struct train {
    thud_world *world;
    thud_body_id wall, wheel[2];
    thud_joint_id axle[2], gear;
} train;

/* Two wheels of radius 1 and 0.5 on axles, with a gear of this ratio. */
static train make_train(const thud_quality *quality, double ratio) {
    train t = {.world = world_at(quality)};
    t.wall = add_body(t.world, THUD_BODY_STATIC, 0, 0, 0);
    for (int i = 0; i < 2; i++) {
        t.wheel[i] = add_ball(t.world, 2 * i, 0, 1 - 0.5f * (float)i);
        t.axle[i] = make(t.world, between(THUD_JOINT_HINGE, t.wall, t.wheel[i],
                                          (thud_vec2){2 * (float)i, 0}, middle));
    }
    thud_joint_def def = thud_default_joint_def(THUD_JOINT_GEAR);
    def.gear[0] = t.axle[0];
    def.gear[1] = t.axle[1];
    def.ratio = (float)ratio;
    t.gear = make(t.world, def);
    return t;
}

/* The angular momentum given to the first wheel is shared: I1 w1 + I2 w2 / r is conserved, and w2 =
 * -w1 / r. */
static void gears_turn_together_over_many_turns(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        for (int k = 0; k < 2; k++) {
            double ratio = k ? -0.5 : 3.0;
            train t = make_train(qualities[q], ratio);
            OK(thud_body_set_velocity(t.world, t.wheel[0], middle, 20));
            run(t.world, 300);
            thud_body_state a = state_of(t.world, t.wheel[0]), b = state_of(t.world, t.wheel[1]);
            double shared = 20 * a.inertia / (a.inertia + b.inertia / (ratio * ratio));
            near_to(a.angular_velocity, shared, 1e-2 * shared);
            near_to(b.angular_velocity, -shared / ratio, 1e-2 * shared / fabs(ratio));
            near_to(joint_of(t.world, t.gear).angle_gap, 0, 2e-3);
            near_to(thud_step_error_of(t.world).joint_angle_max,
                    joint_of(t.world, t.gear).angle_gap, 1e-9);
            thud_world_destroy(t.world);
        }
    }
}

/* Two weights on ropes over pulleys: l1 + r l2 is conserved, and the acceleration is that of
 * Atwood's machine. */
static void gear_of_distances_is_a_pulley(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *world = world_at(qualities[q]);
        thud_body_id beam = add_body(world, THUD_BODY_STATIC, 0, 10, 0);
        thud_joint_def def = thud_default_joint_def(THUD_JOINT_GEAR);
        thud_body_id load[2];
        for (int i = 0; i < 2; i++) {
            load[i] = add_box(world, 2 * i, 5, 0.5f, i ? 1.0f : 0.5f);
            thud_joint_def rope =
                between(THUD_JOINT_DISTANCE, beam, load[i], (thud_vec2){2 * (float)i, 0}, middle);
            rope.drive[THUD_DIRECTION_ALONG].limited = true;
            rope.drive[THUD_DIRECTION_ALONG].lower = 0;
            rope.drive[THUD_DIRECTION_ALONG].upper = 20;
            def.gear[i] = make(world, rope);
        }
        thud_joint_id pulley = make(world, def);
        int steps = 60;
        run(world, steps);
        double time = steps / 60.0, a = 10 * (2.0 - 1.0) / (2.0 + 1.0);
        near_to(state_of(world, load[0]).position.y, 5 + 0.5 * a * time * time, 3e-2);
        near_to(state_of(world, load[1]).position.y, 5 - 0.5 * a * time * time, 3e-2);
        near_to(joint_of(world, pulley).gap, 0, 1e-3);
        thud_world_destroy(world);
    }
}

/* A gear does not act while one of its joints is disabled, and is destroyed with it; no constraint
 * is left. */
static void gear_lets_go_with_a_joint_and_goes_with_it(void **state) {
    (void)state;
    train t = make_train(&thud_quality_default, 1);
    OK(thud_joint_set_enabled(t.world, t.axle[1], false));
    OK(thud_body_set_enabled(t.world, t.wheel[1], true));
    OK(thud_body_set_velocity(t.world, t.wheel[0], middle, 5));
    run(t.world, 10);
    near_to(state_of(t.world, t.wheel[0]).angular_velocity, 5, 1e-4);
    OK(thud_joint_set_enabled(t.world, t.axle[1], true));
    run(t.world, 60);
    assert_true(state_of(t.world, t.wheel[0]).angular_velocity < 4.9);
    near_to(joint_of(t.world, t.gear).angle_gap, 0, 2e-3);
    OK(thud_joint_destroy(t.world, t.axle[1]));
    assert_false(thud_joint_is_valid(t.world, t.gear));
    run(t.world, 1);
    assert_int_equal(t.world->joints.live, 1);
    int count;
    OK(thud_world_get_joints(t.world, NULL, 0, &count));
    assert_int_equal(count, 1);
    OK(thud_body_destroy(t.world, t.wheel[0]));
    run(t.world, 1);
    assert_int_equal(t.world->joints.live + t.world->constraints.live, 0);
    thud_world_destroy(t.world);
}

/* A wheel turns by several turns while the other one, or the gear, is disabled. The gear then holds
 * both where they are: whole turns that it has not counted do not make it jump. */
static void gear_holds_both_wheels_where_they_are_when_it_acts_again(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        for (int k = 0; k < 2; k++) {
            train t = make_train(qualities[q], 1);
            run(t.world, 5);
            OK(k ? thud_joint_set_enabled(t.world, t.gear, false)
                 : thud_body_set_enabled(t.world, t.wheel[1], false));
            OK(thud_body_set_velocity(t.world, t.wheel[0], middle, 20));
            run(t.world, 50); /* 2.65 turns */
            near_to(state_of(t.world, t.wheel[0]).angular_velocity, 20, 1e-3);
            OK(thud_body_set_velocity(t.world, t.wheel[0], middle, 0));
            OK(k ? thud_joint_set_enabled(t.world, t.gear, true)
                 : thud_body_set_enabled(t.world, t.wheel[1], true));
            for (int i = 0; i < 30; i++) {
                run(t.world, 1);
                near_to(state_of(t.world, t.wheel[0]).angular_velocity, 0, 1e-3);
                near_to(joint_of(t.world, t.gear).angle_gap, 0, 1e-3);
            }
            OK(thud_body_set_velocity(t.world, t.wheel[0], middle, 5));
            run(t.world, 30);
            thud_body_state a = state_of(t.world, t.wheel[0]), b = state_of(t.world, t.wheel[1]);
            near_to(a.angular_velocity, -b.angular_velocity, 1e-2);
            assert_true(b.angular_velocity < -1);
            thud_world_destroy(t.world);
        }
    }
}

/* The def of a gear is read back, and lists contain it until one of its joints is destroyed. */
static void gear_is_read_as_it_was_made_and_listed_while_it_is_there(void **state) {
    (void)state;
    train t = make_train(&thud_quality_default, -2.5);
    thud_joint_def def;
    OK(thud_joint_get_def(t.world, t.gear, &def));
    assert_true(def.kind == THUD_JOINT_GEAR && def.ratio == -2.5f && def.collide_connected);
    assert_memory_equal(def.gear, t.axle, sizeof def.gear);
    thud_joint_id listed[3];
    int count;
    OK(thud_world_get_joints(t.world, listed, 3, &count));
    assert_int_equal(count, 3);
    OK(thud_body_get_joints(t.world, t.wheel[1], listed, 3, &count));
    assert_int_equal(count, 2);
    OK(thud_joint_destroy(t.world, t.axle[0]));
    assert_false(thud_joint_is_valid(t.world, t.gear));
    OK(thud_world_get_joints(t.world, listed, 3, &count));
    assert_int_equal(count, 1);
    assert_int_equal(listed[0].index1, t.axle[1].index1);
    OK(thud_body_get_joints(t.world, t.wheel[1], listed, 3, &count));
    assert_int_equal(count, 1);
    thud_world_destroy(t.world);
}

static void gears_of_what_they_cannot_tie_are_refused(void **state) {
    (void)state;
    train t = make_train(&thud_quality_default, 1);
    thud_body_id box = add_box(t.world, 0, 3, 0.5f, 0.5f);
    thud_joint_id weld =
        make(t.world, between(THUD_JOINT_WELD, t.wall, box, (thud_vec2){0, 3}, middle));
    thud_joint_id loose =
        make(t.world, between(THUD_JOINT_HINGE, t.wheel[0], box, (thud_vec2){0, 3}, middle));
    thud_joint_def def = thud_default_joint_def(THUD_JOINT_GEAR);
    def.gear[0] = t.axle[0];
    const thud_joint_id bad[] = {t.axle[0], weld, loose, t.gear};
    for (int i = 0; i < 4; i++) {
        def.gear[1] = bad[i];
        assert_int_equal(thud_joint_create(t.world, &def, NULL), THUD_ERROR_INVALID);
    }
    def.gear[1] = t.axle[1];
    def.ratio = 0;
    assert_int_equal(thud_joint_create(t.world, &def, NULL), THUD_ERROR_INVALID);
    def.gear[1] = (thud_joint_id){0};
    assert_int_equal(thud_joint_create(t.world, &def, NULL), THUD_ERROR_STALE);
    assert_int_equal(thud_joint_set_frame(t.world, t.gear, 0, (thud_joint_frame){{0, 0}, 0}),
                     THUD_ERROR_INVALID);
    thud_world_destroy(t.world);
}

static void gears_go_on_from_snapshots(void **state) {
    (void)state;
    train t = make_train(&thud_quality_default, 2.5);
    OK(thud_body_set_velocity(t.world, t.wheel[0], middle, 30));
    run(t.world, 100);
    saved then = save(t.world);
    run(t.world, 50);
    uint64_t hash = thud_hash_of(t.world);
    back_to(t.world, then);
    run(t.world, 50);
    assert_true(thud_hash_of(t.world) == hash);
    free(then.bytes);
    thud_world_destroy(t.world);
}

/* ---- filters ---- */

static void filtered_bodies_fall_through_each_other(void **state) {
    (void)state;
    thud_world *world = make_world(def_of(&thud_quality_default));
    add_floor(world, NULL);
    thud_body_id lower = add_box(world, 0, 0.5, 0.5f, 0.5f);
    thud_body_id upper = add_box(world, 0, 1.5, 0.5f, 0.5f);
    run(world, 120);
    assert_false(state_of(world, upper).awake);
    thud_joint_id filter = make(world, between(THUD_JOINT_FILTER, lower, upper, middle, middle));
    run(world, 120);
    near_to(state_of(world, upper).position.y, 0.5, 1e-2);
    assert_false(state_of(world, upper).awake);
    thud_joint_id list[2];
    int count;
    OK(thud_body_get_joints(world, upper, list, 2, &count));
    assert_int_equal(count, 1);
    assert_int_equal(list[0].index1, filter.index1);
    /* Waking one body leaves the other asleep: a filter joint does not join islands. */
    OK(thud_body_set_velocity(world, upper, (thud_vec2){0, 3}, 0));
    run(world, 10);
    assert_true(state_of(world, upper).awake);
    assert_false(state_of(world, lower).awake);
    run(world, 120);
    near_to(state_of(world, upper).position.y, 0.5, 1e-2);
    OK(thud_joint_destroy(world, filter));
    run(world, 120);
    assert_true(fabs(state_of(world, upper).position.y - state_of(world, lower).position.y) > 0.9 ||
                fabs(state_of(world, upper).position.x - state_of(world, lower).position.x) > 0.9);
    thud_world_destroy(world);
}

/* ---- breaking ---- */

/* Two balls hang in a row from a hook: the upper joint carries the weight of both. */
static void joint_breaks_where_it_bears_too_much(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        for (int reports = 0; reports < 2; reports++) {
            thud_world *world = world_at(qualities[q]);
            thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            thud_body_id ball = add_ball(world, 0, -1, 0.5f);
            double weight = 10 * state_of(world, ball).mass;
            thud_joint_def def = between(THUD_JOINT_DISTANCE, hook, ball, middle, middle);
            def.only_reports = reports;
            def.user_data = 7;
            thud_joint_id rod = make(world, def);
            run(world, 120);
            near_to(joint_of(world, rod).force.y, weight, 1e-2 * weight);
            int count = 0;
            OK(thud_joint_set_breaking(world, rod, (float)(1.1 * weight), THUD_JOINT_FORCE_MAX,
                                       reports));
            run(world, 10);
            thud_joint_events_of(world, &count);
            assert_int_equal(count, 0);
            OK(thud_joint_set_breaking(world, rod, (float)(0.9 * weight), THUD_JOINT_FORCE_MAX,
                                       reports));
            run(world, 1);
            const thud_joint_event *event = thud_joint_events_of(world, &count);
            assert_int_equal(count, 1);
            near_to(event->force, weight, 1e-2 * weight);
            assert_true(event->broken == !reports && event->user_data == 7);
            assert_int_equal(event->joint.index1, rod.index1);
            assert_int_equal(thud_joint_is_valid(world, rod), reports);
            run(world, 1);
            thud_joint_events_of(world, &count);
            assert_int_equal(count, reports);
            run(world, 30);
            assert_int_equal(state_of(world, ball).position.y < -1.5, !reports);
            thud_world_destroy(world);
        }
    }
}

static void torque_breaks_a_weld(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id arm = add_box(world, 1, 0, 1.0f, 0.1f);
    thud_joint_def def = between(THUD_JOINT_WELD, wall, arm, middle, (thud_vec2){-1, 0});
    double torque = 10 * state_of(world, arm).mass;
    def.break_torque = (float)(0.8 * torque);
    thud_joint_id weld = make(world, def);
    int steps = 0;
    while (thud_joint_is_valid(world, weld) && steps < 60) {
        run(world, 1);
        steps++;
    }
    assert_true(steps < 60);
    saved then = save(world);
    int count = 0;
    run(world, 1);
    back_to(world, then);
    const thud_joint_event *event = thud_joint_events_of(world, &count);
    assert_int_equal(count, 1);
    assert_true(event->torque > 0.8 * torque && event->torque < 2 * torque);
    assert_int_equal(world->breakable, 0);
    free(then.bytes);
    thud_world_destroy(world);
}

static void wrong_breaking_is_refused(void **state) {
    (void)state;
    train t = make_train(&thud_quality_default, 1);
    assert_int_equal(thud_joint_set_breaking(t.world, t.gear, -1, 1, false), THUD_ERROR_INVALID);
    assert_int_equal(thud_joint_set_breaking(t.world, t.gear, 1, NAN, false), THUD_ERROR_INVALID);
    thud_joint_def def = between(THUD_JOINT_WELD, t.wall, t.wheel[0], middle, middle);
    def.break_force = NAN;
    assert_int_equal(thud_joint_create(t.world, &def, NULL), THUD_ERROR_INVALID);
    assert_int_equal(t.world->breakable, 0);
    assert_null(thud_joint_events_of(NULL, NULL));
    thud_world_destroy(t.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gears_turn_together_over_many_turns),
        cmocka_unit_test(gear_of_distances_is_a_pulley),
        cmocka_unit_test(gear_lets_go_with_a_joint_and_goes_with_it),
        cmocka_unit_test(gear_holds_both_wheels_where_they_are_when_it_acts_again),
        cmocka_unit_test(gear_is_read_as_it_was_made_and_listed_while_it_is_there),
        cmocka_unit_test(gears_of_what_they_cannot_tie_are_refused),
        cmocka_unit_test(gears_go_on_from_snapshots),
        cmocka_unit_test(filtered_bodies_fall_through_each_other),
        cmocka_unit_test(joint_breaks_where_it_bears_too_much),
        cmocka_unit_test(torque_breaks_a_weld),
        cmocka_unit_test(wrong_breaking_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
