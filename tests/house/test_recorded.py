"""Tests that tools/recorded.py notices what it cannot record: test_recorded.py PROJECT."""

import json
import sys
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
sys.path.insert(0, str(PROJECT / "tools"))

import recorded  # noqa: E402  (found by the line above)


class RecordedTest(unittest.TestCase):
    def setUp(self):
        self.api = json.loads(recorded.API.read_text(encoding="utf-8"))

    def add(self, name, *parameters):
        world = {"name": "world", "type": "thud_world *"}
        self.api["functions"].append({"name": name, "returns": "thud_result", "parameters":
                                      [world, *({"name": n, "type": t} for n, t in parameters)]})

    def made(self):
        return recorded.made_files(recorded.Api(json.dumps(self.api)))

    def test_a_new_function_is_recorded_as_the_last_one(self):
        self.add("thud_body_spin", ("body", "thud_body_id"), ("speed", "float"))
        texts = {path.name: text for path, text in self.made().items()}
        self.assertIn("#define thud_body_spin thud_recorded_body_spin", texts["thud_recorded.h"])
        self.assertTrue(texts["recorded_calls.txt"].endswith("\nthud_body_spin\n"))
        self.assertIn("return thud_body_spin(w, ARGUMENT(thud_body_id, 0), ARGUMENT(float, 1));",
                      texts["play_call.c"])

    def test_an_argument_that_it_does_not_know_is_an_error(self):
        self.add("thud_world_shake", ("by", "thud_shaker"))
        with self.assertRaisesRegex(SystemExit, "how is a thud_shaker recorded"):
            self.made()

    def test_a_function_that_is_gone_is_an_error(self):
        for name in ("thud_world_draw", "thud_body_destroy"):
            functions = self.api["functions"]
            self.api["functions"] = [f for f in functions if f["name"] != name]
            with self.assertRaisesRegex(SystemExit, name):
                self.made()
            self.api["functions"] = functions


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
