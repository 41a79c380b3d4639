#!/usr/bin/env python3
"""Measures everything and writes docs/performance.md, its picture and docs/performance.json.

usage: performance.py THUD_BENCH [option...]

The hand-written sections come from performance-notes.md beside this file. Every part
of the measurement stays in a folder as soon as it is done; a call that was interrupted goes on with
the next part, as long as the commit is the same and nothing in the tree has changed.
"""

import argparse
import json
import os
import subprocess
import sys

import performance_page
import performance_picture
import measured  # found through performance_page
import sources

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
# Each rival runs alone beside thud: a third engine in turn would evict the data of the other two
# from the caches.
RACES = {"scenes": "box2d", "rapier": "rapier"}
PARTS = ["scenes", "rapier", "growth", "pay", "workers", "profile", "wasm"]


def command_of(part, arguments, path):
    if part == "wasm":
        words = ["node", os.path.join(ROOT, "web", "tools", "bench-wasm.mjs")]
    else:
        words = [arguments.bench, "--" + part]
    words += ["--json", path]
    if part in RACES:
        words[1:2] = ["--scenes", "--against", RACES[part]]
        words += ["--repeat", str(arguments.repeat)] if arguments.repeat else []
    return words + (["--quick"] if arguments.quick else [])


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def is_kept(path, label):
    """Whether a part was measured with the same label, that is, commit and thoroughness."""
    try:
        return read(path + ".label") == label
    except (OSError, ValueError):
        return False


def measure(part, arguments, commit):
    path = os.path.join(arguments.keep, part + ".json")
    label = {"commit": commit, "quick": arguments.quick, "repeat": arguments.repeat}
    known = commit != "unknown" and not commit.endswith("-dirty")
    if known and is_kept(path, label):
        print(f"== {part}: already measured, in {path}", flush=True)
    else:
        print(f"\n== {part}", flush=True)
        subprocess.run(command_of(part, arguments, path), check=True)
        with open(path + ".label", "w", encoding="utf-8") as file:
            json.dump(label, file)
    return read(path)


def add_rival(scenes, others):
    """Adds the rival of a second race to the scenes of the first, with thud's times of that race.
    Scenes without that rival stay as they are."""
    for scene, other in zip(scenes, others):
        own, *rivals = other["engines"]
        scene["engines"] += [{**rival, "beside": own} for rival in rivals]


def has_rapier(bench):
    listed = subprocess.run([bench, "--help"], capture_output=True, text=True, check=False).stdout
    return "rapier" in listed


def measure_all(arguments):
    os.makedirs(arguments.keep, exist_ok=True)
    commit = measured.commit_of_run()
    results = {}
    for part in PARTS:
        if part in arguments.skip or (part == "rapier" and not has_rapier(arguments.bench)):
            continue
        found = measure(part, arguments, commit)
        if part == "wasm":
            found = {"wasm": found}
        if part == "rapier":
            add_rival(results["scenes"], found["scenes"])
        for key, value in found.items():
            results.setdefault(key, value)
    return results


def write_results(results, path):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(results, file, indent=1)
        file.write("\n")


def parse(arguments):
    parser = argparse.ArgumentParser(prog="./run bench --report",
                                     description=__doc__.split("\n", 1)[0])
    parser.add_argument("bench", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="shows that it runs, compares little")
    parser.add_argument("--repeat", type=int, metavar="N", help="repetitions of every scene")
    parser.add_argument("--skip", action="append", default=[], choices=PARTS, metavar="PART",
                        help="leaves out one of " + ", ".join(PARTS) + "; may be given several times")
    parser.add_argument("--keep", default=os.path.join(ROOT, "build", "performance"),
                        metavar="FOLDER", help="where the parts stay (build/performance)")
    parser.add_argument("--out", default=measured.DOCS, metavar="FOLDER",
                        help="where the page goes (docs)")
    parser.add_argument("--again", action="store_true",
                        help="measures nothing: writes the page anew from performance.json in --out, "
                        "after a change of performance-notes.md, say")
    return parser.parse_args(arguments)


def main(words):
    arguments = parse(words)
    kept = os.path.join(arguments.out, "performance.json")
    try:
        if not arguments.again:
            measured.refuse_unnamed(arguments.out)
        results = read(kept) if arguments.again else measure_all(arguments)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(f"performance.py: {error}", file=sys.stderr)
        return 1
    os.makedirs(os.path.join(arguments.out, "pictures"), exist_ok=True)
    if not arguments.again:
        write_results(results, kept)
    with open(os.path.join(HERE, "performance-notes.md"), encoding="utf-8") as file:
        page = performance_page.fill(file.read(), results)
    with open(os.path.join(arguments.out, "performance.md"), "w", encoding="utf-8") as file:
        file.write(page)
    performance_picture.draw(results, os.path.join(arguments.out, "pictures", "performance.svg"))
    sources.refresh(arguments.out)
    print("wrote " + os.path.join(arguments.out, "performance.md"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
