#!/usr/bin/env python3
"""Checks measured figures in headers and typings against the pages' JSON: each is in a phrase of
source-notes.md, below the name of its file, with {{...}} in place of the figure.

usage: sources.py

Writes the figures again, in place. A phrase is found by its words, also across line ends and
comment signs at the beginning of lines.
"""

import glob
import os
import re
import sys

import measured
import page_figures
import prose
import readme

NOTES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "source-notes.md")
SOURCES = ("engine/include/thud/*.h", "web/package/src/**/*.ts", "web/package/README.md")
SECTION = re.compile(r"^## (.+)\n", re.MULTILINE)
GAP = r"\s+(?:(?:/?\*+|//)\s+)?"
FIGURE = r"([\d,]+(?:\.\d+)?)"
MEASURED = re.compile(prose.NUMBER.pattern + readme.UNIT.pattern)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def names():
    """The files that may contain measured figures, relative to the root."""
    found = [path for pattern in SOURCES
             for path in glob.glob(os.path.join(measured.ROOT, pattern), recursive=True)]
    return sorted(os.path.relpath(path, measured.ROOT) for path in found)


def phrases_of(notes):
    """{file: [phrase with placeholders]}"""
    sections = SECTION.split(prose.strip_given(notes))[1:]
    return {name: [" ".join(text.split()) for text in body.split("\n\n") if text.strip()]
            for name, body in zip(sections[::2], sections[1::2])}


def given_in(notes, name):
    """Phrases of this file with numbers that are not measured, such as defaults and bounds."""
    sections = SECTION.split(notes)[1:]
    return prose.given(dict(zip(sections[::2], sections[1::2])).get(name, ""))


def spaced(text):
    return GAP.join(re.escape(word) for word in text.split())


def place_of(phrase):
    """A regular expression that finds the phrase with any figures; it has a group for each figure."""
    texts = page_figures.PLACEHOLDER.split(phrase)[::2]
    parts = []
    for at, text in enumerate(texts):
        before = GAP if at and text[:1].isspace() else ""
        after = GAP if at + 1 < len(texts) and text[-1:].isspace() else ""
        parts.append(before + spaced(text) + (after if text.strip() else ""))
    return re.compile(FIGURE.join(parts))


def with_figures(source, phrase, figures):
    """The source with the phrase's figures replaced by those of the JSON."""
    found = list(place_of(phrase).finditer(source))
    if len(found) != 1:
        raise ValueError(f"'{phrase[:60]}...' stands there {len(found)} times")
    values = [figures.text(path) for path in page_figures.PLACEHOLDER.findall(phrase)]
    for group in range(len(values), 0, -1):
        start, end = found[0].span(group)
        source = source[:start] + values[group - 1] + source[end:]
    return source


def stray_numbers(source, phrases, given):
    """Numbers with a unit that are neither made from the notes nor given."""
    for phrase in phrases:
        source = place_of(phrase).sub(prose.blank, source)
    for phrase in given:
        source = re.sub(spaced(phrase), prose.blank, source)
    return [(source.count("\n", 0, found.start()) + 1, " ".join(found.group().split()))
            for found in MEASURED.finditer(source)]


def filled(source, phrases, docs=measured.DOCS):
    figures = page_figures.Figures({}, docs)
    for phrase in phrases:
        source = with_figures(source, phrase, figures)
    return source


def wrong_in(name, source, notes, docs=measured.DOCS):
    phrases, given = phrases_of(notes).get(name, []), given_in(notes, name)
    try:
        found = [] if filled(source, phrases, docs) == source else \
            [f"{name} has other figures than docs/: python3 tests/pages/sources.py"]
    except (KeyError, ValueError) as error:
        found = [f"{name}: {error}"]
    found += [f"{name}:{line}: '{number}' is neither a figure of the JSON nor given"
              for line, number in stray_numbers(source, phrases, given)]
    return found + [f"{name}: '{phrase}' is given and not written" for phrase in given
                    if not re.search(spaced(phrase), source)]


def wrong(docs=measured.DOCS):
    notes, there = read(NOTES), names()
    found = [f"tests/pages/source-notes.md: no file {name}"
             for name in SECTION.findall(notes) if name not in there]
    for name in there:
        found += wrong_in(name, read(os.path.join(measured.ROOT, name)), notes, docs)
    return found


def write():
    for name, phrases in phrases_of(read(NOTES)).items():
        path = os.path.join(measured.ROOT, name)
        source = read(path)
        anew = filled(source, phrases)
        if anew != source:
            with open(path, "w", encoding="utf-8") as file:
                file.write(anew)


def refresh(folder):
    """After a page was written to docs/: updates the figures that README, headers and typings
    quote."""
    if measured.is_docs(folder):
        readme.write()
        write()


def main(words):
    if words:
        print(__doc__, file=sys.stderr)
        return 2
    write()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
