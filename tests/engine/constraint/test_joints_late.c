/* test_joints_late.c: an island of joints whose soft solution is found to be bad after the solver
 * is solved directly in the same step, so that its joints open in no step. */
#include "joint_support.h"

static const thud_vec2 middle = {0, 0};

/* A block of a hundred times the mass of its two bars, which are hinged to the ground, passes x at
 * 3 m/s. */
static thud_body_id add_swing(thud_world *world, thud_body_id ground, double x) {
    thud_body_id block = add_body(world, THUD_BODY_DYNAMIC, x, 1, 0);
    add_shape(world, block, 1, 0.5f, false, NULL);
    for (int side = -1; side <= 1; side += 2) {
        thud_body_id bar = add_box(world, x + side, 0.5, 0.02f, 0.5f);
        OK(thud_body_set_velocity(world, bar, (thud_vec2){1.5f, 0}, -3));
        make(world, between(THUD_JOINT_HINGE, ground, bar, (thud_vec2){(float)(x + side), 0},
                            (thud_vec2){0, -0.5f}));
        make(world, between(THUD_JOINT_HINGE, bar, block, (thud_vec2){0, 0.5f},
                            (thud_vec2){(float)side, 0}));
    }
    OK(thud_body_set_velocity(world, block, (thud_vec2){3, 0}, 0));
    return block;
}

/* The loaded mechanism starts to move in the first step; no step has a gap above 1e-4 m. */
static void what_sets_off_under_load_is_whole_from_its_first_step(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    add_swing(world, ground, 0);
    for (int step = 0; step < 20; step++) {
        run(world, 1);
        near_to(thud_step_error_of(world).joint_gap_max, 0, 1e-4);
    }
    thud_world_destroy(world);
}

/* A ball of a hundred times the slide's mass falls on a slide: the contact and the joint are in one
 * island. */
static void what_is_hit_gives_way_in_no_step(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id slide = add_box(world, 0, 0, 0.5f, 0.1f);
    thud_joint_def def = between(THUD_JOINT_SLIDER, ground, slide, middle, middle);
    def.drive[THUD_DIRECTION_ALONG].motor_force = 100;
    make(world, def);
    thud_body_id ball = add_ball(world, 0.2, 2.2, 2);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -5}, 0));
    for (int step = 0; step < 60; step++) {
        run(world, 1);
        near_to(thud_step_error_of(world).joint_gap_max, 0, 1e-3);
    }
    thud_world_destroy(world);
}

/* Each island has a system of its own behind those of the islands found before the solver: several
 * at once move as each does alone. */
static void late_islands_are_as_they_are_alone(void **state) {
    (void)state;
    enum { SWINGS = 5 };
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0), block[SWINGS];
    for (int i = 0; i < SWINGS; i++) {
        block[i] = add_swing(world, ground, 10 * i);
    }
    run(world, 30);
    thud_body_state first = state_of(world, block[0]);
    for (int i = 1; i < SWINGS; i++) {
        thud_body_state other = state_of(world, block[i]);
        near_to(other.position.x - 10 * i, first.position.x, 1e-5);
        near_to(other.position.y, first.position.y, 1e-5);
    }
    thud_world_destroy(world);
}

/* A block that cannot rotate holds a rod off its centre, which pulls a ball towards a static
 * body. */
static void what_cannot_turn_is_not_turned(void **state) {
    (void)state;
    for (int i = 0; i < QUALITIES; i++) {
        thud_world *world = world_at(qualities[i]);
        add_floor(world, NULL);
        thud_body_id hand = add_body(world, THUD_BODY_STATIC, 0.4, 0.5, 0);
        thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
        thud_body_id block = add_body(world, THUD_BODY_DYNAMIC, -5, 2, 0);
        thud_shape_def heavy = thud_default_shape_def();
        heavy.density = 100;
        add_shape(world, block, 2, 2, true, &heavy);
        thud_joint_def rod =
            between(THUD_JOINT_DISTANCE, block, ball, (thud_vec2){2, -1.5f}, middle);
        rod.length = 3;
        make(world, rod);
        thud_joint_def pull = between(THUD_JOINT_TARGET, hand, ball, middle, middle);
        for (int k = 0; k < 2; k++) {
            pull.drive[k].frequency = 5;
            pull.drive[k].damping = 1;
            pull.drive[k].spring_force = 300;
        }
        make(world, pull);
        run(world, 120);
        assert_true(state_of(world, block).sine == 0);
        near_to(state_of(world, ball).position.x, 0, 0.02);
        near_to(state_of(world, block).position.x, -5, 1e-4);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_sets_off_under_load_is_whole_from_its_first_step),
        cmocka_unit_test(what_is_hit_gives_way_in_no_step),
        cmocka_unit_test(late_islands_are_as_they_are_alone),
        cmocka_unit_test(what_cannot_turn_is_not_turned),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
