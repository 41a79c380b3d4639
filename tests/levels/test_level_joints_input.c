/* test_level_joints_input.c: tests the messages for invalid joints in maps, and that the rest of
 * the map is read. */
#include "joint_maps.h"

static void wrong_joint_is_refused_by_id_or_left_out_alone(void **state) {
    (void)state;
    static const struct {
        const char *object, *says;
    } WRONG[] = {
        {POINT("hinge", ""), "a hinge needs b"},
        {POINT("hinge", "{\"name\":\"a\",\"value\":1}"), "a hinge needs b"},
        {POINT("hinge", REFERS(1, 0)), "a hinge needs b"},
        {POINT("filter", "{\"name\":\"b\",\"value\":1}"), "a filter needs both a and b"},
        {POINT("gear", "{\"name\":\"b\",\"value\":1}"), "a gear needs both a and b"},
        {POINT("hinge", REFERS(1, 1)), "a and b are the same object"},
        {POINT("hinge", REFERS(1, 77)), "b refers to object 77, which is no body"},
        {POINT("hinge", REFERS(77, 1)), "a refers to object 77, which is no body"},
        {POINT("hinge", REFERS(1, 9)), "b refers to object 9, which is no body"},
        {POINT("hinge", REFERS(1, "one")), "b is not a number"},
        {POINT("hinge", REFERS(1, -2)), "b is out of range"},
        {POINT("hinge", REFERS(1, 2.5)), "b is not a whole number"},
        {POINT("hinge", "{\"name\":\"b\",\"value\":3}"), "a hinge needs one dynamic body, a or b"},
        {POINT("wheel", REFERS(1, 3)), "a wheel needs a b that is dynamic"},
        {POINT("target", REFERS(1, 3)), "a target needs a b that is dynamic"},
        {POINT("gear", REFERS(1, 2)), "a refers to object 1, which is no joint"},
        {POINT("gear", REFERS(9, 2)), "a refers to object 9, which is no joint"},
        {POINT("distance", REFERS(1, 2)), "a distance is drawn as a line of two points"},
        {"{\"id\":9,\"polygon\":[{\"x\":0,\"y\":0},{\"x\":9,\"y\":9},{\"x\":9,\"y\":0}]," WITH(
             "hinge", REFERS(1, 2)) "}",
         "a joint is drawn as a point"},
        {"{\"id\":9,\"gid\":5," WITH("hinge", REFERS(1, 2)) "}", "a joint is drawn as a point"},
        {"{\"id\":9,\"polyline\":[{\"x\":0,\"y\":0}]," WITH("distance", REFERS(1, 2)) "}",
         "a joint is drawn as a point"},
        {"{\"id\":9,\"polyline\":{\"x\":0,\"y\":0}," WITH("distance", REFERS(1, 2)) "}",
         "a joint is drawn as a point"},
        {"{\"id\":9,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":9}]," WITH("distance", REFERS(1, 2)) "}",
         "y is missing"},
        {"{\"id\":9,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":0,\"y\":0}]," WITH("distance",
                                                                              REFERS(1, 2)) "}",
         "its line is too short"},
        {"{\"id\":9,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":0,\"y\":9e8}]," WITH("distance",
                                                                                REFERS(1, 2)) "}",
         "its line is too long"},
        {"{\"id\":9,\"point\":true,\"type\":\"hinge\",\"x\":9e8,\"y\":0,\"properties\":[" REFERS(
             1, 2) "]}",
         "a hinge is too far from its bodies"},
        {LINE("distance", REFERS(1, 2) HAS("length", 0)), "length is out of range"},
        {LINE("distance", REFERS(1, 2) HAS("length", 1e7)), "length is out of range"},
        {LINE("distance", REFERS(1, 2) HAS("along_lower", -1)), "along_lower is out of range"},
        {LINE("distance", REFERS(1, 2) HAS("along_lower", 6)), "along_lower is larger than"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_lower", -4)), "turn_lower is out of range"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_upper", 90)), "turn_upper is out of range"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_lower", 1) HAS("turn_upper", 0)),
         "turn_lower is larger than turn_upper"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_frequency", -1)), "turn_frequency is out of range"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_damping", "much")), "turn_damping is not a number"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_target", 7)), "turn_target is out of range"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_spring_force", -1)), "turn_spring_force is out"},
        {POINT("slider", REFERS(1, 2) HAS("along_motor_speed", 1e7)), "along_motor_speed is out"},
        {POINT("slider", REFERS(1, 2) HAS("along_motor_force", 1e31)), "along_motor_force is out"},
        {POINT("weld", REFERS(1, 2) HAS("across_frequency", 1e5)), "across_frequency is out"},
        {POINT("weld", REFERS(1, 2) HAS("break_force", -1)), "break_force is out of range"},
        {POINT("weld", REFERS(1, 2) HAS("break_torque", null)), "break_torque is not a number"},
        {POINT("weld", REFERS(1, 2) HAS("collide_connected", 2)), "collide_connected is neither"},
        {POINT("gear", REFERS(1, 2) HAS("ratio", 0)), "ratio is too near to 0"},
        {POINT("gear", REFERS(1, 2) HAS("ratio", -20000)), "ratio is out of range"},
    };
    for (size_t i = 0; i < sizeof WRONG / sizeof WRONG[0]; i++) {
        scene s;
        level_report report;
        bool read = read_map(WRONG[i].object, false, &s, &report);
        const char *said = report.count > 0 ? report.problems[0].text : "nothing";
        if (read || strncmp(said, "object 9: ", 10) != 0 || !strstr(said, WRONG[i].says))
            fail_msg("%s: said '%s', not '%s'", WRONG[i].object, said, WRONG[i].says);
        level_report_free(&report);

        assert_true(read_map(WRONG[i].object, true, &s, &report));
        assert_true(report.fatal == 0 && report.skipped > 0);
        assert_int_equal(s.body_count, 3);
        assert_int_equal(s.joint_count, 0);
        scene_free(&s);
        level_report_free(&report);
    }
}

