"""Tests thud.hpp as games use it, with each C++ compiler there is: the programs of bindings/cpp/README.md
and the example, without and with exceptions; what a program links; and what the compiler refuses. Beside
the engine in one file it is tested by tests/package/test_one_file.py.

usage: check.py PROJECT LIBRARY CXX..."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, LIBRARY, COMPILERS = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), sys.argv[3:]
sys.path.append(str(PROJECT / "tests/package"))
from command import run  # noqa: E402

FLAGS = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]
BARE = ["-fno-exceptions", "-fno-rtti"]
INCLUDE = f"-I{PROJECT / 'engine/include'}"
BLOCKS = re.findall(r"```cpp\n(.*?)```", (PROJECT / "bindings/cpp/README.md").read_text(encoding="utf-8"),
                    re.DOTALL)
BEGIN, REST = BLOCKS[0], "\n".join(BLOCKS[1:])
PARTS = f"#include <thud/thud.hpp>\n#include <cstdio>\nint main() {{\n{REST}\n}}\n"
THROWS = """#define THUD_EXCEPTIONS
#include <thud/thud.hpp>
#include <cstring>
int other();
int main() {
    thud::world world(thud::default_world_def());
    world.create_body();
    thud::body body = *world.create_body();
    body.destroy();
    try {
        body.set_awake(true);
    } catch (const thud::error &error) {
        return error.code != THUD_ERROR_STALE || std::strcmp(error.what(), thud_result_text(error.code)) != 0
            || body.position().x != 0 || other();
    }
    return 1;
}
"""
RETURNS = """#include <thud/thud.hpp>
int other() { return thud::body().set_awake(true).code != THUD_ERROR_NULL; }
"""
REFUSED = {
    "deleted": "world.set_filter([](thud::world_ref, thud_shape_id, thud_shape_id) { return true; });",
    "no member has the name": "struct {} none; thud::listeners l{}; thud::connect(l, none);",
    "private": "class { void epilogue(thud::world_ref, const thud_contact &) {} } shy; "
               "thud::listeners l{}; thud::connect(l, shy);",
    "no matching": "struct { void epilogue(int) {} void epilogue(const char *) {} } odd; "
                   "thud::listeners l{}; thud::connect(l, odd);",
    "nodiscard": "world.create_body();",
}


def said(program):
    return re.findall(r"printf\(.*\); // (.*)", program)


class CppTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def build(self, compiler, text, *flags):
        source, program = self.folder / "game.cpp", self.folder / "game"
        source.write_text(text, encoding="utf-8")
        run(compiler, *FLAGS, *flags, INCLUDE, source, LIBRARY, "-lm", "-o", program)
        return program

    def test_programs_of_the_readme_print_what_it_says(self):
        for compiler in COMPILERS:
            for program in (BEGIN, PARTS):
                with self.subTest(compiler=compiler):
                    self.assertEqual(len(said(program)), program.count("std::printf("))
                    built = self.build(compiler, program, *BARE)
                    self.assertEqual(run(built).splitlines(), said(program))

    def test_example_falls_and_bounces(self):
        text = (PROJECT / "bindings/cpp/examples/falling.cpp").read_text(encoding="utf-8")
        lines = [run(self.build(compiler, text, *BARE)) for compiler in COMPILERS]
        self.assertEqual(len(set(lines)), 1)
        heights = [float(y) for y in re.findall(r" y (\S+)", lines[0])]
        self.assertEqual((len(heights), heights[0]), (80, 6.0))
        self.assertLess(min(heights), 1)
        self.assertGreater(lines[0].count("hit at"), 1)

    def test_exceptions_are_thrown_where_they_are_asked_for(self):
        compiler = COMPILERS[0]
        (self.folder / "returns.cpp").write_text(RETURNS, encoding="utf-8")
        run(compiler, *FLAGS, INCLUDE, "-c", self.folder / "returns.cpp", "-o", self.folder / "returns.o")
        run(self.build(compiler, THROWS, self.folder / "returns.o"))

    def test_a_program_links_what_it_calls(self):
        built = self.build(COMPILERS[0], BEGIN, "-O2", *BARE)
        names = set(re.findall(r" [TtWw] (\w*thud\w*)$", run("nm", built), re.MULTILINE))
        self.assertIn("thud_world_advance", names)
        self.assertEqual({name for name in names if name.startswith("_Z")}, set(), "not inline")
        self.assertEqual({name for name in names if "joint_create" in name or "rollback" in name}, set())

    def test_mistakes_are_refused_by_the_compiler(self):
        for words, call in REFUSED.items():
            text = f"#include <thud/thud.hpp>\nvoid f(thud::world &world) {{ (void)world; {call} }}\n"
            with self.subTest(call=call), self.assertRaisesRegex(AssertionError, words):
                run(COMPILERS[0], *FLAGS, INCLUDE, "-x", "c++", "-fsyntax-only", "-", input=text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
