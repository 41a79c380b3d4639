"""Runs every case of thud-tradeoff in its quick form through ./run tradeoff's Python program, and
checks what must hold on any machine; times are not checked.

usage: check_tradeoff.py THUD_TRADEOFF
"""

import csv
import json
import math
import os
import shlex
import signal
import subprocess
import sys
import tempfile
import time
from xml.etree import ElementTree

import tradeoff_figures as figures
import tradeoff_picture as picture

HERE = os.path.dirname(os.path.abspath(__file__))
QUALITIES = ["draft", "default", "high", "exact", "soft 4", "soft 8", "soft 16", "default swept",
             "high swept"]
SUBSTEPS = ["1", "2", "4", "8", "16", "8 stiff", "16 stiff"]
ITERATIONS = ["10", "40", "160"]
JOINTS = ["chain", "bridge", "ragdolls", "cars"]
MEASURES = ["ms_median", "ms_mean", "ms_total", "penetration_worst", "penetration_mean",
            "energy_gained"]
# Where a finer quality has a larger error than a coarser one: case, coarser and finer, the largest
# error of the finer in the quick run, rounded up, and the reason.
KNOWN_MISSES = {}
# Energy that thud gains beyond 1 %: case and setting, the largest known value, and the reason.
KNOWN_GAINS = {}
DRIVEN = ["cars"]  # motors put energy in
LINE = 43  # characters that one picture of the overview has room for


def run(program, *words):
    return subprocess.run([sys.executable, os.path.join(HERE, "tradeoff.py"), program, *words],
                          capture_output=True, text=True, check=False)


def results_in(folder):
    with open(os.path.join(folder, "tradeoff", "tradeoff.json"), encoding="utf-8") as file:
        return json.load(file)


def check_points(case):
    names = [(p["engine"], p["setting"]) for p in case["points"]]
    thud = [("thud", q) for q in QUALITIES]
    rivals = [("box2d", s) for s in SUBSTEPS]
    joints = [("chipmunk", n) for n in ITERATIONS] if case["case"] in JOINTS else []
    assert names in (thud, thud + rivals, thud + rivals + joints), names
    for p in case["points"]:
        assert all(math.isfinite(p[f]) and p[f] >= 0 for f in MEASURES), (case["case"], p)
        assert 0 < p["ms_median"] and p["ms_mean"] > 0, p
        assert math.isclose(p["ms_mean"] * case["steps"], p["ms_total"], rel_tol=1e-4), p
        assert p["penetration_mean"] <= p["penetration_worst"], p
    for p in figures.own(case):
        assert p["lost"] == 0 and math.isfinite(p["error"]), (case["case"], p)
        check_gain(case["case"], p)


def check_gain(case, p):
    known, reason = KNOWN_GAINS.get((case, p["setting"]), (0.01, ""))
    assert p["energy_gained"] < known or case in DRIVEN, (case, p)
    assert not reason or p["energy_gained"] >= 0.01, ("leaves the list of known gains", case, p)


def check_monotone(cases):
    worse = {(c["case"], a["setting"], b["setting"]): b["error"]
             for c in cases for a, b in figures.not_monotone(c)}
    for pair, reached in worse.items():
        assert pair in KNOWN_MISSES, (pair, reached)
        worst, reason = KNOWN_MISSES[pair]
        assert reached <= worst and reason, (pair, reached, "worse than the worst known", worst)
    kept = set(KNOWN_MISSES) - set(worse)
    assert not kept, ("kept again; they leave the list of known misses", kept)
    # Settings must make a difference, otherwise there is nothing to trade; bullets are stopped at
    # all settings.
    for case in cases:
        if case["case"] != "bullets":
            assert len({p["error"] for p in figures.curve(case, "thud")}) > 1, case["case"]


