"""Tests that a correct tree passes house.py, and that a breach of each rule is reported."""

import tempfile
import unittest
from pathlib import Path

import house

LISTING = """set(THUD_SOURCES
    # numbers
    src/base/base.h
    src/base/simd.h

    src/solver/ray.h
    src/solver/ray.c
    src/state/world.h
    src/api/step.h
    src/solver/solve.h
    src/solver/solve.c # stage
    src/api/sleep.h
    src/api/sleep.c # stage
    src/api/step.c
)
"""
ROOMS = "".join(f"| `{folder}` | files |\n" for folder in ("base", "solver", "state", "api"))
HEALTHY = {
    "CHANGELOG.md": "# Changes\n\n## 1.2.3, not released yet\n\n## 1.2.2\n",
    "docs/architecture.md": ROOMS,
    "engine/CMakeLists.txt": LISTING,
    "engine/include/thud/thud.h": '#include "thud_math.h"\n',
    "engine/include/thud/thud_math.h": "#include <stdint.h>\n",
    "engine/include/thud/thud_version.h": "#define THUD_VERSION_MAJOR 1\n#define THUD_VERSION_MINOR 2\n"
                                          "#define THUD_VERSION_PATCH 3\n",
    "engine/src/base/base.h": '#include "thud/thud_math.h"\n',
    "engine/src/base/simd.h": "#include <immintrin.h>\n",
    "engine/src/solver/ray.h": '#include "base/base.h"\n',
    "engine/src/solver/ray.c": '#include "solver/ray.h"\n#include <math.h>\n',
    "engine/src/state/world.h": '#include "solver/ray.h"\n',
    "engine/src/api/step.h": '#include "state/world.h"\n',
    "engine/src/solver/solve.h": '#include "api/step.h"\n',
    "engine/src/solver/solve.c": '#include "solver/solve.h"\n/* as _mm_add_ps( would do */\n',
    "engine/src/api/sleep.h": '#include "api/step.h"\n',
    "engine/src/api/sleep.c": '#include "api/sleep.h"\n',
    "engine/src/api/step.c": '#include "api/sleep.h"\n#include "solver/solve.h"\n',
    "demo/run/CMakeLists.txt": "add_executable(thud-run main.c) # not old.c\n",
    "demo/run/main.c": "#include <thud/thud.h>\n",
    "web/package-lock.json": '{ "version": "1.0.0" }\n' * 500,
    "web/src/main.ts": 'import "./home/index";\n',
}


HOST = "https:" + "//example.org"


class HouseTest(unittest.TestCase):
    def breaches(self, changes=None):
        with tempfile.TemporaryDirectory() as directory:
            root = Path(directory)
            for name, text in {**HEALTHY, **(changes or {})}.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return house.breaches(root)

    def assert_noticed(self, start, changes):
        found = self.breaches(changes)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(start), found)

    def test_healthy_tree_has_no_breach(self):
        self.assertEqual(self.breaches(), [])

    def test_changelog_without_the_present_version_is_noticed(self):
        self.assert_noticed("changelog: ", {"CHANGELOG.md": "# Changes\n\n## 1.2.2\n"})
        self.assert_noticed("changelog: ", {"CHANGELOG.md": "# Changes\n"})

    def test_include_of_what_stands_below_is_noticed(self):
        self.assert_noticed(
            "order: engine/src/solver/ray.c includes engine/src/state/world.h, which stands below",
            {"engine/src/solver/ray.c": '#include "state/world.h"\n'})

    def test_stage_that_includes_a_stage_is_noticed(self):
        self.assert_noticed("order: the stage engine/src/api/sleep.c",
                            {"engine/src/api/sleep.c": '#include "solver/solve.h"\n'})

    def test_include_of_nothing_is_noticed(self):
        self.assert_noticed("order: engine/src/solver/ray.c includes \"gone.h\"",
                            {"engine/src/solver/ray.c": '#include "gone.h"\n'})

    def test_include_by_macro_is_noticed(self):
        self.assert_noticed("order: engine/src/solver/ray.c includes the macro WHICH",
                            {"engine/src/solver/ray.c": "#include WHICH\n"})

    def test_cycle_is_noticed(self):
        self.assert_noticed("cycles: ", {
            "engine/include/thud/thud_math.h": '#include "thud.h"\n'})

    def test_file_outside_the_list_is_noticed(self):
        self.assert_noticed("listed: engine/src/base/stray.h has 0 lines",
                            {"engine/src/base/stray.h": ""})

    def test_line_without_file_is_noticed(self):
        self.assert_noticed("listed: engine/CMakeLists.txt names src/api/query.h", {
            "engine/CMakeLists.txt": LISTING.replace(")", "    src/api/query.h\n)")})

    def test_file_with_two_lines_is_noticed(self):
        self.assert_noticed("listed: engine/src/base/base.h has 2 lines", {
            "engine/CMakeLists.txt": LISTING.replace("    # numbers\n", "    src/base/base.h\n")})

    def test_folder_without_a_row_in_the_architecture_is_noticed(self):
        self.assert_noticed("folders: docs/architecture.md has no row for engine/src/state", {
            "docs/architecture.md": ROOMS.replace("state", "estate")})

    def test_public_header_that_includes_src_is_noticed(self):
        self.assert_noticed("public: engine/include/thud/thud.h", {
            "engine/include/thud/thud.h": '#include "../../src/state/world.h"\n'})

    def test_demo_that_includes_src_is_noticed(self):
        self.assert_noticed("outside: demo/run/main.c", {
            "demo/run/main.c": '#include "../../engine/src/state/world.h"\n'})

    def test_intrinsic_header_is_noticed(self):
        self.assert_noticed("intrinsics: engine/src/solver/ray.c has arm_neon.h",
                            {"engine/src/solver/ray.c": "#include <arm_neon.h>\n"})

    def test_intrinsic_call_is_noticed(self):
        for call in ("_mm_add_ps(a, b)", "_mm256_sqrt_ps (a)", "vaddq_f32(a, b)",
                     "vld1q_f32(p)", "wasm_f32x4_add(a, b)", "__builtin_ia32_minps(a, b)"):
            with self.subTest(call):
                self.assert_noticed("intrinsics: engine/src/solver/ray.c",
                                    {"engine/src/solver/ray.c": f"int x = {call};\n"})

    def test_only_the_pool_of_the_browser_waits_by_webassembly(self):
        def told(file, call):
            found = self.breaches({file: f"int x = {call};\n"})
            return [line for line in found if line.startswith(f"intrinsics: {file}")]
        wait = "__builtin_wasm_memory_atomic_wait32(p, 0, -1)"
        self.assertEqual(told("web/wasm/api_threads.c", wait), [])
        self.assertEqual(len(told("web/wasm/api_world.c", wait)), 1)
        self.assertEqual(len(told("web/wasm/api_threads.c", "wasm_f32x4_add(a, b)")), 1)

    def test_host_in_the_lock_file_is_noticed(self):
        for name in house.LOCK_FILES:
            self.assert_noticed(f"lock: {name}", {name: f'"resolved": "{HOST}/a.tgz"\n'})
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

    def test_glob_of_scenes_is_allowed(self):
        self.assertEqual(self.breaches({
            "demo/scenes/CMakeLists.txt": "file(GLOB all *.c)\n",
            "demo/scenes/pit.c": ""}), [])


if __name__ == "__main__":
    unittest.main()
