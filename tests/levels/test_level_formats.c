/* test_level_formats.c: tests all formats in which Tiled writes maps. The maps in
 * tests/levels/maps, each as JSON and as XML, are made by tools/make_test_levels.py; the page's
 * reader is tested with the same maps (tests/web/package/level-formats.test.mjs). */
#include "level_support.h"

static const scene_body *body_of(const scene *s, uint32_t id) {
    for (int i = 0; i < s->body_count; i++)
        if (s->bodies[i].id == id)
            return &s->bodies[i];
    fail_msg("no body is of object %u", id);
    return NULL;
}

static void assert_same_shapes(const scene *a, const scene *b) {
    assert_int_equal(a->body_count, b->body_count);
    assert_int_equal(a->shape_count, b->shape_count);
    assert_int_equal(a->point_count, b->point_count);
    for (int i = 0; i < a->body_count; i++) {
        const scene_body *p = &a->bodies[i], *q = &b->bodies[i];
        assert_true(p->kind == q->kind && p->x == q->x && p->y == q->y && p->angle == q->angle);
        assert_int_equal(p->shape_count, q->shape_count);
        assert_int_equal(p->id, q->id);
    }
    for (int i = 0; i < a->shape_count; i++) {
        const scene_shape *p = &a->shapes[i], *q = &b->shapes[i];
        assert_true(p->kind == q->kind && p->hx == q->hx && p->hy == q->hy && p->x == q->x &&
                    p->y == q->y && p->angle == q->angle);
        assert_true(p->material.friction == q->material.friction &&
                    p->material.density == q->material.density);
    }
    for (int i = 0; i < a->point_count; i++)
        assert_true(a->points[i].x == b->points[i].x && a->points[i].y == b->points[i].y);
}

static void assert_same_joints(const scene *a, const scene *b) {
    assert_int_equal(a->joint_count, b->joint_count);
    for (int i = 0; i < a->joint_count; i++) {
        const scene_joint *p = &a->joints[i], *q = &b->joints[i];
        assert_int_equal(p->kind, q->kind);
        for (int side = 0; side < 2; side++)
            assert_true(p->body[side] == q->body[side] && p->x[side] == q->x[side] &&
                        p->y[side] == q->y[side] && p->angle[side] == q->angle[side]);
        for (int way = 0; way < SCENE_DIRECTIONS; way++)
            assert_true(p->drive[way].limited == q->drive[way].limited &&
                        p->drive[way].lower == q->drive[way].lower &&
                        p->drive[way].frequency == q->drive[way].frequency &&
                        p->drive[way].motor_force == q->drive[way].motor_force);
        assert_true(p->length == q->length && p->break_torque == q->break_torque &&
                    p->collide_connected == q->collide_connected);
    }
}

static void map_is_the_same_as_json_and_as_xml(void **state) {
    (void)state;
    static const char *const NAMES[] = {"shapes", "hills",  "props",  "infinite", "unmarked",
                                        "wrong",  "csv",    "base64", "zlib",     "gzip",
                                        "zstd",   "joints", "loose",  "polygons", "far"};
    for (size_t i = 0; i < sizeof NAMES / sizeof NAMES[0]; i++) {
        char json[32], xml[32];
        level_report of_json, of_xml;
        snprintf(json, sizeof json, "%s.tmj", NAMES[i]);
        snprintf(xml, sizeof xml, "%s.tmx", NAMES[i]);
        scene a = read_file(json, &of_json), b = read_file(xml, &of_xml);
        assert_same_shapes(&a, &b);
        assert_same_joints(&a, &b);
        assert_int_equal(of_json.count, of_xml.count);
        for (int k = 0; k < of_json.count; k++)
            assert_string_equal(of_json.problems[k].text, of_xml.problems[k].text);
        level_report_free(&of_json);
        level_report_free(&of_xml);
        scene_free(&a);
        scene_free(&b);
    }
}

static void layer_is_the_same_however_it_is_packed(void **state) {
    (void)state;
    static const char *const NAMES[] = {"base64.tmj", "zlib.tmx", "gzip.tmj", "zstd.tmx"};
    level_report report;
    scene plain = read_file("csv.tmj", &report);
    assert_int_equal(report.count, 0);
    assert_true(plain.body_count > 70);
    for (size_t i = 0; i < sizeof NAMES / sizeof NAMES[0]; i++) {
        scene packed = read_file(NAMES[i], &report);
        assert_int_equal(report.count, 0);
        assert_same_shapes(&plain, &packed);
        scene_free(&packed);
    }
    scene_free(&plain);
}

/* The polygons of the map are what tools/make_test_levels.py says: which of them become how many
 * shapes, and what is said of each. */
