/* test_forces.c: forces, targets of bodies, points of bodies, and functions that read a single
 * value (thud_forces.h, thud_reads.h, thud_version.h). */
#include "engine_support.h"

#include <thud/thud_forces.h>
#include <thud/thud_reads.h>
#include <float.h>
#include <thud/thud_version.h>

static thud_body_state get(thud_world *world, thud_body_id body) {
    thud_body_state state;
    OK(thud_body_get_state(world, body, &state));
    return state;
}

static void near(double a, double b, double tolerance) {
    assert_true(fabs(a - b) <= tolerance);
}

/* A force off the centre of mass accelerates and rotates by its lever arm, for one step; impulses
 * act at once. */
static void forces_turn_by_their_arm_for_one_step(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world_def def = weightless();
        def.quality = qualities[q];
        thud_world *world = make_world(def);
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 3, 4, 0);
        add_shape(world, box, 0.5f, 0.5f, false, NULL);
        thud_body_state b = get(world, box);
        OK(thud_body_apply_force(world, box, (thud_vec2){0, 6}, (thud_pos){3.5, 4}));
        for (int i = 0; i < 2; i++) {
            OK(thud_world_step(world));
            near((double)get(world, box).velocity.y, 0.1 / (double)b.mass, 1e-5);
            near((double)get(world, box).angular_velocity, 0.05 / (double)b.inertia, 1e-4);
        }
        OK(thud_body_apply_center_impulse(world, box, (thud_vec2){2, 0}));
        OK(thud_body_apply_angular_impulse(world, box, -0.05f));
        near((double)get(world, box).velocity.x, 2 / (double)b.mass, 1e-5);
        near((double)get(world, box).angular_velocity, 0, 1e-4);
        thud_world_destroy(world);
    }
}

/* A great impulse has a moment that no float holds; a body that cannot turn takes none of it. */
static void great_impulse_leaves_a_body_that_cannot_turn_without_spin(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world_def def = weightless();
        def.quality = qualities[q];
        thud_world *world = make_world(def);
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
        add_shape(world, box, 0.5f, 0.5f, true, NULL);
        OK(thud_body_apply_impulse(world, box, (thud_vec2){0, 3e38f}, (thud_pos){1e6, 0}));
        assert_true(get(world, box).angular_velocity == 0);
        OK(thud_world_step(world));
        assert_true(!get(world, box).quarantined && get(world, box).velocity.y > 0);
        thud_world_destroy(world);
    }
}

static void sleeping_bodies_wake_and_disabled_ones_forget_forces(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
    add_shape(world, floor, 5, 1, true, NULL);
    add_shape(world, ball, 0.5f, 0, false, NULL);
    for (int i = 0; i < 150; i++) {
        OK(thud_world_step(world));
    }
    assert_false(get(world, ball).awake);
    thud_pos at = get(world, ball).center;
    OK(thud_body_apply_force(world, ball, (thud_vec2){0, 100}, at));
    OK(thud_world_step(world));
    assert_true(get(world, ball).awake && get(world, ball).velocity.y > 0.5f);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 0}, 0));
    OK(thud_body_set_enabled(world, ball, false));
    OK(thud_world_step(world));
    OK(thud_body_apply_force(world, ball, (thud_vec2){1000, 0}, at));
    OK(thud_body_apply_center_impulse(world, ball, (thud_vec2){0, 3}));
    OK(thud_body_set_enabled(world, ball, true));
    OK(thud_world_step(world));
    near((double)get(world, ball).velocity.x, 0, 1e-6);
    assert_true(get(world, ball).velocity.y > 2);
    assert_int_equal(thud_body_apply_force(world, floor, (thud_vec2){1, 0}, at),
                     THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

/* A kinematic body with a target is at its place and angle after one step, with and without
 * damping. */
static void targets_are_reached_in_one_step(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES * 2; q++) {
        thud_world_def def = thud_default_world_def_of(qualities[q / 2]);
        thud_world *world = make_world(def);
        thud_body_def body = thud_default_body_def();
        thud_body_id lift;
        body.kind = THUD_BODY_KINEMATIC;
        body.linear_damping = body.angular_damping = q % 2 ? 5 : 0;
        body.angle = 3;
        OK(thud_body_create(world, &body, &lift));
        add_shape(world, lift, 1, 0.2f, false, NULL);
        for (int i = 1; i < 20; i++) {
            OK(thud_body_set_target(world, lift, (thud_pos){0.1 * i, -0.05 * i}, 3 + 0.1 * i));
            OK(thud_world_step(world));
            thud_body_state s = get(world, lift);
            near(s.position.x, 0.1 * i, 1e-6);
            near(s.position.y, -0.05 * i, 1e-6);
            near(remainder(s.angle - 3 - 0.1 * i, 6.283185307179586), 0, 1e-6);
        }
        assert_int_equal(thud_body_set_target(world, lift, (thud_pos){NAN, 0}, 0),
                         THUD_ERROR_INVALID);
        assert_int_equal(thud_body_set_target(world, lift, (thud_pos){1e6, 0}, 0),
                         THUD_ERROR_INVALID);
        thud_world_destroy(world);
    }
}

