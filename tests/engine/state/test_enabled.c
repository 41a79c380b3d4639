/* test_enabled.c: bodies that are disabled leave the world, and come back unchanged when they are
 * enabled. */
#include "resolution_support.h"

static bool found(thud_world *world, double x, double y) {
    bool hit;
    OK(thud_world_cast_shape(world,
                             &(thud_shape_cast){(thud_pos){x, y}, thud_circle_at(0, 0, 0.01), 0, 0,
                                                NULL},
                             &hit, NULL));
    return hit;
}

/* A disabled body has no contacts, is not found by queries, and keeps its pose; when it is enabled
 * it continues with its velocity, awake. */
static void disabled_body_meets_nothing_and_comes_back_as_it_was(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int asleep = 0; asleep < 2; asleep++) {
            thud_world *world = make_world_with(detections[d], NULL, NULL, true);
            add_floor(world, NULL);
            thud_body_id below = add_kind(world, 2, 0, 0.5, NULL);
            thud_body_id above = add_kind(world, 2, 0, 1.5, NULL);
            run(world, asleep ? 150 : 10);
            assert_int_equal(state_of(world, below).awake, !asleep);
            OK(thud_body_set_enabled(world, below, false));
            assert_false(state_of(world, below).enabled);
            assert_false(found(world, 0, 0.5));
            run(world, 1);
            assert_int_equal(thud_events_of(world).end_count, 2);
            run(world, 60);
            near_to(state_of(world, above).position.y, 0.5, 0.02);
            near_to(state_of(world, below).position.y, 0.5, 0.02);
            assert_false(state_of(world, below).awake);
            OK(thud_body_set_transform(world, below, (thud_pos){5, 3.5}, 0));
            OK(thud_body_set_velocity(world, below, (thud_vec2){1, 0}, 0));
            run(world, 30);
            near_to(state_of(world, below).position.y, 3.5, 1e-6);
            OK(thud_body_set_enabled(world, below, true));
            assert_true(found(world, 5, 3.5));
            run(world, 1);
            assert_true(state_of(world, below).awake);
            near_to(state_of(world, below).position.x, 5 + 1.0 / 60, 1e-3);
            run(world, 90);
            near_to(state_of(world, below).position.y, 0.5, 0.02);
            thud_world_destroy(world);
        }
    }
}

/* A body that sleeps on the ground wakes and falls when the ground is disabled. */
static void disabled_ground_lets_fall_and_wakes_who_slept_on_it(void **state) {
    (void)state;
    for (int line = 0; line < 2; line++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
        thud_shape_def def = thud_default_shape_def();
        thud_body_id floor =
            line ? add_body(world, THUD_BODY_STATIC, 0, 0, 0) : add_floor(world, NULL);
        if (line) {
            OK(thud_shape_create_terrain(world, floor, &def, &flat, NULL));
        }
        thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
        run(world, 120);
        assert_false(state_of(world, ball).awake);
        OK(thud_body_set_enabled(world, floor, false));
        run(world, 6);
        assert_true(state_of(world, ball).position.y < 0.5 - 0.04);
        OK(thud_body_set_transform(world, ball, (thud_pos){0, 2}, 0));
        OK(thud_body_set_enabled(world, floor, true));
        run(world, 120);
        near_to(state_of(world, ball).position.y, 0.5, 0.01);
        thud_world_destroy(world);
    }
}

/* Next to a disabled box, the face of its neighbour is not covered any more. */
static void disabled_box_hides_no_face_of_its_neighbour(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id boxes[2];
    for (int i = 0; i < 2; i++) {
        boxes[i] = add_body(world, THUD_BODY_STATIC, 2 * i, 0, 0);
        add_shape(world, boxes[i], 1, 1, true, NULL);
    }
    run(world, 1);
    OK(thud_body_set_enabled(world, boxes[1], false));
    thud_body_id ball = add_ball(world, 3, 0, 0.5f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){-2, 0}, 0));
    run(world, 90);
    near_to(state_of(world, ball).position.x, 1.5, 0.02);
    thud_world_destroy(world);
}

static bool take_out(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    (void)settings;
    (void)context;
    OK(thud_body_set_enabled(world, contact->body_b, false));
    assert_true(state_of(world, contact->body_b).enabled); /* until the next step */
    return true;
}

static void body_disabled_inside_a_callback_leaves_with_the_next_step(void **state) {
    (void)state;
    thud_world *world = make_world_with(&thud_detection_overlap, take_out, NULL, true);
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    run(world, 1);
    assert_int_equal(thud_events_of(world).begin_count, 1);
    run(world, 1);
    assert_int_equal(thud_events_of(world).end_count, 1);
    assert_false(state_of(world, ball).enabled);
    thud_world_destroy(world);
}

static void enabling_what_is_no_body_is_refused(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    OK(thud_body_destroy(world, ball));
    assert_int_equal(thud_body_set_enabled(world, ball, true), THUD_ERROR_STALE);
    assert_int_equal(thud_body_set_enabled(NULL, ball, true), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(disabled_body_meets_nothing_and_comes_back_as_it_was),
        cmocka_unit_test(disabled_ground_lets_fall_and_wakes_who_slept_on_it),
        cmocka_unit_test(disabled_box_hides_no_face_of_its_neighbour),
        cmocka_unit_test(body_disabled_inside_a_callback_leaves_with_the_next_step),
        cmocka_unit_test(enabling_what_is_no_body_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
