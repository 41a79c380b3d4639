/* test_locks.c: bodies whose x or y is locked (thud_locks.h): how far loads and impacts move them
 * off their line, and how locks follow edits of bodies, snapshots and destruction. */
#include "every_choice.h"
#include "some_threads.h"
#include "snapshot_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_joint.h>
#include <thud/thud_lists.h>
#include <thud/thud_locks.h>

/* Sets the locks of a body, and asserts that they are read back. */
static void lock(thud_world *world, thud_body_id body, bool x, bool y) {
    bool has_x = !x, has_y = !y;
    OK(thud_body_set_locks(world, body, x, y));
    OK(thud_body_get_locks(world, body, &has_x, &has_y));
    assert_int_equal(has_x, x);
    assert_int_equal(has_y, y);
}

static thud_world *world_of(int quality, thud_world_def def) {
    def.quality = qualities[quality];
    return make_world(def);
}

static double x_of(const thud_world *world, thud_body_id body) {
    return state_of(world, body).position.x;
}

static double y_of(const thud_world *world, thud_body_id body) {
    return state_of(world, body).position.y;
}

/* ---- how well locks hold ---- */

/* The locked coordinate is held within 2e-4 m, at every quality and detection, and the other
 * follows a free body. */
static void locked_axis_takes_no_gravity_and_the_other_is_free(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES * 4; i++) {
        thud_world_def def = thud_default_world_def();
        def.gravity = (thud_vec2){3, -10};
        def.detection = detections[i % 4];
        thud_world *world = world_of(i / 4, def);
        thud_body_id free = add_ball(world, 0, 50, 0.5f), x = add_ball(world, 10, 50, 0.5f);
        thud_body_id y = add_ball(world, 20.25, 50, 0.5f), both = add_ball(world, -10, 50, 0.5f);
        lock(world, x, true, false);
        lock(world, y, false, true);
        lock(world, both, true, true);
        for (int k = 0; k < 120; k++) {
            run(world, 1);
            thud_pos at = state_of(world, free).position;
            near_to(x_of(world, x), 10, 2e-4);
            near_to(y_of(world, x), at.y, 0.1); /* `swept` may move it along a parabola */
            near_to(x_of(world, y), 20.25 + at.x, 0.03);
            near_to(y_of(world, y), 50, 2e-4);
            near_to(x_of(world, both), -10, 2e-4);
            near_to(y_of(world, both), 50, 2e-4);
        }
        thud_world_destroy(world);
    }
}

/* An hour of steps: the locked coordinate does not drift. */
static void lock_does_not_drift(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    thud_world *world = make_world(def);
    thud_body_id body = add_box(world, 3.3, 5.7, 0.5f, 0.5f);
    lock(world, body, false, true);
    OK(thud_body_set_velocity(world, body, (thud_vec2){0.5f, 0}, 1));
    for (int i = 0; i < 3600; i++) {
        run(world, 60);
        near_to(y_of(world, body), 5.7, 1e-4);
    }
    thud_body_state s = state_of(world, body);
    near_to(s.position.x, 3.3 + 1800, 0.01);
    near_to((double)s.angular_velocity, 1, 1e-4);
    thud_world_destroy(world);
}

/* A platform locked in y carries a load of up to 100,000 times its density; `worst` is how far it
 * leaves its line, in metres. */
static void platform_bears_what_is_heavier(void **state) {
    (void)state;
    static const double worst[QUALITIES] = {0.04, 1e-3, 1e-6, 1e-6};
    for (int q = 0; q < QUALITIES; q++) {
        for (int heavy = 1; heavy <= (q ? 100000 : 100); heavy *= 10) {
            thud_world *world = world_of(q, thud_default_world_def());
            thud_body_id platform = add_box(world, 0, 0, 2, 0.25f);
            thud_body_id load = add_body(world, THUD_BODY_DYNAMIC, 0.3, 0.75, 0);
            thud_shape_def def = thud_default_shape_def();
            def.density = (float)heavy;
            add_shape(world, load, 0.5f, 0.5f, false, &def);
            OK(thud_body_set_fixed_rotation(world, platform, true));
            lock(world, platform, false, true);
            for (int i = 0; i < 300; i++) {
                run(world, 1);
                near_to(y_of(world, platform), 0, worst[q]);
                near_to(y_of(world, load), 0.75, 5 * worst[q]);
            }
            assert_false(state_of(world, load).awake);
            thud_world_destroy(world);
        }
    }
}

