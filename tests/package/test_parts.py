"""Tests what tools/parts.py says that thud.c is compiled without: no file that is left calls one that is
left out, in any combination; each define alone and all at once compile without a warning; what all leave
gives the same bits; and docs/embedding.md has the table.

usage: test_parts.py SOURCE CC NM OBJECT...: the objects of the library, those of kernels for each processor.
With THUD_PARTS=full, which takes some minutes, thud.c is compiled without each part, what is left runs, and
the document's sizes are measured."""

import fnmatch
import functools
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from command import run

SOURCE, CC, NM, *OBJECTS = Path(sys.argv[1]), *sys.argv[2:]
FULL = os.environ.get("THUD_PARTS") == "full"
sys.path.append(str(SOURCE / "tools"))
from parts import PARTS, left_out_with, parts_of  # noqa: E402

FLAGS = ["-std=c17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wno-psabi"]
# Bodies of all kinds of shapes, which fall and collide; prints the hash of every tenth step.
PROGRAM = """#include "thud.h"
#include <stdio.h>
int main(void) {
    thud_pos line[] = {{-9, 1}, {-3, 0}, {3, 0}, {9, 1}};
    thud_terrain ground = {.kind = THUD_TERRAIN_IRREGULAR, .points = line, .count = 4};
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_draft);
    thud_body_options moving = {.kind = THUD_BODY_DYNAMIC, .restitution = 0.5f};
    thud_body_def still = thud_default_body_def();
    thud_shape_def surface = thud_default_shape_def();
    thud_body_id base;
    if (!world || thud_body_create(world, &still, &base) != THUD_OK ||
        thud_shape_create_terrain(world, base, &surface, &ground, NULL) != THUD_OK) {
        return 1;
    }
    for (int i = 0; i < 8; i++) {
        thud_body_make(world, thud_circle_at(i - 4, 3 + i, 0.5), &moving);
        thud_body_make(world, thud_obb_at(4 - i, 5 + i, 0.5, 0.25, 0.5 * i), &moving);
        thud_body_make(world, thud_aabb_at(i - 4, 9 + i, 0.25, 0.25), &moving);
    }
    for (int i = 0; i < 200; i++) {
        if (thud_world_step(world) != THUD_OK) {
            return 2;
        }
        if (i % 10 == 0) {
            printf("%016llx\\n", (unsigned long long)thud_hash_of(world));
        }
    }
    thud_world_destroy(world);
    return 0;
}
"""


def file_of(obj):
    """The file below engine/src that an object was compiled from."""
    return re.search(r"\.dir/(?:\./)?src/(.*)\.o$", obj)[1]


def symbols():
    """Of each file the names that it gives to others, and those that it takes from others."""
    given, taken = {file_of(obj): set() for obj in OBJECTS}, {file_of(obj): set() for obj in OBJECTS}
    for line in run(NM, "-A", *OBJECTS).splitlines():
        place, letter, name = re.match(r"(.*):[ 0-9a-f]* (\w) (.*)", line).groups()
        if letter.isupper():
            (taken if letter == "U" else given)[file_of(place)].add(name)
    return given, taken


def table():
    """The rows of the document, by the name of their part."""
    text = (SOURCE / "docs/embedding.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `THUD_NO_(\w+)`(?: and `THUD_NO_(\w+)`)? \| (.*) \| (.*) \| (\d+) \|$", text, re.MULTILINE)
    made = {" and ".join(filter(None, (name, other))): rest for name, other, *rest in rows}
    whole, = re.findall(r"^\| all of them \| \| \| (\d+) \|$", text, re.MULTILINE)
    return {**made, "ALL": ("", "", whole)}


def defines(names):
    return [f"-DTHUD_NO_{name}" for name in names]


class PartsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.held.name)
        run(sys.executable, "-B", SOURCE / "tools/amalgamate.py", cls.folder)
        (cls.folder / "falls.c").write_text(PROGRAM, encoding="utf-8")
        run(CC, *FLAGS, "-O2", "-c", "falls.c", cwd=cls.folder)
        cls.hashes = cls.run_with(*OBJECTS)
        cls.given, taken = symbols()
        # Pairs of files of which the first calls, or takes the address of what stands in, the second.
        homes = {name: file for file, names in cls.given.items() for name in names}
        cls.calls = {(file, homes[name]) for file, names in taken.items() for name in names
                     if homes.get(name, file) != file}

    @classmethod
    def tearDownClass(cls):
        cls.held.cleanup()

    @classmethod
    def run_with(cls, *objects):
        run(CC, "falls.o", *objects, "-lm", "-lpthread", "-o", "falls", cwd=cls.folder)
        return run(cls.folder / "falls")

    def compile(self, names, *flags):
        run(CC, *FLAGS, *flags, *defines(names), "thud.c", cwd=self.folder)

    @functools.lru_cache(maxsize=None)
    def kilobytes_without(self, *names):
        """The size of the object without these parts, which must run to the same bits."""
        self.compile(names, "-Os", "-c")
        self.assertEqual(self.run_with("thud.o"), self.hashes, names)
        text, data, *_ = run("size", self.folder / "thud.o").splitlines()[1].split()
        return (int(text) + int(data)) / 1000

    def test_what_is_left_calls_nothing_that_is_left_out(self):
        """A file is left out where all of its parts are. Where the parts of the file that is called are,
        and those that go with them, all of the caller's must be among these."""
        self.assertGreater(len(self.calls), 500)
        for caller, called in sorted(self.calls):
            out = left_out_with(*parts_of(called))
            if out:
                self.assertTrue(parts_of(caller) and set(parts_of(caller)) <= set(out),
                                f"{caller} calls {called}, which is left out with {' '.join(out)}")

    def test_what_only_a_part_calls_is_left_out_with_it(self):
        public = {file for file, names in self.given.items() if any(name.startswith("thud_") for name in names)}
        for names in [left_out_with(name) for name in PARTS] + [list(PARTS)]:
            left = {file for file in self.given if not (parts_of(file) and set(parts_of(file)) <= set(names))}
            callers = {file: {caller for caller, called in self.calls if called == file} for file in left}
            alone = [file for file in left - public if callers[file] and not callers[file] & left]
            self.assertEqual(alone, [], f"only parts that are left out by {' '.join(names)} call these")

    def test_every_line_of_the_table_is_of_use(self):
        for name, part in PARTS.items():
            for pattern in part.files:
                self.assertTrue(fnmatch.filter(self.given, pattern), f"{name}: {pattern}")
            for other in part.goes_with:
                self.assertTrue(any(name in parts_of(called) and other in parts_of(caller)
                                    for caller, called in self.calls), f"{other} does not call {name}")

    def test_part_that_another_calls_is_not_left_out_alone(self):
        for name, part in PARTS.items():
            for other in part.goes_with:
                names = [each for each in left_out_with(name) if each != other]
                done = subprocess.run([CC, *FLAGS, "-E", *defines(names), "-o", "/dev/null", "thud.c"],
                                      cwd=self.folder, capture_output=True, text=True, check=False)
                self.assertIn(f'"THUD_NO_{name} leaves out what another part calls: define THUD_NO_{other}, too"',
                              done.stderr)

    def test_each_part_is_left_out_alone(self):
        for name in PARTS:
            self.compile(left_out_with(name), "-fsyntax-only")

    def test_all_parts_are_left_out_at_once(self):
        """Of all combinations this one has the most functions of headers that nothing calls, of which a
        compiler warns."""
        self.compile(list(PARTS), "-Os", "-c")
        self.assertEqual(self.run_with("thud.o"), self.hashes)

    def test_document_has_the_table(self):
        self.assertCountEqual(table(), [*PARTS, "BISECT and SWEPT", "ALL"])
        for name, (what, others, _) in table().items():
            if name in PARTS:
                self.assertEqual(what, PARTS[name].what)
                self.assertEqual(others, ", ".join(f"`{other}`" for other in PARTS[name].goes_with))

    @unittest.skipUnless(FULL, "THUD_PARTS is not full")
    def test_document_has_the_sizes(self):
        """Sizes are those of gcc for x86-64. Other versions than that of the document differ by less than
        what is allowed here."""
        for name, (_, _, saved) in table().items():
            names = list(PARTS) if name == "ALL" else name.split(" and ")
            without = left_out_with(*names)
            others = [] if name == "ALL" else [each for each in without if each not in names]
            measured = self.kilobytes_without(*others) - self.kilobytes_without(*without)
            self.assertAlmostEqual(float(saved), measured, delta=1 + 0.1 * measured, msg=name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