static void polygons_are_approximated_by_at_most_as_many_shapes_as_they_say(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("polygons.tmj", &report);
    static const struct {
        uint32_t id;
        int most, least;
    } EXPECTED[] = {{13, 5, 2}, {14, 12, 6}, {15, 4, 1}, {16, 4, 1}, {17, 4, 2}, {18, 3, 1}};
    for (size_t i = 0; i < sizeof EXPECTED / sizeof EXPECTED[0]; i++) {
        int count = body_of(&s, EXPECTED[i].id)->shape_count;
        assert_true(count <= EXPECTED[i].most && count >= EXPECTED[i].least);
        char said[60];
        snprintf(said, sizeof said, "object %u: its polygon is approximated by %d shapes",
                 EXPECTED[i].id, count);
        assert_true(says(&report, LEVEL_NOTE, said));
    }
    const scene_body *ground = body_of(&s, 19);
    assert_int_equal(s.shapes[ground->first_shape].kind, SCENE_TERRAIN_IRREGULAR);
    assert_true(
        says(&report, LEVEL_SKIP, "object 20: edges of a polygon cross or touch each other"));
    assert_true(says(&report, LEVEL_SKIP, "object 21: a polygon is ground only if"));
    /* The wedge's area by the shoelace formula is 2000 pixels; its mass, at density 3, is that of
     * 2000 / 32^2 m^2. */
    const scene_body *heavy = body_of(&s, 16);
    double mass = 0;
    for (int i = 0; i < heavy->shape_count; i++) {
        const scene_shape *shape = &s.shapes[heavy->first_shape + i];
        double area = shape->kind == SCENE_CIRCLE ? 3.141592653589793 * shape->hx * shape->hx
                                                  : 4 * shape->hx * shape->hy;
        mass += area * shape->material.density;
    }
    assert_true(fabs(mass - 3 * 2000.0 / 1024) < 0.01);
    scene_free(&s);
    level_report_free(&report);
}

/* Reads a map with a tile in one cell and collision shapes for that tile. */
static scene read_tile(const char *shapes, uint32_t gid, level_report *report) {
    static char text[4096];
    snprintf(
        text, sizeof text,
        "{\"type\":\"map\",\"width\":1,\"height\":2,\"tilewidth\":32,\"tileheight\":32,"
        "\"tilesets\":[{\"firstgid\":1,\"tilewidth\":32,\"tileheight\":32,\"tiles\":[{\"id\":0,"
        "\"objectgroup\":{\"objects\":[%s]}}]}],\"layers\":[{\"type\":\"tilelayer\","
        "\"name\":\"t\",\"width\":1,\"height\":2,\"data\":[0,%u]}]}",
        shapes, gid);
    scene s;
    if (!level_read("tile", text, strlen(text), false, &s, report))
        fail_msg("%s", report->problems[0].text);
    return s;
}

static void collision_shape_lies_as_its_tile_is_flipped(void **state) {
    (void)state;
    /* 8 by 4 pixels about (10, 6) of 32 by 32; relative to the tile's middle, in metres with y up:
     * (-6, 10) / 32. */
    static const struct {
        uint32_t flip;
        double x, y, hx, hy;
    } LIES[] = {
        {0, -6, 10, 4, 2},           {0x80000000, 6, 10, 4, 2},  {0x40000000, -6, -10, 4, 2},
        {0xC0000000, 6, -10, 4, 2},  {0x20000000, -10, 6, 2, 4}, {0xA0000000, 10, 6, 2, 4},
        {0x60000000, -10, -6, 2, 4}, {0xE0000000, 10, -6, 2, 4},
    };
    for (size_t i = 0; i < sizeof LIES / sizeof LIES[0]; i++) {
        level_report report;
        scene s = read_tile("{\"id\":1,\"x\":6,\"y\":4,\"width\":8,\"height\":4}", 1 | LIES[i].flip,
                            &report);
        assert_int_equal(s.body_count, 1);
        assert_int_equal(s.shapes[0].kind, SCENE_AABB);
        assert_true(s.bodies[0].x == 0.5 && s.bodies[0].y == 0.5);
        assert_true(s.shapes[0].x == LIES[i].x / 32 && s.shapes[0].y == LIES[i].y / 32);
        assert_true(s.shapes[0].hx == LIES[i].hx / 32 && s.shapes[0].hy == LIES[i].hy / 32);
        scene_free(&s);
    }
}

