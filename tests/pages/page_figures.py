"""Figures in prose: {{PATH | FORMAT}} stands in notes for a figure of the page's JSON.

A path leads from the top of the JSON to a number: `scenes > pyramid & 100 > thud > ms_median`. A word is
a key, or names the element of a list that has this text or number in one of its fields; words joined
by `&` must all be there. What lies one level further down is found without naming the level. `*` stands
for every element, `* gas` for every one that is named so. Between path and format there may be, in any order and worked out from left to right:

    | / PATH      over that figure; its `*` are the elements that the first path took
    | * NUMBER    times so many
    | 1 -         what is left of one

and before the path `least |` or `most |`, which a path with `*` needs. `PAGE: ` before a path names the
JSON of another page. FORMAT is Python's, such as `.2f` or `,.0f`.
"""

import json
import os
import re
import textwrap

import measured
import prose

# The JSON of each page, below docs/.
PAGES = {"performance": "performance.json", "catalogue": "catalogue.json",
         "network": "network.json", "stability": "stability.json",
         "tradeoff": os.path.join("tradeoff", "tradeoff.json")}
PLACEHOLDER = re.compile(r"\{\{([^{}]*\|[^{}]*)\}\}", re.DOTALL)
CODE = re.compile(r"`[^`]*`")
WIDTH = 104
NOT_MEASURED = "(not measured)"


class Missing(KeyError):
    """A path that leads to no figure, or to more than one."""

    def __str__(self):
        return self.args[0]


def page_path(page, docs=measured.DOCS):
    return os.path.join(docs, PAGES[page])


def read_page(page, docs=measured.DOCS):
    with open(page_path(page, docs), encoding="utf-8") as file:
        return json.load(file)


def scalar(value):
    return f"{value:.12g}" if isinstance(value, (int, float)) else value


def is_named(element, word):
    if not isinstance(element, dict):
        return False
    fields = [scalar(v) for v in element.values() if not isinstance(v, (dict, list))]
    return all(part in fields for part in word.split(" & "))


def children(value):
    """The elements that a word may refer to: pairs of a name, or None, and an element."""
    if isinstance(value, dict):
        return list(value.items())
    return [(None, element) for element in value] if isinstance(value, list) else []


def step(value, word):
    if isinstance(value, dict) and word in value:
        return [value[word]]
    found = [v for name, v in children(value) if name is None and is_named(v, word)]
    if found or isinstance(value, list):
        return found
    return [v for _, deeper in children(value) for v in step(deeper, word)
            if isinstance(deeper, (dict, list))]


def follow(value, words, taken, path):
    """[(elements that `*` stood for, figure)]; `taken`: the elements that they must be, if known."""
    if not words:
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise Missing(f"'{path}' is no number")
        return [((), value)]
    star, _, named = words[0].partition(" ")
    if star == "*":
        found = []
        for at, (_, element) in enumerate(children(value)):
            if (taken and taken[0] != at) or (named and not is_named(element, named)):
                continue
            try:
                found += [((at, *deeper), v)
                          for deeper, v in follow(element, words[1:], taken[1:], path)]
            except Missing:
                continue
        return found
    found = step(value, words[0])
    if len(found) != 1:
        raise Missing(f"'{path}' has {len(found)} of '{words[0]}'")
    return follow(found[0], words[1:], taken, path)


class Figures:
    """The figures of one page, and of other pages that paths refer to."""

    def __init__(self, results, docs=measured.DOCS):
        self.results, self.docs, self.others = results, docs, {}

    def find(self, path, taken=()):
        page, colon, rest = path.partition(": ")
        if colon and page in PAGES:
            if page not in self.others:
                self.others[page] = read_page(page, self.docs)
            return follow(self.others[page], rest.split(" > "), taken, path)
        return follow(self.results, path.split(" > "), taken, path)

    def apply(self, operation, found, path):
        if operation == "1 -":
            return [(taken, 1 - v) for taken, v in found]
        sign, _, operand = operation.partition(" ")
        if sign == "*":
            return [(taken, v * float(operand)) for taken, v in found]
        if sign != "/":
            raise Missing(f"'{path}' is followed by '{operation}', which is no operation")
        divided = []
        for taken, v in found:
            below = self.find(operand, taken)
            if len(below) != 1:
                raise Missing(f"'{operand}' is {len(below)} figures")
            divided.append((taken, v / below[0][1]))
        return divided

    def text(self, placeholder):
        parts = [" ".join(part.split()) for part in placeholder.split("|")]
        choose = {"least": min, "most": max}.get(parts[0])
        path, *operations, form = parts[1:] if choose else parts
        found = self.find(path)
        for operation in operations:
            found = self.apply(operation, found, path)
        values = [v for _, v in found]
        if not values or (len(values) > 1 and not choose):
            raise Missing(f"'{path}' is {len(values)} figures")
        return format(choose(values) if choose else values[0], form)


def rewrap(text, change):
    """The text with those paragraphs changed that have placeholders, and their lines filled again."""
    lines, shift = text.split("\n"), 0
    for first, block in list(prose.blocks(text)):
        if not PLACEHOLDER.search(block):
            continue
        count, new = block.count("\n") + 1, change(block)
        if not block.startswith(("|", "#")):
            indent = "  " if prose.ITEM.match(block) else ""
            # Code stays on one line.
            new = CODE.sub(lambda code: code.group().replace(" ", "\0"), " ".join(new.split()))
            new = textwrap.fill(new, WIDTH, subsequent_indent=indent, break_long_words=False,
                                break_on_hyphens=False).replace("\0", " ")
        at = first - 1 + shift
        lines[at:at + count] = new.split("\n")
        shift += len(new.split("\n")) - count
    return "\n".join(lines)


def fill(text, results, whole=True, docs=measured.DOCS):
    """The text with its figures. If a run was not complete, missing figures become NOT_MEASURED."""
    figures = Figures(results, docs)

    def one(match):
        try:
            return figures.text(match.group(1))
        except (Missing, OSError) as error:
            if whole:
                raise ValueError(f"{{{{{match.group(1)}}}}}: {error}") from error
            return NOT_MEASURED

    return rewrap(text, lambda block: PLACEHOLDER.sub(one, block))
