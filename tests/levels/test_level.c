/* test_level.c: tests which bodies and shapes the objects, tiles and properties of a Tiled map
 * become in a scene. */
#include "level.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* Reads a map of 20 by 10 tiles of 32 pixels, with the given map fields and layers. */
static bool read_with(const char *fields, const char *layers, bool skip, scene *s,
                      level_report *report) {
    static char text[16384];
    int length = snprintf(text, sizeof text,
                          "{\"type\":\"map\",\"orientation\":\"orthogonal\",\"width\":20,"
                          "\"height\":10,\"tilewidth\":32,\"tileheight\":32,%s\"layers\":[%s]}",
                          fields, layers);
    assert_true(length > 0 && (size_t)length < sizeof text);
    return level_read("test", text, (size_t)length, skip, s, report);
}

/* Reads a map with one layer of these objects, and expects an empty report. */
static scene read_objects(const char *objects) {
    static char layer[8192];
    scene s;
    level_report report;
    snprintf(layer, sizeof layer, "{\"type\":\"objectgroup\",\"name\":\"a\",\"objects\":[%s]}",
             objects);
    bool read = read_with("", layer, false, &s, &report);
    if (report.count > 0)
        print_error("%s\n", report.problems[0].text);
    assert_true(read);
    assert_int_equal(report.count, 0);
    return s;
}

#define DYNAMIC "{\"name\":\"body\",\"type\":\"string\",\"value\":\"dynamic\"}"

static void rectangle_static_and_upright_becomes_aabb_about_its_middle(void **state) {
    (void)state;
    scene s = read_objects("{\"id\":7,\"x\":64,\"y\":96,\"width\":64,\"height\":32}");
    assert_int_equal(s.body_count, 1);
    assert_int_equal(s.bodies[0].kind, SCENE_STATIC);
    assert_int_equal(s.bodies[0].id, 7);
    assert_int_equal(s.shapes[0].kind, SCENE_AABB);
    assert_true(s.bodies[0].x == 3 && s.bodies[0].y == 6.5);
    assert_true(s.shapes[0].hx == 1 && s.shapes[0].hy == 0.5);
    scene_free(&s);
}

static void rectangle_dynamic_becomes_obb_unless_its_rotation_is_fixed(void **state) {
    (void)state;
    scene s = read_objects(
        "{\"id\":1,\"x\":0,\"y\":0,\"width\":32,\"height\":32,\"properties\":[" DYNAMIC "]},"
        "{\"id\":2,\"x\":0,\"y\":0,\"width\":32,\"height\":32,\"properties\":[" DYNAMIC ","
        "{\"name\":\"fixed_rotation\",\"type\":\"bool\",\"value\":true}]}");
    assert_int_equal(s.bodies[0].kind, SCENE_DYNAMIC);
    assert_int_equal(s.shapes[0].kind, SCENE_OBB);
    assert_int_equal(s.shapes[1].kind, SCENE_AABB);
    assert_true(s.bodies[1].fixed_rotation);
    scene_free(&s);
}

static void rectangle_rotated_by_a_quarter_turns_clockwise_about_its_top_left_corner(void **state) {
    (void)state;
    /* 64 wide, 32 high, turned about (320, 96): it reaches 32 to the left and 64 down. */
    scene s =
        read_objects("{\"id\":1,\"x\":320,\"y\":96,\"width\":64,\"height\":32,\"rotation\":90}");
    assert_int_equal(s.shapes[0].kind, SCENE_OBB);
    assert_true(s.bodies[0].x == (320.0 - 16) / 32);
    assert_true(s.bodies[0].y == (320.0 - 96 - 32) / 32);
    assert_true(fabs(s.bodies[0].angle + acos(-1) / 2) < 1e-15);
    scene_free(&s);
}

static void rectangle_rotated_by_30_degrees_agrees_with_the_c_library(void **state) {
    (void)state;
    scene s =
        read_objects("{\"id\":1,\"x\":100,\"y\":50,\"width\":64,\"height\":32,\"rotation\":30}");
    double a = acos(-1) / 6;
    double x = 100 + cos(a) * 32 - sin(a) * 16, y = 50 + sin(a) * 32 + cos(a) * 16;
    assert_true(fabs(s.bodies[0].x - x / 32) <= 0x1p-17);
    assert_true(fabs(s.bodies[0].y - (320 - y) / 32) <= 0x1p-17);
    assert_true(fabs(s.bodies[0].angle + a) < 1e-15);
    scene_free(&s);
}