static void collision_shape_that_leans_leans_the_other_way_in_a_flipped_tile(void **state) {
    (void)state;
    static const char SHAPE[] =
        "{\"id\":1,\"x\":9,\"y\":3,\"width\":18,\"height\":6,\"rotation\":30}";
    level_report report;
    scene s = read_tile(SHAPE, 1, &report);
    scene flipped = read_tile(SHAPE, 0x80000001, &report);
    scene turned = read_tile(SHAPE, 0x20000001, &report);
    assert_int_equal(s.shapes[0].kind, SCENE_OBB);
    assert_true(flipped.shapes[0].angle == -s.shapes[0].angle);
    assert_true(fabs(flipped.shapes[0].x + s.shapes[0].x) < 1e-12);
    assert_true(flipped.shapes[0].y == s.shapes[0].y);
    /* x and y are exchanged: an angle of 30 degrees from x becomes one of 30 degrees from y. */
    assert_true(turned.shapes[0].angle == -s.shapes[0].angle);
    assert_true(turned.shapes[0].hx == s.shapes[0].hy && turned.shapes[0].hy == s.shapes[0].hx);
    scene_free(&s);
    scene_free(&flipped);
    scene_free(&turned);
}

static void slope_is_ground_where_all_below_it_is_solid(void **state) {
    (void)state;
    static const char SLOPE[] = "{\"id\":1,\"x\":0,\"y\":32,\"polygon\":[{\"x\":0,\"y\":0},"
                                "{\"x\":32,\"y\":-32},{\"x\":32,\"y\":0}]}";
    level_report report;
    scene s = read_tile(SLOPE, 1, &report);
    assert_int_equal(s.shapes[0].kind, SCENE_TERRAIN_IRREGULAR);
    assert_true(s.bodies[0].x + s.points[0].x == 0 && s.bodies[0].y + s.points[0].y == 0);
    assert_true(s.bodies[0].x + s.points[1].x == 1 && s.bodies[0].y + s.points[1].y == 1);
    scene_free(&s);

    scene flipped = read_tile(SLOPE, 0x80000001, &report);
    assert_true(flipped.bodies[0].y + flipped.points[0].y == 1);
    assert_true(flipped.bodies[0].y + flipped.points[1].y == 0);
    scene_free(&flipped);

    /* In the air, all below it would become solid. */
    scene in_air = read_file("wrong.tmj", &report);
    assert_true(says(&report, LEVEL_SKIP, "the polygons of 1 tiles are no ground"));
    for (int i = 0; i < in_air.shape_count; i++)
        assert_true(in_air.shapes[i].kind != SCENE_TERRAIN_IRREGULAR);
    scene_free(&in_air);
    level_report_free(&report);
}

static void polygons_become_boxes_and_ground(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("hills.tmj", &report);
    assert_int_equal(report.count, 0);
    const scene_body *hill = body_of(&s, 31), *mirrored = body_of(&s, 32);
    assert_int_equal(s.shapes[hill->first_shape].kind, SCENE_TERRAIN_IRREGULAR);
    assert_int_equal(s.shapes[hill->first_shape].point_count, 4);
    assert_int_equal(s.shapes[mirrored->first_shape].point_count, 3);
    const scene_body *turned = body_of(&s, 33), *slanted = body_of(&s, 34);
    assert_int_equal(s.shapes[turned->first_shape].kind, SCENE_OBB);
    assert_true(s.shapes[turned->first_shape].hx == 1);
    assert_true(fabs(turned->angle + 20 * acos(-1) / 180) < 1e-12);
    /* 60 by 20 pixels, with the long side along (4, 3). */
    assert_true(fabs(s.shapes[slanted->first_shape].hx - 30.0 / 32) < 1e-12);
    assert_true(fabs(slanted->angle + atan2(3, 4)) < 1e-12);
    /* An arch becomes three boxes, and a dynamic body with two parts stays one body. */
    assert_int_equal(body_of(&s, 35)->shape_count, 3);
    assert_int_equal(body_of(&s, 36)->shape_count, 2);
    assert_int_equal(body_of(&s, 36)->kind, SCENE_DYNAMIC);
    assert_true(s.shapes[body_of(&s, 36)->first_shape].material.friction == 0.9);
    scene_free(&s);
}

static void tile_object_stands_on_its_lower_left_corner_as_large_as_it_is_drawn(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("props.tmx", &report);
    assert_false(says(&report, LEVEL_SKIP, ""));
    const scene_body *crate = body_of(&s, 13), *leaning = body_of(&s, 14);
    assert_true(crate->x == (60 + 20) / 32.0 && crate->y == (480 - (120 - 12)) / 32.0);
    assert_int_equal(crate->kind, SCENE_DYNAMIC);
    assert_true(s.shapes[leaning->first_shape].hx == 30.0 / 32);
    assert_true(s.shapes[leaning->first_shape].hy == 9.0 / 32);
    assert_int_equal(leaning->kind, SCENE_DYNAMIC); /* by its property `bodyType` */
    const scene_shape *barrel = &s.shapes[body_of(&s, 16)->first_shape];
    assert_int_equal(barrel->kind, SCENE_CIRCLE);
    assert_true(barrel->hx == 24.0 / 32 && barrel->material.density == 3);
    assert_int_equal(body_of(&s, 17)->shape_count, 2);
    scene_free(&s);
    level_report_free(&report);
}

