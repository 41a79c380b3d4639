/* test_level_input.c: tests that invalid levels are reported, and refused or skipped, and that none
 * crashes the reader. */
#define _POSIX_C_SOURCE 200809L

#include "level.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

static const char *const LEVELS[] = {"assets/levels/platform.tmj",  "assets/levels/quarry.tmj",
                                     "assets/levels/towers.tmj",    "assets/levels/mountain.tmj",
                                     "assets/levels/adventure.tmj", "assets/levels/playground.tmj"};
enum { LEVEL_COUNT = sizeof LEVELS / sizeof LEVELS[0] };

#define MAP(fields) \
    "{\"type\":\"map\",\"width\":20,\"height\":10,\"tilewidth\":32,\"tileheight\":32," fields "}"
#define OBJECTS(objects) \
    MAP("\"layers\":[{\"type\":\"objectgroup\",\"name\":\"a\",\"objects\":[" objects "]}]")
/* A valid object 1 beside the invalid one. */
#define BESIDE(object) OBJECTS("{\"id\":1,\"x\":0,\"y\":0,\"width\":32,\"height\":32}," object)
#define BOX "\"x\":0,\"y\":0,\"width\":32,\"height\":32"
/* The same where a unit is a thousandth of a pixel. */
#define TINY(scale)                                                   \
    "\"properties\":[{\"name\":\"pixels_per_unit\",\"value\":0.001}," \
    "{\"name\":\"length_scale\",\"value\":" scale "}],"
#define BESIDE_FAR(scale, object)                                                              \
    MAP(TINY(scale) "\"layers\":[{\"type\":\"objectgroup\",\"name\":\"a\","                    \
                    "\"objects\":[{\"id\":1,\"x\":0,\"y\":0,\"width\":9,\"height\":9}," object \
                    "]}]")
#define WITH(property) BESIDE("{\"id\":9," BOX ",\"properties\":[" property "]}")

