#!/usr/bin/env python3
"""Tests of thud-run --advise: that the advice, taken, does what it says.

Usage: python3 test_advise.py PATH_OF_THUD_RUN, in the root of the project.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

THUD_RUN = os.path.abspath(sys.argv.pop(1))
LEVEL = "assets/levels/towers.tmj"
STEPS = "12"
# How much longer than advised a step may take when the advice is taken. Other programs run on the
# machine meanwhile; the shortest of several runs is compared.
SLOWER, TRIES = 3, 9
# Times that differ by less than this factor count as equal.
EQUAL = 1.05
# At its smallest size the valley under the bridge has no ground line.
SMALLEST = {"bridge": 10}


def run(*arguments, code=0):
    done = subprocess.run([THUD_RUN, *arguments], capture_output=True, text=True, timeout=120)
    assert done.returncode == code, (arguments, done.returncode, done.stderr)
    return done


def advice(*arguments, patience="0"):
    """The advice as JSON, without larger sizes of the scene."""
    return json.loads(run(*arguments, "--advise", "--json", "--patience", patience).stdout)


def repeat(command):
    """What a printed command measures."""
    program, *arguments = shlex.split(command)
    assert program == "thud-run", command
    return json.loads(run(*arguments, "--json").stdout)


def uses(*arguments):
    return json.loads(run(*arguments, "--uses", "--json").stdout)


def scenes():
    """Each built-in scene with its smallest size."""
    lines = run("--list").stdout.splitlines()
    for name, size in zip(lines[::2], lines[1::2]):
        name = name.split()[0]
        yield name, SMALLEST.get(name, int(re.search(r", (\d+) to ", size).group(1)))


def error_of(result, length_scale):
    """The error of a run by what thud-run tells of it."""
    if result["passed"] or result["quarantined"]:
        return None
    worst = max(result["penetration_max"], result["worst_step_error"]["joint_gap_max"], 0)
    return worst / length_scale


class Advice(unittest.TestCase):
    def check_setting(self, told, setting):
        """Runs the setting's command and compares."""
        found = repeat(setting["command"])
        for field in ("hash", "penetration_max", "passed", "quarantined", "bytes"):
            self.assertEqual(found[field], setting[field], setting["command"])
        self.assertEqual(found["worst_step_error"]["joint_gap_max"], setting["joint_gap_max"])
        self.assertEqual(error_of(found, told["length_scale"]), setting["error"])
        return found

    def check(self, told):
        """Whether the advice follows from its settings, and holds when it is taken."""
        settings = told["settings"]
        for setting in settings:
            fits = told["budget_ms"] is None or setting["ms"] <= told["budget_ms"]
            good = setting["error"] is not None and setting["error"] <= told["max_error"]
            self.assertEqual(setting["meets"], good and fits, setting)
        meeting = [s["ms"] for s in settings if s["meets"]]
        if told["advised"] is None:
            self.assertEqual(meeting, [])
            return self.check_setting(told, settings[told["nearest"]])
        near = [s for s in settings if s["meets"] and s["ms"] <= EQUAL * min(meeting)]
        self.assertIn(settings[told["advised"]], near)
        self.assertEqual(settings[told["advised"]]["error"], min(s["error"] for s in near))
        return self.check_setting(told, settings[told["advised"]])

    def check_parts(self, told):
        """Whether what is said of parts that were left out follows from their runs."""
        base = told["settings"][told["base"]]
        for off in told["off"]:
            self.assertEqual(off["same"], off["hash"] == base["hash"], off)
            if off["same"]:
                self.assertEqual(off["moved"], 0, off)
            moved = off["moved"] is not None and off["moved"] <= told["max_error"]
            good = off["error"] is not None and off["error"] <= told["max_error"]
            self.assertEqual(off["needless"], good and moved, off)
            self.assertEqual(off["saved_bytes"], base["bytes"] - off["bytes"])

    def test_advice_of_every_scene_holds_when_it_is_taken(self):
        for name, size in scenes():
            told = advice(name, "--size", str(size), "--steps", STEPS, "--repeat", "1")
            self.assertGreaterEqual(len(told["settings"]), 22, name)
            found = self.check(told)
            self.check_parts(told)
            self.assertEqual((found["scene"], found["steps"]), (name, int(STEPS)))

    def test_advice_of_a_level_holds_when_it_is_taken(self):
        self.check(advice(LEVEL, "--steps", STEPS, "--repeat", "1"))

    def test_every_setting_repeats_by_its_command(self):
        for arguments in (("bullets", "--size", "9"), ("chain", "--size", "5"), ("gas", "--size", "30")):
            told = advice(*arguments, "--steps", "30", "--repeat", "1")
            for setting in told["settings"]:
                self.check_setting(told, setting)

    def test_time_is_what_the_advised_setting_takes(self):
        told = advice("tall_stack", "--size", "30", "--steps", "100")
        setting = told["settings"][told["advised"]]
        took = min(repeat(setting["command"])["ms_per_step"] for _ in range(TRIES))
        self.assertTrue(setting["ms"] / SLOWER < took < setting["ms"] * SLOWER, (took, setting))

    def test_a_setting_that_lets_bullets_pass_is_not_advised(self):
        told = advice("bullets", "--size", "5", "--steps", "60", "--repeat", "1")
        by_name = {s["name"]: s for s in told["settings"]}
        # The bullet that flies 1,000 m/s crosses the box of 24 m in 1.5 steps.
        self.assertGreater(by_name["draft, overlap"]["passed"], 0)
        self.assertIsNone(by_name["draft, overlap"]["error"])
        self.assertEqual(by_name["draft, swept"]["passed"], 0)
        self.assertNotIn(told["settings"][told["advised"]]["detection"], ("overlap", "bisect"))

    def test_a_smaller_error_needs_a_finer_setting_and_a_larger_one_no_finer(self):
        errors = []
        for limit in ("0.1", "0.003", "0.00001"):
            told = advice("pyramid", "--size", "8", "--steps", "60", "--repeat", "1",
                          "--max-error", limit)
            self.assertEqual(told["max_error"], float(limit))
            errors.append(told["settings"][told["advised"]]["error"])
            self.assertLessEqual(errors[-1], float(limit))
        self.assertGreater(errors[0], errors[2])

    def test_what_no_setting_meets_is_said(self):
        told = advice("tall_stack", "--steps", "5", "--budget", "0", "--repeat", "1")
        self.assertIsNone(told["advised"])
        self.assertEqual(told["budget_ms"], 0)
        text = run("tall_stack", "--steps", "5", "--budget", "0", "--repeat", "1", "--advise",
                   "--patience", "0").stdout
        self.assertIn("No setting that was tried meets the error within the budget", text)
        self.assertIn("Nearest: ", text)

    def test_text_gives_the_advised_setting_with_its_command(self):
        text = run("cradle", "--steps", STEPS, "--advise", "--repeat", "1",
                   "--patience", "0").stdout
        found = re.search(r"Advised: .*: error ([0-9.e-]+), [0-9.]+ ms a step.*\n +(thud-run .*)\n", text)
        result = repeat(found.group(2))
        self.assertAlmostEqual(max(result["penetration_max"], 0), float(found.group(1)), delta=1e-3)

    def test_command_of_any_path_is_run_by_a_shell(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("$HOME`date`.tmj", "it's \"one\" \\ two.tmj", "a;b&c|d(e)*.tmj"):
                path = os.path.join(folder, name)
                shutil.copy(LEVEL, path)
                told = advice(path, "--steps", "2", "--repeat", "1")["settings"][0]
                command = told["command"].replace("thud-run", shlex.quote(THUD_RUN), 1)
                done = subprocess.run(["sh", "-c", command + " --json"], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(json.loads(done.stdout)["hash"], told["hash"])

    def test_picture_marks_the_advised_setting(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "advice.svg")
            told = advice("gas", "--size", "20", "--steps", "20", "--repeat", "1", "--picture", path)
            root = ElementTree.parse(path).getroot()
            points = root.findall("{http://www.w3.org/2000/svg}circle")
            self.assertEqual(len(points), len(told["settings"]))
            marked = [p for p in points if p.get("id") == "advised"]
            name = marked[0].find("{http://www.w3.org/2000/svg}title").text
            self.assertTrue(name.startswith(told["settings"][told["advised"]]["name"] + ":"))
            unwritable = run("gas", "--size", "20", "--steps", "5", "--repeat", "1", "--advise",
                             "--picture", os.path.join(folder, "no", "such.svg"), code=1)
            self.assertIn("cannot be written", unwritable.stderr)

    def test_wrong_arguments_are_told_and_give_2(self):
        for arguments in (["gas", "--advise", "--max-error", "-1"],
                          ["gas", "--advise", "--max-error", "small"],
                          ["gas", "--advise", "--max-error", "nan"],
                          ["gas", "--advise", "--max-error"],
                          ["gas", "--advise", "--budget", "1e9"],
                          ["gas", "--advise", "--repeat", "0"],
                          ["gas", "--advise", "--repeat", "101"],
                          ["gas", "--advise", "--steps", "1000001"], ["gas", "--advise", "--uses"],
                          ["gas", "--substeps", "0"], ["gas", "--substeps", "65"],
                          ["gas", "--max-error", "0.1"], ["gas", "--budget", "1"],
                          ["gas", "--picture", "x.svg"], ["gas", "--patience", "1"],
                          ["gas", "--advise", "--patience", "-1"],
                          ["gas", "--rate", "0"], ["gas", "--rate", "0.5"], ["gas", "--heavier", "0"],
                          ["gas", "--heavier", "1e7"], ["gas", "--rate", "fast"],
                          ["gas", "--without", "mass"], ["gas", "--without", ""],
                          ["gas", "--without", "friction,,bounce"], ["gas", "--without"], ["--advise"]):
            done = run(*arguments, code=2)
            self.assertEqual(done.stdout, "", arguments)
            self.assertIn("thud-run:", done.stderr, arguments)
        self.assertIn("is called", run("pyramids", "--advise", code=1).stderr)

    def test_help_tells_of_advice(self):
        text = run("--help").stdout
        for option in ("--advise", "--max-error", "--budget", "--picture", "--substeps", "--repeat", "--rate",
                       "--heavier", "--without", "--uses", "--patience"):
            self.assertIn(option, text)


class Parts(unittest.TestCase):
    def off(self, told):
        return {off["without"]: off for off in told["off"]}

    def test_every_part_repeats_by_its_command(self):
        for arguments in (("ragdolls", "--size", "2"), ("planks", "--size", "3"), ("boats", "--size", "2"),
                          ("meetings", "--size", "4"), (LEVEL,)):
            told = advice(*arguments, "--steps", "40", "--repeat", "1")
            self.assertGreaterEqual(len(told["off"]), 4, arguments)
            for off in told["off"]:
                found = repeat(off["command"])
                self.assertEqual((found["hash"], found["bytes"]), (off["hash"], off["bytes"]), off)

    def test_gas_needs_its_bounces_and_no_friction_is_left_out_that_it_lacks(self):
        off = self.off(advice("gas", "--size", "50", "--steps", "60", "--repeat", "1"))
        self.assertNotIn("friction", off)
        self.assertNotIn("joints", off)
        self.assertFalse(off["bounce"]["needless"])
        self.assertGreater(off["bounce"]["moved"], 0.1)
        # Nothing turns, and nothing sleeps.
        for part in ("turning", "sleep", "events"):
            if part in off:
                self.assertEqual((off[part]["moved"], off[part]["needless"]), (0, True), off[part])

    def test_column_can_do_without_oriented_boxes(self):
        # Quality default is solved directly here, and keeps every box in its place.
        told = advice("tall_stack", "--size", "8", "--steps", "60", "--repeat", "1", "--max-error", "0.01")
        off = self.off(told)
        self.assertTrue(off["obbs"]["needless"])
        without = uses("tall_stack", "--size", "8", "--steps", "5", "--without", "obbs")
        self.assertEqual((without["obbs"], without["aabbs"]), (0, 9))

    def test_each_part_leaves_out_what_it_names(self):
        def left(scene, part, *more):
            return uses(scene, "--steps", "40", "--without", part, *more)
        self.assertEqual(left("ragdolls", "joints")["joints"], 0)
        self.assertEqual(left("ragdolls", "turning", "--size", "2")["turned"], 0)
        self.assertEqual(left("planks", "friction", "--size", "3")["rubbed"], 0)
        self.assertEqual(left("gas", "bounce", "--size", "50")["bounced"], 0)
        self.assertEqual(left("heavy_on_light", "direct", "--size", "2")["direct_steps"], 0)
        self.assertEqual(left("tall_stack", "sleep", "--size", "5")["slept"], 0)
        self.assertEqual(left("boats", "fields", "--size", "2")["water"], False)
        self.assertEqual(left("crates", "rules", "--size", "3")["rules"], 0)
        self.assertEqual(left("pyramid", "obbs", "--size", "3")["obbs"], 0)
        two = left("ragdolls", "joints,friction", "--size", "2")
        self.assertEqual((two["joints"], two["rubbed"]), (0, 0))

    def test_boxes_that_lean_stay_oriented(self):
        self.assertGreater(uses("slopes", "--steps", "2", "--without", "obbs")["obbs"], 0)

    def test_linked_kilobytes_are_those_of_the_size_test(self):
        with open("tests/web/package/size.test.mjs", encoding="utf-8") as file:
            bounds = {name: float(bound) for name, bound in
                      re.findall(r'{ name: "(\w+)", bound: ([0-9.]+)', file.read())}
        def linked(told):
            for part in (*told["settings"], *told["off"]):
                if part["link_program"]:
                    self.assertEqual(part["link_kB"], bounds[part["link_program"]])
            return {s["name"]: s["link_program"] for s in told["settings"]}
        def of(*arguments):
            return linked(advice(*arguments, "--steps", "10", "--repeat", "1"))
        pit, heap = of("circle_pit", "--size", "9"), of("pyramid", "--size", "3")
        self.assertEqual((pit["draft"], pit["default"], pit["draft, swept"]), ("boxes", "everything", None))
        self.assertEqual((heap["draft"], heap["default"]), ("everything", "everything"))
        # No program of the size test has joints and boxes.
        self.assertIsNone(of("ragdolls", "--size", "1")["draft"])


class Growth(unittest.TestCase):
    def test_what_breaks_first_is_measured_and_repeats(self):
        told = advice("tall_stack", "--size", "8", "--steps", "30", "--repeat", "1", "--max-error",
                      "0.003", patience="2")
        growth = told["growth"]
        sizes = growth["sizes"]
        self.assertEqual(sizes[0]["size"], 8)
        for row in sizes:
            fits = row["ms"] <= growth["budget_ms"]
            good = row["error"] is not None and row["error"] <= 0.003
            self.assertEqual(row["broken"], "holds" if good and fits else "time" if good else "error")
            self.assertEqual((row["bodies"], row["stack"]), (row["size"] + 1, row["size"]))
        self.assertEqual(repeat(sizes[-1]["command"])["hash"], sizes[-1]["hash"])
        held = [r["size"] for r in sizes if r["broken"] == "holds"]
        missed = [r["size"] for r in sizes if r["broken"] != "holds"]
        self.assertEqual(sizes[growth["held"]]["size"], max(held))
        if missed:
            self.assertEqual(sizes[growth["missed"]]["size"], min(missed))
        else:
            self.assertIsNone(growth["missed"])

    def test_a_budget_that_no_crowd_keeps_breaks_in_time(self):
        told = advice("gas", "--size", "50", "--steps", "20", "--repeat", "1", "--budget", "0.2",
                      "--max-error", "1", patience="2")
        growth = told["growth"]
        self.assertEqual(growth["budget_ms"], 0.2)
        self.assertEqual(growth["sizes"][growth["missed"]]["broken"], "time")
        self.assertGreater(growth["sizes"][growth["missed"]]["ms"], 0.2)

    def test_speed_and_mass_grow_alone_until_the_first_breaks(self):
        told = advice("tall_stack", "--size", "6", "--steps", "64", "--repeat", "1", "--max-error", "0.01")
        growth = told["growth"]
        breaks = []
        for name, values in (("speed", growth["faster"]), ("mass", growth["heavier"])):
            base = 2 if name == "speed" else 10
            self.assertEqual([row["factor"] for row in values], [base ** k for k in range(len(values))])
            wrong = [row["error"] is None or row["error"] > 0.01 for row in values]
            self.assertFalse(any(wrong[:-1]), name)
            breaks += [(values[-1]["factor"], name)] if wrong[-1] else []
            found = repeat(values[-1]["command"])
            self.assertEqual(found["hash"], values[-1]["hash"])
        self.assertTrue(breaks)
        if growth["first"] in ("speed", "mass"):
            self.assertEqual((growth["first_factor"], growth["first"]), min(breaks))

    def test_rate_and_mass_of_the_heaviest_change_what_they_name(self):
        self.assertEqual(uses("tall_stack", "--size", "5", "--steps", "9")["mass_ratio"], 1)
        self.assertEqual(uses("tall_stack", "--size", "5", "--steps", "9", "--heavier", "50")["mass_ratio"], 50)
        speeds = [uses("bullets", "--size", "2", "--steps", "9", "--rate", rate)["speed"]
                  for rate in ("60", "30")]
        self.assertAlmostEqual(speeds[1] / speeds[0], 2, delta=0.01)

    def test_speeds_of_scenes_with_fields_are_not_measured(self):
        growth = advice("boats", "--size", "1", "--steps", "8", "--repeat", "1")["growth"]
        self.assertEqual(growth["faster"], [])
        self.assertIn("fields", growth["no_speeds_as"])

    def test_what_is_not_measured_is_said(self):
        level = run(LEVEL, "--advise", "--steps", "5", "--repeat", "1").stdout
        self.assertIn("Size: not measured, as a level has one size", level)
        impatient = run("gas", "--size", "20", "--advise", "--steps", "5", "--repeat", "1",
                        "--patience", "0").stdout
        self.assertIn("Size: larger ones take too long to measure here", impatient)


class Uses(unittest.TestCase):
    def test_counting_changes_no_bit_of_a_run(self):
        for scene in ("ragdolls", "heavy_on_light", "crates", "meetings"):
            arguments = (scene, "--steps", "60")
            self.assertEqual(uses(*arguments)["hash"],
                             json.loads(run(*arguments, "--json").stdout)["hash"], scene)

    def test_pit_of_circles_has_no_box_that_turns_and_no_joint(self):
        found = uses("circle_pit", "--size", "40", "--steps", "200")
        self.assertEqual([found[k] for k in ("circles", "aabbs", "obbs", "terrains", "joints")],
                         [40, 3, 0, 0, 0])
        self.assertEqual((found["dynamic_bodies"], found["static_bodies"]), (40, 3))
        self.assertEqual((found["turned_boxes"], found["bounced"], found["held"]), (0, 0, 0))
        self.assertGreater(found["turned"], 0)

    def test_column_of_boxes_stands_still(self):
        found = uses("tall_stack", "--size", "12", "--steps", "100")
        self.assertEqual([found[k] for k in ("turned", "bounced", "slid", "held", "impacts", "joints")],
                         [0] * 6)
        self.assertEqual((found["stack"], found["slept"], found["mass_ratio"]), (12, 12, 1))
        # They are awake for half a second or a little more, with a contact under each box.
        self.assertTrue(12 * 29 <= found["contacts"] <= 12 * 60, found["contacts"])
        awake = uses("tall_stack", "--size", "12", "--steps", "100", "--no-sleeping")
        self.assertEqual(awake["slept"], 0)
        self.assertTrue(12 * 98 <= awake["contacts"] <= 12 * 100, awake["contacts"])

    def test_gas_without_friction_and_gravity_only_bounces(self):
        found = uses("gas", "--size", "100", "--steps", "200")
        self.assertEqual([found[k] for k in ("turned", "slid", "rubbed", "slept", "stack")], [0] * 5)
        self.assertEqual(found["bounced"], 100)

    def test_bullets_are_held_by_the_detection_that_is_chosen(self):
        arguments = ("bullets", "--size", "5", "--steps", "30")
        found = uses(*arguments)
        self.assertGreater(found["held"], 0)
        # 1e5 m/s against walls of 0.02 m, in steps of 1/60 s.
        self.assertAlmostEqual(found["speed"], 1e5 / 60 / 0.02, delta=50)
        self.assertEqual((found["impacts"], found["dynamic_bodies"]), (0, 5))
        self.assertEqual(uses(*arguments, "--detection", "overlap")["held"], 0)
        self.assertGreater(uses(*arguments, "--detection", "swept")["impacts"], 0)

    def test_direct_islands_are_counted_where_there_are_some(self):
        arguments = ("heavy_on_light", "--size", "2", "--steps", "40")
        found = uses(*arguments)
        self.assertGreater(found["direct_contacts"], 0)
        self.assertGreaterEqual(found["contacts"], found["direct_contacts"])
        self.assertGreaterEqual(found["mass_ratio"], 10)
        draft = uses(*arguments, "--quality", "draft")
        self.assertEqual((draft["direct_contacts"], draft["direct_steps"]), (0, 0))

    def test_joints_and_what_acts_are_listed(self):
        found = uses("chain", "--steps", "5")
        self.assertEqual(found["joints"], sum(found["joints_by_kind"].values()))
        self.assertEqual(found["joints"], 101)
        self.assertTrue(uses("boats", "--steps", "2")["water"])
        self.assertTrue(uses("flags", "--steps", "2")["wind"])
        self.assertGreater(uses("explosion", "--steps", "2")["explosions"], 0)
        self.assertTrue(uses("crates", "--steps", "2")["breaking"])

    def test_text_has_the_counts(self):
        text = run("circle_pit", "--size", "10", "--steps", "5", "--uses").stdout
        self.assertIn("10 circles, 3 aabbs, 0 obbs, 0 terrains; 0 sensors; 0 joints", text)

    def test_advice_has_the_counts_with_a_command_that_repeats_them(self):
        told = advice("ragdolls", "--size", "2", "--steps", STEPS, "--repeat", "1")["uses"]
        program, *arguments = shlex.split(told["command"])
        self.assertEqual(json.loads(run(*arguments, "--json").stdout), told["counts"])


if __name__ == "__main__":
    unittest.main()