static void object_of_a_template_has_its_fields_properties_and_tileset(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("props.tmj", &report);
    const scene_body *plain = body_of(&s, 22), *changed = body_of(&s, 23);
    const scene_shape *shape = &s.shapes[plain->first_shape];
    assert_int_equal(plain->kind, SCENE_DYNAMIC);
    assert_true(shape->hx == 20.0 / 32 && shape->hy == 12.0 / 32);
    assert_true(shape->material.density == 2.5);
    assert_true(s.shapes[changed->first_shape].material.density == 4);
    assert_true(fabs(changed->angle + acos(-1) / 4) < 1e-15);
    /* A gid on the object itself refers to the map's tilesets. */
    assert_int_equal(s.shapes[body_of(&s, 24)->first_shape].kind, SCENE_CIRCLE);
    assert_true(fabs(body_of(&s, 25)->angle + 25 * acos(-1) / 180) < 1e-15);
    scene_free(&s);
    level_report_free(&report);
}

static void infinite_map_has_the_tiles_of_all_its_chunks(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("infinite.tmj", &report);
    assert_int_equal(report.count, 0);
    double left = 1e9, right = -1e9;
    int lines = 0;
    for (int i = 0; i < s.body_count; i++) {
        if (s.bodies[i].id != 0)
            continue;
        left = fmin(left, s.bodies[i].x);
        right = fmax(right, s.bodies[i].x);
        lines += s.shapes[s.bodies[i].first_shape].kind == SCENE_TERRAIN_IRREGULAR;
    }
    /* Eight cells to the left of the origin, and the layer has an offset of 3.5 pixels. */
    assert_true(left == -7.5 + 3.5 / 32 && right == 15.5 + 3.5 / 32);
    assert_int_equal(lines, 3);
    scene_free(&s);
}

static void map_that_says_nothing_of_collisions_collides_everywhere_with_a_note(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("unmarked.tmj", &report);
    assert_int_equal(report.count, 1);
    assert_true(says(&report, LEVEL_NOTE, "nothing in this map says what collides"));
    assert_int_equal(s.body_count, 4);
    /* 48 by 40 pixels in the lower left corner of cell (4, 5), with an offset of (5, -3). */
    assert_true(s.shapes[0].hx == 24.0 / 32 && s.shapes[0].hy == 20.0 / 32);
    assert_true(s.bodies[0].x == (4 * 32 + 5 + 24) / 32.0);
    assert_true(s.bodies[0].y == (480 - (6 * 32 - 3 - 20)) / 32.0);
    assert_true(s.shapes[1].hx == 20.0 / 32 && s.shapes[1].hy == 24.0 / 32);
    assert_true(s.shapes[2].hx == 0.5); /* drawn at the size of its cell */
    scene_free(&s);
    level_report_free(&report);
}

static void everything_that_cannot_be_modelled_is_listed(void **state) {
    (void)state;
    level_report report;
    scene s = read_file("wrong.tmx", &report);
    assert_int_equal(body_of(&s, 1)->shape_count, 1);
    for (uint32_t id = 2; id <= 13; id++) {
        if (id == 10)
            continue; /* is valid */
        char object[20];
        snprintf(object, sizeof object, "object %u: ", id);
        if (!says(&report, LEVEL_SKIP, object))
            fail_msg("nothing is said of object %u", id);
    }
    scene_free(&s);
    level_report_free(&report);
    assert_false(level_read_file("tests/levels/maps/wrong.tmx", false, &s, &report));
    assert_int_equal(s.body_count, 0);
    level_report_free(&report);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(map_is_the_same_as_json_and_as_xml),
        cmocka_unit_test(layer_is_the_same_however_it_is_packed),
        cmocka_unit_test(polygons_are_approximated_by_at_most_as_many_shapes_as_they_say),
        cmocka_unit_test(collision_shape_lies_as_its_tile_is_flipped),
        cmocka_unit_test(collision_shape_that_leans_leans_the_other_way_in_a_flipped_tile),
        cmocka_unit_test(slope_is_ground_where_all_below_it_is_solid),
        cmocka_unit_test(polygons_become_boxes_and_ground),
        cmocka_unit_test(tile_object_stands_on_its_lower_left_corner_as_large_as_it_is_drawn),
        cmocka_unit_test(object_of_a_template_has_its_fields_properties_and_tileset),
        cmocka_unit_test(infinite_map_has_the_tiles_of_all_its_chunks),
        cmocka_unit_test(map_that_says_nothing_of_collisions_collides_everywhere_with_a_note),
        cmocka_unit_test(everything_that_cannot_be_modelled_is_listed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
