"""Runs thud-catalogue with --quick and checks its tables, its JSON and its errors. No time is
asserted.

usage: check_catalogue.py THUD_CATALOGUE
"""

import json
import os
import subprocess
import sys
import tempfile

import catalogue_page
import catalogue_picture
from catalogue_figures import BROADPHASES, WAYS


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def results_of(program, folder, *arguments):
    path = os.path.join(folder, "catalogue.json")
    done = run(program, "--quick", "--json", path, *arguments)
    assert done.returncode == 0 and done.stderr == "", done
    with open(path, encoding="utf-8") as file:
        return json.load(file), done.stdout


def rows_of(results, part):
    """The rows of a part, which must not be empty."""
    assert results[part], part
    return results[part]


def check_broadphases(results):
    for part in ("growth", "coherence", "sizes", "gathering"):
        for row in rows_of(results, part):
            for name in BROADPHASES:
                # The broadphase is a stage of the step, so its time is shorter than the step's.
                assert 0 < row[name]["ns_per_shape"] < row[name]["step_ns_per_shape"], row
            # In a crowd (broadphase.c) pairs take turns, and which have had theirs depends on the
            # broadphase.
            pairs = {row[name]["pairs"] for name in BROADPHASES[part == "gathering":]}
            assert len(pairs) == 1, row
    assert results["gathering"][-1]["overlaps"] == 100 * 99 / 2, results["gathering"]


def check_detections(results):
    for scene in rows_of(results, "detections"):
        assert list(scene["ways"]) == WAYS, scene
        for way in scene["ways"].values():
            assert way["ms_median"] > 0 and way["ms_max"] >= way["ms_mean"] > 0, way
            levels = [way[k] for k in ("motion_pairs", "motion_circles", "motion_boxes")]
            assert levels == sorted(levels, reverse=True), way
    gas = results["detections"][0]["ways"]
    assert gas["swept"]["impacts"] > 0 and gas["overlap"]["impacts"] == 0, gas
    assert gas["swept"]["overlap_max"] < 1e-6 < gas["overlap"]["overlap_max"], gas


def check_walls(results):
    passed = {(row["wall"], row["detection"]): [s["passed"] for s in row["speeds"]]
              for row in results["walls"]}
    assert len(passed) == 2 * len(WAYS), passed
    for wall in ("static", "dynamic"):
        assert set(passed[wall, "swept"]) == {0}, passed
        assert passed[wall, "overlap"][-1] == passed[wall, "bisect"][-1] == 1, passed
    assert set(passed["static", "continuous"]) == {0}, passed


def check_throws(results):
    """bend: measured error of a step's straight path, m; chord: its bound g h^2 / 8; flight: distance
    from the parabola in free flight; mean, worst: of the hits from the parabola."""
    for row in rows_of(results, "throws"):
        # Up to rounding of floats at a distance of 20 m.
        assert row["bend"] <= row["chord"] + 2e-5, row
        assert 0 < row["flight"] < 0.1 and row["mean"] <= row["worst"], row


def check_prices(results):
    """error: mean distance of balls from their closed form, m; us: processor time, microseconds."""
    errors = {(row["scene"], row["detection"], row["rate"]): row["error"]
              for row in rows_of(results, "prices")}
    assert {way for _, way, _ in errors} == set(WAYS), errors
    for row in results["prices"]:
        assert row["us"] > 0 and 0 <= row["error"] < 2, row
    for scene in ("shuttle", "hop"):
        # What looks ahead meets a wall where it stands, what does not a part of a step behind it.
        assert errors[scene, "swept", 60] < 0.5 * errors[scene, "overlap", 60], errors


def check_levels(results):
    for row in rows_of(results, "levels"):
        counts = [row[k] for k in ("pairs", "circles", "boxes", "oriented", "exact")]
        assert counts == sorted(counts, reverse=True) and counts[0] > 0, row
        counts = [row[k] for k in ("pairs", "sieved", "near", "exact")]
        assert counts == sorted(counts, reverse=True), row
        # Two independent counts, half a step apart.
        assert abs(row["near"] - row["contacts"]) <= 0.1 * row["near"] + 3, row


def check_calls(results):
    prices = [ns for part in ("calls", "tolerances", "volumes", "grounds")
              for row in results[part]
              for ns in row["ns"].values()]
    prices += [row[k]["median"] for row in results["digging"] for k in ("dig", "raise")]
    prices += [row[k] for row in results["queries"] for k in BROADPHASES]
    prices += [row["ns"] for row in results["mover"]]
    assert len(prices) > 150 and all(ns > 0 for ns in prices), prices
    assert all(0 < row["found"] < 50 for row in results["queries"]), results["queries"]


def check_page(results):
    for needs, make in catalogue_page.SECTIONS.values():
        # Each is a table, except the mover's, which is a sentence.
        wanted = [f"{m['mover']} " for m in results[needs]] if needs == "mover" else ["|"]
        assert wanted and all(part in make(results) for part in wanted), needs
    assert len(catalogue_picture.draw(results)) == 8


def check_parts_and_errors(program, folder):
    results, table = results_of(program, folder, "--part", "walls")
    assert "walls" in results and "growth" not in results and "swept" in table, results
    for arguments, text in [
        (["--part", "no_such"], "no_such"),
        (["--part"], "--part"),
        (["--unknown"], "--unknown"),
        (["--json", os.path.join(folder, "missing", "x.json")], "cannot write"),
    ]:
        done = run(program, *arguments)
        assert done.returncode == 2 and text in done.stderr and done.stdout == "", (arguments, done)
    done = run(program, "--help")
    assert done.returncode == 0 and "--quick" in done.stdout, done


with tempfile.TemporaryDirectory() as scratch:
    everything, _ = results_of(sys.argv[1], scratch)
    check_broadphases(everything)
    check_detections(everything)
    check_walls(everything)
    check_throws(everything)
    check_prices(everything)
    check_levels(everything)
    check_calls(everything)
    check_page(everything)
    check_parts_and_errors(sys.argv[1], scratch)