/* Boxes locked in x fall on each other and keep their x within 2e-3 m. */
static void tower_of_locked_boxes_stands_and_falls_straight(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *world = world_of(q, thud_default_world_def());
        thud_body_id box[12];
        add_floor(world, NULL);
        /* each overhangs the next by far more than half of its width */
        for (int i = 0; i < 12; i++) {
            box[i] = add_box(world, 0.2 * i, 0.5 + 1.5 * i, 0.5f, 0.5f);
            OK(thud_body_set_fixed_rotation(world, box[i], true));
            lock(world, box[i], true, false);
        }
        for (int i = 0; i < 600; i++) {
            run(world, 1);
            for (int k = 0; k < 12; k++) {
                near_to(x_of(world, box[k]), 0.2 * k, 2e-3);
            }
        }
        /* the others have moved beyond the boxes that were below them */
        for (int k = 0; k < 5; k++) {
            near_to(y_of(world, box[k]), 0.5 + k, 0.05);
        }
        assert_false(state_of(world, box[11]).awake);
        thud_world_destroy(world);
    }
}

/* A ball at 400 m/s hits a post that is locked in x: the post moves by less than 5 mm and returns,
 * and the ball does not pass. */
static void fast_hit_leaves_it_on_its_line(void **state) {
    (void)state;
    for (int q = 1; q < QUALITIES; q++) {
        thud_world_def def = weightless();
        def.detection = &thud_detection_swept;
        thud_world *world = world_of(q, def);
        thud_body_id post = add_box(world, 0, 0, 0.5f, 2), ball = add_ball(world, -9, 0, 0.3f);
        OK(thud_body_set_fixed_rotation(world, post, true));
        lock(world, post, true, false);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){400, 0}, 0));
        for (int i = 0; i < 120; i++) {
            run(world, 1);
            near_to(x_of(world, post), 0, 5e-3);
            assert_true(x_of(world, ball) < -0.79);
        }
        near_to(x_of(world, post), 0, 1e-6);
        thud_world_destroy(world);
    }
}

/* Locks hold at distances of up to 9e8 from the origin. */
static void far_away_it_holds_as_well(void **state) {
    (void)state;
    static const double places[] = {1e5, -1e7, 9e8};
    for (int i = 0; i < 3; i++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_body_id near_one = add_ball(world, 0, 0, 0.5f);
        thud_body_id body = add_ball(world, places[i] + 0.3, places[i] / 2, 0.5f);
        lock(world, near_one, true, true);
        lock(world, body, true, true);
        run(world, 300);
        near_to(x_of(world, body), places[i] + 0.3, 1e-4);
        near_to(y_of(world, body), places[i] / 2, 1e-4);
        thud_world_destroy(world);
    }
}

/* ---- edits ---- */

/* Each combination of locks can be set after each other. Locks are one joint of the body, which may
 * also be destroyed. */
static void locks_change_and_go(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id body = add_ball(world, 0, 0, 0.5f);
    thud_joint_id joint;
    int count;
    for (int i = 0; i < 16; i++) {
        lock(world, body, i & 1, i & 2);
        OK(thud_body_get_joints(world, body, &joint, 1, &count));
        assert_int_equal(count, (i & 3) != 0);
        run(world, i & 4 ? 1 : 0);
    }
    lock(world, body, true, true);
    OK(thud_body_set_locks(world, body, true, true));
    OK(thud_body_get_joints(world, body, &joint, 1, &count));
    assert_int_equal(count, 1);
    run(world, 120);
    assert_true(y_of(world, body) > -0.2);
    OK(thud_joint_destroy(world, joint));
    bool x = true, y = true;
    OK(thud_body_get_locks(world, body, &x, NULL));
    OK(thud_body_get_locks(world, body, NULL, &y));
    assert_false(x || y);
    run(world, 60);
    assert_true(y_of(world, body) < -3);
    thud_world_destroy(world);
}

/* Locks are held by an anchor body of the engine's own. It is in no list, and is destroyed with the
 * last lock. */
/* The hash covers the caller's bodies and not the anchor of locks, which is destroyed in the next
 * step; a step that fails for want of memory must not change the hash by that. */
