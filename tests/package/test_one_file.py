"""Tests the engine in one file: it is made to the same bytes twice, compiled without a warning by one
call beside the program of README.md, and gives the bits of the library, golden hashes included. Where
there is a C++ compiler, thud.hpp stands beside it.

usage: test_one_file.py SOURCE CC TEST..., where a TEST is a program's name, its object file and what is
linked to it besides thud, between commas"""

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from command import run

SOURCE, CC = Path(sys.argv[1]), sys.argv[2]
TESTS = [words.split(",") for words in sys.argv[3:]]
# The objects of the one call are kept, and the tests linked to thud's. What clang says of the files in
# between, which it reads with all warnings, is not about the sources.
FLAGS = ["-std=c17", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-save-temps=obj"]


def make(folder):
    run(sys.executable, "-B", SOURCE / "tools/amalgamate.py", folder)


class OneFileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.held.name)
        make(cls.folder)
        program = (SOURCE / "examples/embed.c").read_text(encoding="utf-8")
        (cls.folder / "ball.c").write_text(program.replace("<thud/thud_all.h>", '"thud.h"'),
                                           encoding="utf-8")
        flags = FLAGS + ["-Wno-gnu-line-marker"] * ("clang" in run(CC, "--version"))
        run(CC, *flags, "ball.c", "thud.c", "-lm", "-o", "ball", cwd=cls.folder)
        cls.engine = next(path for path in cls.folder.glob("*thud*.o"))

    @classmethod
    def tearDownClass(cls):
        cls.held.cleanup()

    def test_files_are_the_same_to_the_byte(self):
        again = self.folder / "again"
        make(again)
        for name in ("thud.h", "thud.c", "thud.hpp", "thud_recorded.h"):
            self.assertEqual((again / name).read_bytes(), (self.folder / name).read_bytes(), name)
        shutil.rmtree(again)

    def test_program_of_the_readme_runs(self):
        self.assertEqual(run(self.folder / "ball"), "the ball rests at y = 0.50\n")

    def test_calls_can_be_recorded(self):
        program = """#include "thud.h"
#include "thud_recorded.h"
int main(void) {
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    thud_recorder *recorder = NULL;
    thud_player *player = NULL;
    thud_player_progress progress;
    thud_bytes bytes;
    if (thud_recorder_begin(world, NULL, &recorder) == THUD_OK && thud_world_step(world) == THUD_OK &&
        thud_recorder_get_bytes(recorder, &bytes) == THUD_OK &&
        thud_player_create(bytes, NULL, &player) == THUD_OK &&
        thud_player_get_progress(player, &progress) == THUD_OK)
        return progress.end == 1 ? 0 : 1;
    return 2;
}
"""
        (self.folder / "recorded.c").write_text(program, encoding="utf-8")
        run(CC, "-std=c17", "-Wall", "-Werror", "recorded.c", self.engine, "-lm", "-o", "recorded",
            cwd=self.folder)
        run(self.folder / "recorded")

    @unittest.skipUnless(shutil.which("c++"), "there is no C++ compiler")
    def test_header_for_cplusplus_needs_no_other(self):
        text = (SOURCE / "bindings/cpp/README.md").read_text(encoding="utf-8")
        program = re.search(r"```cpp\n(.*?)```", text, re.DOTALL)[1]
        (self.folder / "ball.cpp").write_text(program.replace("<thud/thud.hpp>", '"thud.hpp"'),
                                              encoding="utf-8")
        self.assertIn("\nc++ -std=c++17 -O2 ball.cpp thud.o -lm\n", text)
        run("c++", "-std=c++17", "-O2", "ball.cpp", self.engine, "-lm", "-o", "ball_cpp", cwd=self.folder)
        self.assertEqual(run(self.folder / "ball_cpp"), "0.5\n")

    def test_document_has_the_call(self):
        self.assertIn("\ncc -O2 ball.c thud.c -lm\n",
                      (SOURCE / "docs/embedding.md").read_text(encoding="utf-8"))

    def test_bits_are_those_of_the_library(self):
        self.assertTrue(TESTS)
        for name, *objects in TESTS:
            program = self.folder / name
            run(CC, "-o", program, *objects[:-1], self.engine, objects[-1], "-lm")
            self.assertIn("PASSED", run(program, cwd=SOURCE))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
