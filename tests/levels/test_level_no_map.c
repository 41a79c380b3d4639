/* test_level_no_map.c: tests that files which are no maps, in all formats that Tiled writes, are
 * refused with a message. */
#include "level_support.h"

/* ---- files that are no maps ---- */

#define XML(body)                                                            \
    "<?xml version=\"1.0\"?><map width=\"2\" height=\"2\" tilewidth=\"32\" " \
    "tileheight=\"32\">" body "</map>"
#define PACKED(packing, data)                                                            \
    XML("<tileset firstgid=\"1\" tilewidth=\"32\" tileheight=\"32\"/><layer name=\"t\" " \
        "width=\"2\" "                                                                   \
        "height=\"2\"><data encoding=\"base64\" compression=\"" packing "\">" data       \
        "</data></layer>")

static void bad_file_is_told(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } BAD[] = {
        {"<map", "XML cannot be read"},
        {XML("<layer"), "XML cannot be read"},
        {"<html/>", "not a Tiled map"},
        {"<tileset/>", "not a Tiled map"},
        {"<map/>", "width is missing"},
        {"<map width=\"two\"/>", "width is not a number"},
        {"<!DOCTYPE m [<!ENTITY a \"b\">]><map>&a;</map>", "declares entities"},
        {PACKED("zlib", "ab!c"), "not in base64"},
        {PACKED("zlib", "a"), "not in base64"},
        {PACKED("zlib", "aaa=="), "not in base64"},
        {PACKED("zlib", "eJxjYGBgAAAABAAB"), "do not unpack"},
        {PACKED("gzip", "eJxjYGBgAAAABAAB"), "do not unpack"},
        {PACKED("zstd", "eJxjYGBgAAAABAAB"), "do not unpack"},
        {PACKED("", "AAAA"), "do not unpack"},
        {PACKED("lzma", "AAAA"), "not known"},
        {XML("<layer name=\"t\" width=\"900000\" height=\"900000\"><data encoding=\"base64\">AA"
             "</data></layer>"),
         "more cells than are read"},
        {XML("<layer name=\"t\" width=\"2\" height=\"2\"><data "
             "encoding=\"morse\">-.</data></layer>"),
         "not known"},
        {XML("<layer name=\"t\"><data encoding=\"csv\"><chunk x=\"0\" y=\"0\" width=\"1e9\" "
             "height=\"1\">0</chunk></data></layer>"),
         "width is out of range"},
        {XML("<layer name=\"t\"><data encoding=\"csv\"><chunk x=\"-1000000\" y=\"-1000000\" "
             "width=\"1\" height=\"1\">0</chunk><chunk x=\"1000000\" y=\"1000000\" width=\"1\" "
             "height=\"1\">0</chunk></data></layer>"),
         "more cells than are read"},
        {XML("<objectgroup><object id=\"3\" x=\"0\" y=\"0\"><polyline points=\"0,0 a\"/></object>"
             "</objectgroup>"),
         "object 3: x is missing"},
    };
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        scene s;
        level_report report;
        if (level_read("bad", BAD[i].text, strlen(BAD[i].text), false, &s, &report) ||
            report.count == 0 || !strstr(report.problems[0].text, BAD[i].says))
            fail_msg("%s: said '%s', not '%s'", BAD[i].text,
                     report.count > 0 ? report.problems[0].text : "nothing", BAD[i].says);
        assert_int_equal(s.body_count, 0);
        level_report_free(&report);
    }
}

static void xml_nested_deeply_is_refused_without_overflow(void **state) {
    (void)state;
    enum { DEPTH = 100000 };
    char *text = malloc(DEPTH * 7 + 64);
    int length = sprintf(text, "<map>");
    for (int i = 0; i < DEPTH; i++)
        length += sprintf(text + length, "<group>");
    scene s;
    level_report report;
    assert_false(level_read("deep", text, (size_t)length, true, &s, &report));
    assert_non_null(strstr(report.problems[0].text, "nested too deeply"));
    level_report_free(&report);
    free(text);
}

/* Opens a folder in which every path has the same content. */
static char *open_always(void *context, const char *path, size_t *length) {
    (void)path;
    *length = strlen(context);
    char *copy = malloc(*length + 1);
    strcpy(copy, context);
    return copy;
}

static void template_or_tileset_that_is_no_such_thing_is_told(void **state) {
    (void)state;
    static char TEMPLATE_OF_ITSELF[] = "<template><object template=\"a.tx\"/></template>";
    static char A_MAP[] = "<map/>";
    static const char MAP[] = XML("<tileset firstgid=\"1\" source=\"a.tx\"/><objectgroup>"
                                  "<object id=\"3\" x=\"0\" y=\"0\" template=\"a.tx\"/>"
                                  "<object id=\"4\" x=\"0\" y=\"0\" gid=\"1\"/></objectgroup>");
    scene s;
    level_report report;
    level_opener opener = {.open = open_always, .context = TEMPLATE_OF_ITSELF};
    assert_true(level_read_with("m", MAP, strlen(MAP), &opener, true, &s, &report));
    assert_true(says(&report, LEVEL_SKIP, "object 3: its template has no object of its own"));
    assert_true(says(&report, LEVEL_SKIP, "'a.tx' is no tileset"));
    scene_free(&s);
    level_report_free(&report);

    opener.context = A_MAP;
    assert_true(level_read_with("m", MAP, strlen(MAP), &opener, true, &s, &report));
    assert_true(says(&report, LEVEL_SKIP, "template 'a.tx': it is no template"));
    scene_free(&s);
    level_report_free(&report);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_file_is_told),
        cmocka_unit_test(xml_nested_deeply_is_refused_without_overflow),
        cmocka_unit_test(template_or_tileset_that_is_no_such_thing_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