/* Each map has one valid object, 1, and one invalid object, 9. */
static const struct {
    const char *text, *says;
} BAD_OBJECTS[] = {
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"width\":40,\"height\":30,\"ellipse\":true}"), "unequal"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polygon\":[{\"x\":0,\"y\":0}]}"), "polygon"},
    {BESIDE("{\"id\":9," BOX ",\"text\":{\"text\":\"a\"}}"), "text"},
    {BESIDE("{\"id\":9," BOX ",\"gid\":3}"), "no tileset"},
    {BESIDE("{\"id\":9," BOX ",\"gid\":0}"), "gid is out of range"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"template\":\"a.tj\"}"), "template"},
    {BESIDE("{\"id\":9," BOX ",\"capsule\":true}"), "capsule"},
    {BESIDE("{\"id\":9,\"y\":0,\"width\":32,\"height\":32}"), "x is missing"},
    {BESIDE("{\"id\":9,\"x\":\"0\",\"y\":0,\"width\":32,\"height\":32}"), "x is not a number"},
    {BESIDE("{\"id\":9,\"x\":1e999,\"y\":0,\"width\":32,\"height\":32}"), "x is out of range"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":-1e10,\"width\":32,\"height\":32}"), "y is out of range"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"width\":-32,\"height\":32}"), "width is out of range"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"width\":0,\"height\":32}"), "size"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"width\":32}"), "size"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"width\":1e8,\"height\":32}"), "size"},
    {BESIDE("{\"id\":9," BOX ",\"rotation\":1e7}"), "rotation"},
    {BESIDE("{\"id\":9," BOX ",\"rotation\":null}"), "rotation"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polyline\":[{\"x\":0,\"y\":0}]}"), "two points"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polyline\":7}"), "two points"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":9}]}"), "y is"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polyline\":[{\"x\":0,\"y\":0},4]}"), "x is missing"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":9,\"y\":0},"
            "{\"x\":9,\"y\":9}]}"),
     "turns back"},
    {BESIDE("{\"id\":9,\"x\":0,\"y\":0,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":9,\"y\":0}],"
            "\"properties\":[{\"name\":\"body\",\"value\":\"dynamic\"}]}"),
     "static"},
    {WITH("{\"name\":\"density\",\"value\":\"heavy\"}"), "density is not a number"},
    {WITH("{\"name\":\"density\",\"value\":0}"), "density is out of range"},
    {WITH("{\"name\":\"density\",\"value\":1e300}"), "density is out of range"},
    {WITH("{\"name\":\"friction\",\"value\":-1}"), "friction is out of range"},
    {WITH("{\"name\":\"restitution\",\"value\":1.5}"), "restitution is out of range"},
    {WITH("{\"name\":\"velocity_x\",\"value\":-1e999}"), "velocity_x is out of range"},
    {WITH("{\"name\":\"sensor\",\"value\":1}"), "sensor is neither"},
    {WITH("{\"name\":\"body\",\"value\":\"solid\"}"), "body is none of"},
    {WITH("{\"name\":\"body\",\"value\":true}"), "body is not a text"},
    {WITH("{\"name\":\"mask\",\"value\":0.5}"), "mask is not a whole number"},
    {WITH("{\"name\":\"approximate\",\"value\":1.5}"), "approximate is not a whole number"},
    {WITH("{\"name\":\"friction\",\"value\":1e7}"), "friction"},
    {WITH("{\"name\":\"approximate\",\"value\":65}"), "approximate"},
    {WITH("{\"name\":\"approximate\",\"value\":-1}"), "approximate"},
    {WITH("{\"name\":\"category\",\"value\":-1}"), "category is out of range"},
    {BESIDE_FAR("1", "{\"id\":9,\"x\":2e6,\"y\":0,\"width\":9,\"height\":9}"), "place is further"},
    {BESIDE_FAR("1", "{\"id\":9,\"x\":0,\"y\":-2e6,\"polyline\":[{\"x\":0,\"y\":0},"
                     "{\"x\":9,\"y\":0}]}"),
     "place is further"},
    {BESIDE_FAR("1", "{\"id\":9,\"x\":0,\"y\":2e6,\"point\":true,\"type\":\"spawn\"}"),
     "place is further"},
    {BESIDE_FAR("1", "{\"id\":9,\"x\":0,\"y\":0,\"polyline\":[{\"x\":0,\"y\":0},"
                     "{\"x\":2e6,\"y\":0}]}"),
     "line is too long"},
    {BESIDE_FAR("1", "{\"id\":9,\"x\":0,\"y\":0,\"polygon\":[{\"x\":20,\"y\":0},"
                     "{\"x\":24,\"y\":0},{\"x\":24,\"y\":8},{\"x\":22,\"y\":8},"
                     "{\"x\":22,\"y\":4},{\"x\":20,\"y\":4}]}"),
     "further from its body"},
    {BESIDE_FAR("1000", "{\"id\":9,\"x\":0,\"y\":0,\"width\":2e4,\"height\":9}"), "size"},
};

static void bad_object_is_refused_by_id_or_skipped_alone(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof BAD_OBJECTS / sizeof BAD_OBJECTS[0]; i++) {
        const char *text = BAD_OBJECTS[i].text;
        scene s;
        level_report report;
        bool read = level_read("bad", text, strlen(text), false, &s, &report);
        /* A missing template is reported before the object that refers to it. */
        int first = 0;
        while (first < report.count && report.problems[first].object == 0)
            first++;
        const char *said = first < report.count ? report.problems[first].text : "nothing";
        if (read || strncmp(said, "object 9: ", 10) != 0 || !strstr(said, BAD_OBJECTS[i].says))
            fail_msg("%s: said '%s', not '%s'", text, said, BAD_OBJECTS[i].says);
        assert_int_equal(s.body_count, 0);
        scene_free(&s);
        level_report_free(&report);

        assert_true(level_read("bad", text, strlen(text), true, &s, &report));
        assert_int_equal(report.fatal, 0);
        assert_true(report.skipped > 0);
        assert_int_equal(s.body_count, 1);
        assert_int_equal(s.bodies[0].id, 1);
        scene_free(&s);
        level_report_free(&report);
    }
}

