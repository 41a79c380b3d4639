"""Runs thud-envelope and the program that makes its page, and checks what they print and write:
check_envelope.py PROGRAM. Run it in the project's root."""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv.pop(1)
PAGE = "tests/stability/envelope.py"


def run(*options):
    return subprocess.run([PROGRAM, *options], capture_output=True, text=True, timeout=200)


def page(*options):
    return subprocess.run([sys.executable, "-B", PAGE, PROGRAM, *options], capture_output=True,
                          text=True, timeout=200)


def names():
    """The names of all extremes, as --help lists them."""
    listed = run("--help").stdout.split("Extremes:\n")[1]
    return [line.split()[0] for line in listed.splitlines()]


class Envelope(unittest.TestCase):
    def test_quick_page_has_every_extreme_and_its_figures(self):
        with tempfile.TemporaryDirectory() as directory:
            done = page("--quick", "--out", directory)
            self.assertEqual(done.returncode, 0, done.stderr)
            text = (Path(directory) / "stability.md").read_text(encoding="utf-8")
            again = page("--again", "--out", directory)
            self.assertEqual(again.returncode, 0, again.stderr)
            self.assertEqual((Path(directory) / "stability.md").read_text(encoding="utf-8"), text)
        self.assertEqual(re.findall(r'<a id="(.*)">', text), names())
        for section in text.split('<a id="')[1:]:
            self.assertRegex(section, r"\n\|---\|.*\n\| .* \|")

    def test_only_runs_what_was_asked_for(self):
        options = ["--quick", "--without-box2d", "--only", "columns", "--only", "time-step"]
        done = run(*options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([e["name"] for e in json.loads(done.stdout)["extremes"]],
                         ["columns", "time-step"])
        done = page(*options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Column of boxes\n\n| extreme |", done.stdout)

    def test_the_same_run_twice_gives_the_same_figures(self):
        once, again = (json.loads(run("--quick", "--without-box2d", "--only", "energy").stdout)
                       for _ in range(2))
        self.assertEqual(once["extremes"], again["extremes"])

    def test_wrong_command_lines_are_refused_with_a_message(self):
        for options in (["--only"], ["--only", "nonsense"], ["--fast"],
                        ["--json", "/nowhere/x", "--quick", "--only", "columns"]):
            done = run(*options)
            self.assertNotEqual(done.returncode, 0, options)
            self.assertIn("thud-envelope:", done.stderr, options)
        for options in (["--only"], ["--only", "nonsense"], ["--fast"], ["--again", "--out", "/no"]):
            done = page(*options)
            self.assertNotEqual(done.returncode, 0, options)
            self.assertNotEqual(done.stderr, "", options)

    def test_usage_of_run_names_every_extreme(self):
        usage = "".join(page("--help").stdout.split())
        for name in names():
            self.assertIn(name, usage)

    def test_page_in_docs_has_every_extreme_in_order(self):
        text = Path("docs/stability.md").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r'<a id="(.*)">', text), names())


unittest.main()
