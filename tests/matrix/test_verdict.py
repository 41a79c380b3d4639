"""Tests that verdict.py distinguishes rows of ./run matrix that differ from rows that agree, that
docs/platforms.md has the table of all rows, and that ./run matrix refuses unknown names."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import verdict

ROOT = Path(__file__).resolve().parents[2]
RUNS = "scene pit 01\nexact pit 02\nswept pit 03\nlevel hills 04\n"
REFUSED = re.sub(r"\d\d", verdict.OTHER_BUILD, RUNS)
ROWS = """# a comment
first | gcc | native | 64 bits | the reference
other | gcc | native plain | 64 bits | as the reference
big | s390x | qemu-s390x | big-endian | another order of bytes
x87 | i686 | refused | - | no row
"""


class VerdictTest(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.root = Path(place.name)
        self.write("tests/golden/hashes.txt", "pit 01\n")
        self.write("tests/matrix/rows.txt", ROWS)
        self.rows = verdict.read_rows(self.root)
        self.folders = self.root / "rows"
        for name in ("reference/full.out", "reference/short.out"):
            self.write("rows/" + name, RUNS)
        for name in ("rows/reference/levels", "rows/first/levels"):
            self.write(name, "level hills")
        for row, length in (("first", "full"), ("other", "full"), ("big", "short")):
            self.write(f"rows/{row}/{length}.snapshots", "")
            self.write(f"rows/{row}/own.out", RUNS)
            self.write(f"rows/{row}/back.out", RUNS)
            self.write(f"rows/{row}/from-reference.out", REFUSED if row == "big" else RUNS)
        self.write("rows/x87/refused", "3 3\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def judge(self, row):
        return verdict.judge(row, self.rows, self.folders, self.root)

    def fails(self, row, *faults):
        outcome = self.judge(row)
        self.assertEqual(outcome["verdict"], "failed", outcome)
        self.assertEqual(outcome["faults"], list(faults))

    def test_rows_that_agree(self):
        for row in ("first", "other", "big"):
            self.assertEqual(self.judge(row)["verdict"], "agrees", row)
        self.assertEqual(self.judge("x87")["verdict"], "refused")
        outcome = self.judge("other")
        self.assertEqual(verdict.cells_of("other", self.rows["other"], outcome)[3:],
                         ["120 steps", "1/1", "2/2", "1/1", "8/8", "agrees"])
        cells = verdict.cells_of("big", self.rows["big"], self.judge("big"))
        self.assertEqual(cells[3:],
                         ["60 steps", "1/1", "2/2", "1/1", "4/4; reference's refused", "agrees"])

    def test_another_hash_is_named(self):
        self.write("rows/other/own.out", RUNS.replace("03", "33"))
        self.fails("other", "swept pit")

    def test_a_run_too_few_or_too_many_is_named(self):
        self.write("rows/other/own.out", RUNS.replace("exact pit 02\n", ""))
        self.fails("other", "exact pit")
        self.write("rows/other/own.out", RUNS + "level valley 05\n")
        self.fails("other", "level valley, which the reference lacks")

    def test_snapshots_that_do_not_continue_are_named(self):
        self.write("rows/other/from-reference.out", RUNS.replace("01", verdict.OTHER_BUILD))
        self.fails("other", "the reference's snapshot of scene pit")
        self.write("rows/big/back.out", "")
        self.assertEqual(len(self.judge("big")["faults"]), 4)

    def test_foreign_snapshots_have_to_be_refused_by_their_reason(self):
        for outcome in ("01", "refused: restore: the snapshot is damaged"):
            self.write("rows/big/from-reference.out", REFUSED.replace(verdict.OTHER_BUILD, outcome, 1))
            self.fails("big", "the reference's snapshot of scene pit")

    def test_reference_has_to_end_as_the_golden_file_says(self):
        self.write("tests/golden/hashes.txt", "pit 01\ngas 09\n")
        self.fails("first", "scene gas is not as in tests/golden")

    def test_reference_that_printed_nothing_fails_every_row(self):
        for name in ("reference/full.out", "other/own.out"):
            self.write("rows/" + name, "")
        self.fails("other", "the reference printed nothing")

    def test_levels_read_otherwise_are_a_fault(self):
        self.write("rows/first/levels", "level valley")
        self.fails("first", "the levels that it read differ from the reference's")

    def test_a_file_that_compiles_where_none_may_is_a_fault(self):
        self.write("rows/x87/refused", "2 3\n")
        self.fails("x87", "only 2 of 3 files are refused by a message")
        self.write("rows/x87/refused", "0 0\n")
        self.assertEqual(self.judge("x87")["verdict"], "failed")

    def test_a_row_that_cannot_be_built_or_had(self):
        self.write("rows/other/failed", "1")
        self.write("rows/other/log", "one\nno compiler")
        self.fails("other", "it could not be built or run: no compiler (build/matrix/rows/other/log)")
        self.write("rows/other/missing", "gcc   a compiler\n")
        self.assertEqual(verdict.verdict_of(self.judge("other")), "not had: gcc a compiler")

    def test_table_takes_the_place_of_the_one_before(self):
        old = f"before {verdict.BEGIN}\nold\n{verdict.END} after"
        new = verdict.with_table(old, "| a |\n", "abc")
        self.assertNotIn("old", new)
        self.assertIn("at abc:\n\n| a |\n", new)
        self.assertEqual(new, verdict.with_table(new, "| a |\n", "abc"))


class RunTest(unittest.TestCase):
    def run_matrix(self, *words):
        return subprocess.run([ROOT / "run", "matrix", *words], capture_output=True, text=True,
                              check=False, env=dict(os.environ))

    def test_list_has_every_row(self):
        done = self.run_matrix("--list")
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertEqual(names, list(verdict.read_rows()))

    def test_unknown_words_are_refused(self):
        for words in (["--fast"], ["--rows", "gcc-O2,gcc-O9"], ["--rows"], ["--report", "--quick"]):
            done = self.run_matrix(*words)
            self.assertEqual(done.returncode, 1, done)
            self.assertIn("run: ", done.stderr)

    def test_every_row_has_its_build(self):
        text = (ROOT / "tests/matrix/builds.txt").read_text(encoding="utf-8")
        builds = {line.split("|")[0].strip() for line in text.splitlines() if line[0] != "#"}
        used = {row["build"] for row in verdict.read_rows().values() if row["how"] != "refused"}
        self.assertEqual(builds, used)

    def test_page_has_the_table_of_every_row(self):
        text = (ROOT / verdict.PAGE).read_text(encoding="utf-8")
        table = text[text.index(verdict.BEGIN):text.index(verdict.END)]
        names = re.findall(r"^\| ([a-zA-Z0-9-]+) \|", table, re.MULTILINE)
        self.assertEqual([name for name in names if name != "row" and set(name) != {"-"}],
                         list(verdict.read_rows()), "./run matrix --report writes the table")


if __name__ == "__main__":
    sys.exit(unittest.main())