#define TILES(layer)                                                         \
    MAP("\"tilesets\":[{\"firstgid\":1,\"tilewidth\":32,\"tileheight\":32}," \
        "{\"firstgid\":5,\"source\":\"a.tsx\"},"                             \
        "{\"firstgid\":9,\"tilewidth\":16,\"tileheight\":16,\"properties\":" \
        "[{\"name\":\"solid\",\"value\":true}]}],\"layers\":[" layer "]")
#define CELLS(size, data) \
    TILES("{\"type\":\"tilelayer\",\"name\":\"t\"," size ",\"data\":" data "}")

#define XML(data)                                                            \
    "<map width='2' height='2' tilewidth='32' tileheight='32' infinite='0'>" \
    "<tileset firstgid='1' tilewidth='32' tileheight='32'/>"                 \
    "<layer name='t' width='2' height='2'>" data "</layer></map>"

/* Layers that are refused, or skipped with an empty world as the result. */
static const struct {
    const char *text, *says;
} BAD_LAYERS[] = {
    {MAP("\"layers\":7"), "no list of layers"},
    {MAP("\"layers\":[{\"type\":\"objectgroup\",\"name\":\"a\"}]"), "no list of objects"},
    {MAP("\"layers\":[{\"type\":\"wallpaper\",\"name\":\"a\"}]"), "'wallpaper' is not known"},
    {MAP("\"layers\":[3]"), "is not known"},
    {OBJECTS("{\"x\":0,\"y\":0,\"width\":32,\"height\":32}"), "no valid id"},
    {OBJECTS("[]"), "no valid id"},
    {MAP("\"layers\":[{\"type\":\"objectgroup\",\"offsetx\":\"a\",\"objects\":[]}]"), "offsetx"},
    {CELLS("\"width\":2,\"height\":2", "\"eJxjYGBgAAAABAAB\""), "do not fill"},
    {CELLS("\"width\":2,\"height\":2", "7"), "has no tiles"},
    {CELLS("\"width\":2,\"height\":2", "[0,0,0]"), "do not fill"},
    {CELLS("\"width\":-2,\"height\":-2", "[0,0,0,0]"), "width is out of range"},
    {CELLS("\"width\":1.5,\"height\":2", "[0,0,0]"), "no whole numbers"},
    {CELLS("\"height\":2", "[0,0]"), "width is missing"},
    {CELLS("\"width\":2,\"height\":1", "[-1,\"a\"]"), "no tile numbers"},
    {CELLS("\"width\":1,\"height\":1", "[6]"), "tileset 'a.tsx'"},
    {MAP("\"layers\":[{\"type\":\"tilelayer\",\"name\":\"t\",\"width\":1,\"height\":1,"
         "\"data\":[1]}]"),
     "no tileset that can be used"},
    {MAP(TINY("1") "\"tilesets\":[{\"firstgid\":1,\"tilewidth\":32,\"tileheight\":32,"
                   "\"properties\":[{\"name\":\"solid\",\"value\":true}]}],"
                   "\"layers\":[{\"type\":\"tilelayer\",\"name\":\"t\",\"width\":2,"
                   "\"height\":1,\"data\":[1,1],\"offsety\":2e6}]"),
     "layer 't': the places of 2 tiles are further"},
    {XML("<data/>"), "layer 't': has no tiles"},
    {XML("<data encoding='csv'>\n</data>"), "layer 't': has no tiles"},
    {XML("<data encoding='base64' compression='zlib'></data>"), "layer 't': has no tiles"},
    {XML(""), "layer 't': has no tiles"},
};

