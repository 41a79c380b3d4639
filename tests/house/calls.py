"""Checks the order of calls in the compiled engine: calls.py NM LIST OBJECT...

NM is nm or llvm-nm, LIST is engine/CMakeLists.txt, objects are those of the library. A unit
calls another one if it refers to a function or a constant of it. A function that is plugged in
at run time is no call where it is called, but a call where it is named to plug it in.

  loops    no unit calls itself through others
  stages   a unit that the list calls a stage calls no other stage
  order    a unit calls only units above it in the list
  listed   every unit is in the list, and every unit of the list has an object

Prints one line per breach and exits with 1 if there is any.
"""

import re
import subprocess
import sys
from pathlib import Path

from listing import read_listing

# nm prints each object's name in a line of its own, then a line for each symbol.
OBJECT = re.compile(r"^(?:.*/)?src/(.+\.c)\.(?:o|obj):$")
SYMBOL = re.compile(r"^(\S+) ([A-Za-z])(?: |$)")


def read_symbols(text):
    """({unit: symbols that it needs}, {symbol: the unit that has it}) of what `nm -g -P` says."""
    needs, homes, unit = {}, {}, None
    for line in text.splitlines():
        named, symbol = OBJECT.match(line), SYMBOL.match(line)
        if named:
            unit = named.group(1)
            needs.setdefault(unit, set())
        elif symbol and unit and symbol.group(2) in "Uu":
            needs[unit].add(symbol.group(1))
        elif symbol and unit:
            homes[symbol.group(1)] = unit
    return needs, homes


def call_graph(text):
    """{unit: {unit that it calls: one symbol by which it does}}"""
    needs, homes = read_symbols(text)
    return {unit: {homes[symbol]: symbol for symbol in sorted(symbols, reverse=True)
                   if homes.get(symbol, unit) != unit}
            for unit, symbols in needs.items()}


def check_loops(graph):
    done, trail = set(), []

    def visit(unit):
        if unit in trail:
            yield "loops: " + " -> ".join(trail[trail.index(unit):] + [unit])
        elif unit not in done:
            trail.append(unit)
            for called in sorted(graph.get(unit, ())):
                yield from visit(called)
            trail.pop()
            done.add(unit)

    for unit in sorted(graph):
        yield from visit(unit)


def check_calls(graph, listing):
    place = {name: i for i, (name, _) in enumerate(listing)}
    stages = {name for name, stage in listing if stage}
    for unit, calls in sorted(graph.items()):
        for called, symbol in sorted(calls.items()):
            if unit in stages and called in stages:
                yield f"stages: the stage {unit} calls {symbol} of the stage {called}"
            if place.get(called, -1) > place.get(unit, len(place)):
                yield f"order: {unit} calls {symbol} of {called}, which stands below it in the list"


def check_listed(graph, listing):
    units = {name for name, _ in listing if name.endswith(".c")}
    for unit in sorted(set(graph) - units):
        yield f"listed: {unit} does not stand in the list"
    for unit in sorted(units - set(graph)):
        yield f"listed: {unit} has no object"


def breaches(text, listing):
    graph = call_graph(text)
    return [*check_loops(graph), *check_calls(graph, listing), *check_listed(graph, listing)]


def main(arguments):
    if len(arguments) < 3 or arguments[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if arguments and arguments[0] in ("-h", "--help") else 2
    nm, listing, *objects = arguments
    # nm does not print the name if there is only one object, so the first is given twice.
    text = subprocess.run([nm, "-g", "-P", *objects, objects[0]], check=True, capture_output=True,
                          text=True).stdout
    found = breaches(text, read_listing(Path(listing).read_text(encoding="utf-8")))
    for line in found:
        print(line)
    print(f"{len(found)} breaches of the order of calls")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
