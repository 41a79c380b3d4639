/* test_next_event_pair.c: thud_world_next_event_pair, which lists the pairs of two categories that
 * met in a step: each pair once, whatever the order of shapes in the events, and only bodies that
 * still exist. */
#include "engine_support.h"

#include <thud/thud_lists.h>
#include <thud/thud_make.h>
#include <thud/thud_snapshot.h>

#include <limits.h>

enum { GROUND = 1, BALL = 2, COIN = 4, CRATE = 8 };

/* A body of a category: the ground is a static box, the others are circles, and a coin is a
 * weightless sensor. */
static thud_body_id make(thud_world *world, double x, double y, uint32_t category) {
    thud_body_options options = {.kind = category == GROUND ? THUD_BODY_STATIC : THUD_BODY_DYNAMIC,
                                 .category = category,
                                 .sensor = category == COIN,
                                 .weightless = category == COIN,
                                 .user_data = 10 * category};
    thud_geometry box = thud_aabb_at(x, y, 20, 1), ball = thud_circle_at(x, y, 0.5);
    return thud_body_make(world, category == GROUND ? box : ball, &options);
}

/* How many pairs of the two categories met in the last step. */
static int meetings(const thud_world *world, uint32_t first, uint32_t second) {
    int count = 0;
    for (thud_event_pair m = {0}; thud_world_next_event_pair(world, first, second, &m);) {
        count++;
    }
    return count;
}

/* Runs until bodies of the two categories meet. */
static void run_until(thud_world *world, uint32_t first, uint32_t second) {
    for (int i = 0; i < 300 && meetings(world, first, second) == 0; i++) {
        run(world, 1);
    }
}

static bool same(thud_body_id a, thud_body_id b) {
    return a.index1 == b.index1 && a.generation == b.generation;
}

/* Side a of a meeting is of the first category asked for, whatever the order of shapes in the
 * event. */
static void first_kind_comes_first_whatever_the_event_has(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id ground = make(world, 0, -1, GROUND), ball = make(world, 0, 3, BALL);
    run_until(world, BALL, GROUND);
    for (int turned = 0; turned < 2; turned++) {
        thud_event_pair m = {0};
        assert_true(turned ? thud_world_next_event_pair(world, BALL, GROUND, &m)
                           : thud_world_next_event_pair(world, GROUND, BALL, &m));
        assert_true(same(m.a.body, turned ? ball : ground));
        assert_true(same(m.b.body, turned ? ground : ball));
        assert_int_equal(m.a.body_data, turned ? 10 * BALL : 10 * GROUND);
        assert_int_equal(m.b.shape_data, turned ? 10 * GROUND : 10 * BALL);
        thud_body_id whose;
        thud_shape_state shape;
        OK(thud_shape_get_state(world, m.shape_a, &shape));
        whose = shape.body;
        assert_true(same(whose, m.a.body));
        assert_false(turned ? thud_world_next_event_pair(world, BALL, GROUND, &m)
                            : thud_world_next_event_pair(world, GROUND, BALL, &m));
        assert_true(m.a.body.index1 == 0 && m.shape_b.index1 == 0 && m.next > 0);
    }
    assert_int_equal(meetings(world, GROUND, CRATE), 0);
    assert_int_equal(meetings(world, BALL, BALL), 0);
    assert_int_equal(meetings(world, GROUND | BALL, GROUND | BALL), 1);
    thud_world_destroy(world);
}

/* A fast ball begins to touch and has a hit in the same step, and counts once; a hit without a
 * begin counts as well. */
static void pair_is_told_once_a_step(void **state) {
    (void)state;
    int both = 0, hits = 0;
    for (int restitution = 0; restitution < 2; restitution++) {
        thud_world *world = make_world(thud_default_world_def());
        make(world, 0, -1, GROUND);
        for (int i = 0; i < 20; i++) {
            thud_body_options ball = {.kind = THUD_BODY_DYNAMIC,
                                      .category = BALL,
                                      .restitution = (float)restitution,
                                      .detection = i % 2 ? &thud_detection_swept : NULL};
            thud_body_make(world, thud_circle_at(2 * i - 19, 1 + 0.13 * i, 0.5), &ball);
        }
        for (int i = 0; i < 120; i++) {
            run(world, 1);
            thud_events e = thud_events_of(world);
            int pairs = e.begin_count;
            for (int h = 0; h < e.hit_count; h++) {
                bool began = false;
                for (int b = 0; b < e.begin_count; b++) {
                    began |= e.begin[b].shape_b.index1 == e.hit[h].shape_b.index1;
                }
                both += began;
                hits += !began;
                pairs += !began;
            }
            assert_int_equal(meetings(world, GROUND, BALL), pairs);
        }
        thud_world_destroy(world);
    }
    print_message("%d pairs hit as they begin to touch, %d hit alone\n", both, hits);
    assert_true(both > 0 && hits > 0);
}

