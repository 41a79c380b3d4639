/* test_sleeping.c: islands fall asleep and wake as a whole, by every cause of waking, and sleeping
 * needs no further memory. */
#include "engine_support.h"

static thud_world *stack(thud_body_id boxes[5], thud_body_id *floor) {
    thud_world *world = make_world(thud_default_world_def());
    *floor = add_floor(world, NULL);
    for (int i = 0; i < 5; i++) {
        boxes[i] = add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    return world;
}

static int awake_of(thud_world *world) {
    return thud_stats_of(world).awake_bodies;
}

static void stack_sleeps_and_keeps_its_place(void **state) {
    (void)state;
    thud_body_id boxes[5], floor;
    thud_world *world = stack(boxes, &floor);
    run(world, 240);
    assert_int_equal(awake_of(world), 0);
    uint64_t hash = thud_hash_of(world);
    run(world, 600);
    assert_true(thud_hash_of(world) == hash);
    assert_int_equal(thud_stats_of(world).contacts, 5);
    thud_world_destroy(world);
}

static void stack_wakes_by_impact_impulse_gravity_and_loss_of_the_floor(void **state) {
    (void)state;
    for (int how = 0; how < 5; how++) {
        thud_body_id boxes[5], floor;
        thud_world *world = stack(boxes, &floor);
        run(world, 240);
        assert_int_equal(awake_of(world), 0);
        if (how == 0) {
            add_ball(world, 0, 6, 0.5f);
        } else if (how == 1) {
            OK(thud_body_apply_impulse(world, boxes[4], (thud_vec2){1, 0},
                                       state_of(world, boxes[4]).position));
        } else if (how == 2) {
            OK(thud_world_set_gravity(world, (thud_vec2){1, -10}));
        } else if (how == 3) {
            OK(thud_body_destroy(world, floor));
        } else {
            OK(thud_body_destroy(world, boxes[0]));
        }
        run(world, how == 0 ? 45 : 1);
        assert_int_equal(awake_of(world), how == 0 ? 6 : how == 4 ? 4 : 5);
        run(world, 5);
        assert_true(fabs(state_of(world, boxes[4]).position.y) < 10);
        thud_world_destroy(world);
    }
}

static void sleeping_and_waking_many_times_is_stable(void **state) {
    (void)state;
    thud_body_id boxes[5], floor;
    thud_world *world = stack(boxes, &floor);
    for (int i = 0; i < 20; i++) {
        run(world, 120);
        assert_int_equal(awake_of(world), 0);
        OK(thud_body_set_awake(world, boxes[i % 5], true));
        run(world, 1);
        assert_int_equal(awake_of(world), 5);
    }
    near_to(state_of(world, boxes[4]).position.y, 4.5, 0.05);
    near_to(state_of(world, boxes[4]).position.x, 0, 0.01);
    thud_world_destroy(world);
}

static void body_that_may_not_sleep_keeps_its_island_awake(void **state) {
    (void)state;
    thud_body_id boxes[5], floor;
    thud_world *world = stack(boxes, &floor);
    thud_body_def def = thud_default_body_def();
    thud_body_id restless;
    def.kind = THUD_BODY_DYNAMIC;
    def.may_sleep = false;
    def.position = (thud_pos){0, 5.5};
    OK(thud_body_create(world, &def, &restless));
    add_shape(world, restless, 0.5f, 0.5f, false, NULL);
    run(world, 300);
    assert_int_equal(awake_of(world), 6);
    thud_world_destroy(world);
}

/* A static body that is created next to a sleeping body is found when that wakes. */
static void woken_body_meets_what_came_meanwhile(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    run(world, 120);
    assert_int_equal(awake_of(world), 0);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0.75, 0.5, 0);
    add_shape(world, wall, 0.25f, 0.5f, true, NULL);
    run(world, 5);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){3, 0}, 0));
    run(world, 60);
    assert_true(state_of(world, ball).position.x < 0.1);
    thud_world_destroy(world);
}

/* Sleeping bodies keep the lanes of their contacts: falling asleep takes less memory than another
 * lane for each box. */
static void many_fall_asleep_in_the_room_that_they_have(void **state) {
    (void)state;
    enum { BOXES = 6000, LANE = 192 }; /* bytes of a lane with two points */
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    add_shape(world, floor, 2 * BOXES, 1, true, NULL);
    for (int i = 0; i < BOXES; i++) {
        add_box(world, 1.5 * (i - BOXES / 2), 0.5, 0.5f, 0.5f);
    }
    run(world, 10);
    uint64_t before = thud_stats_of(world).bytes;
    run(world, 50);
    assert_int_equal(awake_of(world), 0);
    uint64_t more = thud_stats_of(world).bytes - before;
    if (more > LANE * BOXES) {
        fail_msg("%d boxes take %d kB to fall asleep", BOXES, (int)(more / 1000));
    }
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stack_sleeps_and_keeps_its_place),
        cmocka_unit_test(stack_wakes_by_impact_impulse_gravity_and_loss_of_the_floor),
        cmocka_unit_test(sleeping_and_waking_many_times_is_stable),
        cmocka_unit_test(body_that_may_not_sleep_keeps_its_island_awake),
        cmocka_unit_test(woken_body_meets_what_came_meanwhile),
        cmocka_unit_test(many_fall_asleep_in_the_room_that_they_have),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
