"""Tests that check_table.py reports each kind of breach, and nothing for a correct table."""

import tempfile
import unittest
from pathlib import Path

from check_table import check

ROWS = ("| `walls_stop` | nothing passes | all | [passing.c](../tests/guarantees/passing.c) "
        "| walls were left out |\n"
        "| `rests` | it sleeps | not off: nothing sleeps | [rest.c](../tests/guarantees/rest.c) "
        "| never falls asleep again |\n"
        "| `elsewhere` | as said | all | `stands`, [test_a.c](../tests/test_a.c) "
        "| all of it fell |\n")
LISTING = {"walls_stop": "all", "rests": "not off: nothing sleeps"}
DRAWN = {"walls_stop": {"quality=draft", "quality=exact", "sleeping=on", "sleeping=off"},
         "rests": {"quality=draft", "quality=exact", "sleeping=on"}}


class TableTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for file, text in (("tests/guarantees/passing.c", "void walls_stop(trial *t) {"),
                           ("tests/guarantees/rest.c", "void rests(trial *t) {"),
                           ("tests/test_a.c", "void stands(void **state) {"),
                           ("engine/include/thud/q.h",
                            "extern THUD_API const thud_quality thud_quality_draft;\n"
                            "extern THUD_API const thud_quality thud_quality_exact;\n")):
            path = self.root / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def breaches(self, rows=ROWS, listing=LISTING, drawn=DRAWN):
        return check(rows, listing, drawn, self.root)

    def assert_breach(self, part, **changed):
        found = self.breaches(**changed)
        self.assertTrue(any(part in line for line in found), f"{part}: not in {found}")

    def test_whole_table_has_no_breach(self):
        self.assertEqual(self.breaches(), [])

    def test_guarantee_without_a_row(self):
        self.assert_breach("more is tried and has no row", listing={**LISTING, "more": "all"},
                           drawn={**DRAWN, "more": DRAWN["walls_stop"]})

    def test_row_that_nobody_tries(self):
        self.assert_breach("rests is not tried", listing={"walls_stop": "all"})

    def test_row_twice(self):
        self.assert_breach("elsewhere has 2 rows", rows=ROWS + ROWS.splitlines(True)[2])

    def test_file_that_is_not_there(self):
        self.assert_breach("test_b.c, which is not there", rows=ROWS.replace("test_a", "test_b"))

    def test_name_that_its_file_does_not_have(self):
        self.assert_breach("names falls", rows=ROWS.replace("`stands`", "`falls`"))
        (self.root / "tests/guarantees/rest.c").write_text("")
        self.assert_breach("names rests")

    def test_row_elsewhere_that_names_no_test(self):
        self.assert_breach("names no test", rows=ROWS.replace("`stands`, ", ""))

    def test_settings_that_differ(self):
        self.assert_breach("says 'all'", rows=ROWS.replace("not off: nothing sleeps", "all"))

    def test_row_without_a_fault(self):
        self.assert_breach("walls_stop names no fault", rows=ROWS.replace("walls were left out", ""))

    def test_value_that_a_guarantee_is_never_tried_on(self):
        self.assert_breach("walls_stop is never tried on quality=exact",
                           drawn={**DRAWN, "walls_stop": {"quality=draft", "sleeping=on",
                                                          "sleeping=off"}})

    def test_public_name_that_nobody_draws(self):
        header = self.root / "engine/include/thud/q.h"
        header.write_text(header.read_text() +
                          "extern THUD_API const thud_quality thud_quality_finest;\n")
        self.assert_breach("nobody draws quality=finest")


if __name__ == "__main__":
    unittest.main()