static void bad_layer_is_refused_or_skipped(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof BAD_LAYERS / sizeof BAD_LAYERS[0]; i++) {
        const char *text = BAD_LAYERS[i].text;
        scene s;
        level_report report;
        if (level_read("bad", text, strlen(text), false, &s, &report) || report.count == 0 ||
            !strstr(report.problems[0].text, BAD_LAYERS[i].says))
            fail_msg("%s: said '%s', not '%s'", text,
                     report.count > 0 ? report.problems[0].text : "nothing", BAD_LAYERS[i].says);
        level_report_free(&report);
        assert_true(level_read("bad", text, strlen(text), true, &s, &report));
        assert_int_equal(s.body_count, 0);
        scene_free(&s);
        level_report_free(&report);
    }
}

/* Each of 33 by 33 cells has a tile with 1024 shapes; 1024 of these make up 2^20 shapes. */
static void small_file_cannot_demand_any_amount_of_memory(void **state) {
    (void)state;
    enum { SHAPES = 1024, SIDE = 33 };
    char *text = malloc(1 << 17), *end = text;
    end += sprintf(end, "{\"type\":\"map\",\"width\":33,\"height\":33,\"tilewidth\":32,"
                        "\"tileheight\":32,\"tilesets\":[{\"firstgid\":1,\"tilewidth\":32,"
                        "\"tileheight\":32,\"tiles\":[{\"id\":0,\"objectgroup\":{\"objects\":[");
    for (int i = 1; i <= SHAPES; i++)
        end += sprintf(end, "%s{\"id\":%d,\"x\":0,\"y\":0,\"width\":32,\"height\":32}",
                       i > 1 ? "," : "", i);
    end += sprintf(end, "]}}]}],\"layers\":[{\"type\":\"tilelayer\",\"name\":\"t\",\"width\":33,"
                        "\"height\":33,\"data\":[");
    for (int i = 0; i < SIDE * SIDE; i++)
        end += sprintf(end, "%s1", i > 0 ? "," : "");
    end += sprintf(end, "]}]}");
    scene s;
    level_report report;
    assert_true(level_read("many", text, (size_t)(end - text), true, &s, &report));
    assert_int_equal(report.count, 1);
    assert_string_equal(report.problems[0].text,
                        "layer 't': 65 tiles are left out: this map has more shapes and vertices "
                        "than are read, 1048576 in all");
    assert_int_equal(s.shape_count, 1024 * SHAPES);
    scene_free(&s);
    level_report_free(&report);
    const char *wide = CELLS("\"width\":4097,\"height\":4096", "[]");
    assert_false(level_read("wide", wide, strlen(wide), false, &s, &report));
    assert_non_null(strstr(report.problems[0].text, "more cells than are read, 16777216 in all"));
    level_report_free(&report);
    free(text);
}

static void file_that_is_no_usable_map_is_refused_even_when_skipping(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } bad[] = {
        {"", "not JSON"},
        {"{", "not JSON"},
        {"\n\n{\"a\":}", "line 3"},
        {"{} {}", "not JSON"},
        {"[]", "not a Tiled map"},
        {"null", "not a Tiled map"},
        {"{\"type\":\"tileset\"}", "not a Tiled map"},
        {"{\"type\":\"map\"}", "width is missing"},
        {MAP("\"orientation\":\"isometric\",\"layers\":[]"), "isometric"},
        {MAP("\"layers\":[],\"properties\":[{\"name\":\"gravity_y\",\"value\":\"down\"}]"),
         "gravity_y is not a number"},
        {MAP("\"layers\":[],\"properties\":[{\"name\":\"pixels_per_unit\",\"value\":0}]"),
         "pixels_per_unit is out of range"},
        {"{\"type\":\"map\",\"width\":1e9,\"height\":10,\"tilewidth\":32,\"tileheight\":32}",
         "width is out of range"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        scene s;
        level_report report;
        if (level_read("bad", bad[i].text, strlen(bad[i].text), true, &s, &report) ||
            report.fatal == 0 || !strstr(report.problems[0].text, bad[i].says))
            fail_msg("%s: said '%s'", bad[i].text,
                     report.count > 0 ? report.problems[0].text : "nothing");
        level_report_free(&report);
    }
    scene s;
    level_report report;
    assert_false(level_read_file("assets/levels/none.tmj", true, &s, &report));
    assert_int_equal(report.fatal, 1);
    level_report_free(&report);
    assert_false(level_read_file("assets/levels", true, &s, &report));
    assert_int_equal(report.fatal, 1);
    level_report_free(&report);
}