static void rotation_of_a_whole_turn_counts_as_none(void **state) {
    (void)state;
    scene s =
        read_objects("{\"id\":1,\"x\":0,\"y\":0,\"width\":32,\"height\":32,\"rotation\":-720}");
    assert_int_equal(s.shapes[0].kind, SCENE_AABB);
    assert_true(s.bodies[0].angle == 0);
    scene_free(&s);
}

static void ellipse_with_equal_axes_becomes_circle(void **state) {
    (void)state;
    scene s =
        read_objects("{\"id\":1,\"x\":32,\"y\":32,\"width\":48,\"height\":48.01,\"ellipse\":true}");
    assert_int_equal(s.shapes[0].kind, SCENE_CIRCLE);
    assert_true(s.shapes[0].hx == 0.75 && s.shapes[0].hy == 0);
    assert_true(s.bodies[0].x == 1.75);
    scene_free(&s);
}

static void polyline_drawn_from_the_right_becomes_terrain_from_the_left(void **state) {
    (void)state;
    scene s = read_objects("{\"id\":1,\"x\":320,\"y\":160,\"polyline\":[{\"x\":0,\"y\":0},"
                           "{\"x\":-64,\"y\":32},{\"x\":-320,\"y\":-32}]}");
    assert_int_equal(s.shapes[0].kind, SCENE_TERRAIN_IRREGULAR);
    assert_int_equal(s.shapes[0].point_count, 3);
    assert_true(s.bodies[0].x == 10 && s.bodies[0].y == 5);
    assert_true(s.points[0].x == -10 && s.points[0].y == 1);
    assert_true(s.points[1].x == -2 && s.points[1].y == -1);
    assert_true(s.points[2].x == 0 && s.points[2].y == 0);
    scene_free(&s);
}

static void point_of_class_spawn_sets_the_spawn_and_others_are_noted(void **state) {
    (void)state;
    scene s = read_objects("{\"id\":1,\"x\":64,\"y\":64,\"point\":true,\"type\":\"spawn\"}");
    assert_int_equal(s.body_count, 0);
    assert_true(s.spawn_x == 2 && s.spawn_y == 8);
    scene_free(&s);

    level_report report;
    assert_true(read_with("",
                          "{\"type\":\"objectgroup\",\"name\":\"a\",\"objects\":[{\"id\":5,"
                          "\"x\":0,\"y\":0,\"point\":true}]}",
                          false, &s, &report));
    assert_int_equal(report.notes, 1);
    assert_int_equal(report.problems[0].object, 5);
    scene_free(&s);
    level_report_free(&report);
}

static void properties_are_inherited_from_map_and_layer_and_overridden(void **state) {
    (void)state;
    scene s;
    level_report report;
    assert_true(read_with(
        "\"properties\":[{\"name\":\"friction\",\"value\":0.1},{\"name\":\"density\",\"value\":2},"
        "{\"name\":\"gravity_y\",\"value\":-3},{\"name\":\"pixels_per_unit\",\"value\":16},"
        "{\"name\":\"character\",\"value\":true}],",
        "{\"type\":\"group\",\"name\":\"g\",\"offsetx\":32,\"properties\":[{\"name\":\"body\","
        "\"value\":\"dynamic\"}],\"layers\":[{\"type\":\"objectgroup\",\"name\":\"a\","
        "\"offsetx\":16,\"offsety\":16,\"properties\":[{\"name\":\"density\",\"value\":5}],"
        "\"objects\":[{\"id\":1,\"x\":0,\"y\":0,\"width\":32,\"height\":32,\"properties\":"
        "[{\"name\":\"restitution\",\"value\":0.5},{\"name\":\"velocity_x\",\"value\":4},"
        "{\"name\":\"mask\",\"value\":6},{\"name\":\"sensor\",\"value\":true}]}]}]}",
        false, &s, &report));
    assert_int_equal(report.count, 0);
    const scene_shape *shape = &s.shapes[0];
    assert_int_equal(s.bodies[0].kind, SCENE_DYNAMIC);
    assert_true(s.bodies[0].vx == 4);
    assert_true(shape->material.friction == 0.1 && shape->material.density == 5);
    assert_true(shape->material.restitution == 0.5 && shape->sensor && shape->mask == 6);
    assert_true(s.character);
    assert_true(s.gravity_y == -3 && s.bodies[0].x == 4 && s.bodies[0].y == 18);
    scene_free(&s);
}

