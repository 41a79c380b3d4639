"""Compares docs/guarantees.md with the tests: check_table.py TEST_GUARANTEES ROOT.

  rows      each guarantee of the program has one row, and each row is tested there or names a
            test elsewhere
  tests     the file that a row links exists, and contains each `name` in the row's test
  settings  a row states the same settings as the program's table
  faults    each row names the deliberate fault that made its test fail
  drawn     each value of each dimension is drawn for each guarantee, unless its row excludes it;
            each quality, detection and broadphase of the public headers is a value

Prints one line per breach and exits with 1 if there is any.
"""

import re
import subprocess
import sys
from pathlib import Path

TABLE = "docs/guarantees.md"
HERE = "tests/guarantees/"
LINK = re.compile(r"\[[^\]]*\]\(\.\./([^)#]+)\)")
NAME = re.compile(r"`(\w+)`")
PUBLIC = re.compile(r"^extern THUD_API const thud_(quality|detection|broadphase) thud_\1_(\w+);",
                    re.MULTILINE)
ROW = ["name", "promise", "settings", "test", "fault"]
FAULT_WORDS = 3


def read_rows(text):
    """The rows of all tables whose first cell is a name in backticks."""
    rows = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("| `") and len(cells) == len(ROW):
            row = dict(zip(ROW, cells))
            row["name"] = row["name"].strip("`")
            rows.append(row)
        elif line.startswith("| `"):
            raise SystemExit(f"{TABLE}: this row has {len(cells)} cells, not {len(ROW)}: {line}")
    return rows


def read_listing(text):
    """{guarantee: settings}, as --list prints them."""
    return dict(line.split("\t") for line in text.splitlines())


def read_draws(text):
    """{guarantee: {"dimension=value", ...}}, as --draws prints them."""
    drawn = {}
    for line in text.splitlines():
        name, values = line.split("\t")
        drawn.setdefault(name, set()).update(values.split(","))
    return drawn


def public_values(root):
    """Each quality, detection and broadphase of the public headers, as "dimension=value"."""
    return {f"{dimension}={name}" for header in sorted((root / "engine/include/thud").glob("*.h"))
            for dimension, name in PUBLIC.findall(header.read_text(encoding="utf-8"))}


def check_rows(rows, listing):
    names = [row["name"] for row in rows]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f"rows: {name} has {names.count(name)} rows"
    for name in sorted(set(listing) - set(names)):
        yield f"rows: {name} is tried and has no row"
    for row in rows:
        if row["name"] not in listing and f"(../{HERE}" in row["test"]:
            yield f"rows: {row['name']} is not tried by {HERE}"


def check_tests(rows, listing, root):
    for row in rows:
        files = LINK.findall(row["test"])
        if not files:
            yield f"tests: {row['name']} links no test"
        text = ""
        for file in files:
            if (root / file).is_file():
                text += (root / file).read_text(encoding="utf-8")
            else:
                yield f"tests: {row['name']} links {file}, which is not there"
        wanted = [name for name in NAME.findall(row["test"]) if "." not in name]
        if row["name"] in listing:
            wanted = [row["name"]]
        for name in wanted:
            if not re.search(rf"\b{name}\b", text):
                yield f"tests: {row['name']} names {name}, which its file does not have"
        if row["name"] not in listing and not wanted:
            yield f"tests: {row['name']} names no test of its file"


def check_settings(rows, listing):
    for row in rows:
        wanted = listing.get(row["name"])
        if wanted is not None and row["settings"] != wanted:
            yield f"settings: {row['name']} says '{row['settings']}', the test '{wanted}'"
        if not row["settings"]:
            yield f"settings: {row['name']} says nothing"


def check_faults(rows):
    for row in rows:
        if len(row["fault"].split()) < FAULT_WORDS:
            yield f"faults: {row['name']} names no fault that its test has been seen to find"


def left_out(settings):
    """The values that a row's settings exclude: "not draft, high: why; not on: why"."""
    return {value.strip() for part in settings.split(";") if part.strip().startswith("not ")
            for value in part.strip()[4:].split(":")[0].split(",")}


def check_drawn(listing, drawn, public):
    values = set().union(*drawn.values()) if drawn else set()
    for value in sorted(public - values):
        yield f"drawn: nobody draws {value}"
    for name, settings in listing.items():
        out = left_out(settings)
        for value in sorted(values - drawn.get(name, set())):
            if value.split("=")[1] not in out:
                yield f"drawn: {name} is never tried on {value}"


def check(text, listing, drawn, root):
    rows = read_rows(text)
    return [*check_rows(rows, listing), *check_tests(rows, listing, root),
            *check_settings(rows, listing), *check_faults(rows),
            *check_drawn(listing, drawn, public_values(root))]


def ask(program, option):
    return subprocess.run([program, option], capture_output=True, text=True, check=True).stdout


def main():
    program, root = sys.argv[1], Path(sys.argv[2])
    breaches = check((root / TABLE).read_text(encoding="utf-8"),
                     read_listing(ask(program, "--list")), read_draws(ask(program, "--draws")),
                     root)
    for breach in breaches:
        print(breach)
    print(f"{len(breaches)} breaches between {TABLE} and its tests")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
