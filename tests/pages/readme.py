#!/usr/bin/env python3
"""Writes the figures of README.md anew, from the JSON of the pages in docs/ by readme-notes.md.

usage: readme.py
"""

import os
import re
import sys

import measured
import page_figures
import prose

HERE = os.path.dirname(os.path.abspath(__file__))
README = os.path.join(measured.ROOT, "README.md")
NOTES = os.path.join(HERE, "readme-notes.md")
TABLE = "What works today"
GIVEN_THERE = re.compile(r"<!-- given in README\.md:(.*?)-->", re.DOTALL)
# What follows a number that may have been measured.
UNIT = re.compile(r"\s+(?:to [\d.,]+ )?(?:ns|µs|ms|s|%|times|kB|MB)(?!\w)")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def parts_of(notes):
    """The texts of the sections, and the last cells of rows by their first."""
    sections = re.split(r"^## (.+)\n", notes, flags=re.MULTILINE)[1:]
    texts = {name: text.strip("\n") for name, text in zip(sections[::2], sections[1::2])}
    rows = dict(re.findall(r"^\| (.+?) \| (.+) \|$", texts.pop(TABLE), re.MULTILINE))
    rows.pop("system")
    return texts, rows


def put_row(readme, name, cell):
    row = re.compile(rf"^(\| {re.escape(name)} \|.*\| )[^|]*( \|)$", re.MULTILINE)
    if len(row.findall(readme)) != 1:
        raise ValueError(f"README.md has no row, or several, '{name}'")
    return row.sub(lambda match: match.group(1) + cell + match.group(2), readme)


def put_section(readme, name, text):
    section = re.compile(rf"(^## {re.escape(name)}\n\n).*?(?=\n\n## |\Z)", re.MULTILINE | re.DOTALL)
    if not section.search(readme):
        raise ValueError(f"README.md has no section '{name}'")
    return section.sub(lambda match: match.group(1) + text, readme, count=1)


def apply(readme, notes, fill):
    """The README with what the notes make, where `fill` makes text of a template."""
    texts, rows = parts_of(prose.strip_given(GIVEN_THERE.sub("", notes)))
    for name, cell in rows.items():
        readme = put_row(readme, name, fill(cell))
    for name, text in texts.items():
        readme = put_section(readme, name, fill(text).strip("\n"))
    return readme


def filled(readme, notes, docs=measured.DOCS):
    return apply(readme, notes, lambda text: page_figures.fill(text, {}, docs=docs))


def stray_numbers(readme, notes):
    """As of prose.py, of the numbers with a unit that the README has and the notes do not make."""
    bare = apply(readme, notes, lambda text: "")
    listed = "".join(f"<!-- given:{found}-->" for found in GIVEN_THERE.findall(notes))
    numbers = re.compile(prose.NUMBER.pattern + UNIT.pattern)
    return prose.stray_numbers(bare + "\n\n" + listed, numbers)


def write():
    anew = filled(read(README), read(NOTES))
    with open(README, "w", encoding="utf-8") as file:
        file.write(anew)


def main(words):
    if words:
        print(__doc__, file=sys.stderr)
        return 2
    write()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
