#!/usr/bin/env python3
"""Tests of thud-run --jobs: results, sweeps, workers, parts, resuming, and files that are wrong.

Usage: python3 test_jobs.py PATH_OF_THUD_RUN, in the root of the project.
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

THUD_RUN = os.path.abspath(sys.argv.pop(1))
LEVEL = "assets/levels/towers.tmj"

JOBS = [
    {"id": "stack", "scene": "tall_stack", "steps": 30, "quality": ["draft", "high"],
     "size": {"from": 5, "to": 15, "step": 5}},
    {"scene": "pyramid", "size": 8, "steps": 60, "seed": {"from": 1, "to": 3, "count": 3},
     "inputs": [{"step": 30, "push": 3, "impulse": [5, 0]},
                {"step": 10, "drop": "box", "at": [0, 20], "size": 1},
                {"step": 40, "explode": [0, 1], "radius": 1, "falloff": 5, "impulse": 30}]},
    {"scene": LEVEL, "steps": 10, "rate": [30, 60], "detection": "swept", "broadphase": "sweep"},
    {"id": "fails", "scene": "chain", "steps": 20,
     "inputs": [{"step": 5, "drop": "circle", "at": [1e20, 0], "size": 1}]},
]
RUNS = 6 + 3 + 2 + 1


class Jobs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def write(self, *jobs):
        path = self.folder / "jobs"
        path.write_text("".join((job if isinstance(job, str) else json.dumps(job)) + "\n"
                                for job in jobs))
        return path

    def run_jobs(self, path, *options):
        return subprocess.run([THUD_RUN, "--jobs", str(path), *options], capture_output=True,
                              text=True, timeout=120)

    def results(self, *jobs, options=()):
        done = self.run_jobs(self.write(*jobs), *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {result["id"]: result for result in map(json.loads, done.stdout.splitlines())}

    def whole(self):
        """The lines of all of JOBS, sorted, without times."""
        done = self.run_jobs(self.write(*JOBS), "--no-times")
        self.assertEqual(done.returncode, 1, done.stderr)
        return sorted(done.stdout.splitlines())

    def test_a_result_is_that_of_the_same_run_alone(self):
        result = self.results({"scene": "bullets", "steps": 40, "quality": "high", "size": 9,
                               "rate": 50, "detection": "swept"})["1"]
        alone = json.loads(subprocess.run(
            [THUD_RUN, "bullets", "--steps", "40", "--quality", "high", "--size", "9", "--rate",
             "50", "--detection", "swept", "--json"], capture_output=True, check=True).stdout)
        for field in ("hash", "steps", "bodies", "awake", "contacts", "passed", "energy",
                      "penetration_max"):
            self.assertEqual(result[field], alone[field], field)
        self.assertGreater(result["times"]["ms_per_step"], 0)
        self.assertGreaterEqual(result["error"], 0)

    def test_lists_and_ranges_are_multiplied_out(self):
        results = self.results(
            {"id": "a", "scene": ["chain", "tall_stack"], "steps": 2,
             "rate": {"from": 30, "to": 90, "step": 30}},
            {"scene": "pyramid", "size": 3, "steps": 3, "inputs": [
                [], [{"step": 1, "push": 2, "impulse": [9, 9]}]]},
            {"id": "b", "scene": "chain", "steps": {"from": 1, "to": 3, "count": 2}})
        self.assertEqual([(key, results[key]["job"]["scene"], results[key]["job"]["rate"])
                          for key in sorted(results) if key[0] == "a"],
                         [("a/1", "chain", 30), ("a/2", "chain", 60), ("a/3", "chain", 90),
                          ("a/4", "tall_stack", 30), ("a/5", "tall_stack", 60),
                          ("a/6", "tall_stack", 90)])
        self.assertEqual([results[key]["steps"] for key in ("b/1", "b/2")], [1, 3])
        self.assertNotEqual(results["2/1"]["hash"], results["2/2"]["hash"])
        self.assertEqual(len(results), 10)

    def test_each_input_and_seed_changes_the_outcome_at_its_step(self):
        base = {"scene": "pyramid", "size": 4, "steps": 20}
        inputs = [{"push": 3, "impulse": [2, 0]}, {"drop": "box", "at": [0.3, 4.7], "size": 1},
                  {"drop": "circle", "at": [0.3, 4.7], "size": 1},
                  {"drop": "circle", "at": [0.3, 4.7], "size": 1, "velocity": [0, -5]},
                  {"explode": [0, 1], "radius": 1, "falloff": 5, "impulse": 30}]
        jobs = [base, {**base, "seed": [1, 2]}, {**base, "seed": 1, "shake": 0.5}]
        jobs += [{**base, "inputs": [{"step": step, **one}]} for one in inputs for step in (0, 7)]
        results = self.results(*jobs)
        self.assertEqual(len({result["hash"] for result in results.values()}), 14)
        self.assertEqual([results[str(4 + i)]["bodies"] - results["1"]["bodies"]
                          for i in range(10)], [0, 0, 1, 1, 1, 1, 1, 1, 0, 0])
        still = self.results({**base, "seed": 7, "shake": 0})
        self.assertEqual(still["1"]["hash"], results["1"]["hash"])

    def test_workers_and_parts_give_the_same_lines(self):
        whole = self.whole()
        self.assertEqual(len(whole), RUNS)
        for workers in "123":
            done = self.run_jobs(self.write(*JOBS), "--no-times", "--workers", workers)
            self.assertEqual(sorted(done.stdout.splitlines()), whole, workers)
        parts = [self.run_jobs(self.write(*JOBS), "--no-times", "--part", f"{k}/5").stdout
                 for k in range(1, 6)]
        self.assertEqual(sorted("".join(parts).splitlines()), whole)
        self.assertEqual([part.count("\n") for part in parts], [3, 3, 2, 2, 2])

    def test_what_fails_in_running_has_a_line_and_gives_1(self):
        failed = [line for line in map(json.loads, self.whole()) if "failed" in line]
        self.assertEqual([line["id"] for line in failed], ["fails"])
        self.assertIn("input 1 failed after step 5", failed[0]["failed"])
        self.assertNotIn("hash", failed[0])

    def test_resuming_after_a_torn_line_runs_only_what_is_left(self):
        whole, jobs = self.whole(), self.write(*JOBS)
        for kept, torn in ((0, whole[0][:40]), (3, whole[3][:-1]), (5, ""), (RUNS, "")):
            self.out.write_text("".join(line + "\n" for line in whole[:kept]) + torn)
            done = self.run_jobs(jobs, "--no-times", "--out", str(self.out), "--resume")
            self.assertIn(f"{RUNS - kept} jobs run", done.stderr)
            self.assertEqual(done.returncode, 1, "one of them fails, also if its result is old")
            self.assertEqual(self.out.read_text().splitlines()[:kept], whole[:kept])
            self.assertEqual(sorted(self.out.read_text().splitlines()), whole)

    def test_a_run_that_is_killed_is_resumed(self):
        jobs = self.write({"scene": "pyramid", "size": 12, "steps": 150,
                           "seed": {"from": 1, "to": 40, "step": 1}})
        whole = self.run_jobs(jobs, "--no-times").stdout.splitlines()
        command = [THUD_RUN, "--jobs", str(jobs), "--no-times", "--out", str(self.out)]
        with subprocess.Popen(command + ["--workers", "2"], stderr=subprocess.DEVNULL) as run:
            end = time.monotonic() + 60
            while time.monotonic() < end and run.poll() is None:
                if self.out.exists() and self.out.read_bytes().count(b"\n") >= 3:
                    break
            run.send_signal(signal.SIGKILL)
        kept = self.out.read_bytes().count(b"\n")
        self.assertTrue(3 <= kept < 40, kept)
        done = subprocess.run(command + ["--resume"], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{40 - kept} jobs run, 0 of them failed; {kept} had results", done.stderr)
        self.assertEqual(sorted(self.out.read_text().splitlines()), sorted(whole))

    def test_a_result_is_in_the_file_while_the_next_job_runs(self):
        jobs = self.write({"scene": "chain", "steps": 1}, {"scene": "chain", "steps": 10 ** 9})
        command = [THUD_RUN, "--jobs", str(jobs), "--out", str(self.out), "--workers", "1"]
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as run:
            end = time.monotonic() + 20
            while time.monotonic() < end and not (self.out.exists() and self.out.stat().st_size):
                time.sleep(0.01)
            run.kill()
        self.assertEqual([json.loads(line)["id"] for line in self.out.read_text().splitlines()],
                         ["1"])

    def test_results_of_other_jobs_are_not_continued_nor_overwritten(self):
        first = self.write({"scene": "chain", "steps": 2})
        self.assertEqual(self.run_jobs(first, "--out", str(self.out)).returncode, 0)
        kept = self.out.read_text()
        for jobs, options, says in (
                ({"scene": "chain", "steps": 3}, ["--resume"], ":1: no result of a job"),
                ({"scene": "chain", "steps": 2}, [], "--resume continues it")):
            done = self.run_jobs(self.write(jobs), "--out", str(self.out), *options)
            self.assertEqual(done.returncode, 2)
            self.assertIn(says, done.stderr)
            self.assertEqual(self.out.read_text(), kept)

    def test_wrong_jobs_are_told_by_line_and_nothing_is_run(self):
        push = {"step": 1, "push": 1, "impulse": [0, 1]}
        for wrong, says in (
                ("{", "not a JSON object"), ("[]", "not a JSON object"),
                ('{"scene":"gas"} {}', "not a JSON object"),
                ('{"scene":"gas"}\0', "not a JSON object"),
                ('{"scene":"gas","scene":"gas"}', "twice: scene"),
                ({}, "names its scene"), ({"scene": "nix"}, "cannot be loaded"),
                ({"scene": "no/such.tmj"}, "cannot be loaded"),
                ({"scene": "pyramid", "size": 10 ** 6}, "cannot be loaded"),
                ({"scene": "pyramid", "rtae": 1}, "rtae"), ({"scene": "pyramid", "rate": 0}, "rate"),
                ({"scene": "pyramid", "rate": "60"}, "rate"),
                ({"scene": "pyramid", "quality": "best"}, "quality"),
                ({"scene": "pyramid", "steps": 1.5}, "steps"),
                ({"scene": "pyramid", "sleeping": 1}, "sleeping"),
                ({"scene": "pyramid", "seed": -1}, "seed"),
                ({"scene": "pyramid", "shake": 1}, "shake needs a seed"),
                ({"scene": "pyramid", "size": []}, "size"), ({"scene": "pyramid", "size": [[1]]}, "size"),
                ({"scene": "pyramid", "size": {"from": 1, "to": 9}}, "size"),
                ({"scene": "pyramid", "size": {"from": 9, "to": 1, "step": 1}}, "size"),
                ({"scene": "pyramid", "size": {"from": 1, "to": 1e12, "step": 1}}, "size"),
                ({"scene": "pyramid", "seed": {"from": 1, "to": 2000, "step": 1},
                  "rate": {"from": 1, "to": 2000, "step": 1}}, "more jobs"),
                ({"id": "", "scene": "pyramid"}, "id"), ({"id": 5, "scene": "pyramid"}, "id"),
                ({"id": "first", "scene": "chain"}, "another job has the id first"),
                ({"scene": "pyramid", "inputs": {"step": 1}}, "inputs"),
                ({"scene": "pyramid", "inputs": [5]}, "input 1"),
                ({"scene": "pyramid", "inputs": [push, {"step": 1, "jump": 1}]}, "input 2"),
                ({"scene": "pyramid", "inputs": [{**push, "hard": 1}]}, "input 1"),
                ({"scene": "pyramid", "inputs": [{**push, "step": 600}]}, "from 0 to 599"),
                ({"scene": "pyramid", "inputs": [{**push, "impulse": [1e31, 0]}]}, "input 1"),
                ({"scene": "pyramid", "inputs": [{**push, "push": 99999}]}, "has fewer"),
                ({"scene": "pyramid", "inputs": [{**push, "push": 0}]}, "does not move freely")):
            done = self.run_jobs(self.write({"id": "first", "scene": "chain"}, "", wrong), "--out",
                                 str(self.out))
            self.assertEqual(done.returncode, 2, wrong)
            self.assertIn(f"{self.folder}/jobs:3: ", done.stderr)
            self.assertIn(says, done.stderr)
            self.assertFalse(self.out.exists(), wrong)

    def test_wrong_options_are_told_and_give_2(self):
        jobs = self.write({"scene": "chain", "steps": 1})
        for options in (["--workers", "0"], ["--workers", "x"], ["--workers"], ["--part", "0/2"],
                        ["--part", "3/2"], ["--part", "1"], ["--part", "1/2x"], ["--resume"],
                        ["--steps", "3"], ["gas"]):
            done = self.run_jobs(jobs, *options)
            self.assertEqual((done.returncode, done.stdout), (2, ""), options)
            self.assertIn("thud-run:", done.stderr)
        for path in (self.folder / "none", self.write("")):
            done = self.run_jobs(path)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("thud-run:", done.stderr)

    def test_example_of_the_documentation_runs(self):
        text = pathlib.Path("docs/embedding.md").read_text(encoding="utf-8")
        [jobs] = re.findall(r"^```json\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        results = self.results(*jobs.splitlines())
        self.assertEqual(set(results), {f"stack/{i}" for i in range(1, 7)} |
                         {f"2/{i}" for i in range(1, 21)})
        pushed = {result["hash"] for name, result in results.items() if name.startswith("2/")}
        self.assertEqual(len(pushed), 20)

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_results_that_cannot_be_written_give_1(self):
        jobs = self.write({"scene": "chain", "steps": 1})
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([THUD_RUN, "--jobs", str(jobs)], stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be written", done.stderr)


if __name__ == "__main__":
    unittest.main()