def check_files(folder, cases):
    with open(os.path.join(folder, "tradeoff", "tradeoff.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == sum(len(c["points"]) for c in cases), len(rows)
    assert all(float(row["error"]) >= 0 and float(row["ms_mean"]) > 0 for row in rows)
    with open(os.path.join(folder, "tradeoff.md"), encoding="utf-8") as file:
        page = file.read()
    for case in cases:
        name = f"tradeoff/{case['case']}.svg"
        assert f"({name})" in page and f"## {case['title']}\n" in page, name
        words = "".join(ElementTree.parse(os.path.join(folder, name)).getroot().itertext())
        assert all(figures.label(p) in words for p in case["points"]), (name, words)
    overview = ElementTree.parse(os.path.join(folder, "tradeoff", "overview.svg"))
    words = [text.text for text in overview.iter("{http://www.w3.org/2000/svg}text")]
    for case in cases:
        line = case["error"] + picture.unit(case)
        assert line in words and len(line) <= LINE, (line, "is cut off in the overview")


def check_quick_run(program, folder):
    done = run(program, "--quick", "--out", folder)
    assert done.returncode == 0 and done.stderr == "", done
    results = results_in(folder)
    assert results["missing"] == [] and results["quick"] is True
    cases = results["cases"]
    assert len(cases) >= 11 and [c["case"] for c in cases] == results["wanted"]
    for case in cases:
        check_points(case)
    check_monotone(cases)
    check_files(folder, cases)


def errors_of(program, case):
    done = subprocess.run([program, "--quick", "--case", case], capture_output=True, text=True,
                          check=True)
    found, = json.loads(done.stdout)["cases"]
    return [(p["setting"], p["error"], p["penetration_worst"]) for p in found["points"]]


def check_errors_repeat(program):
    for case in ("rubble", "gas"):
        assert errors_of(program, case) == errors_of(program, case), case


def check_again_measures_nothing(program, folder):
    before = results_in(folder)
    os.remove(os.path.join(folder, "tradeoff", "pyramid.svg"))
    done = run("no-such-program", "--again", "--out", folder)
    assert done.returncode == 0 and results_in(folder) == before, done
    assert os.path.exists(os.path.join(folder, "tradeoff", "pyramid.svg"))


def finished_in(folder):
    try:
        return [c["case"] for c in results_in(folder)["cases"]]
    except OSError:
        return []


def waiting_at(case, program, folder):
    """A program like thud-tradeoff that waits in a case until a file exists: (program, file)."""
    waiting, there = os.path.join(folder, "waiting-tradeoff"), os.path.join(folder, "go-on")
    with open(waiting, "w", encoding="utf-8") as file:
        file.write('#!/bin/sh\n'
                   f'case "$* " in *"--case {case} "*)\n'
                   f'    until [ -e {shlex.quote(there)} ]; do sleep 0.1; done ;;\n'
                   'esac\n'
                   f'exec {shlex.quote(program)} "$@"\n')
    os.chmod(waiting, 0o755)
    return waiting, there


def check_interrupted_run_goes_on(program, folder):
    """Ctrl-C is sent to the whole process group, as by a terminal."""
    os.mkdir(folder)
    few = ["slope", "rolling", "cradle"]
    waiting, there = waiting_at(few[2], program, folder)
    options = ["--quick", "--out", folder]
    options += [word for name in few for word in ("--case", name)]
    words = [sys.executable, os.path.join(HERE, "tradeoff.py"), waiting, *options]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          start_new_session=True) as child:
        # Once there are two results, the page of the first is complete.
        while len(finished_in(folder)) < 2 and child.poll() is None:
            time.sleep(0.01)
        os.killpg(child.pid, signal.SIGINT)
        _, words_left = child.communicate()
    assert child.returncode == 130 and "goes on" in words_left, (child.returncode, words_left)
    assert finished_in(folder) == few[:2], finished_in(folder)
    with open(os.path.join(folder, "tradeoff.md"), encoding="utf-8") as file:
        assert "unfinished: without" in file.read()
    first = results_in(folder)["cases"][0]
    with open(there, "w", encoding="utf-8"):
        pass
    done = run(waiting, *options)
    assert done.returncode == 0 and "going on" in done.stdout, done
    assert results_in(folder)["cases"][0] == first and finished_in(folder) == few


def check_one_case(program, folder):
    done = run(program, "--quick", "--case", "slope", "--out", folder)
    assert done.returncode == 0 and finished_in(folder) == ["slope"], done


def check_refusals(program, folder):
    for words, says in ((["--unknown"], "--unknown"), (["--repeat", "0"], "--repeat"),
                        (["--repeat", "many"], "--repeat"), (["--out"], "--out"),
                        (["--again", "--anew"], "--again")):
        done = run(program, *words)
        assert done.returncode == 2 and says in done.stderr, (words, done)
    done = run(program, "--quick", "--case", "no_such", "--out", folder)
    assert done.returncode == 1 and "no_such" in done.stderr and "pyramid" in done.stderr, done
    done = run(program, "--quick", "--out", os.path.join(HERE, "case.h"))
    assert done.returncode == 1 and "case.h" in done.stderr, done
    for words, says in ((["--case"], "--case"), (["--case", "x"], "x"), (["-x"], "-x"),
                        (["--repeat", "3x"], "3x"), (["--repeat", "101"], "101")):
        done = subprocess.run([program, *words], capture_output=True, text=True, check=False)
        assert done.returncode == 2 and says in done.stderr and not done.stdout, (words, done)
    for words in ((program, "--help"), (program, "--list")):
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        assert done.returncode == 0 and len(done.stdout) > 400, done
    assert run(program, "--help").returncode == 0


def main(program):
    with tempfile.TemporaryDirectory() as scratch:
        folders = [os.path.join(scratch, name) for name in ("whole", "broken", "one", "refused")]
        check_quick_run(program, folders[0])
        check_again_measures_nothing(program, folders[0])
        check_interrupted_run_goes_on(program, folders[1])
        check_one_case(program, folders[2])
        check_refusals(program, folders[3])
    check_errors_repeat(program)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]))
