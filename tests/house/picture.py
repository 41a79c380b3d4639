"""Draws the folders of the engine, floor by floor, from the list of its files.

picture.py LIST SVG           writes the picture
picture.py LIST SVG --check   exits with 1 unless the picture is up to date

LIST is engine/CMakeLists.txt. A floor is a part of the list, with its comment as title; a room
is the files of a folder on that floor.
"""

import sys
from html import escape
from pathlib import Path

from listing import read_floors

WIDTH, MARGIN, GAP = 1180, 20, 8
TITLE_WIDTH = 210
SIZE, LINE = 12, 16
GLYPH = 6.7  # pixels: mean width of a letter at this size
COLOURS = {
    "base": "#e3e3e3", "geometry": "#d8e8f7", "terrain": "#e4efd3", "state": "#fdeec4",
    "broadphase": "#d5efe9", "constraint": "#f9d8d2", "contact": "#fbe3cd", "solver": "#e6dcf4",
    "joints": "#f6e3d9", "islands": "#f3d8ea", "direct": "#ead8f3", "detection": "#dcdff7", "api": "#f0ead8",
}


def wrap(text, width):
    """The text's words in lines of at most `width` pixels."""
    lines, line = [], ""
    for word in text.split():
        longer = f"{line} {word}".strip()
        if line and len(longer) * GLYPH > width:
            lines.append(line)
            longer = word
        line = longer
    return [*lines, line]


def rooms_of(paths):
    """{folder: its units on a floor, each named once}, in the order of the list."""
    rooms = {}
    for path in paths:
        folder, name = path.split("/")
        unit = name.rsplit(".", 1)[0]
        units = rooms.setdefault(folder, [])
        if unit not in units:
            units.append(unit)
    return rooms


def widths_of(rooms, width):
    """The width of each room: that of its longest word, and a share of the rest by its text's
    length."""
    least = [GLYPH * 1.15 * max(map(len, [folder, *units])) + 24 for folder, units in rooms.items()]
    weights = [sum(len(unit) + 2 for unit in units) for units in rooms.values()]
    free = width - GAP * (len(least) - 1) - sum(least)
    return [own + free * weight / sum(weights) for own, weight in zip(least, weights)]


def text(x, y, words, style=""):
    return f'<text x="{x:.0f}" y="{y:.0f}"{style}>{escape(words)}</text>'


def draw_floor(title, rooms, y):
    """The SVG elements of a floor, and its height."""
    shapes, x = [], MARGIN + TITLE_WIDTH
    widths = widths_of(rooms, WIDTH - 2 * MARGIN - TITLE_WIDTH)
    filled = [wrap(", ".join(units), width - 20)
              for units, width in zip(rooms.values(), widths)]
    titled = wrap(title, TITLE_WIDTH - 20)
    height = LINE * max(len(titled), *(len(lines) + 1 for lines in filled)) + 14
    for i, line in enumerate(titled):
        shapes.append(text(MARGIN, y + 20 + LINE * i, line, ' font-style="italic"'))
    for folder, width, lines in zip(rooms, widths, filled):
        shapes.append(f'<rect x="{x:.0f}" y="{y}" width="{width:.0f}" height="{height}" rx="4" '
                      f'fill="{COLOURS.get(folder, "#eeeeee")}" stroke="#777777"/>')
        shapes.append(text(x + 10, y + 20, folder, ' font-weight="bold"'))
        shapes += [text(x + 10, y + 20 + LINE * (i + 1), line) for i, line in enumerate(lines)]
        x += width + GAP
    return shapes, height


def draw(floors):
    shapes, y = [], MARGIN
    for title, paths in reversed(floors):
        floor, height = draw_floor(title, rooms_of(paths), y)
        shapes += floor
        y += height + GAP
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{y + MARGIN - GAP}" '
        f'viewBox="0 0 {WIDTH} {y + MARGIN - GAP}" font-family="sans-serif" font-size="{SIZE}">',
        "<title>The files of engine/src: each stands only on what is below it</title>",
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        *shapes, "</svg>", ""])


def main(arguments):
    listing, picture, *more = arguments
    drawn = draw(read_floors(Path(listing).read_text(encoding="utf-8")))
    if more == ["--check"]:
        if Path(picture).read_text(encoding="utf-8") != drawn:
            sys.exit(f"{picture} is not what tests/house/picture.py draws now: run it again")
    else:
        Path(picture).write_text(drawn, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
