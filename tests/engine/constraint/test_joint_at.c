/* test_joint_at.c: joints by places in the world (thud_joint_at.h): as they are made they are
 * closed, at any pose of their bodies, and move as joints made from frames by hand. */
#include "joint_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_joint_at.h>
#include <thud/thud_reads.h>

/* Two boxes far from the origin, turned by different angles, with the joint's place outside of
 * both. */
typedef struct pair {
    thud_world *world;
    thud_body_id a, b;
    thud_pos place;
} pair;

static thud_body_id add_turned(thud_world *world, double x, double y, double angle) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){x, y};
    def.angle = angle;
    thud_body_id body;
    OK(thud_body_create(world, &def, &body));
    thud_shape_def shape = thud_default_shape_def();
    OK(thud_shape_create_obb(world, body, &shape, (thud_vec2){0.3f, 0}, (thud_vec2){1, 0.5f}, 0.2,
                             NULL));
    return body;
}

static pair make_pair(void) {
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){0, 0};
    def.sleeping = false;
    thud_world *world = make_world(def);
    pair p = {.world = world, .place = {998, -503}};
    p.a = add_turned(world, 1000, -500, 2.5);
    p.b = add_turned(world, 1004, -501, -1.25);
    return p;
}

/* Makes the joint, and asserts that it is closed and moves nothing. */
static void is_closed(const pair *p, thud_joint_def def) {
    thud_joint_id joint = thud_joint_make(p->world, def);
    assert_true(thud_joint_is_valid(p->world, joint));
    OK(thud_world_step(p->world));
    thud_joint_state state = joint_of(p->world, joint);
    near_to(state.gap, 0, 1e-6);
    near_to(state.angle_gap, 0, 1e-6);
    thud_vec2 velocity = thud_velocity_of(p->world, p->b);
    near_to(velocity.x, 0, 1e-5);
    near_to(velocity.y, 0, 1e-5);
    OK(thud_joint_destroy(p->world, joint));
}

static void joints_at_places_are_closed(void **state) {
    (void)state;
    pair p = make_pair();
    const thud_pos far_end = {1006, -499};
    is_closed(&p, thud_hinge_at(p.world, p.a, p.b, p.place));
    is_closed(&p, thud_weld_at(p.world, p.a, p.b, p.place));
    is_closed(&p, thud_target_at(p.world, p.a, p.b, p.place));
    is_closed(&p, thud_rod_at(p.world, p.a, p.b, p.place, far_end));
    is_closed(&p, thud_rope_at(p.world, p.a, p.b, p.place, far_end, 10));
    for (int i = 0; i < 16; i++) {
        double angle = i * PI / 8;
        thud_vec2 axis = {(float)(3 * cos(angle)), (float)(3 * sin(angle))};
        is_closed(&p, thud_slider_at(p.world, p.a, p.b, p.place, axis));
        is_closed(&p, thud_wheel_at(p.world, p.a, p.b, p.place, axis));
    }
    thud_world_destroy(p.world);
}

/* A slider's motor moves b along the axis in the world, whatever the angles of the bodies. The
 * other body is static, so that nothing turns. */
static void axis_is_a_direction_in_the_world(void **state) {
    (void)state;
    for (int i = 0; i < 8; i++) {
        pair p = make_pair();
        OK(thud_body_set_kind(p.world, p.a, THUD_BODY_STATIC));
        double angle = 0.3 + i * PI / 4;
        thud_vec2 axis = {(float)cos(angle), (float)sin(angle)};
        thud_joint_def def = thud_slider_at(p.world, p.a, p.b, p.place, axis);
        def.drive[THUD_DIRECTION_ALONG].motor_speed = 2;
        def.drive[THUD_DIRECTION_ALONG].motor_force = 1e6f;
        assert_true(thud_joint_is_valid(p.world, thud_joint_make(p.world, def)));
        OK(thud_world_step(p.world));
        thud_vec2 velocity = thud_velocity_of(p.world, p.b);
        near_to(velocity.x, 2 * axis.x, 0.02);
        near_to(velocity.y, 2 * axis.y, 0.02);
        thud_world_destroy(p.world);
    }
}

static void rod_has_the_present_distance_and_rope_its_length(void **state) {
    (void)state;
    pair p = make_pair();
    const thud_pos to = {998 + 3, -503 + 4};
    near_to(thud_rod_at(p.world, p.a, p.b, p.place, to).length, 5, 1e-6);
    thud_joint_def rope = thud_rope_at(p.world, p.a, p.b, p.place, to, 7);
    assert_true(rope.drive[THUD_DIRECTION_ALONG].limited);
    assert_true(rope.drive[THUD_DIRECTION_ALONG].lower == 0);
    assert_true(rope.drive[THUD_DIRECTION_ALONG].upper == 7);
    thud_world_destroy(p.world);
}

/* Bad input makes a def that is refused, with a reason, and changes nothing. */
static void joints_at_bad_places_are_refused(void **state) {
    (void)state;
    pair p = make_pair();
    const thud_body_id none = {0, 0};
    const thud_vec2 zero = {0, 0}, up = {0, 1}, not_finite = {NAN, 1};
    const thud_pos nowhere = {INFINITY, 0};
    const thud_joint_def bad[] = {
        thud_hinge_at(p.world, none, p.b, p.place),
        thud_hinge_at(p.world, p.a, none, p.place),
        thud_hinge_at(p.world, p.a, p.a, p.place),
        thud_hinge_at(p.world, p.a, p.b, nowhere),
        thud_hinge_at(NULL, none, none, p.place),
        thud_slider_at(p.world, p.a, p.b, p.place, zero),
        thud_wheel_at(p.world, p.a, p.b, p.place, not_finite),
        thud_wheel_at(p.world, p.a, p.b, nowhere, up),
        thud_rod_at(p.world, p.a, p.b, p.place, p.place),
        thud_rope_at(p.world, p.a, p.b, p.place, p.place, 0),
        thud_rope_at(p.world, p.a, p.b, p.place, p.place, -1),
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(thud_joint_is_valid(p.world, thud_joint_make(p.world, bad[i])));
    }
    assert_int_equal(thud_joint_make(NULL, bad[0]).index1, 0);
    int count;
    OK(thud_world_get_joints(p.world, NULL, 0, &count));
    assert_int_equal(count, 0);
    thud_world_destroy(p.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joints_at_places_are_closed),
        cmocka_unit_test(axis_is_a_direction_in_the_world),
        cmocka_unit_test(rod_has_the_present_distance_and_rope_its_length),
        cmocka_unit_test(joints_at_bad_places_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
