"""What fills the notes of the benchmark's pages: tables, what they were measured on, and figures."""

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
    """`sections`: by name, what of the results a table needs, and what makes it. `words`: more texts by
    their names. A name that nothing makes is an error."""
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
