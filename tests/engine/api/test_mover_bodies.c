/* test_mover_bodies.c: the character mover and bodies: it pushes them, its own body pushes them,
 * moving walls push it out, and it never overlaps a shape of a level. */
#include "mover_support.h"

#include "build_thud.h"
#include "level.h"

/* The mover pushes a crate by at most push_force * time, and not at all with a push_force of 0. */
static void dynamic_body_is_pushed_by_a_bounded_impulse_if_asked(void **state) {
    (void)state;
    double speed[3];
    for (int i = 0; i < 3; i++) {
        thud_world *world = make_world(weightless());
        add_floor(world, NULL);
        thud_body_id crate = add_box(world, 1, 0.52, 0.5f, 0.5f);
        thud_mover mover = box_mover(0, 0.6);
        mover.push_force = i == 0 ? 0 : i == 1 ? 6 : 1e9;
        go_on(world, &mover, 3, 10);
        speed[i] = (double)state_of(world, crate).velocity.x;
        thud_world_destroy(world);
    }
    near_to(speed[0], 0, 1e-9);
    /* force * time / mass, which is 1 kg */
    assert_true(speed[1] > 0.1 && speed[1] <= 6 * DT * 10 + 1e-6);
    /* 3 m/s at the point that is pushed; the body turns as well */
    assert_true(speed[2] > 2.5 && speed[2] < 3.001);
}

/* A kinematic body follows the mover exactly, and pushes a ball away. */
static void kinematic_body_follows_and_dynamic_bodies_meet_it(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    thud_mover mover = box_mover(0, 0.6);
    mover.body = add_body(world, THUD_BODY_KINEMATIC, 0, 0.6, 0);
    add_shape(world, mover.body, 0.3f, 0.5f, true, NULL);
    thud_body_id ball = add_ball(world, 3, 0.3, 0.3f);
    thud_vec2 velocity = {0, 0};
    for (int i = 0; i < 120; i++) {
        go(world, &mover, &velocity, 2);
        thud_pos wanted = {mover.shape.x, mover.shape.y};
        run(world, 1);
        near_to(state_of(world, mover.body).position.x, wanted.x, 1e-5);
        near_to(state_of(world, mover.body).position.y, wanted.y, 1e-5);
    }
    assert_true(mover.on_ground);
    near_to(mover.shape.y, 0.5 + mover.skin, 1e-4);
    assert_true(mover.shape.x > 2.2 && state_of(world, ball).position.x > mover.shape.x);
    thud_world_destroy(world);
}

/* A moving wall pushes the mover out. Between that wall and a fixed one it has no free place, and
 * report.depth tells how deep it overlaps. */
static void mover_pressed_by_a_moving_wall_is_pushed_out_and_told_where_it_cannot_be(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_floor(world, NULL);
    thud_body_id press = add_body(world, THUD_BODY_KINEMATIC, -2, 10.1, 0);
    add_shape(world, press, 0.5f, 10, true, NULL);
    OK(thud_body_set_velocity(world, press, (thud_vec2){2, 0}, 0));
    thud_mover mover = box_mover(0, 0.6);
    thud_vec2 velocity = {0, 0};
    thud_mover_report report = {0};
    for (int i = 0; i < 120; i++) {
        run(world, 1);
        report = go(world, &mover, &velocity, 0);
        near_to(report.depth, 0, 1e-12);
        assert_true(mover.shape.x - 0.3 > state_of(world, press).position.x + 0.5);
    }
    add_block(world, mover.shape.x + 1, 10, 0.5f, 10);
    for (int i = 0; i < 15; i++) {
        run(world, 1);
        report = go(world, &mover, &velocity, 0);
    }
    assert_true(report.depth > 0.1);
    thud_world_destroy(world);
}

/* ---- a level ---- */

static bool count_one(thud_shape_id shape, void *context) {
    (void)shape;
    ++*(int *)context;
    return true;
}

static void random_moves_in_a_level_never_enter_anything(void **state) {
    (void)state;
    scene s;
    level_report problems;
    thud_world *world;
    assert_true(level_read_file("assets/levels/platform.tmj", false, &s, &problems));
    /* Only static bodies, since falling ones may fall onto the mover. */
    for (int i = 0; i < s.body_count; i++) {
        if (s.bodies[i].kind == SCENE_DYNAMIC) {
            s.bodies[i].kind = SCENE_STATIC;
            s.bodies[i].vx = s.bodies[i].vy = s.bodies[i].angular_velocity = 0;
        }
    }
    OK(scene_build_thud(&s, NULL, &world, NULL, NULL));
    uint64_t seed = 77;
    for (int kind = 0; kind < 2; kind++) {
        thud_mover mover = kind ? circle_mover(36, 24) : box_mover(36, 24);
        thud_vec2 velocity = {0, 0};
        int on_ground = 0;
        for (int i = 0; i < 10000; i++) {
            thud_mover_report report;
            if (i % 20 == 0) {
                velocity.x = (float)random_in(&seed, -12, 12);
                velocity.y = (float)random_in(&seed, -25, 14);
            }
            velocity.y -= 20.0f / 60;
            OK(thud_mover_move(world, &mover, velocity, DT, &report));
            velocity.y = report.velocity.y;
            on_ground += mover.on_ground;
            int inside = 0;
            thud_geometry shape = mover.shape;
            thud_pos origin = {0, 0};
            OK(thud_world_overlap_shape(world, origin, shape, NULL, count_one, &inside));
            assert_int_equal(inside, 0);
            assert_true(report.depth == 0);
        }
        assert_true(on_ground > 1000 && on_ground < 9999);
        assert_true(mover.shape.x > 0 && mover.shape.x < 160);
        assert_true(mover.shape.y > 0 && mover.shape.y < 40);
    }
    thud_world_destroy(world);
    scene_free(&s);
}

/* With a time of 1e-39 s the velocity of the mover's body is bounded and finite. */
static void body_follows_in_the_shortest_of_times_by_a_speed_that_is_a_number(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_floor(world, NULL);
    thud_body_id crate = add_box(world, 1, 0.52, 0.5f, 0.5f);
    thud_mover mover = box_mover(0, 0.6);
    mover.push_force = 1e9;
    mover.body = add_body(world, THUD_BODY_KINEMATIC, 5, 0.6, 0);
    OK(thud_mover_move(world, &mover, (thud_vec2){3e38f, 0}, 1e-39, NULL));
    near_to((double)state_of(world, mover.body).velocity.x, -1e30, 1e24);
    assert_true(state_of(world, crate).velocity.x > 0);
    run(world, 1);
    assert_true(isfinite(state_of(world, mover.body).position.x));
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dynamic_body_is_pushed_by_a_bounded_impulse_if_asked),
        cmocka_unit_test(kinematic_body_follows_and_dynamic_bodies_meet_it),
        cmocka_unit_test(body_follows_in_the_shortest_of_times_by_a_speed_that_is_a_number),
        cmocka_unit_test(mover_pressed_by_a_moving_wall_is_pushed_out_and_told_where_it_cannot_be),
        cmocka_unit_test(random_moves_in_a_level_never_enter_anything),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