static void tiles_become_boxes_where_layer_tile_or_tileset_says_solid(void **state) {
    (void)state;
    scene s;
    level_report report;
    /* Tile 1 is solid by its tileset, tile 2 is not by its own property, and tile 3 has its own
     * friction; the cell 2147483649 is tile 1 with a flip bit. */
    const char *tilesets =
        "\"tilesets\":[{\"firstgid\":1,\"tilewidth\":32,\"tileheight\":32,\"properties\":"
        "[{\"name\":\"solid\",\"value\":true}],\"tiles\":[{\"id\":1,\"properties\":[{\"name\":"
        "\"solid\",\"value\":false}]},{\"id\":2,\"properties\":[{\"name\":\"friction\","
        "\"value\":0}]}]}],";
    assert_true(read_with(tilesets,
                          "{\"type\":\"tilelayer\",\"name\":\"t\",\"width\":3,\"height\":2,"
                          "\"data\":[1,2,3,0,2147483649,0]}",
                          false, &s, &report));
    assert_int_equal(s.body_count, 3);
    assert_true(s.bodies[0].x == 0.5 && s.bodies[0].y == 9.5);
    assert_true(s.shapes[1].material.friction == 0 && s.bodies[1].x == 2.5);
    assert_true(s.bodies[2].x == 1.5 && s.bodies[2].y == 8.5);
    for (int i = 0; i < 3; i++)
        assert_true(s.shapes[i].kind == SCENE_AABB && s.shapes[i].hx == 0.5);
    scene_free(&s);

    assert_true(read_with(tilesets,
                          "{\"type\":\"tilelayer\",\"name\":\"t\",\"width\":1,\"height\":1,"
                          "\"data\":[1],\"properties\":[{\"name\":\"solid\",\"value\":false}]}",
                          false, &s, &report));
    assert_int_equal(s.body_count, 0);
    scene_free(&s);
}

static void turn_agrees_with_the_c_library_and_is_exact_at_quarters(void **state) {
    (void)state;
    double c, s;
    for (int i = -7200; i <= 7200; i++) {
        double degrees = 0.1 * i, radians = degrees * acos(-1) / 180;
        level_turn(degrees, &c, &s);
        assert_true(fabs(c - cos(radians)) < 1e-14 && fabs(s - sin(radians)) < 1e-14);
    }
    const double quarters[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int i = -8; i <= 8; i++) {
        double r = level_turn(90.0 * i, &c, &s);
        assert_true(c == quarters[(i + 8) % 4][0] && s == quarters[(i + 8) % 4][1]);
        assert_true(r >= -180 && r < 180);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangle_static_and_upright_becomes_aabb_about_its_middle),
        cmocka_unit_test(rectangle_dynamic_becomes_obb_unless_its_rotation_is_fixed),
        cmocka_unit_test(rectangle_rotated_by_a_quarter_turns_clockwise_about_its_top_left_corner),
        cmocka_unit_test(rectangle_rotated_by_30_degrees_agrees_with_the_c_library),
        cmocka_unit_test(rotation_of_a_whole_turn_counts_as_none),
        cmocka_unit_test(ellipse_with_equal_axes_becomes_circle),
        cmocka_unit_test(polyline_drawn_from_the_right_becomes_terrain_from_the_left),
        cmocka_unit_test(point_of_class_spawn_sets_the_spawn_and_others_are_noted),
        cmocka_unit_test(properties_are_inherited_from_map_and_layer_and_overridden),
        cmocka_unit_test(tiles_become_boxes_where_layer_tile_or_tileset_says_solid),
        cmocka_unit_test(turn_agrees_with_the_c_library_and_is_exact_at_quarters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
