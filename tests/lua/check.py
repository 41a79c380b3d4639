"""Tests thud.lua, with the engine's library as a shared one: its own suite, the programs of its README,
and the example, whose pictures are those of the example for C++.

usage: check.py PROJECT LIBRARY CC LUAJIT"""

import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT, LIBRARY, CC, LUAJIT = Path(sys.argv[1]).resolve(), *sys.argv[2:5]
sys.path.append(str(PROJECT / "tests/package"))
from command import run  # noqa: E402

BINDING = PROJECT / "bindings/lua"


class LuaTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        held = tempfile.TemporaryDirectory()
        cls.addClassCleanup(held.cleanup)
        cls.library = Path(held.name) / "libthud.so"
        run(CC, "-shared", "-o", cls.library, "-Wl,--whole-archive", LIBRARY, "-Wl,--no-whole-archive", "-lm",
            "-pthread")

    def lua(self, *words, **more):
        return run(LUAJIT, *words, env={**os.environ, "LUA_PATH": f"{BINDING}/?.lua", "MALLOC_PERTURB_": "90",
                                        "THUD_LIBRARY": str(self.library)}, **more)

    def test_its_own_suite(self):
        self.assertRegex(self.lua(PROJECT / "tests/lua/test.lua", PROJECT / "tests/golden/hashes.txt"),
                         r"^\d\d tests passed\n$")

    def test_programs_of_the_readme_print_what_it_says(self):
        text = (BINDING / "README.md").read_text(encoding="utf-8")
        program = "\n".join(re.findall(r"```lua\n(.*?)```", text, re.DOTALL))
        said = re.findall(r"^print\(.*\) -- (.*)", program, re.MULTILINE)
        self.assertGreater(len(said), 9)
        self.assertEqual(len(said), len(re.findall(r"\bprint\(", program)))
        self.assertEqual(self.lua("-", input=program).splitlines(), said)

    def test_example_falls_and_bounces(self):
        said = self.lua(BINDING / "examples/falling.lua")
        heights = [float(y) for y in re.findall(r" y (\S+)", said)]
        self.assertEqual((len(heights), heights[0]), (80, 6.0))
        self.assertLess(min(heights), 1)
        self.assertGreater(said.count("hit at"), 1)

    def test_example_for_love_is_a_program(self):
        for path in (BINDING / "examples/love").glob("*.lua"):
            run(LUAJIT, "-bl", path)

    def test_a_library_of_another_version_is_refused(self):
        program = "local ffi = require('ffi')\nlocal load = ffi.load\nffi.load = function(name)\n" \
                  "    local C = load(name)\n    return setmetatable({}, { __index = function(_, key)\n" \
                  "        return key == 'thud_version' and function() return 1 end or C[key]\n    end })\nend\n" \
                  "require('thud')\n"
        with self.assertRaisesRegex(AssertionError, "of different versions"):
            self.lua("-", input=program)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
