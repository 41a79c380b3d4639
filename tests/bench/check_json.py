"""Runs thud-bench on small scenes and checks its tables, its JSON and its errors.

usage: check_json.py THUD_BENCH
"""

import json
import math
import os
import subprocess
import sys
import tempfile

FIELDS = ["ms_median", "ms_p99", "ms_max", "penetration_max", "penetration_mean", "bytes"]


def run(bench, *arguments):
    return subprocess.run([bench, *arguments], capture_output=True, text=True, check=False)


def results_of(bench, folder, *arguments):
    path = os.path.join(folder, "bench.json")
    done = run(bench, "--quick", "--json", path, *arguments)
    assert done.returncode == 0, done.stderr
    assert done.stderr == "", done.stderr
    with open(path, encoding="utf-8") as file:
        return json.load(file), done.stdout


def check_scenes(bench, folder):
    results, table = results_of(bench, folder, "--scene", "tall_stack", "--scene",
                                "circle_pit:300", "--against", "box2d")
    assert "tall_stack" in table and "circle_pit" in table, table
    about = results["about"]
    assert all(about[k] for k in ("date", "commit", "processor", "system", "compiler")), about
    assert "-O3 -DNDEBUG" in about["box2d"], about
    scenes = results["scenes"]
    assert [s["scene"] for s in scenes] == ["tall_stack", "circle_pit"], scenes
    for scene in scenes:
        assert scene["steps"] == 40 and scene["verdict"] == "", scene
        assert scene["bodies"] == (31 if scene["scene"] == "tall_stack" else 303), scene
        assert [e["engine"] for e in scene["engines"]] == ["thud", "box2d"], scene
        for e in scene["engines"]:
            assert all(isinstance(e[f], (int, float)) and math.isfinite(e[f]) for f in FIELDS), e
            assert 0 < e["ms_median"] <= e["ms_p99"] <= e["ms_max"], e
            assert 0 <= e["penetration_mean"] <= e["penetration_max"] < 0.5, e
            assert e["bytes"] > 1000 and e["lost"] == 0, e


def check_promise(bench, folder):
    results, table = results_of(bench, folder, "--scene", "gas:1000", "--steps", "3")
    scene, = results["scenes"]
    assert scene["target"] == 8 and scene["steps"] == 3, scene
    assert scene["verdict"].split(":")[0] in ("holds", "misses"), scene
    assert scene["verdict"] in table, table
    assert "rapier" not in results["about"] or len(scene["engines"]) == 3, scene


def check_labs(bench, folder):
    results, table = results_of(bench, folder, "--growth", "--pay", "--workers", "--profile")
    assert "scenes" not in results
    assert [g["scene"] for g in results["growth"]] == ["gas", "rubble"], results["growth"]
    for growth in results["growth"]:
        each = [size["ns_per_body"] for size in growth["sizes"]]
        assert math.isclose(growth["span"], max(each) / min(each), rel_tol=1e-4), growth
        assert all(size["bytes_per_body"] > 0 for size in growth["sizes"]), growth
    for memory in results["memory"]:
        assert 50 < memory["bytes_per_body"] < 5000, memory
        assert 50 < memory["bytes_per_contact"] < 5000, memory
        assert 50 < memory["box2d_bytes_per_contact"] < 5000, memory
    features = [pair["feature"] for pair in results["pay"]]
    assert len(features) == len(set(features)) >= 8, features
    assert all(p["ms_with"] > 0 and p["ms_without"] > 0 for p in results["pay"])
    scenes = [w["scene"] for w in results["workers"]]
    assert scenes == ["pyramid", "circle_pit", "smash", "gas", "tumbler", "mixed_terrain", "platformer",
                      "sizes", "ragdolls", "joint_grid"], scenes
    assert all(w["ms_one_worker"] > 0 and w["ms_two_workers"] > 0 for w in results["workers"])
    assert len(results["profile"]) >= 15
    for profile in results["profile"]:
        assert profile["ms"] > 0 and 90 < sum(profile["percent"].values()) <= 100.1, profile
    for word in ("dearest over cheapest", "B/body", "rotation", "broadphase"):
        assert word in table, word


def check_profile_of_one_scene(bench, folder):
    results, _ = results_of(bench, folder, "--profile", "--scene", "gas:500", "--steps", "3")
    assert [(p["scene"], p["bodies"]) for p in results["profile"]] == [("gas", 504)], results


def check_errors(bench, folder):
    for arguments, text in [
        (["--scene", "no_such"], "no_such"),
        (["--scene", "gas:0"], "gas:0"),
        (["--steps", "none"], "none"),
        (["--repeat", "0"], "--repeat"),
        (["--scene"], "--scene"),
        (["--against", "nobody"], "nobody"),
        (["--unknown"], "--unknown"),
        (["--growth", "--scene", "gas"], "--scene goes with"),
        (["--pay", "--steps", "5"], "--steps goes with"),
        (["--quick", "--json", os.path.join(folder, "missing", "x.json")], "cannot write"),
    ]:
        done = run(bench, *arguments)
        assert done.returncode == 2 and text in done.stderr, (arguments, done)
        assert done.stdout == "", (arguments, done)
    for option in ["--help", "--list"]:
        done = run(bench, option)
        assert done.returncode == 0 and len(done.stdout) > 300, done


with tempfile.TemporaryDirectory() as scratch:
    check_scenes(sys.argv[1], scratch)
    check_promise(sys.argv[1], scratch)
    check_labs(sys.argv[1], scratch)
    check_profile_of_one_scene(sys.argv[1], scratch)
    check_errors(sys.argv[1], scratch)
