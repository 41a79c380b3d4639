"""Fills the notes of the benchmark's pages with tables and figures, and names commit and machine."""

import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "pages"))

import page_figures  # noqa: E402
import measured  # noqa: E402
import prose  # noqa: E402

NOT_MEASURED = "Not part of this run."
ABOUT = ["processor", "processors", "system", "compiler", "box2d", "rapier"]


def fill(notes, results, sections, words=None):
    """`sections`: by name, the part of the results that a table needs, and the function that makes
    it. `words`: further texts by name. An unknown name is an error."""
    known = {name: str(results["about"].get(name, "not built")) for name in ABOUT}
    known.update(words or {}, measured=measured.line(results["about"]))

    def text_of(match):
        name = match.group(1)
        if name in known:
            return known[name]
        needs, make = sections[name]
        return make(results) if needs in results else NOT_MEASURED

    whole = not results.get("quick") and all(needs in results for needs, _ in sections.values())
    text = re.sub(r"\{\{(\w+)\}\}", text_of, prose.strip_given(notes))
    return page_figures.fill(text, results, whole)
