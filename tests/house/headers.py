"""Checks what the text of the public headers must contain: headers.py PROJECT.

  stated    each limit that tests/wrong_input/limits.h tests at a field or argument is named in
            the comment of that field, or for an argument in those of its function's section
  tried     each limit of thud_limits.h is in that table
  used      the engine uses each limit of thud_limits.h
  numbers   no other header gives a limit as a number, and no file of the engine compares with one
  vectors   functions of a world take places and directions as thud_pos and thud_vec2, except the
            path of a ray or cast; geometry without a world takes and returns numbers
  all       thud_all.h includes every other header, but thud_recorded.h, which includes it

Prints one line per breach and exits with 1 if there is any.
"""

import re
import sys
from pathlib import Path

LIMIT = re.compile(r"\bTHUD_[A-Z_]+_(?:MAX|MIN|ERROR)\b")
DEFINED = re.compile(r"^#define (THUD_[A-Z_]+) +([-0-9.]\S*)", re.MULTILINE)
ROW = re.compile(r"\b(FIELD|CALL)\(\s*(thud_\w+),\s*(\w+),(.*?)(?=\b(?:FIELD|CALL)\(|\n\n|#endif)",
                 re.DOTALL)
STRUCT = re.compile(r"(?:typedef )?struct (thud_\w+) \{(.*?)\n\}", re.DOTALL)
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
FUNCTION = re.compile(r"^(?:THUD_NODISCARD )?(?:THUD_API |bool )[^;{}#]*?\b(thud_\w+)\(([^;{}]*)\);", re.MULTILINE)
NUMBER = re.compile(r"(?:<=|>=|\[|\]|,) *-?\d[\d.]*e\+?\d")
COMPARED = re.compile(r"[<>]=? *-?\d[\d.]*e\+?\d")
# Handles and structs that belong to a world.
OF_A_WORLD = re.compile(r"\bthud_(?:world|mover|mover_hit) \*|\bthud_(?:body|shape|joint)_id\b")
PAIR = re.compile(r"\bdouble \*?([a-z_]*?)x, double \*?\1y\b")
# Prefixes of paths of rays and casts, and of sizes in queries; thud_math.h has the reasons.
WAYS = {"d", "half_"}


def rows(table):
    """(is a field, struct or function, field or argument, limits) of each row of limits.h."""
    for kind, where, what, rest in ROW.findall(table.replace("\\\n", "\n").replace("\\", "")):
        yield kind == "FIELD", where, what, sorted(set(LIMIT.findall(rest)))


def comment_of_field(body, field):
    """The comment behind a field, or the one above it where there is none."""
    at = re.search(rf"^\s[^/*;]*\b{field}\b[^;]*;", body, re.MULTILINE)
    if not at:
        return None
    behind = re.match(r"[ \t]*(/\*.*?\*/)", body[at.end():], re.DOTALL)
    above = COMMENT.findall(body[:at.start()])
    return behind.group(1) if behind else above[-1] if above else ""


def comments_of_function(text, name):
    """Of a function's section, down to itself, and of the head of the file."""
    at = re.search(rf"\b{name}\(", re.sub(COMMENT, lambda c: " " * len(c.group()), text))
    if not at:
        return None
    section = text.rfind("/* ---- ", 0, at.start())
    return " ".join(COMMENT.findall(text[max(section, 0):at.start()]) + COMMENT.findall(text)[:1])


def check_stated(headers, table):
    structs = {name: body for text in headers.values() for name, body in STRUCT.findall(text)}
    for is_field, where, what, limits in rows(table):
        if is_field:
            said = comment_of_field(structs.get(where, ""), what)
        else:
            said = next(filter(None, (comments_of_function(text, where)
                                      for text in headers.values())), None)
        for limit in limits:
            if said is None:
                yield f"stated: no header has {what} of {where}"
            elif limit not in said:
                yield f"stated: the comment of {what} of {where} does not name {limit}"


def check_limits(headers, tests, engine):
    for limit, _ in DEFINED.findall(headers["thud_limits.h"]):
        if limit not in tests:
            yield f"tried: no test tries {limit}"
        if not any(re.search(rf"\b{limit}\b", text) for text in engine.values()):
            yield f"used: the engine does not go by {limit}"


def check_numbers(headers, engine):
    for name, text in headers.items():
        for line in text.splitlines():
            if name != "thud_limits.h" and NUMBER.search(line):
                yield f"numbers: {name} has a limit as a number: {line.strip()}"
    for name, text in engine.items():
        for line in text.splitlines():
            if COMPARED.search(line):
                yield f"numbers: {name} compares with a number: {line.strip()}"


def check_vectors(headers):
    for text in headers.values():
        for name, arguments in FUNCTION.findall(COMMENT.sub("", text)):
            arguments = " ".join(arguments.split())
            if OF_A_WORLD.search(arguments) or name.startswith("thud_world_"):
                for pair in PAIR.findall(arguments):
                    if pair not in WAYS:
                        yield f"vectors: {name} has {pair}x, {pair}y, which should be one vector"
            elif re.search(r"(?:^|, )thud_(?:pos|vec2) ", arguments):
                yield f"vectors: {name} has a vector, which geometry takes and gives as numbers"


def check_all(headers):
    included = set(re.findall(r'#include "(\w+\.h)"', headers["thud_all.h"]))
    for name in sorted(set(headers) - included - {"thud_all.h", "thud_recorded.h"}):
        yield f"all: thud_all.h does not include {name}"


def read(folder, *patterns):
    return {path.name: path.read_text(encoding="utf-8")
            for pattern in patterns for path in sorted(folder.rglob(pattern))}


def breaches(headers, engine, table, tests):
    return [*check_stated(headers, table), *check_limits(headers, table + tests, engine),
            *check_numbers(headers, engine), *check_vectors(headers), *check_all(headers)]


def main(arguments):
    if len(arguments) != 1 or arguments[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if arguments and arguments[0] in ("-h", "--help") else 2
    project = Path(arguments[0])
    refused = project / "tests" / "wrong_input"
    found = breaches(read(project / "engine/include/thud", "*.h"),
                     read(project / "engine/src", "*.c", "*.h"),
                     (refused / "limits.h").read_text(encoding="utf-8"),
                     (refused / "test_limits.c").read_text(encoding="utf-8"))
    for line in found:
        print(line)
    print(f"{len(found)} breaches by the public headers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
