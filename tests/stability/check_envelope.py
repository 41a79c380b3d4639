"""Checks thud-envelope from outside: check_envelope.py PROGRAM. Run in the project's root."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv.pop(1)
NOTES = "tests/stability/notes.md"


def run(*options):
    return subprocess.run([PROGRAM, *options], capture_output=True, text=True, timeout=200)


def names():
    """Of all extremes, as --help lists them."""
    listed = run("--help").stdout.split("Extremes:\n")[1]
    return [line.split()[0] for line in listed.splitlines()]


class Envelope(unittest.TestCase):
    def test_quick_page_has_every_extreme_and_its_figures(self):
        with tempfile.TemporaryDirectory() as directory:
            page = Path(directory) / "page.md"
            done = run("--quick", "--notes", NOTES, "--out", str(page))
            self.assertEqual(done.returncode, 0, done.stderr)
            text = page.read_text(encoding="utf-8")
        self.assertEqual(done.stdout, "")
        self.assertEqual(re.findall(r'<a id="(.*)">', text), names())
        for section in text.split('<a id="')[1:]:
            self.assertRegex(section, r"\n\|---\|.*\n\| .* \|")

    def test_only_runs_what_was_asked_for(self):
        done = run("--quick", "--without-box2d", "--only", "columns", "--only", "time-step")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(re.findall(r'<a id="(.*)">', done.stdout), ["columns", "time-step"])

    def test_the_same_run_twice_gives_the_same_page(self):
        once, again = (run("--quick", "--without-box2d", "--only", "energy") for _ in range(2))
        self.assertEqual(once.stdout, again.stdout)

    def test_wrong_command_lines_are_refused_with_a_message(self):
        for options in (["--only"], ["--only", "nonsense"], ["--fast"], ["--notes", "/nowhere/x"],
                        ["--out", "/nowhere/x", "--quick", "--only", "columns"]):
            done = run(*options)
            self.assertNotEqual(done.returncode, 0, options)
            self.assertIn("thud-envelope:", done.stderr, options)

    def test_usage_of_run_names_every_extreme(self):
        usage = Path("tools/envelope.sh").read_text(encoding="utf-8")
        for name in names():
            self.assertRegex(usage, rf"\b{name}\b")

    def test_page_in_docs_has_every_extreme_in_order(self):
        page = Path("docs/stability.md").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r'<a id="(.*)">', page), names())


unittest.main()
