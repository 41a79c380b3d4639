"""Tests ./run test without building: its help lists its parts, and other names are refused."""

import os
import re
import subprocess
import unittest

RUN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../run")
PARTS = ["native", "sanitizers", "wasm", "page", "baseline"]


def run(*words):
    return subprocess.run([RUN, "test", *words], capture_output=True, text=True, check=False)


class RunTest(unittest.TestCase):
    def test_help_tells_of_every_part(self):
        done = run("--help")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(re.findall(r"^  ([a-z]+)  ", done.stdout, re.MULTILINE), PARTS)

    def test_unknown_part_is_refused_by_the_names_of_those_there_are(self):
        for words in (["firefox"], ["native", "pages"], ["--fast"]):
            done = run(*words)
            self.assertEqual(done.returncode, 1, done)
            self.assertEqual(done.stdout, "")
            self.assertIn(f"'{words[-1]}', only --full and: {' '.join(PARTS)}", done.stderr)

    def test_full_without_native_and_page_is_refused(self):
        done = run("--full", "wasm")
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("--full belongs to the parts native and page", done.stderr)


if __name__ == "__main__":
    unittest.main()