/* A sensor meets a body in the step in which their overlap begins, and in no later one. */
static void sensors_meet_what_they_begin_to_overlap(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id coin = make(world, 0, 1, COIN), ball = make(world, 0, 3, BALL);
    run_until(world, BALL, COIN);
    thud_event_pair m = {0};
    assert_true(thud_world_next_event_pair(world, BALL, COIN, &m));
    assert_true(same(m.a.body, ball) && same(m.b.body, coin) && m.b.sensor && !m.a.sensor);
    run(world, 1);
    assert_int_equal(meetings(world, BALL, COIN), 0); /* the overlap continues and does not begin */
    thud_world_destroy(world);
}

/* Two sensors report two events, and count as one meeting. */
static void two_sensors_meet_once(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    make(world, 0, 0, COIN);
    make(world, 0.5, 0, COIN);
    run(world, 1);
    assert_int_equal(thud_events_of(world).sensor_begin_count, 2);
    assert_int_equal(meetings(world, COIN, COIN), 1);
    thud_world_destroy(world);
}

/* Bodies that are destroyed between two calls of thud_world_next_event_pair are not listed any
 * more. */
static void who_is_gone_has_met_nobody(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    make(world, 0, 0, COIN);
    for (int i = 0; i < 3; i++) {
        make(world, 0.1 * i, 0.2, CRATE);
    }
    run(world, 1);
    assert_int_equal(meetings(world, COIN, CRATE), 3);
    int count = 0;
    for (thud_event_pair m = {0}; thud_world_next_event_pair(world, COIN, CRATE, &m); count++) {
        if (count == 1) {
            OK(thud_body_destroy(world, m.a.body)); /* the coin: the third crate met nothing else */
            make(world, 9, 9, COIN);                /* reuses the slot of the coin */
        }
        OK(thud_body_destroy(world, m.b.body));
    }
    assert_int_equal(count, 2);
    assert_int_equal(meetings(world, COIN, CRATE), 0);
    thud_world_destroy(world);
}

/* A search for meetings ends where a step or a restore comes between two calls. */
static void new_step_or_older_snapshot_between_two_meetings_does_no_harm(void **state) {
    (void)state;
    static char bytes[1 << 16];
    size_t size;
    thud_world *world = make_world(thud_default_world_def());
    OK(thud_world_snapshot(world, bytes, sizeof bytes, &size));
    make(world, 0, 0, COIN);
    make(world, 0.2, 0.2, CRATE);
    make(world, -0.2, 0.2, CRATE);
    run(world, 1);
    thud_event_pair m = {0};
    assert_true(thud_world_next_event_pair(world, COIN, CRATE, &m));
    run(world, 1);
    assert_false(thud_world_next_event_pair(world, COIN, CRATE, &m));
    OK(thud_world_restore(world, bytes, size));
    assert_false(thud_world_next_event_pair(world, COIN, CRATE, &m));
    thud_world_destroy(world);
}

static int told;

static void hear(thud_result result, const char *message, void *context) {
    (void)message;
    *(thud_result *)context = result;
    told++;
}

static void wrong_questions_are_told(void **state) {
    (void)state;
    thud_result heard = THUD_OK;
    thud_world_def def = thud_default_world_def();
    def.log = hear;
    def.log_context = &heard;
    thud_world *world = make_world(def);
    thud_event_pair m = {.next = -1}, far = {.next = INT_MAX};
    told = 0;
    assert_false(thud_world_next_event_pair(NULL, 1, 1, &m));
    assert_false(thud_world_next_event_pair(world, 1, 1, NULL));
    assert_int_equal(heard, THUD_ERROR_NULL);
    assert_false(thud_world_next_event_pair(world, 1, 1, &m));
    assert_int_equal(heard, THUD_ERROR_INVALID);
    assert_int_equal(told, 2);
    assert_false(thud_world_next_event_pair(world, 1, 1, &far));
    assert_int_equal(told, 2);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(first_kind_comes_first_whatever_the_event_has),
        cmocka_unit_test(pair_is_told_once_a_step),
        cmocka_unit_test(sensors_meet_what_they_begin_to_overlap),
        cmocka_unit_test(two_sensors_meet_once),
        cmocka_unit_test(who_is_gone_has_met_nobody),
        cmocka_unit_test(new_step_or_older_snapshot_between_two_meetings_does_no_harm),
        cmocka_unit_test(wrong_questions_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
