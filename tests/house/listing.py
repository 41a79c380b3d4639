"""The list of the engine's files in engine/CMakeLists.txt, bottom to top."""

import re

LIST_FILE = "engine/CMakeLists.txt"
LIST = re.compile(r"^set\(THUD_SOURCES\n(.*?)\)$", re.MULTILINE | re.DOTALL)
LINE = re.compile(r"^\s*src/(\S+)[ \t]*(?:#[ \t]*(stage)?.*)?$")


def read_listing(text):
    """[(path below engine/src, whether it is a stage)] in the order of the list."""
    found = LIST.search(text)
    lines = [LINE.match(line) for line in found.group(1).splitlines()] if found else []
    return [(line.group(1), line.group(2) is not None) for line in lines if line]


def read_floors(text):
    """[(comment of a part of the list, its paths)], bottom to top."""
    found, floors = LIST.search(text), []
    for line in found.group(1).splitlines() if found else []:
        if line.strip().startswith("#"):
            floors.append((line.strip("# \t"), []))
        elif LINE.match(line):
            floors[-1][1].append(LINE.match(line).group(1))
    return floors
