"""Measures again the figures that do not depend on the machine, and compares them with the pages.
Two values of a figure agree if they differ by at most the factor FACTOR, or if both are at most
the figure's floor. Times are compared as ratios to Box2D's, which vary less between machines and
runs, with the factor TIMES."""

import json
import os
import subprocess
import tempfile

import page_figures

FACTOR = 1.25
TIMES = 1.5

# The parts that the short form measures, which take seconds; the long form measures all of LONG.
SHORT = {
    "tradeoff": ["column_30", "heavy_on_light", "slope", "rolling", "gas", "cradle", "bullets"],
    "stability": ["mass-ratio", "sizes", "time-step"],
    "catalogue": ["walls", "throws", "levels"],
    "network": ["ordinary, 120 ms, 2 players"],
    "performance": ["pyramid", "tumbler", "platformer", "gas:1000"],
}
# The parts that the long form measures, in about five minutes: all except those that take as long
# on their own (the dense pit, the crowding), and of the catalogue all that is not a time.
LONG = {
    "tradeoff": ["column_30", "column_100", "pyramid", "heavy_on_light", "rubble", "slope", "rolling",
                 "gas", "cradle", "bullets"],
    "stability": ["mass-ratio", "columns", "far-away", "speed", "sizes", "time-step", "energy",
                  "slopes", "long-run", "wrong-input"],
    "catalogue": ["walls", "throws", "levels", "detections"],
    "network": ["steady, 30 ms, 4 players", "ordinary, 120 ms, 3 players", "bad, 60 ms, 4 players",
                "worst, 250 ms, 4 players"],
}
OPTIONS = {"tradeoff": "--case", "stability": "--only", "catalogue": "--part",
           "network": "--run", "performance": "--scene"}


def measure(page, program, parts, more=()):
    words = [program, *more]
    for part in parts:
        words += [OPTIONS[page], part]
    if page == "stability":
        words.append("--without-box2d")
    if page in ("tradeoff", "performance", "network"):
        words += ["--repeat", "1"]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        if page in ("tradeoff", "network"):
            with open(path, "w", encoding="utf-8") as file:
                code = subprocess.run(words, stdout=file, check=False).returncode
        else:
            words += ["--json", path]
            code = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                  check=False).returncode
        # thud-envelope exits with 1 if a known miss is wrong, for which there is another test.
        if code not in ((0, 1) if page == "stability" else (0,)):
            raise ValueError(f"{os.path.basename(program)} ended with {code}")
        with open(path, encoding="utf-8") as file:
            return json.load(file)


def tradeoff(results):
    for case in results["cases"]:
        for p in case["points"]:
            if p["engine"] == "thud":
                name = f"{case['case']}, {p['setting']}"
                yield f"{name}, error", p["error"], case["floor"]
                yield f"{name}, lost", p["lost"], 0
                for key in ("penetration_worst", "penetration_mean"):
                    yield f"{name}, {key}", p[key], 1e-4


def stability(results):
    for extreme in results["extremes"]:
        for figure in extreme["figures"]:
            bound = figure.get("bound", {"kind": "none", "value": 0.1})
            for entrant, reached in figure["reached"].items():
                if entrant != "Box2D":
                    floor = 0 if bound["kind"] == "at least" else 0.01 * bound["value"]
                    yield f"{extreme['name']}: {figure['what']}: {entrant}", reached, floor


def catalogue(results):
    for row in results.get("walls", []):
        for speed in row["speeds"]:
            yield (f"{row['wall']} wall, {row['detection']}, {speed['speed']} m/s: passed",
                   speed["passed"], 0.02)
    for row in results.get("throws", []):
        for key in ("flight", "mean", "worst", "early", "late", "bend"):
            yield f"throws, {row['detection']}, {row['rate']}: {key}", row[key], 1e-4
    for row in results.get("levels", []):
        for key in ("bounds", "circles", "boxes", "oriented", "exact", "near", "contacts"):
            yield f"levels, {row['scene']}: {key}", row[key], 5
    for row in results.get("detections", []):
        for way, found in row["ways"].items():
            for key, floor in (("overlap_max", 1e-3), ("overlap_mean", 1e-3), ("energy_kept", 0.01),
                               ("impacts", 20), ("held_bodies", 20), ("held_seconds", 0.2)):
                yield f"detections, {row['scene']}, {way}: {key}", found[key], floor


def performance(results):
    for scene in results["scenes"]:
        own = next(e for e in scene["engines"] if e["engine"] == "thud")
        for key, floor in (("penetration_max", 1e-3), ("penetration_mean", 1e-4), ("lost", 0),
                           ("bytes", 0)):
            yield f"{scene['scene']}, {scene['size']}: {key}", own[key], floor


def network(results):
    for run in results["runs"]:
        for key, floor in (("lost", 0), ("overtaken", 0), ("replayed", 1), ("replayed_max", 1),
                           ("waits", 0), ("bytes", 0), ("bytes_in_all", 0), ("bytes_states", 0)):
            yield f"{run['name']}: {key}", run[key], floor
        for way in run["ways"]:
            for measure, floor in (("place", 1e-3), ("angle", 0.1), ("place_jump", 1e-3),
                                   ("angle_jump", 0.1)):
                for key in ("mean", "p99", "max"):
                    yield f"{run['name']}: {way['way']}, {measure} {key}", way[measure][key], floor


FIGURES = {"tradeoff": tradeoff, "network": network, "stability": stability, "catalogue": catalogue,
           "performance": performance}


def agree(a, b, floor, factor=FACTOR):
    if not all(isinstance(v, (int, float)) for v in (a, b)):
        return a == b
    a, b = sorted((abs(a), abs(b)))
    return b <= floor or b <= factor * a


def off(page, kept, anew):
    """The figures that differ from those of the page, or that the page does not have."""
    page_has = {name: value for name, value, _ in FIGURES[page](kept)}
    wrong = []
    for name, value, floor in FIGURES[page](anew):
        if name not in page_has:
            wrong.append(f"{name}: {value} now, and not on the page")
        elif not agree(page_has[name], value, floor):
            wrong.append(f"{name}: {page_has[name]} on the page, {value} now")
    return wrong


def median_ratios(results):
    for scene in results["scenes"]:
        found = {e["engine"]: e["ms_median"] for e in scene["engines"]}
        if "box2d" in found:
            yield f"{scene['scene']}, {scene['size']}", found["box2d"] / found["thud"]


def slow(kept, anew):
    """The scenes whose ratio of medians to Box2D's differs from that of the page."""
    page_has = dict(median_ratios(kept))
    return [f"{name}: Box2D's median step is {page_has[name]:.2f} times thud's on the page, "
            f"{ratio:.2f} now" for name, ratio in median_ratios(anew)
            if name not in page_has or not agree(page_has[name], ratio, 0, TIMES)]


def parts_of(page, kept, is_long):
    if not is_long:
        return SHORT[page]
    if page == "performance":
        return [f"{s['scene']}:{s['size']}" for s in kept["scenes"]]
    return LONG[page]


def wrong(page, program, is_long, docs):
    kept = page_figures.read_page(page, docs)
    parts = parts_of(page, kept, is_long)
    return off(page, kept, measure(page, program, parts))


def wrong_times(bench, docs):
    kept = page_figures.read_page("performance", docs)
    parts = parts_of("performance", kept, True)
    return slow(kept, measure("performance", bench, parts, ["--against", "box2d"]))