/* ---- inside callbacks ---- */

/* The context of a callback that pushes, once. */
typedef struct pusher {
    thud_body_id box, lift;
    int asked;
    bool ready;
} pusher;

/* Makes each kind of push, once. */
static void push_all(thud_world *world, pusher *p) {
    if (p->ready && p->asked++ == 0) {
        thud_pos at = get(world, p->box).center;
        at.x += 0.5;
        OK(thud_body_apply_center_impulse(world, p->box, (thud_vec2){2, 0}));
        OK(thud_body_apply_angular_impulse(world, p->box, 0.25f));
        OK(thud_body_apply_force(world, p->box, (thud_vec2){0, 6}, at));
        OK(thud_body_set_target(world, p->lift, (thud_pos){7.25, -7.5}, 0.125));
    }
}

static bool push_before(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)contact, (void)settings;
    push_all(world, context);
    return true;
}

static void push_after(thud_world *world, const thud_contact *contact, void *context) {
    (void)contact;
    push_all(world, context);
}

/* Impulses, forces and targets set inside a callback have no effect in that step and act in the
 * next. */
static void pushes_inside_callbacks_act_through_the_next_step(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES * 2; i++) {
        pusher p = {.asked = 0};
        thud_world_def def = weightless();
        def.quality = qualities[i / 2];
        thud_world *world = make_world(def);
        set_listeners(world, i % 2 ? push_before : NULL, i % 2 ? NULL : push_after, &p);
        p.box = add_body(world, THUD_BODY_DYNAMIC, 3, 4, 0);
        p.lift = add_body(world, THUD_BODY_KINEMATIC, 7, -7, 0);
        add_shape(world, p.box, 0.5f, 0.5f, false, NULL);
        add_shape(world, add_body(world, THUD_BODY_STATIC, -9, 0, 0), 1, 1, false, NULL);
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, -9, 1.49, 0), 0.5f, 0, false, NULL);
        OK(thud_world_step(world));
        p.ready = true;
        OK(thud_world_step(world));
        assert_true(p.asked > 0);
        thud_body_state b = get(world, p.box);
        near((double)b.velocity.x, 0, 0);
        near((double)b.angular_velocity, 0, 0);
        for (int k = 0; k < 2; k++) {
            OK(thud_world_step(world));
            thud_body_state now = get(world, p.box);
            near((double)now.velocity.x, 2 / (double)b.mass, 1e-5);
            near((double)now.velocity.y, 0.1 / (double)b.mass, 1e-5);
            near((double)now.angular_velocity, 0.3 / (double)b.inertia, 1e-4);
            if (k == 0) {
                near(get(world, p.lift).position.x, 7.25, 1e-6);
                near(get(world, p.lift).position.y, -7.5, 1e-6);
                near(get(world, p.lift).angle, 0.125, 1e-6);
            }
        }
        thud_world_destroy(world);
    }
}

/* A local point and vector are transformed to the world and back, and a point's velocity includes
 * the rotation. */
