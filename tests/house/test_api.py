"""Tests that declarations by the rules pass api.py, and that a breach of each rule is reported:
test_api.py [CLANG]."""

import sys
import unittest

import api

CLANG = "clang-16"
GOOD = """
#define THUD_API __attribute__((visibility("default")))
typedef struct thud_world thud_world;
typedef struct thud_shape_id { unsigned index1; } thud_shape_id;
typedef struct thud_geometry { double x; } thud_geometry;
typedef struct thud_stats { int steps; _Bool enabled; } thud_stats;
typedef enum thud_result { THUD_OK, THUD_ERROR_NULL } thud_result;
typedef enum thud_body_kind { THUD_BODY_STATIC, THUD_BODY_KIND_COUNT } thud_body_kind;
typedef void thud_log_fn(const char *text, void *context);
THUD_API thud_result thud_world_get_stats(const thud_world *world, thud_stats *out);
THUD_API thud_result thud_world_set_log(thud_world *world, thud_log_fn *log, void *context);
THUD_API thud_result thud_world_get_shapes(const thud_world *world, thud_shape_id *out,
                                           int capacity, int *out_count);
THUD_API thud_result thud_shape_set_friction(thud_world *world, thud_shape_id shape, float x);
THUD_API _Bool thud_geometry_overlap(const thud_geometry *a, const thud_geometry *b);
THUD_API thud_geometry thud_circle_at(double x);
THUD_API thud_result thud_world_load(thud_world *world, void *out_own, unsigned long bytes);
static inline thud_stats thud_stats_of(const thud_world *world) {
    thud_stats stats = {0, 0};
    thud_world_get_stats(world, &stats);
    return stats;
}
"""


class ApiTest(unittest.TestCase):
    def breaches(self, text):
        return api.breaches(api.parse(text, ".", CLANG))

    def assert_noticed(self, start, good, bad):
        self.assertIn(good, GOOD)
        found = self.breaches(GOOD.replace(good, bad))
        self.assertTrue(any(line.startswith(start) for line in found), found)

    def test_declarations_by_the_rules_pass(self):
        self.assertEqual(self.breaches(GOOD), [])

    def test_enumerator_without_the_name_of_its_type_is_noticed(self):
        self.assert_noticed("names", "THUD_BODY_STATIC,", "THUD_STATIC,")
        self.assert_noticed("names", "THUD_ERROR_NULL", "THUD_NULL")

    def test_object_behind_another_argument_is_noticed(self):
        self.assert_noticed("order", "thud_shape_set_friction(thud_world *world, thud_shape_id shape",
                            "thud_shape_set_friction(thud_shape_id shape, thud_world *world")

    def test_argument_behind_an_output_is_noticed(self):
        self.assert_noticed("order", "unsigned long bytes);", "int at);")

    def test_output_of_another_name_is_noticed(self):
        self.assert_noticed("outputs", "int *out_count);", "int *count);")

    def test_read_that_returns_its_value_is_noticed(self):
        self.assert_noticed("reads", "THUD_API thud_result thud_world_get_shapes(",
                            "THUD_API int thud_world_get_shapes(")
        self.assert_noticed("reads", "THUD_API thud_geometry thud_circle_at(double x);",
                            "THUD_API thud_stats thud_world_stats(const thud_world *world);")

    def test_list_with_another_end_is_noticed(self):
        self.assert_noticed("lists", "int *out_count);", "int *out_number);")

    def test_name_of_what_is_not_is_noticed(self):
        self.assert_noticed("enabled", "_Bool enabled", "_Bool disabled")

    def test_eighth_argument_is_noticed(self):
        self.assert_noticed("seven", "thud_shape_id shape, float x", "thud_shape_id shape, float x, "
                            "int b, int c, int d, int e, int f")

    def test_geometry_named_as_a_shape_is_noticed(self):
        self.assert_noticed("shapes", "thud_geometry_overlap", "thud_shape_overlap")
        self.assert_noticed("shapes", "thud_geometry_overlap", "thud_overlap")

    def test_function_that_is_not_exported_is_noticed(self):
        self.assert_noticed("exported", "THUD_API _Bool", "_Bool")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        CLANG = sys.argv.pop(1)
    unittest.main()
