/* test_json.c: compares what the JSON writer writes with expected texts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "json.h"

#include <math.h>

/* Closes the file and compares its whole text. */
static void assert_written(json *out, const char *expected) {
    long length = ftell(out->file);
    assert_true(length >= 0 && length < 1000);
    char text[1000] = "";
    rewind(out->file);
    assert_int_equal(fread(text, 1, (size_t)length, out->file), length);
    fclose(out->file);
    assert_string_equal(text, expected);
}

static json begin(void) {
    json out = {.file = tmpfile()};
    assert_non_null(out.file);
    return out;
}

static void json_nested_values_have_commas_only_between_them(void **state) {
    (void)state;
    json out = begin();
    json_begin_object(&out, NULL);
    json_bool(&out, "quick", true);
    json_begin_array(&out, "rows");
    for (int i = 0; i < 2; i++) {
        json_begin_object(&out, NULL);
        json_number(&out, "a", i);
        json_number(&out, "b", 0.125);
        json_end(&out);
    }
    json_end(&out);
    json_begin_array(&out, "none");
    json_end(&out);
    json_end(&out);
    assert_written(&out, "{\n  \"quick\": true,\n  \"rows\": [\n    {\"a\": 0, \"b\": 0.125},\n"
                         "    {\"a\": 1, \"b\": 0.125}\n  ],\n  \"none\": []\n}\n");
}

static void json_text_with_quotes_and_controls_is_escaped(void **state) {
    (void)state;
    json out = begin();
    json_begin_object(&out, NULL);
    json_text(&out, "a\\b", "say \"yes\"\n");
    json_end(&out);
    assert_written(&out, "{\n  \"a\\\\b\": \"say \\\"yes\\\"\\u000a\"\n}\n");
}

static void json_number_that_is_whole_stays_whole_and_infinite_is_null(void **state) {
    (void)state;
    json out = begin();
    json_begin_array(&out, NULL);
    json_number(&out, NULL, 123456789);
    json_number(&out, NULL, 1.0 / 3);
    json_number(&out, NULL, INFINITY);
    json_number(&out, NULL, NAN);
    json_end(&out);
    assert_written(&out, "[\n  123456789,\n  0.333333,\n  null,\n  null\n]\n");
}

static void json_without_a_file_writes_nothing(void **state) {
    (void)state;
    json out = {.file = NULL};
    json_begin_object(&out, NULL);
    json_number(&out, "a", 1);
    json_end(&out);
    assert_int_equal(out.depth, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(json_nested_values_have_commas_only_between_them),
        cmocka_unit_test(json_text_with_quotes_and_controls_is_escaped),
        cmocka_unit_test(json_number_that_is_whole_stays_whole_and_infinite_is_null),
        cmocka_unit_test(json_without_a_file_writes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
