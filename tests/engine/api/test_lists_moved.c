/* test_lists_moved.c: which bodies thud_world_get_moved_bodies lists as moved: after steps and
 * edits, asleep and quarantined, where a slot is reused, with too small arrays, and after a
 * restore. */
#include "lists_support.h"
#include "resolution_support.h"
#include "snapshot_support.h"

/* A body is listed as moved exactly where its pose differs from that when it was last listed; a new
 * body is. */
static void moved_are_those_whose_pose_is_another(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *world = make_world(thud_default_world_def_of(qualities[q]));
        watch w = {0};
        thud_body_id floor = add_floor(world, NULL),
                     lift = add_body(world, THUD_BODY_KINEMATIC, 9, 9, 0);
        thud_body_id box = add_kind(world, 2, 0, 1, NULL);
        assert_int_equal(look(&w, world), 3); /* all are new */
        assert_int_equal(look(&w, world), 0);
        run(world, 1);
        assert_int_equal(look(&w, world), 1);
        assert_true(told(&w, box));
        OK(thud_body_set_velocity(world, lift, (thud_vec2){1, 0}, 0));
        assert_int_equal(look(&w, world), 0);
        run(world, 1);
        assert_int_equal(look(&w, world), 2);
        OK(thud_body_set_velocity(world, lift, (thud_vec2){0, 0}, 0));
        thud_body_state before = state_of(world, box);
        for (int i = 0; i < 200; i++) {
            run(world, 1);
            look(&w, world);
            thud_body_state now = state_of(world, box);
            bool moved = now.position.x != before.position.x ||
                         now.position.y != before.position.y || now.angle != before.angle;
            assert_int_equal(told(&w, box), moved); /* also in the last step before it sleeps */
            assert_int_equal(w.count, moved);
            before = now;
        }
        assert_false(before.awake);
        OK(thud_body_set_awake(world, box, true));
        assert_int_equal(look(&w, world), 0); /* waking does not move it */
        OK(thud_body_set_transform(world, floor, (thud_pos){0, -2}, 0));
        assert_int_equal(look(&w, world), 1);
        OK(thud_body_set_transform(world, floor, (thud_pos){0, -2}, 0));
        assert_int_equal(look(&w, world), 0); /* set to where it is */
        OK(thud_body_set_enabled(world, box, false));
        run(world, 5);
        assert_int_equal(look(&w, world), 0);
        thud_world_destroy(world);
    }
}

/* A body that only rotates is listed as moved. */
static void body_that_turns_in_its_place_is_told(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    watch w = {0};
    thud_body_id mill = add_body(world, THUD_BODY_KINEMATIC, 1, 2, 0), post;
    add_shape(world, mill, 2, 0.1f, false, NULL);
    post = add_body(world, THUD_BODY_STATIC, 9, 9, 0);
    look(&w, world);
    OK(thud_body_set_velocity(world, mill, (thud_vec2){0, 0}, 0.5f));
    for (int i = 0; i < 10; i++) {
        run(world, 1);
        assert_int_equal(look(&w, world), 1);
        assert_true(told(&w, mill));
    }
    OK(thud_body_set_transform(world, post, (thud_pos){9, 9}, 1));
    assert_int_equal(look(&w, world), 1);
    assert_true(told(&w, post));
    assert_true(state_of(world, mill).position.x == 1 && state_of(world, mill).position.y == 2);
    thud_world_destroy(world);
}

static void quarantined_body_is_listed_and_moves_no_more(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id ball = add_ball(world, 0, 0, 0.5f), wild = add_ball(world, 5, 0, 0.5f);
    watch w = {0};
    OK(thud_body_set_velocity(world, ball, (thud_vec2){1, 0}, 0));
    OK(thud_body_set_velocity(world, wild, (thud_vec2){1, 0}, 0));
    run(world, 1);
    assert_int_equal(look(&w, world), 2);
    for (int i = 0; i < 2; i++) { /* twice, so that the sum overflows float */
        OK(thud_body_apply_center_force(world, wild, (thud_vec2){3e38f, 3e38f}));
        OK(thud_body_apply_torque(world, wild, 3e38f));
    }
    run(world, 1);
    assert_true(state_of(world, wild).quarantined);
    assert_int_equal(look(&w, world), 1);
    assert_true(told(&w, ball));
    assert_true(is_among_bodies(world, wild));
    assert_false(is_among_awake(world, wild));
    thud_world_destroy(world);
}