/* Opening a named pipe blocks until another process writes to it. */
static void named_pipe_is_refused_without_waiting(void **state) {
    (void)state;
    char folder[] = "/tmp/thud-pipe-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/map.tmj", folder);
    assert_int_equal(mkfifo(path, 0600), 0);
    scene s;
    level_report report;
    alarm(10); /* ends the process if the reader waits */
    assert_false(level_read_file(path, true, &s, &report));
    alarm(0);
    assert_int_equal(report.fatal, 1);
    level_report_free(&report);
    remove(path);
    remove(folder);
}

static void deep_nesting_is_refused_without_overflow(void **state) {
    (void)state;
    enum { DEPTH = 100000 };
    char *text = malloc(DEPTH);
    memset(text, '[', DEPTH);
    scene s;
    level_report report;
    assert_false(level_read("deep", text, DEPTH, true, &s, &report));
    level_report_free(&report);
    free(text);

    const char *group = "{\"type\":\"group\",\"name\":\"g\",\"layers\":[";
    char groups[4096] = "{\"type\":\"map\",\"width\":1,\"height\":1,\"tilewidth\":1,"
                        "\"tileheight\":1,\"layers\":[";
    for (int i = 0; i < 40; i++)
        strcat(groups, group);
    for (int i = 0; i < 40; i++)
        strcat(groups, "]}");
    strcat(groups, "]}");
    assert_false(level_read("groups", groups, strlen(groups), false, &s, &report));
    assert_non_null(strstr(report.problems[0].text, "too deep"));
    level_report_free(&report);
}

static void misspelt_property_is_noted(void **state) {
    (void)state;
    const char *text = WITH("{\"name\":\"densty\",\"value\":2}");
    scene s;
    level_report report;
    assert_true(level_read("note", text, strlen(text), false, &s, &report));
    assert_int_equal(report.notes, 1);
    assert_int_equal(report.problems[0].object, 9);
    assert_non_null(strstr(report.problems[0].text, "densty"));
    scene_free(&s);
    level_report_free(&report);
}

static void report_has_every_problem_in_words_however_many(void **state) {
    (void)state;
    enum { BAD = 3000 };
    char *text = malloc(BAD * 64 + 256);
    int length = sprintf(text, "{\"type\":\"map\",\"width\":1,\"height\":1,\"tilewidth\":1,"
                               "\"tileheight\":1,\"layers\":[{\"type\":\"objectgroup\","
                               "\"objects\":[");
    for (int i = 1; i <= BAD; i++)
        length += sprintf(text + length, "%s{\"id\":%d,\"capsule\":true}", i > 1 ? "," : "", i);
    length += sprintf(text + length, "]}]}");
    scene s;
    level_report report;
    assert_false(level_read("many", text, (size_t)length, false, &s, &report));
    assert_int_equal(report.count, BAD);
    assert_int_equal(report.skipped, BAD);
    for (uint32_t i = 0; i < BAD; i++)
        assert_int_equal(report.problems[i].object, i + 1);
    level_report_free(&report);
    free(text);
}

/* The whole file's text, which the caller frees. */
static char *read_text(const char *path, size_t *length) {
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_msg("%s cannot be read", path);
    char *text = malloc(1 << 20);
    *length = fread(text, 1, 1 << 20, file);
    fclose(file);
    return text;
}