static void points_go_there_and_back(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 3, 4, 1.57079632679489662);
    thud_pos there;
    thud_vec2 back, v;
    add_shape(world, box, 1, 1, false, NULL);
    OK(thud_body_set_velocity(world, box, (thud_vec2){1, 0}, 2));
    OK(thud_body_get_world_point(world, box, (thud_vec2){1, 0}, &there));
    near(there.x, 3, 1e-6);
    near(there.y, 5, 1e-6);
    OK(thud_body_get_local_point(world, box, there, &back));
    near((double)back.x, 1, 1e-6);
    near((double)back.y, 0, 1e-6);
    OK(thud_body_get_velocity_at(world, box, there, &v));
    near((double)v.x, -1, 1e-6);
    near((double)v.y, 0, 1e-6);
    OK(thud_body_get_world_vector(world, box, (thud_vec2){1, 0}, &v));
    near((double)v.y, 1, 1e-6);
    OK(thud_body_get_local_vector(world, box, v, &back));
    near((double)back.x, 1, 1e-6);
    /* A vector of the greatest floats, half a right angle on, is longer along one axis than they.
     */
    OK(thud_body_set_transform(world, box, (thud_pos){3, 4}, 0.78539816339744831));
    OK(thud_body_get_world_vector(world, box, (thud_vec2){FLT_MAX, FLT_MAX}, &v));
    assert_true(v.y == FLT_MAX);
    OK(thud_body_get_local_vector(world, box, (thud_vec2){-FLT_MAX, -FLT_MAX}, &v));
    assert_true(v.x == -FLT_MAX);
    assert_int_equal(thud_body_get_local_point(world, box, (thud_pos){INFINITY, 0}, &back),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_body_get_world_point(world, box, (thud_vec2){0, 0}, NULL),
                     THUD_ERROR_NULL);
    thud_world_destroy(world);
}

static void too_much_is_refused_and_changes_nothing(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    uint64_t before = thud_hash_of(world);
    float wrong[] = {NAN, INFINITY, 3e30f};
    for (int i = 0; i < 3; i++) {
        thud_vec2 v = {wrong[i], 0};
        assert_int_equal(thud_body_apply_force(world, ball, v, (thud_pos){0, 0}),
                         THUD_ERROR_INVALID);
        assert_int_equal(thud_body_apply_center_impulse(world, ball, v), THUD_ERROR_INVALID);
        assert_int_equal(thud_body_apply_angular_impulse(world, ball, wrong[i]),
                         THUD_ERROR_INVALID);
    }
    OK(thud_world_step(world));
    assert_int_equal(thud_hash_of(world), before);
    thud_world_destroy(world);
}

/* Functions that read a single value return what thud_body_get_state and the other reads of all
 * values do. */
static void single_values_are_those_of_the_whole(void **state) {
    (void)state;
    thud_world_def def = weightless();
    thud_world *world = make_world(def);
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 3, 4, 1), back;
    thud_shape_id shape = add_shape(world, box, 1, 2, false, NULL);
    thud_body_state s = get(world, box);
    thud_pos place;
    double angle;
    float c, turn;
    thud_vec2 velocity;
    uint64_t data = 9;
    thud_step_settings settings;
    OK(thud_body_set_user_data(world, box, 77));
    OK(thud_body_get_position(world, box, &place));
    OK(thud_body_get_rotation(world, box, &angle, &c, NULL));
    OK(thud_body_get_velocity(world, box, &velocity, &turn));
    assert_true(place.x == s.position.x && angle == s.angle && c == s.cosine);
    assert_true(velocity.x == s.velocity.x && turn == s.angular_velocity);
    OK(thud_body_get_user_data(world, box, &data));
    assert_int_equal(data, 77);
    OK(thud_shape_get_user_data(world, shape, &data));
    assert_int_equal(data, 0);
    OK(thud_shape_get_body(world, shape, &back));
    assert_int_equal(back.index1, box.index1);
    OK(thud_world_get_step_settings(world, &settings));
    assert_true(settings.time_step == def.time_step && settings.gravity.y == 0);
    assert_int_equal(settings.substeps, thud_quality_default.substeps);
    assert_int_equal(thud_version(), THUD_VERSION);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_turn_by_their_arm_for_one_step),
        cmocka_unit_test(great_impulse_leaves_a_body_that_cannot_turn_without_spin),
        cmocka_unit_test(sleeping_bodies_wake_and_disabled_ones_forget_forces),
        cmocka_unit_test(targets_are_reached_in_one_step),
        cmocka_unit_test(pushes_inside_callbacks_act_through_the_next_step),
        cmocka_unit_test(points_go_there_and_back),
        cmocka_unit_test(too_much_is_refused_and_changes_nothing),
        cmocka_unit_test(single_values_are_those_of_the_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