static void locks_are_not_in_the_hash(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id ball = add_ball(world, 0, 0, 0.5f);
    uint64_t hash = thud_hash_of(world);
    lock(world, ball, true, true);
    assert_true(thud_hash_of(world) == hash);
    lock(world, ball, false, false);
    assert_true(thud_hash_of(world) == hash);
    thud_world_destroy(world);
}

/* Locked bodies are created and destroyed; lists contain the body and not the anchor, and nothing
 * is left. */
static void bodies_come_and_go_with_their_locks(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    for (int i = 0; i < 300; i++) {
        thud_body_id body = add_ball(world, i, 0, 0.4f), listed[4];
        int count, moved = -1;
        lock(world, body, i & 1, true);
        run(world, i % 3);
        OK(thud_world_get_bodies(world, listed, 4, &count));
        assert_int_equal(count, 1);
        assert_memory_equal(&listed[0], &body, sizeof body);
        OK(thud_world_get_awake_bodies(world, NULL, 0, &moved));
        assert_int_equal(moved, 1);
        assert_int_equal(thud_stats_of(world).bodies, 2);
        OK(thud_body_destroy(world, body));
        run(world, 1);
        OK(thud_world_get_joints(world, NULL, 0, &count));
        assert_int_equal(count, 0);
        assert_int_equal(thud_stats_of(world).bodies, 0);
    }
    thud_world_destroy(world);
}

/* An epilogue that moves a body and tries to unlock it, which is refused inside a callback. */
static thud_body_id moved_inside;

static void put_it(thud_world *world, const thud_contact *contact, void *context) {
    (void)contact, (void)context;
    OK(thud_body_set_transform(world, moved_inside, (thud_pos){40, 9}, 0));
    assert_int_equal(thud_body_set_locks(world, moved_inside, false, false), THUD_ERROR_LOCKED);
}

/* A locked body that is moved by thud_body_set_transform is held at the new place: awake or asleep,
 * and inside a callback. */
static void lock_holds_where_its_body_is_put(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_body_id body = add_ball(world, 0, 5, 0.5f);
        lock(world, body, i & 1, true);
        run(world, i & 2 ? 200 : 0);
        assert_int_equal(state_of(world, body).awake, !(i & 2));
        OK(thud_body_set_transform(world, body, (thud_pos){20.3, 7.7}, 1));
        for (int k = 0; k < 100; k++) {
            run(world, 1);
            near_to(x_of(world, body), 20.3, 2e-4);
            near_to(y_of(world, body), 7.7, 2e-4);
        }
        moved_inside = body;
        add_floor(world, NULL);
        add_ball(world, -9, 0.45, 0.5f);
        set_listeners(world, NULL, put_it, NULL);
        run(world, 1);
        set_listeners(world, NULL, NULL, NULL);
        run(world, 30);
        near_to(x_of(world, body), 40, 2e-4);
        near_to(y_of(world, body), 9, 2e-4);
        thud_world_destroy(world);
    }
}

/* A lock holds the centre of mass, also where shapes move it. */
static void lock_follows_the_centre_of_mass(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id body = add_box(world, 0, 5, 1, 0.5f);
    thud_shape_def def = thud_default_shape_def();
    lock(world, body, true, true);
    run(world, 10);
    OK(thud_shape_create_circle(world, body, &def, (thud_vec2){2, 0}, 0.8f, NULL));
    thud_body_state s = state_of(world, body);
    thud_pos center = s.center;
    assert_true(center.x > 0.5);
    OK(thud_body_set_velocity(world, body, (thud_vec2){0, 0}, 5));
    for (int i = 0; i < 100; i++) {
        run(world, 1);
        s = state_of(world, body);
        near_to(s.center.x, center.x, 1e-3);
        near_to(s.center.y, center.y, 1e-3);
    }
    near_to((double)s.angular_velocity, 5, 0.01);
    thud_world_destroy(world);
}

/* A locked body may sleep; its kind cannot be changed while it is locked. */
static void locked_body_sleeps_and_stays_dynamic(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id body = add_ball(world, 0, 5, 0.5f);
    lock(world, body, true, true);
    run(world, 100);
    assert_false(state_of(world, body).awake);
    double y = y_of(world, body);
    assert_int_equal(thud_body_set_kind(world, body, THUD_BODY_STATIC), THUD_ERROR_INVALID);
    assert_int_equal(thud_body_set_kind(world, body, THUD_BODY_KINEMATIC), THUD_ERROR_INVALID);
    OK(thud_body_set_enabled(world, body, false));
    run(world, 2);
    OK(thud_body_set_enabled(world, body, true));
    run(world, 60);
    near_to(y_of(world, body), y, 1e-4);
    lock(world, body, false, false);
    run(world, 30);
    assert_true(y_of(world, body) < 4.5);
    OK(thud_body_set_kind(world, body, THUD_BODY_STATIC));
    thud_world_destroy(world);
}

