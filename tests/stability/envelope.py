#!/usr/bin/env python3
"""Drives thud and Box2D to the extremes and writes docs/stability.md and docs/stability.json.

usage: envelope.py THUD_ENVELOPE [option...]

The text between the tables comes from notes.md beside this file.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "pages"))

import measured  # noqa: E402
import sources  # noqa: E402
import stability_page  # noqa: E402


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="./run envelope", allow_abbrev=False, description=__doc__.split("\n", 1)[0])
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("--only", action="append", default=[], metavar="ROW",
                        help="only this extreme, to standard output; may be given several times: "
                        "mass-ratio, columns, far-away, speed, sizes, time-step, energy, slopes, "
                        "long-run, crowding, chains, linkages, springs, joint-crowds, "
                        "wrong-input")
    parser.add_argument("--quick", action="store_true",
                        help="seconds of simulated time, as in the tests: shows that it runs")
    parser.add_argument("--without-box2d", action="store_true", help="thud alone")
    parser.add_argument("--out", metavar="FOLDER", help="where the page goes (docs)")
    parser.add_argument("--again", action="store_true",
                        help="measures nothing: writes the page anew from stability.json in FOLDER, "
                        "after a change of notes.md, say")
    # For ./run, which checks the options before it builds.
    parser.add_argument("--check", action="store_true", help=argparse.SUPPRESS)
    found = parser.parse_args(arguments)
    found.tables = bool(found.only) and not found.out
    found.out = found.out or measured.DOCS
    return found


def run(arguments):
    """The results, and the exit code of thud-envelope: 1 if a known miss is wrong."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "stability.json")
        words = [arguments.program, "--json", path]
        words += [word for name in arguments.only for word in ("--only", name)]
        words += ["--quick"] if arguments.quick else []
        words += ["--without-box2d"] if arguments.without_box2d else []
        code = subprocess.run(words, check=False).returncode
        if code not in (0, 1):
            raise ValueError(f"thud-envelope ended with {code}")
        return read(path), code


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read_notes():
    with open(os.path.join(HERE, "notes.md"), encoding="utf-8") as file:
        return file.read()


def write_page(out, results):
    # One figure per line, so that a diff shows which figures changed.
    write(os.path.join(out, "stability.json"), as_json(results))
    write(os.path.join(out, "stability.md"), stability_page.fill(read_notes(), results))
    sources.refresh(out)
    print("wrote " + os.path.join(out, "stability.md"))


def as_json(results):
    head = {key: value for key, value in results.items() if key != "extremes"}
    lines = [json.dumps(head, ensure_ascii=False)[:-1] + ', "extremes": [']
    for extreme in results["extremes"]:
        texts = {key: value for key, value in extreme.items() if key != "figures"}
        rows = [json.dumps(figure, ensure_ascii=False) for figure in extreme["figures"]]
        lines.append(json.dumps(texts, ensure_ascii=False)[:-1] + ', "figures": [\n  '
                     + ",\n  ".join(rows) + "]}"
                     + ("," if extreme is not results["extremes"][-1] else ""))
    return "\n".join(lines) + "\n]}\n"


def main(words):
    arguments = parse(words)
    if arguments.check:
        return 0
    code = 0
    try:
        if arguments.again:
            results = read(os.path.join(arguments.out, "stability.json"))
        else:
            if not arguments.tables:
                measured.refuse_unnamed(arguments.out)
                os.makedirs(arguments.out, exist_ok=True)
            results, code = run(arguments)
        if arguments.tables:
            print("\n\n".join(f"{e['title']}\n\n{stability_page.table(e)}"
                              for e in results["extremes"]))
        else:
            write_page(arguments.out, results)
    except (OSError, ValueError) as error:
        print(f"envelope.py: {error}", file=sys.stderr)
        return 2
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
