#!/usr/bin/env python3
"""Measures what the delay of a network costs, and writes docs/network.md with its figures and
pictures.

usage: network.py THUD_NETWORK [option...]

The text between the tables comes from network-notes.md beside this file.
"""

import argparse
import json
import os
import subprocess
import sys

import network_page
import network_picture
import measured  # found through network_page
import sources

HERE = os.path.dirname(os.path.abspath(__file__))


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="./run network", allow_abbrev=False,
        description="Plays a game over simulated networks of 0 to 250 ms, with jitter, loss, "
        "duplicates and reordering, and writes what the delay costs to docs/network.md, with its "
        "figures in docs/network.json and its pictures in docs/pictures/. Takes two minutes.")
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true",
                        help="seconds of play: shows that it works")
    parser.add_argument("--out", metavar="DIR",
                        help="where the page goes (default docs, with --quick build/network)")
    parser.add_argument("--repeat", type=int, metavar="N",
                        help="timed repetitions (default 5, with --quick 1)")
    parser.add_argument("--again", action="store_true",
                        help="measures nothing: writes the page anew from network.json in DIR")
    # For ./run, which checks the options before it builds.
    parser.add_argument("--check", action="store_true", help=argparse.SUPPRESS)
    found = parser.parse_args(arguments)
    if found.repeat is not None and not 1 <= found.repeat <= 100:
        parser.error(f"--repeat wants a number from 1 to 100, not {found.repeat}")
    found.out = found.out or (os.path.join(measured.ROOT, "build", "network") if found.quick
                              else measured.DOCS)
    return found


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def measure(arguments):
    words = [arguments.program]
    words += ["--quick"] if arguments.quick else []
    words += ["--repeat", str(arguments.repeat)] if arguments.repeat else []
    done = subprocess.run(words, stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout


def write_page(out):
    """Writes the page and its pictures from network.json in `out`."""
    results = json.loads(read(os.path.join(out, "network.json")))
    pictures = os.path.join(out, "pictures")
    os.makedirs(pictures, exist_ok=True)
    for name, picture in network_picture.draw(results).items():
        write(os.path.join(pictures, f"network-{name}.svg"), picture)
    notes = read(os.path.join(HERE, "network-notes.md"))
    write(os.path.join(out, "network.md"), network_page.fill(notes, results))
    sources.refresh(out)


def main(words):
    arguments = parse(words)
    if arguments.check:
        return 0
    try:
        if not arguments.again:
            measured.refuse_unnamed(arguments.out)
            found = measure(arguments)
            os.makedirs(arguments.out, exist_ok=True)
            write(os.path.join(arguments.out, "network.json"), found)
        write_page(arguments.out)
    except (OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        print(f"network.py: {error}", file=sys.stderr)
        return 1
    print("wrote " + os.path.join(arguments.out, "network.md"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