static void everything_that_is_wrong_with_a_joint_is_listed(void **state) {
    (void)state;
    scene s;
    level_report report;
    assert_true(read_map(POINT("hinge", REFERS(1, 2) HAS("turn_damping", -1) HAS("break_force", -1)
                                            HAS("turn_lower", 9)),
                         true, &s, &report));
    assert_int_equal(report.skipped, 3);
    scene_free(&s);
    level_report_free(&report);
}

static void gear_of_what_cannot_be_geared_is_left_out(void **state) {
    (void)state;
    static const struct {
        const char *joint, *says;
    } JOINTS[] = {
        {"{\"id\":10,\"point\":true," WITH("weld", "{\"name\":\"b\",\"value\":1}") "}",
         "object 9: a gear needs two joints, each a hinge"},
        {"{\"id\":10,\"point\":true," WITH("hinge", REFERS(1, 2)) "}",
         "object 9: a gear needs two joints, each a hinge"},
        {AXLE(10, 2), "object 9: a gear needs joints of two bodies"},
    };
    for (size_t i = 0; i < sizeof JOINTS / sizeof JOINTS[0]; i++) {
        char objects[1024];
        snprintf(objects, sizeof objects, "%s,%s,%s", JOINTS[i].joint, AXLE(11, 2),
                 POINT("gear", REFERS(10, 11)));
        scene s;
        level_report report;
        assert_true(read_map(objects, true, &s, &report));
        assert_int_equal(s.joint_count, 2);
        assert_true(says(&report, LEVEL_SKIP, JOINTS[i].says));
        scene_free(&s);
        level_report_free(&report);
    }
}

static void property_that_its_kind_does_not_have_is_noted(void **state) {
    (void)state;
    static const struct {
        const char *object, *property;
    } NOTED[] = {
        {POINT("hinge", REFERS(1, 2) HAS("along_lower", 1)), "along_lower"},
        {POINT("hinge", REFERS(1, 2) HAS("turn_speed", 1)), "turn_speed"},
        {POINT("hinge", REFERS(1, 2) HAS("length", 1)), "length"},
        {POINT("hinge", REFERS(1, 2) HAS("ratio", 1)), "ratio"},
        {POINT("hinge", REFERS(1, 2) HAS("density", 1)), "density"},
        {POINT("slider", REFERS(1, 2) HAS("turn_lower", 1)), "turn_lower"},
        {POINT("filter", REFERS(1, 2) HAS("break_force", 1)), "break_force"},
        {"{\"id\":9,\"width\":8,\"height\":8," WITH("", "{\"name\":\"length\",\"value\":1}") "}",
         "length"},
    };
    for (size_t i = 0; i < sizeof NOTED / sizeof NOTED[0]; i++) {
        char note[80];
        scene s;
        level_report report;
        assert_true(read_map(NOTED[i].object, false, &s, &report));
        assert_int_equal(report.count, 1);
        snprintf(note, sizeof note, "object 9: property '%s' has no meaning", NOTED[i].property);
        assert_true(says(&report, LEVEL_NOTE, note));
        scene_free(&s);
        level_report_free(&report);
    }
}

static void shape_that_is_called_a_wheel_but_holds_nothing_is_a_body(void **state) {
    (void)state;
    scene s;
    level_report report;
    assert_true(read_map("{\"id\":9,\"type\":\"wheel\",\"x\":0,\"y\":0,\"width\":32,\"height\":32,"
                         "\"ellipse\":true," DYNAMIC "}",
                         false, &s, &report));
    assert_int_equal(s.body_count, 4);
    assert_int_equal(s.joint_count, 0);
    assert_int_equal(report.count, 1);
    assert_true(says(&report, LEVEL_NOTE, "object 9: without a or b it is no joint"));
    scene_free(&s);
    level_report_free(&report);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wrong_joint_is_refused_by_id_or_left_out_alone),
        cmocka_unit_test(everything_that_is_wrong_with_a_joint_is_listed),
        cmocka_unit_test(gear_of_what_cannot_be_geared_is_left_out),
        cmocka_unit_test(property_that_its_kind_does_not_have_is_noted),
        cmocka_unit_test(shape_that_is_called_a_wheel_but_holds_nothing_is_a_body),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
