#!/usr/bin/env python3
"""Measures what accuracy costs, and writes docs/tradeoff.md with its pictures and figures.

usage: tradeoff.py THUD_TRADEOFF [option...]

What is finished of a run is written case by case: after Ctrl-C the same command goes on where it was,
as long as thud-tradeoff is the same. The text between the tables comes word for word from
tradeoff-notes.md beside this file, but for the figures in it.
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import time

import tradeoff_page
import tradeoff_picture
import measured  # found through tradeoff_page
import sources

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
FOLDER = "tradeoff"
INTERRUPTED = 130


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="./run tradeoff", allow_abbrev=False,
        description="Runs every case in thud at each quality and in Box2D v3.2 at 1 to 16 substeps, "
        "which takes some minutes, and writes what accuracy costs to docs/tradeoff.md, with its "
        "pictures and figures in docs/tradeoff/. After Ctrl-C the same command goes on with the "
        "cases that are missing.")
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true",
                        help="small scenes and short runs: shows that it works")
    parser.add_argument("--out", metavar="DIR", help="where the page goes (default docs, with --quick or --case "
                        "build/tradeoff, so that docs keeps the full run)")
    parser.add_argument("--case", action="append", metavar="NAME", dest="cases",
                        help="only this case; may be given several times")
    parser.add_argument("--repeat", type=int, metavar="N",
                        help="timed repetitions (default 9, with --quick 1)")
    # For ./run, which checks the options before it builds.
    parser.add_argument("--check", action="store_true", help=argparse.SUPPRESS)
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--again", action="store_true",
                     help="measures nothing: writes the page anew from the figures in DIR")
    how.add_argument("--anew", action="store_true",
                     help="forgets what an interrupted run left")
    found = parser.parse_args(arguments)
    if found.repeat is not None and not 1 <= found.repeat <= 100:
        parser.error(f"--repeat wants a number from 1 to 100, not {found.repeat}")
    part = found.quick or found.cases
    found.out = found.out or os.path.join(ROOT, *(["build", "tradeoff"] if part else ["docs"]))
    found.repeat = found.repeat or (1 if found.quick else 9)
    return found


def write(path, words):
    """Writes the file atomically: an interruption leaves the old or the new text."""
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(words)
    os.replace(path + ".new", path)


def write_all(out, results, only=None):
    """Writes the page, its figures, and the pictures: of all cases, or of the case `only`."""
    folder = os.path.join(out, FOLDER)
    # Pictures come first: a run that goes on draws none of the cases that the figures have.
    if results["cases"]:
        for name, picture in tradeoff_picture.draw(results, only).items():
            write(os.path.join(folder, name), picture)
    write(os.path.join(folder, "tradeoff.json"), json.dumps(results, indent=1) + "\n")
    write(os.path.join(folder, "tradeoff.csv"), tradeoff_page.comma_separated(results))
    with open(os.path.join(HERE, "tradeoff-notes.md"), encoding="utf-8") as file:
        write(os.path.join(out, "tradeoff.md"),
              tradeoff_page.fill(file.read(), results, FOLDER))


def read_results(out):
    with open(os.path.join(out, FOLDER, "tradeoff.json"), encoding="utf-8") as file:
        return json.load(file)


def build_of(program):
    """A digest of the program, which tells builds apart."""
    with open(program, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()[:16]


def list_cases(arguments):
    """[(name, its share of the work)] of the wanted cases."""
    words = [arguments.program, "--list"] + (["--quick"] if arguments.quick else [])
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    # The fixed cost of a step is about that of twenty bodies.
    all_cases = {name: (int(bodies) + 20) * int(steps)
                 for name, bodies, steps, *_ in map(str.split, done.stdout.splitlines())}
    unknown = [name for name in arguments.cases or [] if name not in all_cases]
    if unknown:
        raise ValueError(f"there is no case {', '.join(unknown)}; there are "
                         + ", ".join(all_cases))
    return [(n, w) for n, w in all_cases.items() if n in (arguments.cases or all_cases)]


class Progress:
    """Shows a bar with the remaining time, if stderr is a terminal."""

    def __init__(self, work):
        self.work, self.done, self.begun = max(work, 1), 0, time.monotonic()
        self.shown = sys.stderr.isatty()

    def show(self, case, work, fraction):
        if not self.shown:
            return
        part = min((self.done + work * fraction) / self.work, 1)
        passed = time.monotonic() - self.begun
        left = f"{passed * (1 - part) / part:4.0f} s left" if part > 0.01 else ""
        filled = int(30 * part)
        sys.stderr.write(f"\r[{'#' * filled}{'.' * (30 - filled)}] {100 * part:3.0f} %  {left:12}  "
                         f"{case:16}")
        sys.stderr.flush()

    def finish_case(self, work):
        self.done += work

    def clear(self):
        if self.shown:
            sys.stderr.write("\r" + 78 * " " + "\r")


def measure_case(arguments, name, work, progress):
    words = [arguments.program, "--case", name, "--repeat", str(arguments.repeat), "--progress"]
    with subprocess.Popen(words + (["--quick"] if arguments.quick else []), text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        try:
            for line in child.stderr:
                case, _, fraction = line.strip().partition(" ")
                if case == name:
                    progress.show(name, work, float(fraction))
                else:
                    progress.clear()
                    sys.stderr.write(line)
            found = child.stdout.read()
        except KeyboardInterrupt:
            child.terminate()
            raise
    if child.returncode != 0:
        raise subprocess.CalledProcessError(child.returncode, words)
    return json.loads(found)


def left_over(arguments, wanted):
    """The results of an interrupted run with the same options and build, or empty ones."""
    terms = {"build": build_of(arguments.program), "quick": arguments.quick,
             "repeat": arguments.repeat, "wanted": wanted}
    fresh = {"about": {}, **terms, "missing": wanted, "cases": []}
    if arguments.anew:
        return fresh
    try:
        old = read_results(arguments.out)
        same = old["missing"] and all(old[name] == value for name, value in terms.items())
        return old if same else fresh
    except (OSError, ValueError, KeyError):
        return fresh


def measure(arguments):
    """Measures case by case, and writes each result when it is done."""
    cases = list_cases(arguments)
    wanted = [name for name, _ in cases]
    results = left_over(arguments, wanted)
    to_do = [(name, work) for name, work in cases if name in results["missing"]]
    if len(to_do) < len(cases):
        print(f"going on: {len(cases) - len(to_do)} of {len(cases)} cases are there (--anew "
              "measures them again)")
    progress = Progress(sum(work for _, work in to_do))
    for name, work in to_do:
        found = measure_case(arguments, name, work, progress)
        results["about"] = found["about"]
        results["cases"] += found["cases"]
        results["cases"].sort(key=lambda case: wanted.index(case["case"]))
        results["missing"] = [n for n in results["missing"] if n != name]
        write_all(arguments.out, results, only=name)
        progress.finish_case(work)
        progress.clear()
        print(f"{name}: {tradeoff_page.verdict(found['cases'][0])}".replace("**", ""))


def main(words):
    arguments = parse(words)
    if arguments.check:
        return 0
    try:
        os.makedirs(os.path.join(arguments.out, FOLDER), exist_ok=True)
        if arguments.again:
            write_all(arguments.out, read_results(arguments.out))
        else:
            measured.refuse_unnamed(arguments.out)
            measure(arguments)
        sources.refresh(arguments.out)
    except KeyboardInterrupt:
        print("\ninterrupted: the finished cases are in "
              f"{os.path.join(arguments.out, FOLDER)}; the same command goes on", file=sys.stderr)
        return INTERRUPTED
    except (OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        print(f"tradeoff.py: {error}", file=sys.stderr)
        return 1
    print("wrote " + os.path.join(arguments.out, "tradeoff.md"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
