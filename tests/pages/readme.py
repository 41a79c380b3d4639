#!/usr/bin/env python3
"""Writes the figures of README.md and docs/features.md anew, from the JSON of the pages in docs/ by the
notes of each.

usage: readme.py
"""

import os
import re
import sys

import measured
import page_figures
import prose

HERE = os.path.dirname(os.path.abspath(__file__))
# The notes of each document that quotes figures.
DOCUMENTS = {"README.md": os.path.join(HERE, "readme-notes.md"),
             "docs/features.md": os.path.join(HERE, "features-notes.md")}
# The section whose notes are the last cells of table rows, found by their first cells.
TABLE = "What works today"
GIVEN_THERE = re.compile(r"<!-- given in (?:README|docs/features)\.md:(.*?)-->", re.DOTALL)
# A unit after a number means that it may have been measured.
UNIT = re.compile(r"\s+(?:to [\d.,]+ )?(?:ns|µs|ms|s|%|times|kB|MB)(?!\w)")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def path_of(name):
    return os.path.join(measured.ROOT, name)


def parts_of(notes):
    """The texts of the sections, and the last cells of table rows by their first cells."""
    sections = re.split(r"^## (.+)\n", notes, flags=re.MULTILINE)[1:]
    texts = {name: text.strip("\n") for name, text in zip(sections[::2], sections[1::2])}
    rows = dict(re.findall(r"^\| (.+?) \| (.+) \|$", texts.pop(TABLE, ""), re.MULTILINE))
    rows.pop("system", None)
    return texts, rows


def put_row(document, name, cell):
    row = re.compile(rf"^(\| {re.escape(name)} \|.*\| )[^|]*( \|)$", re.MULTILINE)
    if len(row.findall(document)) != 1:
        raise ValueError(f"there is no row, or several, '{name}'")
    return row.sub(lambda match: match.group(1) + cell + match.group(2), document)


def put_section(document, name, text):
    section = re.compile(rf"(^## {re.escape(name)}\n\n).*?(?=\n\n## |\Z)", re.MULTILINE | re.DOTALL)
    if not section.search(document):
        raise ValueError(f"there is no section '{name}'")
    return section.sub(lambda match: match.group(1) + text, document, count=1)


def apply(document, notes, fill):
    """The document with the texts of its notes, where `fill` replaces a template's placeholders."""
    texts, rows = parts_of(prose.strip_given(GIVEN_THERE.sub("", notes)))
    for name, cell in rows.items():
        document = put_row(document, name, fill(cell))
    for name, text in texts.items():
        document = put_section(document, name, fill(text).strip("\n"))
    return document


def filled(document, notes, docs=measured.DOCS):
    return apply(document, notes, lambda text: page_figures.fill(text, {}, docs=docs))


def stray_numbers(document, notes):
    """As in prose.py: the numbers with a unit in the document that its notes do not make."""
    bare = apply(document, notes, lambda text: "")
    listed = "".join(f"<!-- given:{found}-->" for found in GIVEN_THERE.findall(notes))
    numbers = re.compile(prose.NUMBER.pattern + UNIT.pattern)
    return prose.stray_numbers(bare + "\n\n" + listed, numbers)


def write():
    for name, notes in DOCUMENTS.items():
        anew = filled(read(path_of(name)), read(notes))
        with open(path_of(name), "w", encoding="utf-8") as file:
            file.write(anew)


def main(words):
    if words:
        print(__doc__, file=sys.stderr)
        return 2
    write()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
