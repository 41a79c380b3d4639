"""Tests that correct calls pass calls.py, and that a breach of each rule is reported."""

import unittest

import calls
from listing import read_listing

LISTING = """set(THUD_SOURCES
    src/base/base.h
    src/base/memory.c
    src/solver/wide_tally.c
    # stages
    src/solver/solve.c # stage
    src/islands/sleep.c # stage
    src/api/step.c
)
"""
OBJECTS = {
    "engine/CMakeFiles/thud.dir/src/base/memory.c.o": "qsort U         \ntd_memory_get T 0 40\n",
    "engine/CMakeFiles/thud-base.dir/src/solver/wide_tally.c.o": "td_tally_base T 0 10\n",
    "engine/CMakeFiles/thud-avx2.dir/src/solver/wide_tally.c.o": "td_tally_avx2 T 0 10\n",
    "engine/CMakeFiles/thud.dir/src/solver/solve.c.o":
        "td_solve T 0 10\ntd_memory_get U\ntd_tally_base U\ntd_tally_avx2 U\ntd_passes R 0 8\n",
    "engine/CMakeFiles/thud.dir/src/islands/sleep.c.o": "td_sleep T 0 10\ntd_memory_get U\n",
    "engine/CMakeFiles/thud.dir/src/api/step.c.o": "td_solve U\ntd_sleep U\nthud_world_step T 0 9\n",
}


class CallsTest(unittest.TestCase):
    def breaches(self, more=None, listing=LISTING):
        objects = {name: text + (more or {}).get(name.split("src/")[1], "")
                   for name, text in OBJECTS.items()}
        text = "".join(f"\n{name}:\n{symbols}" for name, symbols in objects.items())
        return calls.breaches(text, read_listing(listing))

    def assert_noticed(self, start, more=None, listing=LISTING):
        found = self.breaches(more, listing)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(start), found)

    def test_calls_that_go_up_have_no_breach(self):
        self.assertEqual(self.breaches(), [])

    def test_loop_is_noticed(self):
        found = self.breaches({"base/memory.c.o": "td_solve U\n"})
        self.assertIn("loops: base/memory.c -> solver/solve.c -> base/memory.c", found)

    def test_loop_through_a_constant_is_noticed(self):
        found = self.breaches({"base/memory.c.o": "td_passes U\n"})
        self.assertIn("loops: base/memory.c -> solver/solve.c -> base/memory.c", found)

    def test_stage_that_calls_a_stage_is_noticed(self):
        self.assert_noticed("stages: the stage islands/sleep.c calls td_solve",
                            {"islands/sleep.c.o": "td_solve U\n"})

    def test_call_of_what_stands_below_is_noticed(self):
        self.assert_noticed("order: base/memory.c calls td_tally_avx2 of solver/wide_tally.c",
                            {"base/memory.c.o": "td_tally_avx2 U\n"})

    def test_unit_outside_the_list_is_noticed(self):
        self.assert_noticed("listed: islands/sleep.c does not stand",
                            listing=LISTING.replace("src/islands/sleep.c # stage", ""))

    def test_unit_without_object_is_noticed(self):
        self.assert_noticed("listed: api/world.c has no object",
                            listing=LISTING.replace(")", "    src/api/world.c\n)"))


if __name__ == "__main__":
    unittest.main()
