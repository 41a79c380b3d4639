/* test_joint_limits.c: limits of joints are not exceeded, at every quality and detection: bodies
 * reach them at high speed, land on them, and load them with a mass ratio of 10,000. */
#include "every_choice.h"
#include "joint_support.h"

#include "constraint/lanes.h"
#include "direct/rows.h"
#include "joints/joint.h"

static const thud_vec2 middle = {0, 0};

/* A world of one of the 4 qualities times 4 detections. */
static thud_world *limits_world(int choice, float gravity) {
    thud_world_def def = def_of(qualities[choice / 4]);
    def.detection = detections[choice % 4];
    def.gravity = (thud_vec2){0, gravity};
    def.sleeping = false;
    return make_world(def);
}

/* Creates the joint with limits of -most and most in this direction. */
static thud_joint_id limited(thud_world *world, thud_joint_def def, thud_direction direction,
                             float most) {
    def.drive[direction].limited = true;
    def.drive[direction].lower = -most;
    def.drive[direction].upper = most;
    return make(world, def);
}

/* By how much the joint's value exceeds its limit at worst in that many steps. */
static double beyond(thud_world *world, thud_joint_id joint, thud_direction direction, double most,
                     int steps) {
    double worst = 0;
    for (int i = 0; i < steps; i++) {
        run(world, 1);
        worst = fmax(worst, fabs(joint_of(world, joint).value[direction]) - most);
    }
    return worst;
}

/* The body starts between both limits and reaches the upper one within a step: the step must not
 * act on the lower one, which was equally near. */
static void slider_stops_at_a_limit_that_it_reaches_within_a_step(void **state) {
    (void)state;
    for (int i = 0; i < 4 * QUALITIES; i++) {
        thud_world *world = limits_world(i, 0);
        thud_body_id rail = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id box = add_box(world, 0, 0, 0.25f, 0.25f);
        thud_joint_id slider = limited(world, between(THUD_JOINT_SLIDER, rail, box, middle, middle),
                                       THUD_DIRECTION_ALONG, 1);
        OK(thud_body_set_velocity(world, box, (thud_vec2){i % 2 ? 100 : -100, 0}, 0));
        assert_true(beyond(world, slider, THUD_DIRECTION_ALONG, 1, 30) < 1e-5);
        thud_world_destroy(world);
    }
}

/* A body crosses the range within a step and pushes against the upper limit at its end, further
 * from it than it was from the lower one. A direct solution may be refused after its rows were
 * made: the force of the limit must not change its sign by that. */
static void rows_of_a_limit_leave_its_force_as_it_is(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_draft);
    thud_body_id rail = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id box = add_box(world, -0.9999, 0, 0.25f, 0.25f);
    thud_joint_def def = between(THUD_JOINT_SLIDER, rail, box, middle, middle);
    thud_joint_id slider = limited(world, def, THUD_DIRECTION_ALONG, 1);
    OK(thud_body_set_velocity(world, box, (thud_vec2){112, 0}, 0));
    run(world, 1);
    float force = joint_of(world, slider).drive[THUD_DIRECTION_ALONG].limit;
    assert_true(force < 0);
    const td_joint *joint = td_joint_at(world, (int)slider.index1 - 1);
    const td_constraint *part = td_constraint_at(world, joint->part[THUD_DIRECTION_ALONG]);
    td_lane at = td_lane_of(world, part);
    td_direct_constraint made = {.block = at.block, .lane = at.lane, .kind = part->kind};
    float impulses[TD_DIRECT_ROWS + 1] = {0};
    td_take_rows_of(world, part->kind)(world, at.block, at.lane, impulses, &made);
    assert_true(joint_of(world, slider).drive[THUD_DIRECTION_ALONG].limit == force);
    assert_true(made.row[0].b[0] < 0);
    thud_world_destroy(world);
}

static void hinge_stops_at_its_limit(void **state) {
    (void)state;
    for (int i = 0; i < 4 * QUALITIES; i++) {
        thud_world *world = limits_world(i, 0);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id bar = add_box(world, 0, 0, 0.5f, 0.1f);
        thud_joint_id hinge = limited(world, between(THUD_JOINT_HINGE, hook, bar, middle, middle),
                                      THUD_DIRECTION_TURN, 0.1f);
        OK(thud_body_set_velocity(world, bar, middle, 10));
        assert_true(beyond(world, hinge, THUD_DIRECTION_TURN, 0.1, 30) < 1e-5);
        thud_world_destroy(world);
    }
}

/* A car lands at 10 m/s on suspensions with limits of 0.1 m either way. */
static void suspension_takes_a_landing(void **state) {
    (void)state;
    for (int i = 0; i < 4 * QUALITIES; i++) {
        thud_world *world = limits_world(i, -10);
        thud_joint_id wheel[2];
        add_floor(world, NULL);
        thud_body_id car = add_box(world, 0, 1, 1, 0.25f);
        OK(thud_body_set_velocity(world, car, (thud_vec2){0, -10}, 0));
        for (int k = 0; k < 2; k++) {
            double x = k ? 0.8 : -0.8;
            thud_body_id tyre = add_ball(world, x, 0.55, 0.3f);
            OK(thud_body_set_velocity(world, tyre, (thud_vec2){0, -10}, 0));
            thud_joint_def def =
                between(THUD_JOINT_WHEEL, car, tyre, (thud_vec2){(float)x, -0.45f}, middle);
            def.frame_a.angle = def.frame_b.angle = PI / 2;
            def.drive[THUD_DIRECTION_ALONG].frequency = 4;
            wheel[k] = limited(world, def, THUD_DIRECTION_ALONG, 0.1f);
        }
        double worst = 0;
        for (int k = 0; k < 60; k++) {
            worst = fmax(worst, beyond(world, wheel[k % 2], THUD_DIRECTION_ALONG, 0.1, 1));
        }
        assert_true(worst < (i / 4 ? 1e-3 : 2e-3));
        thud_world_destroy(world);
    }
}

/* The load that hangs on the limit is 10,000 times as heavy as the body. push_speed, a setting of
 * contacts, has no effect. */
static void limit_bears_a_heavy_load(void **state) {
    (void)state;
    const double most[] = {5, 0.01, 1e-4, 1e-4};
    for (int i = 0; i < 2 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i / 2]);
        def.push_speed = i % 2 ? 3 : 0;
        def.sleeping = false;
        thud_world *world = make_world(def);
        thud_body_id rail = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id box = add_box(world, 0, 0, 0.5f, 0.5f);
        thud_body_id load = add_heavy(world, 0, -1, 0.5f, 1e4f);
        thud_joint_def slides = between(THUD_JOINT_SLIDER, rail, box, middle, middle);
        slides.frame_a.angle = slides.frame_b.angle = PI / 2;
        slides.drive[THUD_DIRECTION_ALONG] = (thud_drive){.limited = true, .upper = 1};
        thud_joint_id slider = make(world, slides);
        make(world, between(THUD_JOINT_WELD, box, load, (thud_vec2){0, -1}, middle));
        run(world, 600);
        assert_true(joint_of(world, slider).value[THUD_DIRECTION_ALONG] > -most[i / 2]);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slider_stops_at_a_limit_that_it_reaches_within_a_step),
        cmocka_unit_test(rows_of_a_limit_leave_its_force_as_it_is),
        cmocka_unit_test(hinge_stops_at_its_limit),
        cmocka_unit_test(suspension_takes_a_landing),
        cmocka_unit_test(limit_bears_a_heavy_load),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
