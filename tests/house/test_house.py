"""A healthy tree passes house.py, and each rule, broken alone, is noticed."""

import tempfile
import unittest
from pathlib import Path

import house

FLOORS = "0 base.h\n0 base/simd.h\n1 ray.*\n2 world.h\n3 step.h\n3 stage solve.*\n3 stage sleep.*\n4 step.c\n"
HEALTHY = {
    "engine/CMakeLists.txt": "add_library(thud STATIC\n  src/ray.c src/solve.c src/sleep.c src/step.c)\n",
    "engine/include/thud/thud.h": '#include "thud_math.h"\n',
    "engine/include/thud/thud_math.h": "#include <stdint.h>\n",
    "engine/src/base.h": '#include "thud/thud_math.h"\n',
    "engine/src/base/simd.h": "#include <immintrin.h>\n",
    "engine/src/ray.h": '#include "base.h"\n',
    "engine/src/ray.c": '#include "ray.h"\n#include <math.h>\n',
    "engine/src/world.h": '#include "ray.h"\n',
    "engine/src/step.h": '#include "world.h"\n',
    "engine/src/solve.h": '#include "step.h"\n',
    "engine/src/solve.c": '#include "solve.h"\n/* as _mm_add_ps( would do */\n',
    "engine/src/sleep.h": '#include "step.h"\n',
    "engine/src/sleep.c": '#include "sleep.h"\n',
    "engine/src/step.c": '#include "sleep.h"\n#include "solve.h"\n',
    "demo/run/CMakeLists.txt": "add_executable(thud-run main.c) # not old.c\n",
    "demo/run/main.c": "#include <thud/thud.h>\n",
    "web/package-lock.json": '{ "version": "1.0.0" }\n' * 500,
    "web/src/main.ts": 'import "./home/index";\n',
}


HOST = "https:" + "//example.org"


class HouseTest(unittest.TestCase):
    def breaches(self, changes=None, floors=FLOORS):
        with tempfile.TemporaryDirectory() as directory:
            root = Path(directory) / "tree"
            for name, text in {**HEALTHY, **(changes or {})}.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            table = Path(directory) / "floors.txt"
            table.write_text(floors, encoding="utf-8")
            return house.breaches(root, table)

    def assert_noticed(self, start, changes=None, floors=FLOORS):
        found = self.breaches(changes, floors)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(start), found)

    def test_healthy_tree_has_no_breach(self):
        self.assertEqual(self.breaches(), [])

    def test_include_of_a_higher_floor_is_noticed(self):
        self.assert_noticed("floors: engine/src/ray.c (floor 1) includes engine/src/world.h",
                            {"engine/src/ray.c": '#include "world.h"\n'})

    def test_stage_that_includes_a_stage_is_noticed(self):
        self.assert_noticed("floors: the stage engine/src/solve.c",
                            {"engine/src/solve.c": '#include "sleep.h"\n'})

    def test_include_of_nothing_is_noticed(self):
        self.assert_noticed("floors: engine/src/ray.c includes \"gone.h\"",
                            {"engine/src/ray.c": '#include "gone.h"\n'})

    def test_include_by_macro_is_noticed(self):
        self.assert_noticed("floors: engine/src/ray.c includes the macro WHICH",
                            {"engine/src/ray.c": "#include WHICH\n"})

    def test_cycle_is_noticed(self):
        self.assert_noticed("cycles: ", {
            "engine/include/thud/thud_math.h": '#include "thud.h"\n'})

    def test_file_on_no_floor_is_noticed(self):
        self.assert_noticed("listed: engine/src/stray.h", {"engine/src/stray.h": ""})

    def test_line_without_file_is_noticed(self):
        self.assert_noticed("listed: no file", floors=FLOORS + "4 query.c\n")

    def test_file_on_two_floors_is_noticed(self):
        self.assert_noticed("listed: engine/src/base.h", floors=FLOORS + "1 base.*\n")

    def test_public_header_that_includes_src_is_noticed(self):
        self.assert_noticed("public: engine/include/thud/thud.h", {
            "engine/include/thud/thud.h": '#include "../../src/world.h"\n'})

    def test_demo_that_includes_src_is_noticed(self):
        self.assert_noticed("outside: demo/run/main.c", {
            "demo/run/main.c": '#include "../../engine/src/world.h"\n'})

    def test_intrinsic_header_is_noticed(self):
        self.assert_noticed("intrinsics: engine/src/ray.c has arm_neon.h",
                            {"engine/src/ray.c": "#include <arm_neon.h>\n"})

    def test_intrinsic_call_is_noticed(self):
        for call in ("_mm_add_ps(a, b)", "_mm256_sqrt_ps (a)", "vaddq_f32(a, b)",
                     "vld1q_f32(p)", "wasm_f32x4_add(a, b)", "__builtin_ia32_minps(a, b)"):
            with self.subTest(call):
                self.assert_noticed("intrinsics: engine/src/ray.c",
                                    {"engine/src/ray.c": f"int x = {call};\n"})

    def test_400_lines_pass_and_401_are_noticed(self):
        self.assertEqual(self.breaches({"engine/src/ray.c": "\n" * 400}), [])
        self.assert_noticed("length: engine/src/ray.c has 401", {
            "engine/src/ray.c": "\n" * 401})

    def test_long_text_of_the_page_is_noticed(self):
        self.assert_noticed("length: web/src/main.ts has 401", {"web/src/main.ts": "\n" * 401})
        self.assertEqual(self.breaches({"web/node_modules/a/a.js": "\n" * 401}), [])

    def test_host_in_the_lock_file_is_noticed(self):
        self.assert_noticed("lock: web/package-lock.json", {
            "web/package-lock.json": f'"resolved": "{HOST}/a.tgz"\n'})
        self.assertEqual(self.breaches({"web/package-lock.json": '"resolved": "package"\n'}), [])

    def test_folder_of_another_machine_is_noticed(self):
        self.assert_noticed("elsewhere: web/src/main.ts has /home/", {
            "web/src/main.ts": 'const path = "/home/someone/thud";\n'})

    def test_source_that_cmake_does_not_name_is_noticed(self):
        self.assert_noticed("sources: demo/run/old.c", {"demo/run/old.c": ""})

    def test_source_that_is_not_there_is_noticed(self):
        self.assert_noticed("sources: a CMakeLists.txt names demo/run/new.c", {
            "demo/run/CMakeLists.txt": "add_executable(thud-run main.c new.c)\n"})

    def test_globbed_source_is_noticed(self):
        self.assert_noticed("sources: demo/run/CMakeLists.txt does not name *.c", {
            "demo/run/CMakeLists.txt": "file(GLOB all *.c)\nadd_executable(thud-run main.c)\n"})


if __name__ == "__main__":
    unittest.main()
