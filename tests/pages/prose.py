"""Numbers in prose about measured figures. A number stands there in one of three ways:

- as a figure of the JSON, {{PATH | FORMAT}}: figures.py;
- as something given, such as a size that was chosen or a bound that is promised: within a phrase that
  the list at the end of the notes has, <!-- given: radius 0.25; 4 substeps -->;
- as history: in a paragraph or below a heading that says of when it is, (as of 2026-11-21, commit
  0123456789ab).

Anything else may have been measured once and be wrong by now. Code, links and names are left out.
"""

import re

GIVEN = re.compile(r"<!-- given:(.*?)-->\s*", re.DOTALL)
PLACEHOLDER = re.compile(r"\{\{.*?\}\}", re.DOTALL)
NOT_PROSE = re.compile(r"`[^`]*`|\]\([^)]*\)|<[^>]*>|https?://\S+")
NUMBER = re.compile(r"(?<![\w./-])\d[\d,]*(?:[./^]-?\d+)*(?:e-?\d+)?")
DATED = re.compile(r"\(as\s+of\s+\d{4}-\d\d-\d\d,\s+commit\s+([0-9a-f]{10,12})\)")
HEADING = re.compile(r"^(#+) ")
ITEM = re.compile(r"^\s*(?:- |\|)")


def blank(match):
    """Replaces a match by as many lines, so that the following lines keep their numbers."""
    return " " * len(match.group()) if "\n" not in match.group() else \
        re.sub(r"[^\n]", " ", match.group())


def strip_given(notes):
    return GIVEN.sub("", notes)


def given(notes):
    return [" ".join(phrase.split()) for found in GIVEN.findall(notes) for phrase in found.split(";")
            if phrase.strip()]


def blocks(text):
    """(first line, text) of every paragraph, list item, table row and heading."""
    start, lines = 1, []
    for at, line in enumerate(text.split("\n") + [""], 1):
        is_item = ITEM.match(line)
        if line.strip() and not HEADING.match(line) and not (is_item and lines):
            start = start if lines else at
            lines.append(line)
            continue
        if lines:
            yield start, "\n".join(lines)
            lines = []
        if is_item:
            start, lines = at, [line]
        elif line.strip():
            yield at, line


def covered(block, phrases):
    """The block without the given phrases; a phrase may be broken over two lines."""
    for phrase in sorted(phrases, key=len, reverse=True):
        words = r"\s+".join(re.escape(word) for word in phrase.split())
        block = re.sub(rf"(?<!\w){words}(?!\w)", blank, block)
    return block


def stray_numbers(notes, numbers=NUMBER):
    """[(line, the line's text, number)] of all numbers that belong to none of the three kinds."""
    phrases, found = given(notes), []
    text = NOT_PROSE.sub(blank, PLACEHOLDER.sub(blank, GIVEN.sub(blank, notes)))
    dated_from = 0  # level of the dated heading; 0: none
    lines = notes.split("\n")
    for first, block in blocks(text):
        heading = HEADING.match(block)
        if heading and (not dated_from or len(heading.group(1)) <= dated_from):
            dated_from = len(heading.group(1)) if DATED.search(block) else 0
        if dated_from or DATED.search(block):
            continue
        for at, line in enumerate(covered(block, phrases).split("\n"), first):
            found += [(at, lines[at - 1], number.group()) for number in numbers.finditer(line)]
    return found


def stray_phrases(notes):
    """Phrases that are listed as given and do not occur in the text."""
    text = " ".join(GIVEN.sub("", notes).split())
    return [phrase for phrase in given(notes) if phrase not in text]


def dates(notes):
    return DATED.findall(notes)