/* A body in the slot of a destroyed one is listed as moved, though its pose is the same. */
static void slot_of_another_is_told_as_moved(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    watch w = {0};
    thud_body_id old = add_ball(world, 0, 0, 0.5f), got;
    assert_int_equal(look(&w, world), 1);
    OK(thud_body_destroy(world, old));
    assert_int_equal(look(&w, world), 0);
    OK(thud_world_get_body_at(world, 0, &got));
    assert_int_equal(got.index1, 0);
    run(world, 1);
    thud_body_id young = add_ball(world, 0, 0, 0.5f);
    assert_int_equal(young.index1, old.index1);
    assert_int_equal(look(&w, world), 1);
    assert_true(told(&w, young));
    OK(thud_world_get_body_at(world, (int)young.index1 - 1, &got));
    assert_true(same_body(got, young));
    OK(thud_body_destroy(world, young)); /* and no call comes before its slot is used again */
    run(world, 1);
    thud_body_id third = add_ball(world, 0, 0, 0.5f);
    assert_int_equal(third.index1, old.index1);
    assert_int_equal(look(&w, world), 1);
    assert_true(told(&w, third));
    thud_world_destroy(world);
}

/* Moved bodies for which the list has no room are listed by later calls. Bodies whose slots are
 * beyond the caller's array of seen poses are not listed. */
static void moved_without_room_are_told_later_and_beyond_the_seen_never(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_seen seen[4] = {0};
    thud_body_id list[4], bodies[6];
    int count, order = 0;
    for (int i = 0; i < 6; i++) {
        bodies[i] = add_ball(world, 2 * i, 0, 0.5f);
    }
    OK(thud_world_get_moved_bodies(world, seen, 4, NULL, 0, &count));
    assert_int_equal(count, 4);
    for (int left = 4; left > 0; left -= 3) {
        memset(list, 0, sizeof list);
        OK(thud_world_get_moved_bodies(world, seen, 4, list, 3, &count));
        assert_int_equal(count, left);
        assert_int_equal(list[3].index1, 0);
        for (int i = 0; i < left && i < 3; i++) {
            assert_true(same_body(list[i], bodies[order++]));
        }
    }
    OK(thud_world_get_moved_bodies(world, seen, 4, list, 3, &count));
    assert_int_equal(count, 0);
    OK(thud_world_get_moved_bodies(world, NULL, 0, list, 3, &count));
    assert_int_equal(count, 0);
    thud_world_destroy(world);
}

/* After a restore, the bodies listed as moved are those that are elsewhere than when they were last
 * listed; the other lists are those of the snapshot's time. */
static void restore_tells_who_is_elsewhere(void **state) {
    (void)state;
    yard y = make_yard(NULL);
    watch w = {0};
    run(y.world, 20);
    int all = look(&w, y.world), awake[2], shapes[2], sensed[2];
    thud_shape_id sensor = {0};
    thud_shape_id list[ROOM];
    OK(thud_world_get_shapes(y.world, list, ROOM, &shapes[0]));
    for (int i = 0; i < shapes[0]; i++) {
        thud_shape_state s;
        OK(thud_shape_get_state(y.world, list[i], &s));
        sensor = s.sensor ? list[i] : sensor;
    }
    sensed[0] = sensed_by(y.world, sensor);
    assert_true(sensed[0] > 1);
    OK(thud_world_get_awake_bodies(y.world, NULL, 0, &awake[0]));
    saved kept = save(y.world);
    assert_int_equal(all, 16);
    OK(thud_body_destroy(y.world, y.box));
    run(y.world, 60);
    look(&w, y.world);
    back_to(y.world, kept);
    assert_int_equal(look(&w, y.world), 14); /* all bodies but the ground's and the sensor's */
    assert_true(told(&w, y.box));
    OK(thud_world_get_awake_bodies(y.world, NULL, 0, &awake[1]));
    OK(thud_world_get_shapes(y.world, NULL, 0, &shapes[1]));
    sensed[1] = sensed_by(y.world, sensor);
    assert_int_equal(awake[1], awake[0]);
    assert_int_equal(shapes[1], shapes[0]);
    assert_int_equal(sensed[1], sensed[0]);
    back_to(y.world, kept);
    assert_int_equal(look(&w, y.world), 0);
    free(kept.bytes);
    thud_world_destroy(y.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moved_are_those_whose_pose_is_another),
        cmocka_unit_test(body_that_turns_in_its_place_is_told),
        cmocka_unit_test(quarantined_body_is_listed_and_moves_no_more),
        cmocka_unit_test(slot_of_another_is_told_as_moved),
        cmocka_unit_test(moved_without_room_are_told_later_and_beyond_the_seen_never),
        cmocka_unit_test(restore_tells_who_is_elsewhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
