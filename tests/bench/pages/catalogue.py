#!/usr/bin/env python3
"""Measures every system and writes docs/catalogue.md, its pictures and docs/catalogue.json.

usage: catalogue.py THUD_CATALOGUE [option...]

The text between the tables comes from catalogue-notes.md beside this file.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

import catalogue_page
import catalogue_picture
import measured  # found through catalogue_page
import sources

HERE = os.path.dirname(os.path.abspath(__file__))


def parse(arguments):
    parser = argparse.ArgumentParser(prog="./run bench --catalogue",
                                     description=__doc__.split("\n", 1)[0])
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="shows that it runs, compares little")
    parser.add_argument("--out", default=measured.DOCS, metavar="DIR",
                        help="where the page goes (docs)")
    parser.add_argument("--again", action="store_true",
                        help="measures nothing: writes the page anew from catalogue.json in DIR, "
                        "after a change of catalogue-notes.md, say")
    return parser.parse_args(arguments)


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def measure(arguments):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "catalogue.json")
        words = [arguments.program, "--json", path]
        subprocess.run(words + (["--quick"] if arguments.quick else []), check=True)
        return read(path)


def main(words):
    arguments = parse(words)
    kept = os.path.join(arguments.out, "catalogue.json")
    pictures = os.path.join(arguments.out, "pictures")
    try:
        # Checked before the measurement, which takes minutes.
        if not arguments.again:
            measured.refuse_unnamed(arguments.out)
        os.makedirs(pictures, exist_ok=True)
        results = read(kept) if arguments.again else measure(arguments)
        if not arguments.again:
            write(kept, json.dumps(results, indent=1) + "\n")
        with open(os.path.join(HERE, "catalogue-notes.md"), encoding="utf-8") as file:
            page = catalogue_page.fill(file.read(), results)
        write(os.path.join(arguments.out, "catalogue.md"), page)
        for name, picture in catalogue_picture.draw(results).items():
            write(os.path.join(pictures, f"catalogue-{name}.svg"), picture)
        sources.refresh(arguments.out)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(f"catalogue.py: {error}", file=sys.stderr)
        return 1
    print("wrote " + os.path.join(arguments.out, "catalogue.md"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
