/* test_level_joints.c: tests which joints the objects of a Tiled map become in a scene and in a
 * world. */
#include "build_thud.h"
#include "joint_maps.h"

/* Reads a map and expects an empty report. */
static scene read_objects(const char *objects) {
    scene s;
    level_report report;
    bool read = read_map(objects, false, &s, &report);
    if (!read || report.count > 0)
        fail_msg("%s: %s", objects, report.count > 0 ? report.problems[0].text : "");
    return s;
}

/* The place of a joint's anchor on one side, in world coordinates. */
static scene_point place_of(const scene *s, const scene_joint *joint, int side) {
    const scene_body *body = &s->bodies[joint->body[side]];
    double c = cos(body->angle), sine = sin(body->angle);
    return (scene_point){body->x + c * joint->x[side] - sine * joint->y[side],
                         body->y + sine * joint->x[side] + c * joint->y[side]};
}

static void assert_at(const scene *s, const scene_joint *joint, int side, double x, double y) {
    scene_point place = place_of(s, joint, side);
    assert_true(fabs(place.x - x) < 1e-12 && fabs(place.y - y) < 1e-12);
}

/* Builds a world: the engine accepts all joints that the reader returns. */
static thud_world *build(const scene *s) {
    thud_world *world = NULL;
    assert_int_equal(scene_build_thud(s, NULL, &world, NULL, NULL), THUD_OK);
    return world;
}

static void every_kind_ties_the_bodies_that_it_refers_to_at_its_place(void **state) {
    (void)state;
    static const struct {
        scene_joint_kind kind;
        const char *object;
    } KINDS[] = {
        {SCENE_HINGE, POINT("hinge", REFERS(1, 2))},
        {SCENE_SLIDER, POINT("slider", REFERS(1, 2))},
        {SCENE_WELD, POINT("weld", REFERS(1, 2))},
        {SCENE_WHEEL, POINT("wheel", REFERS(1, 2))},
        {SCENE_TARGET, POINT("target", REFERS(1, 2))},
        {SCENE_FILTER, POINT("filter", REFERS(1, 2))},
    };
    for (size_t i = 0; i < sizeof KINDS / sizeof KINDS[0]; i++) {
        scene s = read_objects(KINDS[i].object);
        assert_int_equal(s.body_count, 3);
        assert_int_equal(s.joint_count, 1);
        const scene_joint *joint = &s.joints[0];
        assert_int_equal(joint->kind, KINDS[i].kind);
        assert_int_equal(joint->body[0], 0);
        assert_int_equal(joint->body[1], 1);
        for (int side = 0; side < 2; side++)
            assert_at(&s, joint, side, 3, 8.5);
        double up = joint->kind == SCENE_WHEEL ? acos(0) : 0;
        assert_true(fabs(joint->angle[0] - up) < 1e-15);
        assert_true(fabs(joint->angle[1] - (up + acos(-1) / 6)) < 1e-15);
        assert_false(joint->collide_connected);
        assert_true(joint->break_force == 1e30 && joint->break_torque == 1e30);
        thud_world_destroy(build(&s));
        scene_free(&s);
    }
}

static void rectangle_is_a_joint_at_its_middle_with_its_rotation(void **state) {
    (void)state;
    scene s = read_objects(
        "{\"id\":9,\"width\":64,\"height\":32,\"rotation\":90," WITH("slider", REFERS(1, 2)) "}");
    /* The rectangle is turned about (96, 48), so that it is to the left and below. */
    assert_at(&s, &s.joints[0], 0, (96 - 16) / 32.0, (320 - 48 - 32) / 32.0);
    assert_true(fabs(s.joints[0].angle[0] + acos(-1) / 2) < 1e-15);
    scene_free(&s);
}

static void line_is_the_axis_of_a_joint_at_its_beginning(void **state) {
    (void)state;
    scene s = read_objects(LINE("slider", REFERS(1, 2)));
    assert_at(&s, &s.joints[0], 0, 3, 8.5);
    assert_at(&s, &s.joints[0], 1, 3, 8.5);
    assert_true(fabs(s.joints[0].angle[0] - atan2(128, 96)) < 1e-14);
    scene_free(&s);
}

static void line_is_a_distance_from_one_end_to_the_other(void **state) {
    (void)state;
    scene s = read_objects(LINE("distance", REFERS(1, 2)));
    const scene_joint *rod = &s.joints[0];
    assert_at(&s, rod, 0, 3, 8.5);
    assert_at(&s, rod, 1, 6, 12.5);
    assert_true(rod->length == 5);
    assert_false(rod->drive[SCENE_ALONG].limited);
    scene_free(&s);

    s = read_objects(LINE("distance", REFERS(1, 2) HAS("length", 2.5)));
    assert_true(s.joints[0].length == 2.5);
    scene_free(&s);
}

