"""Tests that correct headers pass headers.py, and that a breach of each rule is reported."""

import unittest

import headers

LIMITS = """/* thud_limits.h: every range. */
#define THUD_DENSITY_MAX 1e12f /* of a shape */
#define THUD_ANGLE_MAX 1e6
"""
MAIN = """/* thud.h: worlds. */
typedef struct thud_shape_def {
    float density; /* [0, THUD_DENSITY_MAX] */
    float friction;
} thud_shape_def;

/* ---- bodies ---- */

/* |angle| <= THUD_ANGLE_MAX. */
THUD_API thud_result thud_body_turn(thud_world *world, thud_pos about, double angle);
THUD_API thud_result thud_world_cast_ray(thud_world *world, thud_pos from, double dx, double dy);
"""
PURE = """/* thud_geometry.h: geometry. */
THUD_API bool thud_shapes_meet(const thud_shape *a, double x, double y, const thud_pos *points);
"""
ALL = "".join(f'#include "{name}.h"\n' for name in ("thud", "thud_limits", "thud_geometry"))
ENGINE = "if (density <= THUD_DENSITY_MAX && angle <= THUD_ANGLE_MAX) {\n    return 1e300;\n}\n"
TABLE = """#define LIMITS(FIELD, CALL) \\
    FIELD(thud_shape_def, density, density, 0, THUD_DENSITY_MAX, shape) \\
    CALL(thud_body_turn, angle, -THUD_ANGLE_MAX, THUD_ANGLE_MAX, \\
         thud_body_turn(p->world, p->here, x))

#endif
"""


class HeadersTest(unittest.TestCase):
    def breaches(self, main=MAIN, limits=LIMITS, pure=PURE, engine=ENGINE, table=TABLE, every=ALL):
        return headers.breaches({"thud.h": main, "thud_limits.h": limits, "thud_geometry.h": pure,
                                 "thud_all.h": every}, {"shape.c": engine}, table, "")

    def assert_noticed(self, start, **broken):
        found = self.breaches(**broken)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(start), found)

    def test_headers_that_say_what_they_must_pass(self):
        self.assertEqual(self.breaches(), [])

    def test_field_without_its_limit_is_noticed(self):
        self.assert_noticed("stated", main=MAIN.replace("[0, THUD_DENSITY_MAX]", ">= 0"))
        self.assert_noticed("stated", main=MAIN.replace("float density;", "float thickness;"))

    def test_limit_of_the_next_field_does_not_count(self):
        moved = MAIN.replace(" /* [0, THUD_DENSITY_MAX] */", "").replace(
            "float friction;", "float friction; /* [0, THUD_DENSITY_MAX] */")
        self.assert_noticed("stated", main=moved)

    def test_argument_without_its_limit_is_noticed(self):
        self.assert_noticed("stated", main=MAIN.replace("|angle| <= THUD_ANGLE_MAX", "Turns"))

    def test_limit_that_nothing_tries_or_uses_is_noticed(self):
        found = self.breaches(limits=LIMITS + "#define THUD_SIZE_MAX 16384.0f\n")
        self.assertEqual([line.split(":")[0] for line in found], ["tried", "used"])

    def test_numbers_are_noticed(self):
        self.assert_noticed("numbers", main=MAIN + "/* |x| <= 1e9 */\n")
        self.assert_noticed("numbers", engine=ENGINE + "return x <= 1e6f;\n")

    def test_mixed_vectors_are_noticed(self):
        self.assert_noticed("vectors", main=MAIN.replace("thud_pos about", "double x, double y"))
        self.assert_noticed("vectors", pure=PURE.replace("double x, double y", "thud_pos at"))

    def test_header_that_is_in_none_of_all_is_noticed(self):
        self.assert_noticed("all", every=ALL.replace('#include "thud_geometry.h"', ""))


if __name__ == "__main__":
    unittest.main()
