#!/usr/bin/env python3
"""Tests of the examples that spread a file of jobs over machines, here over processes of this one.

Usage: python3 test_machines.py PATH_OF_THUD_RUN, in the root of the project.
"""

import hashlib
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

THUD_RUN = os.path.abspath(sys.argv.pop(1))
FOLDER = pathlib.Path(__file__).parent
JOBS = [{"scene": "pyramid", "size": 4, "steps": 20, "seed": {"from": 1, "to": 7, "step": 1}},
        {"scene": "chain", "size": 5, "steps": [5, 10]}]
RUNS = 9
# What each kind of cluster tells the second of three tasks.
TASKS = {"Slurm": {"SLURM_ARRAY_TASK_ID": "2", "SLURM_ARRAY_TASK_COUNT": "3"},
         "PBS": {"PBS_ARRAY_INDEX": "2", "COUNT": "3"},
         "Grid Engine": {"SGE_TASK_ID": "2", "SGE_TASK_LAST": "3"}}
# A stand-in for Ray that runs each task when its result is asked for.
RAY = """
from types import SimpleNamespace as space

exceptions = space(RayError=type("RayError", (Exception,), {}))

def init(**options):
    pass

def remote(**options):
    return lambda task: space(options=lambda **options: space(remote=lambda *values: (task, values)))

def wait(tasks, num_returns):
    return tasks[:num_returns], tasks[num_returns:]

def get(begun):
    task, values = begun
    return task(*values)
"""


def sorted_results(text):
    results = [json.loads(line) for line in text.splitlines()]
    for result in results:
        result.pop("times")
    return sorted(results, key=lambda result: result["id"])


class Machines(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.jobs = self.folder / "jobs.ndjson"
        self.jobs.write_text("".join(json.dumps(job) + "\n" for job in JOBS))
        done = subprocess.run([THUD_RUN, "--jobs", self.jobs], capture_output=True, check=True)
        self.whole = sorted_results(done.stdout)
        self.assertEqual(len(self.whole), RUNS)

    def array_task(self, variables):
        kept = {name: value for name, value in os.environ.items()
                if not name.startswith(("SLURM_", "PBS_", "SGE_"))}
        return subprocess.Popen([FOLDER / "job_array.sh", self.jobs, self.folder / "parts"],
                                env=kept | {"THUD_RUN": THUD_RUN} | variables,
                                stderr=subprocess.PIPE, text=True)

    def test_tasks_of_a_job_array_have_the_results_of_one_run(self):
        tasks = [self.array_task({"SLURM_ARRAY_TASK_ID": str(k), "SLURM_ARRAY_TASK_COUNT": "3"})
                 for k in (1, 2, 3)]
        for task in tasks:
            self.assertEqual((task.wait(60), task.stderr.read().count("0 of them failed")), (0, 1))
            task.stderr.close()
        parts = sorted((self.folder / "parts").iterdir())
        self.assertEqual(len(parts), 3)
        self.assertEqual(sorted_results("".join(part.read_text() for part in parts)), self.whole)

    def test_each_kind_of_cluster_gives_a_task_its_part(self):
        for cluster, variables in TASKS.items():
            task = self.array_task(variables)
            complaint = task.communicate(timeout=60)[1]
            self.assertEqual(task.returncode, 0, f"{cluster}: {complaint}")
            part = self.folder / "parts" / "part-2.ndjson"
            self.assertEqual(len(part.read_text().splitlines()), 3, cluster)
            part.unlink()

    def test_what_is_no_task_of_an_array_is_told(self):
        task = self.array_task({})
        complaint = task.communicate(timeout=60)[1]
        self.assertEqual(task.returncode, 2)
        self.assertIn("no task of a job array", complaint)

    def test_failures_are_told_by_the_status(self):
        stand_in = self.folder / "modules"
        stand_in.mkdir()
        (stand_in / "ray.py").write_text(RAY)
        fails = self.folder / "fails.ndjson"
        fails.write_text(json.dumps({"scene": "chain", "size": 5, "steps": 9, "inputs": [
            {"step": 5, "drop": "circle", "at": [1e20, 0], "size": 1}]}))
        wrong = self.folder / "wrong.ndjson"
        wrong.write_text('{"scene": "nowhere"}')
        programs = {name: self.folder / name for name in ("crashes", "writes_nothing", "is_cut")}
        for path, text in zip(programs.values(), ("echo '{'; kill -9 $$", "exit 1", "printf '{'; exit 1")):
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(0o755)
        for number, (jobs, program, status, says) in enumerate((
                (self.jobs, THUD_RUN, 0, ""), (fails, THUD_RUN, 1, ""),
                (wrong, THUD_RUN, 2, "nowhere"), (self.folder / "none", THUD_RUN, 2, "No such file"),
                (self.jobs, self.folder / "no-thud-run", 3, "No such file"),
                (self.jobs, programs["crashes"], 3, "ended with -9"),
                (self.jobs, programs["writes_nothing"], 3, "ended with 1"),
                (self.jobs, programs["is_cut"], 3, "ended with 1"))):
            done = subprocess.run(
                [sys.executable, FOLDER / "ray_jobs.py", jobs, self.folder / f"results-{number}",
                 "--parts", "2", "--thud-run", program], capture_output=True, text=True, timeout=60,
                env=os.environ | {"PYTHONPATH": str(stand_in)})
            self.assertEqual(done.returncode, status, (program, done.stderr))
            self.assertIn(says, done.stderr)
            self.assertNotIn("Traceback", done.stderr)
            self.assertEqual((self.folder / f"results-{number}").exists(), status < 2)

    @unittest.skipUnless(importlib.util.find_spec("ray"), "needs Ray")
    def test_ray_has_the_results_of_one_run(self):
        results = self.folder / "results.ndjson"
        name = hashlib.sha256(self.jobs.read_bytes()).hexdigest()[:12]
        kept = subprocess.run([THUD_RUN, "--jobs", self.jobs, "--part", "3/4"],
                              capture_output=True, check=True).stdout
        (self.folder / f"results.ndjson.{name}.3-4").write_bytes(kept)  # of a run that was stopped
        command = [sys.executable, FOLDER / "ray_jobs.py", self.jobs, results, "--parts", "4",
                   "--thud-run", THUD_RUN]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count(" of 4 done"), 3)
        self.assertEqual(sorted_results(results.read_text()), self.whole)
        self.assertEqual(len(list(self.folder.iterdir())), 2, "parts are left over")
        again = subprocess.run(command, capture_output=True, text=True, timeout=300)
        self.assertEqual(again.returncode, 2)
        self.assertIn("is there already", again.stderr)


if __name__ == "__main__":
    unittest.main()