static void rope_and_spring_are_as_long_as_they_are_drawn(void **state) {
    (void)state;
    scene s = read_objects(LINE("distance", REFERS(1, 2) HAS("along_lower", 0)));
    const scene_drive *rope = &s.joints[0].drive[SCENE_ALONG];
    assert_true(rope->limited && rope->lower == 0 && rope->upper == 5);
    scene_free(&s);

    s = read_objects(LINE("distance", REFERS(1, 2) HAS("along_upper", 7)));
    rope = &s.joints[0].drive[SCENE_ALONG];
    assert_true(rope->limited && rope->lower == 0 && rope->upper == 7);
    scene_free(&s);

    s = read_objects(LINE("distance", REFERS(1, 2) HAS("along_frequency", 2)));
    const scene_drive *spring = &s.joints[0].drive[SCENE_ALONG];
    assert_true(!spring->limited && spring->frequency == 2 && spring->target == 5);
    scene_free(&s);
}

static void joint_without_a_holds_to_a_body_without_shapes_in_the_world(void **state) {
    (void)state;
    scene s = read_objects(LINE("distance", "{\"name\":\"b\",\"value\":1}"));
    const scene_joint *rod = &s.joints[0];
    assert_int_equal(s.body_count, 4);
    assert_int_equal(rod->body[0], 3);
    assert_int_equal(rod->body[1], 0);
    const scene_body *anchor = &s.bodies[3];
    assert_true(anchor->kind == SCENE_STATIC && anchor->shape_count == 0 && anchor->id == 9);
    assert_true(anchor->x == 3 && anchor->y == 8.5);
    assert_at(&s, rod, 0, 3, 8.5);
    assert_at(&s, rod, 1, 6, 12.5);
    thud_world_destroy(build(&s));
    scene_free(&s);
}

#define DRIVE(way)            \
    HAS(way "_lower", -0.5)   \
    HAS(way "_upper", 0.75)   \
    HAS(way "_frequency", 3)  \
    HAS(way "_damping", 0.25) \
    HAS(way "_target", 0.125) \
    HAS(way "_spring_force", 50) HAS(way "_motor_speed", -2.5) HAS(way "_motor_force", "40")

static void assert_driven(const scene_drive *d) {
    assert_true(d->limited && d->lower == -0.5 && d->upper == 0.75);
    assert_true(d->frequency == 3 && d->damping == 0.25 && d->target == 0.125);
    assert_true(d->spring_force == 50 && d->motor_speed == -2.5 && d->motor_force == 40);
}

static void assert_free(const scene_drive *d) {
    assert_true(!d->limited && d->lower == 0 && d->upper == 0);
    assert_true(d->frequency == 0 && d->damping == 0.7 && d->target == 0);
    assert_true(d->spring_force == 1e30 && d->motor_speed == 0 && d->motor_force == 0);
}

static void drive_of_each_direction_is_read_where_the_kind_has_it(void **state) {
    (void)state;
    static const struct {
        const char *object;
        int driven;
    } DRIVEN[] = {
        {POINT("hinge", REFERS(1, 2) DRIVE("turn")), 1 << SCENE_TURN},
        {POINT("slider", REFERS(1, 2) DRIVE("along")), 1 << SCENE_ALONG},
        {POINT("wheel", REFERS(1, 2) DRIVE("along") DRIVE("turn")),
         1 << SCENE_ALONG | 1 << SCENE_TURN},
        {POINT("weld", REFERS(1, 2) DRIVE("along") DRIVE("across") DRIVE("turn")), 7},
        {POINT("target", REFERS(1, 2) DRIVE("along") DRIVE("across") DRIVE("turn")), 7},
        {POINT("target", REFERS(1, 2) DRIVE("across")), 1 << SCENE_ACROSS},
    };
    for (size_t i = 0; i < sizeof DRIVEN / sizeof DRIVEN[0]; i++) {
        scene s = read_objects(DRIVEN[i].object);
        for (int way = 0; way < SCENE_DIRECTIONS; way++)
            (DRIVEN[i].driven >> way & 1 ? assert_driven : assert_free)(&s.joints[0].drive[way]);
        thud_world_destroy(build(&s));
        scene_free(&s);
    }
}

static void limit_on_one_side_leaves_the_other_open(void **state) {
    (void)state;
    scene s = read_objects(POINT("hinge", REFERS(1, 2) HAS("turn_upper", 0.5)));
    const scene_drive *turn = &s.joints[0].drive[SCENE_TURN];
    assert_true(turn->limited && turn->lower == -3.1415927 && turn->upper == 0.5);
    thud_world_destroy(build(&s));
    scene_free(&s);
}

static void joint_says_when_it_breaks_and_whether_its_bodies_meet(void **state) {
    (void)state;
    scene s = read_objects(POINT("weld", REFERS(1, 3) HAS("break_force", 80) HAS("break_torque", 0)
                                             HAS("collide_connected", true)));
    assert_true(s.joints[0].break_force == 80 && s.joints[0].break_torque == 0);
    assert_true(s.joints[0].collide_connected);
    scene_free(&s);
}

