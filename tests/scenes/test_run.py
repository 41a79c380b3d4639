#!/usr/bin/env python3
"""Tests of the program thud-run: its output, its options and its error messages.

Usage: python3 test_run.py PATH_OF_THUD_RUN, in the root of the project.
"""

import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest

THUD_RUN = os.path.abspath(sys.argv.pop(1))
LEVEL = "assets/levels/towers.tmj"


# Answers as thud-run does, with other hashes from a step on.
OTHER_BUILD = """#!{python}
import subprocess, sys
lines = subprocess.run(["{run}", *sys.argv[1:]], capture_output=True, text=True).stdout.splitlines()
def other(hash):
    return format(int(hash, 16) ^ 1, "016x")
differs = False
for i, line in enumerate(lines):
    number, hash = line.split()
    is_step = i == 0 or "--hashes" in sys.argv
    differs |= is_step and int(number) >= {first}
    if differs and (is_step or number == "{slot}"):
        lines[i] = number + " " + other(hash)
try:
    print("\\n".join(lines), flush=True)
except BrokenPipeError:
    pass
"""


def run(*arguments):
    return subprocess.run([THUD_RUN, *arguments], capture_output=True, text=True, timeout=120)


class ThudRun(unittest.TestCase):
    def test_json_is_one_object_with_the_promised_fields(self):
        done = run("tall_stack", "--steps", "20", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout)
        for field in ("scene", "steps", "bodies", "contacts", "ms_per_step", "penetration_max",
                      "energy", "hash"):
            self.assertIn(field, result)
        self.assertEqual((result["scene"], result["steps"], result["bodies"]),
                         ("tall_stack", 20, 31))
        self.assertRegex(result["hash"], "^[0-9a-f]{16}$")
        self.assertGreater(result["ms_per_step"], 0)
        self.assertGreater(result["contacts"], 0)
        worst = result["worst_step_error"]
        self.assertEqual(sorted(worst), ["energy_change", "joint_angle_max", "joint_gap_max",
                                         "overlaps", "penetration_max", "penetration_mean",
                                         "residual"])
        self.assertAlmostEqual(worst["penetration_max"], result["penetration_max"], delta=1e-6)
        self.assertGreater(worst["residual"], 0)

    def test_gap_of_joints_is_told_where_there_are_some(self):
        chain, stack = (run(scene, "--steps", "5", "--quality", "draft").stdout
                        for scene in ("chain", "tall_stack"))
        gap = float(re.search(r"joints +101, open by ([0-9.e-]+) and", chain).group(1))
        self.assertTrue(0 < gap < 0.1, gap)
        self.assertNotIn("joints", stack)

    def test_level_runs_and_hash_repeats(self):
        first, second = (json.loads(run(LEVEL, "--steps", "30", "--json").stdout)
                         for _ in range(2))
        self.assertEqual(first["scene"], "towers")
        self.assertEqual(first["hash"], second["hash"])

    def test_text_names_stages_and_hash(self):
        done = run("cradle", "--steps", "5", "--quality", "exact")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("quality exact", "broadphase", "ms per step", "penetration", "worst step", "hash"):
            self.assertIn(word, done.stdout)

    def test_quality_and_size_change_the_outcome(self):
        hashes = {json.loads(run("tall_stack", "--steps", "30", "--json", *more).stdout)["hash"]
                  for more in ([], ["--quality", "draft"], ["--size", "7"])}
        self.assertEqual(len(hashes), 3)

    def test_broadphases_give_one_hash_and_detections_several(self):
        def hash_with(*more):
            done = run("bullets", "--steps", "200", "--json", *more)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(done.stdout)["hash"]
        self.assertEqual(len({hash_with("--broadphase", name)
                              for name in ("grid", "sweep", "all")}), 1)
        self.assertEqual(len({hash_with("--detection", name)
                              for name in ("overlap", "continuous", "bisect", "swept")}), 4)
        self.assertEqual(hash_with(), hash_with("--detection", "continuous"))

    def test_recording_plays_to_the_same_hash_and_tells_where_it_differs(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "run.rec")
            made = json.loads(run("cradle", "--steps", "40", "--json", "--record", file).stdout)
            for workers in ("1", "2"):
                played = json.loads(run("--replay", file, "--json", "--workers", workers).stdout)
                self.assertEqual(played, {"steps": 40, "hashes": 41, "hash": made["hash"]})
            # Crates break: the calls of the scene itself are recorded.
            self.assertEqual(run("crates", "--steps", "70", "--record", file).returncode, 0)
            self.assertEqual(run("--replay", file).returncode, 0)
            made = json.loads(run("cradle", "--steps", "40", "--json", "--record", file).stdout)
            self.assertIn(f"40 steps, 41 hashes are the same, hash {made['hash']}",
                          run("--replay", file).stdout)
            with open(file, "r+b") as recording:
                recording.seek(-30, os.SEEK_END)
                recording.write(b"?")
            done = run("--replay", file)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn("damaged", done.stderr)
            self.assertEqual(run("cradle", "--record", os.path.join(folder, "no", "where")).returncode, 1)
            self.assertEqual(run("--replay", os.path.join(folder, "nothing")).returncode, 1)
        for wrong in (("cradle", "--keyframes", "9"), ("cradle", "--replay", "x"), ("--replay", "x", "--record", "y"),
                      ("cradle", "--record", "x", "--uses"), ("--record",)):
            self.assertEqual(run(*wrong).returncode, 2, wrong)

    def test_recording_has_keyframes_from_which_it_is_played(self):
        def keyframes(*more):
            """The steps before the keyframes of a recording of 300 steps, by recording.h."""
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "run.rec")
                self.assertEqual(run("cradle", "--steps", "300", "--record", file, *more).returncode, 0)
                self.assertEqual(run("--replay", file).returncode, 0)
                with open(file, "rb") as recording:
                    data = recording.read()
            found, at = [], 12
            while at < len(data):
                kind, _, steps, length = struct.unpack_from("<cIQQ", data, at)
                at += 21 + length + 8
                if kind == b"K":
                    found.append(steps)
            return found
        self.assertEqual(keyframes(), [0, 120, 240])
        self.assertEqual(keyframes("--keyframes", "100"), [0, 100, 200, 300])
        self.assertEqual(keyframes("--keyframes", "0"), [0])

    def test_bisect_finds_where_another_build_differs(self):
        with tempfile.TemporaryDirectory() as folder:
            file, other = (os.path.join(folder, name) for name in ("run.rec", "other"))
            self.assertEqual(run("ragdolls", "--steps", "200", "--record", file, "--keyframes",
                                 "50").returncode, 0)

            def bisect(first, slot, *more):
                """With a build that has another state from step `first` on, first in a body."""
                with open(other, "w", encoding="utf-8") as script:
                    script.write(OTHER_BUILD.format(python=sys.executable, run=THUD_RUN,
                                                    first=first, slot=slot))
                os.chmod(other, 0o755)
                done = run("--replay", file, "--bisect", other, *more)
                self.assertEqual(done.returncode, 1, done.stderr)
                return done.stdout

            for first in (1, 64, 101, 200):
                self.assertEqual(json.loads(bisect(first, 17, "--json")),
                                 {"same": False, "after": first - 1, "at": first, "body": 17})
            self.assertEqual(json.loads(bisect(77, 100000, "--json")),
                             {"same": False, "after": 76, "at": 77})
            self.assertEqual(bisect(128, 3), "the builds differ after step 127, at step 128, "
                                             "first in the body of slot 3\n")
            same = run("--replay", file, "--bisect", THUD_RUN)
            self.assertEqual((same.returncode, same.stdout),
                             (0, "the builds have the same hashes up to step 200\n"))
            for nobody in (os.path.join(folder, "none"), "true"):
                done = run("--replay", file, "--bisect", nobody)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertIn("does not answer", done.stderr)
            self.assertEqual(run("--replay", file, "--hash-at", "201").returncode, 1)
            hashes = run("--replay", file, "--hashes", "90,1000,60").stdout.split()
            self.assertEqual(hashes[::2], ["90", "150", "200"])
            self.assertEqual(hashes[1], run("--replay", file, "--hash-at", "90").stdout.split()[1])
        for wrong in (("--bisect", "x"), ("--replay", "x", "--hashes", "1,2"),
                      ("--replay", "x", "--hashes", "2,1,1"), ("--hash-at", "3")):
            self.assertEqual(run(*wrong).returncode, 2, wrong)

    def test_list_and_help_succeed(self):
        self.assertIn("pyramid", run("--list").stdout)
        for flag in ("--help", "-h"):
            self.assertIn("--skip-unsupported", run(flag).stdout)
            self.assertEqual(run(flag).returncode, 0)
        for beside in (["--jobs", "none.json", "--help"], ["--help", "--jobs"], ["gas", "--steps", "ten", "-h"],
                       ["--bogus", "--help"], ["--steps", "--help"], ["--list", "--help"]):
            done = run(*beside)
            self.assertEqual((done.returncode, done.stderr), (0, ""), beside)
            self.assertEqual(done.stdout, run("--help").stdout)

    def test_wrong_arguments_are_told_and_give_2(self):
        for arguments in ([], ["pyramid", "gas"], ["gas", "--steps"], ["gas", "--steps", "0"],
                          ["gas", "--steps", "ten"], ["gas", "--quality", "best"],
                          ["gas", "--detection", "best"], ["gas", "--broadphase", "tree"],
                          ["gas", "--detection"],
                          ["gas", "--fast"], ["gas", "--size", "-1"],
                          ["--replay", "a.rec", "--advise"], ["--replay", "a.rec", "--uses"]):
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertIn("thud-run:", done.stderr)

    def test_output_that_cannot_be_written_gives_1(self):
        for arguments in (["--list"], ["pyramid", "--steps", "2", "--json"]):
            with open("/dev/full", "w") as full:
                done = subprocess.run([THUD_RUN, *arguments], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn("cannot be written", done.stderr)

    def test_unknown_scene_and_unreadable_level_are_told_and_give_1(self):
        for arguments, says in ((["pyramids"], "--list"), (["no/such.tmj"], "cannot be read"),
                                (["assets/levels/README.md"], "not JSON"),
                                (["gas", "--size", "9999999"], "size"), ([LEVEL, "--size", "3"], "--size")):
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
            self.assertIn(says, done.stderr)

    def test_unsupported_object_is_refused_by_id_or_skipped(self):
        level = {"type": "map", "width": 10, "height": 10, "tilewidth": 32, "tileheight": 32,
                 "layers": [{"type": "objectgroup", "name": "a", "objects": [
                     {"id": 4, "x": 0, "y": 0, "width": 32, "height": 32},
                     {"id": 5, "x": 0, "y": 0, "polygon": [{"x": 0, "y": 0}]}]}]}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bad.tmj")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(level, file)
            refused = run(path)
            self.assertEqual((refused.returncode, refused.stdout), (1, ""))
            self.assertIn("object 5: a polygon", refused.stderr)
            skipped = run(path, "--skip-unsupported", "--json", "--steps", "1")
            self.assertEqual(skipped.returncode, 0, skipped.stderr)
            self.assertIn("object 5: a polygon", skipped.stderr)
            self.assertEqual(json.loads(skipped.stdout)["bodies"], 1)

    def test_map_in_xml_finds_its_files_from_anywhere_and_is_the_same_as_in_json(self):
        folder = os.path.abspath("tests/levels/maps")
        hashes = set()
        for name in ("props.tmj", "props.tmx"):
            done = run(os.path.join(folder, name), "--json", "--steps", "30")
            self.assertEqual(done.returncode, 0, done.stderr)
            hashes.add(json.loads(done.stdout)["hash"])
        self.assertEqual(len(hashes), 1)

    def test_everything_that_cannot_be_modelled_is_listed(self):
        refused = run("tests/levels/maps/wrong.tmx")
        self.assertEqual(refused.returncode, 1)
        for number in (2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13):
            self.assertIn(f"object {number}: ", refused.stderr)


if __name__ == "__main__":
    unittest.main()