/* ---- snapshots, workers ---- */

/* A world of 40 boxes, two thirds of which are locked in x or y. */
static thud_world *make_rails(thud_job_system job_system) {
    thud_world_def def = thud_default_world_def();
    def.job_system = job_system;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    for (int i = 0; i < 40; i++) {
        thud_body_id body = add_box(world, i % 8, 1 + 1.2 * (i / 8), 0.45f, 0.4f);
        if (i % 3) {
            lock(world, body, i % 3 == 1, i % 4 == 1);
        }
    }
    return world;
}

static void snapshots_have_the_locks(void **state) {
    (void)state;
    thud_world *world = make_rails((thud_job_system){0}),
               *other = make_world(thud_default_world_def());
    run(world, 20);
    saved here = save(world);
    trail way = walk(world, 120);
    back_to(world, here);
    walks_again(world, &way, "the same world");
    add_box(other, 0, 0, 1, 1);
    add_shape(other, add_body(other, THUD_BODY_STATIC, 0, 0, 0), 1, 1, true, NULL);
    OK(thud_world_use_joints(other));
    back_to(other, here);
    walks_again(other, &way, "another world");
    free(here.bytes);
    thud_world_destroy(world);
    thud_world_destroy(other);
}

static void any_number_of_workers_gives_the_same_bits(void **state) {
    (void)state;
    thud_world *alone = make_rails((thud_job_system){0});
    run(alone, 200);
    for (int workers = 2; workers <= 4; workers++) {
        thud_threads *p = some_threads(workers);
        thud_world *shared = make_rails(jobs_of_small_steps(p));
        run(shared, 200);
        assert_int_equal(thud_hash_of(shared), thud_hash_of(alone));
        thud_world_destroy(shared);
        thud_threads_destroy(p);
    }
    thud_world_destroy(alone);
}

/* ---- refused ---- */

static void wrong_input_is_refused(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id ball = add_ball(world, 0, 0, 1), wall = add_floor(world, NULL);
    thud_body_id lift = add_body(world, THUD_BODY_KINEMATIC, 0, 9, 0);
    bool x, y;
    assert_int_equal(thud_body_set_locks(NULL, ball, true, true), THUD_ERROR_NULL);
    assert_int_equal(thud_body_get_locks(NULL, ball, &x, &y), THUD_ERROR_NULL);
    assert_int_equal(thud_body_set_locks(world, wall, true, false), THUD_ERROR_INVALID);
    assert_int_equal(thud_body_set_locks(world, lift, true, false), THUD_ERROR_INVALID);
    OK(thud_body_get_locks(world, wall, &x, &y));
    assert_false(x || y);
    OK(thud_body_destroy(world, ball));
    assert_int_equal(thud_body_set_locks(world, ball, true, true), THUD_ERROR_STALE);
    assert_int_equal(thud_body_get_locks(world, ball, &x, &y), THUD_ERROR_STALE);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(locked_axis_takes_no_gravity_and_the_other_is_free),
        cmocka_unit_test(lock_does_not_drift),
        cmocka_unit_test(platform_bears_what_is_heavier),
        cmocka_unit_test(tower_of_locked_boxes_stands_and_falls_straight),
        cmocka_unit_test(fast_hit_leaves_it_on_its_line),
        cmocka_unit_test(far_away_it_holds_as_well),
        cmocka_unit_test(locks_change_and_go),
        cmocka_unit_test(locks_are_not_in_the_hash),
        cmocka_unit_test(bodies_come_and_go_with_their_locks),
        cmocka_unit_test(lock_holds_where_its_body_is_put),
        cmocka_unit_test(lock_follows_the_centre_of_mass),
        cmocka_unit_test(locked_body_sleeps_and_stays_dynamic),
        cmocka_unit_test(snapshots_have_the_locks),
        cmocka_unit_test(any_number_of_workers_gives_the_same_bits),
        cmocka_unit_test(wrong_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