static void gear_comes_after_the_joints_that_it_ties(void **state) {
    (void)state;
    scene s = read_objects(
        POINT("gear", REFERS(11, 10) HAS("ratio", -2.5)) "," AXLE(10, 1) "," AXLE(11, 2));
    assert_int_equal(s.joint_count, 3);
    const scene_joint *gear = &s.joints[2];
    assert_int_equal(gear->kind, SCENE_GEAR);
    assert_int_equal(gear->body[0], 1);
    assert_int_equal(gear->body[1], 0);
    assert_true(gear->ratio == -2.5 && gear->collide_connected && gear->break_force == 1e30);
    thud_world_destroy(build(&s));
    scene_free(&s);

    s = read_objects(POINT("gear",
                           REFERS(11, 10) HAS("collide_connected", false) HAS("break_force", 5)
                               HAS("break_torque", 6)) "," AXLE(10, 1) "," AXLE(11, 2));
    assert_false(s.joints[2].collide_connected);
    assert_true(s.joints[2].break_force == 5 && s.joints[2].break_torque == 6);
    scene_free(&s);
}

static void joint_is_inherited_from_its_layer_and_told_in_xml(void **state) {
    (void)state;
    static const char TEXT[] =
        "<map width=\"9\" height=\"9\" tilewidth=\"32\" tileheight=\"32\"><objectgroup name=\"o\">"
        "<properties><property name=\"turn_damping\" type=\"float\" value=\"0.5\"/></properties>"
        "<object id=\"5\" class=\"hinge\" x=\"40\" y=\"40\"><properties>"
        "<property name=\"b\" type=\"object\" value=\"6\"/></properties><point/></object>"
        "<object id=\"6\" x=\"32\" y=\"32\" width=\"32\" height=\"32\"><properties>"
        "<property name=\"body\" value=\"dynamic\"/></properties></object></objectgroup></map>";
    scene s;
    level_report report;
    assert_true(level_read("xml", TEXT, strlen(TEXT), false, &s, &report));
    assert_int_equal(report.count, 0);
    assert_int_equal(s.joint_count, 1);
    assert_true(s.joints[0].drive[SCENE_TURN].damping == 0.5);
    scene_free(&s);
}

/* ---- in the world ---- */

static void pendulum_of_a_map_swings_about_its_hinge(void **state) {
    (void)state;
    scene s = read_objects(POINT("hinge", "{\"name\":\"b\",\"value\":2}"));
    thud_body_id bodies[4];
    thud_world *world = NULL;
    assert_int_equal(scene_build_thud(&s, NULL, &world, bodies, NULL), THUD_OK);
    const scene_body *start = &s.bodies[1];
    double radius = hypot(start->x - 3, start->y - 8.5), lowest = start->y;
    for (int i = 0; i < 120; i++) {
        assert_int_equal(thud_world_step(world), THUD_OK);
        thud_body_state now;
        assert_int_equal(thud_body_get_state(world, bodies[1], &now), THUD_OK);
        thud_pos at = now.position;
        assert_true(fabs(hypot(at.x - 3, at.y - 8.5) - radius) < 0.01 * radius);
        lowest = fmin(lowest, at.y);
    }
    assert_true(lowest < start->y - 1);
    thud_world_destroy(world);
    scene_free(&s);
}

static void maps_with_joints_are_built_and_what_is_wrong_is_left_out(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("joints.tmj", &report);
    assert_int_equal(report.count, 0);
    assert_true(s.joint_count >= 12);
    thud_world_destroy(build(&s));
    scene_free(&s);
    s = read_file("loose.tmx", &report);
    assert_int_equal(s.joint_count, 3);
    thud_world_destroy(build(&s));
    scene_free(&s);
    level_report_free(&report);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_ties_the_bodies_that_it_refers_to_at_its_place),
        cmocka_unit_test(rectangle_is_a_joint_at_its_middle_with_its_rotation),
        cmocka_unit_test(line_is_the_axis_of_a_joint_at_its_beginning),
        cmocka_unit_test(line_is_a_distance_from_one_end_to_the_other),
        cmocka_unit_test(rope_and_spring_are_as_long_as_they_are_drawn),
        cmocka_unit_test(joint_without_a_holds_to_a_body_without_shapes_in_the_world),
        cmocka_unit_test(drive_of_each_direction_is_read_where_the_kind_has_it),
        cmocka_unit_test(limit_on_one_side_leaves_the_other_open),
        cmocka_unit_test(joint_says_when_it_breaks_and_whether_its_bodies_meet),
        cmocka_unit_test(gear_comes_after_the_joints_that_it_ties),
        cmocka_unit_test(joint_is_inherited_from_its_layer_and_told_in_xml),
        cmocka_unit_test(pendulum_of_a_map_swings_about_its_hinge),
        cmocka_unit_test(maps_with_joints_are_built_and_what_is_wrong_is_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
