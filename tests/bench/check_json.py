"""Runs thud-bench on small scenes and checks its table, its JSON and its errors.

usage: check_json.py THUD_BENCH
"""

import json
import math
import os
import subprocess
import sys
import tempfile

FIELDS = ["bodies", "steps", "ms_median", "ms_p99", "ms_max", "penetration_max",
          "penetration_mean", "bytes"]


def run(bench, *arguments):
    return subprocess.run([bench, *arguments], capture_output=True, text=True, check=False)


def check_results(bench, folder):
    path = os.path.join(folder, "bench.json")
    done = run(bench, "--quick", "--scene", "tall_stack", "--scene", "circle_pit:300",
               "--json", path)
    assert done.returncode == 0, done.stderr
    assert "tall_stack" in done.stdout and "circle_pit" in done.stdout, done.stdout
    with open(path, encoding="utf-8") as file:
        results = json.load(file)
    found = [(r["scene"], r["engine"]) for r in results]
    assert found == [("tall_stack", "thud"), ("tall_stack", "box2d"),
                     ("circle_pit", "thud"), ("circle_pit", "box2d")], found
    for r in results:
        assert all(isinstance(r[f], (int, float)) and math.isfinite(r[f]) for f in FIELDS), r
        assert 0 < r["ms_median"] <= r["ms_p99"] <= r["ms_max"], r
        assert 0 <= r["penetration_mean"] <= r["penetration_max"] < 0.5, r
        assert r["steps"] == 40 and r["bytes"] > 1000 and r["lost"] == 0, r
        assert r["bodies"] == (31 if r["scene"] == "tall_stack" else 303), r


def check_labs(bench, folder):
    """Growth, prices and profile are tables of finite numbers."""
    for option, fields in [("--growth", ["bodies", "ns_per_body", "bytes_per_body"]),
                           ("--pay", ["ms_with", "ms_without"]), ("--profile", ["ms", "solve"])]:
        path = os.path.join(folder, option[2:] + ".json")
        done = run(bench, option, "--quick", "--json", path)
        assert done.returncode == 0, done.stderr
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)
        assert len(rows) > 3, rows
        assert all(math.isfinite(r[f]) and r[f] >= 0 for r in rows for f in fields), rows


def check_errors(bench, folder):
    for arguments, text in [
        (["--scene", "no_such"], "no_such"),
        (["--scene", "gas:0"], "gas:0"),
        (["--steps", "none"], "none"),
        (["--repeat", "0"], "--repeat"),
        (["--scene"], "--scene"),
        (["--unknown"], "--unknown"),
        (["--json", os.path.join(folder, "missing", "x.json")], "cannot write"),
    ]:
        done = run(bench, *arguments)
        assert done.returncode == 2 and text in done.stderr, (arguments, done)
    for option in ["--help", "--list"]:
        done = run(bench, option)
        assert done.returncode == 0 and len(done.stdout) > 300, done


with tempfile.TemporaryDirectory() as scratch:
    check_results(sys.argv[1], scratch)
    check_labs(sys.argv[1], scratch)
    check_errors(sys.argv[1], scratch)