static void every_shipped_level_loads_without_a_word(void **state) {
    (void)state;
    for (int i = 0; i < LEVEL_COUNT; i++) {
        scene s;
        level_report report;
        bool read = level_read_file(LEVELS[i], false, &s, &report);
        if (!read || report.count > 0)
            fail_msg("%s: %s", LEVELS[i], report.count > 0 ? report.problems[0].text : "");
        assert_true(s.body_count > 100);
        assert_true(strlen(s.title) > 0 && strlen(s.about) > 0);
        scene_free(&s);
    }
}

static void platform_level_has_a_thousand_tiles(void **state) {
    (void)state;
    scene s;
    level_report report;
    assert_true(level_read_file(LEVELS[0], false, &s, &report));
    int tiles = 0;
    for (int i = 0; i < s.body_count; i++)
        tiles += s.bodies[i].kind == SCENE_STATIC && s.bodies[i].id == 0;
    assert_true(tiles >= 1000);
    scene_free(&s);
}

/* Each text is in a block of exactly its length, so that the sanitizer finds reads beyond it. */
static void level_cut_short_anywhere_is_refused(void **state) {
    (void)state;
    level_report report;
    for (int i = 0; i < LEVEL_COUNT; i++) {
        size_t length;
        char *whole = read_text(LEVELS[i], &length);
        for (int cut = 0; cut < 150; cut++) {
            size_t keep = length * (size_t)cut / 150;
            char *text = malloc(keep + (keep == 0));
            memcpy(text, whole, keep);
            scene s;
            assert_false(level_read("cut", text, keep, true, &s, &report));
            assert_true(report.fatal > 0);
            level_report_free(&report);
            free(text);
        }
        free(whole);
    }
}

/* With some bytes changed, the reader refuses the level or returns finite numbers. */
static void level_with_bytes_changed_is_refused_or_finite(void **state) {
    (void)state;
    static const char replacements[] = "0129-.eE\"{}[],:xt\\\0\xff";
    uint32_t random = 1;
    level_report report;
    size_t length;
    char *text = read_text(LEVELS[2], &length);
    for (int round = 0; round < 400; round++) {
        size_t at[3];
        char saved[3];
        for (int i = 0; i < 3; i++) {
            random = random * 1664525u + 1013904223u;
            at[i] = (random >> 4) % length;
            saved[i] = text[at[i]];
            text[at[i]] = replacements[(random >> 25) % (sizeof replacements - 1)];
        }
        scene s;
        if (level_read("changed", text, length, true, &s, &report)) {
            for (int i = 0; i < s.body_count; i++) {
                const scene_body *b = &s.bodies[i];
                assert_true(b->x - b->x == 0 && b->y - b->y == 0 && b->angle - b->angle == 0);
            }
            for (int i = 0; i < s.shape_count; i++)
                assert_true(s.shapes[i].hx >= 0 && s.shapes[i].hx < 1e9);
            scene_free(&s);
        }
        level_report_free(&report);
        for (int i = 2; i >= 0; i--)
            text[at[i]] = saved[i];
    }
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_object_is_refused_by_id_or_skipped_alone),
        cmocka_unit_test(bad_layer_is_refused_or_skipped),
        cmocka_unit_test(small_file_cannot_demand_any_amount_of_memory),
        cmocka_unit_test(file_that_is_no_usable_map_is_refused_even_when_skipping),
        cmocka_unit_test(named_pipe_is_refused_without_waiting),
        cmocka_unit_test(deep_nesting_is_refused_without_overflow),
        cmocka_unit_test(misspelt_property_is_noted),
        cmocka_unit_test(report_has_every_problem_in_words_however_many),
        cmocka_unit_test(every_shipped_level_loads_without_a_word),
        cmocka_unit_test(platform_level_has_a_thousand_tiles),
        cmocka_unit_test(level_cut_short_anywhere_is_refused),
        cmocka_unit_test(level_with_bytes_changed_is_refused_or_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
