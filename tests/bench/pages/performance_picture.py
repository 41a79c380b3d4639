#!/usr/bin/env python3
"""Draws the results of thud-bench: how many times as fast as its rivals thud is, scene by scene.

usage: performance_picture.py RESULTS.json PICTURE.svg
"""

import json
import sys
from xml.sax.saxutils import escape

# Pixels: the picture's width, the widths left and right of the bars, the height above them, and the
# heights of a row and of a bar.
WIDTH, NAMES, RIGHT, TOP, ROW, BAR = 900, 190, 50, 92, 32, 20
FIGURE = 40  # pixels: the figure of a shorter bar stands beside it
GREEN, AMBER, INK, GREY = "#2a7f62", "#c9822b", "#202020", "#8a8a8a"


def engine(scene, name):
    """The results of one engine in a scene; None if it did not run."""
    return next((e for e in scene["engines"] if e["engine"] == name), None)


def ratio(scene, name):
    """The rival's median over thud's, from the race in which both ran."""
    rival = engine(scene, name)
    own = rival and (rival.get("beside") or engine(scene, "thud"))
    return rival["ms_median"] / own["ms_median"] if rival else None


def text(x, y, words, size=14, anchor="start", colour=INK, weight="normal"):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{colour}" font-weight="{weight}">{escape(words)}</text>')


def line(x, y1, y2, colour, width, dashes=""):
    return (f'<line x1="{x:.1f}" y1="{y1:.1f}" x2="{x:.1f}" y2="{y2:.1f}" stroke="{colour}" '
            f'stroke-width="{width}"{dashes}/>')


def tick_step(most):
    """The smallest step of the axis that gives at most ten intervals."""
    return next(step for step in (1, 2, 5, 10, 20, 50, 100, 1000) if most / step <= 10)


def row(scene, y, scale):
    """Draws one scene: its name, Box2D's bar, a line at the target, and Rapier's circle."""
    box2d, rapier, target = ratio(scene, "box2d"), ratio(scene, "rapier"), scene["target"]
    middle = y + ROW / 2
    name = f"{scene['scene'].replace('_', ' ')}, {scene['size']:,}"
    parts = [text(NAMES - 12, middle + 5, name, anchor="end")]
    if box2d:
        colour = GREEN if box2d >= target else AMBER
        parts.append(f'<rect class="box2d" x="{NAMES}" y="{middle - BAR / 2}" '
                     f'width="{box2d * scale:.1f}" height="{BAR}" fill="{colour}"/>')
        beside = box2d * scale < FIGURE
        parts.append(text(NAMES + 8 + beside * box2d * scale, middle + 5, f"{box2d:.1f}",
                          colour=INK if beside else "white", weight="bold"))
    if target:
        parts.append(line(NAMES + target * scale, middle - 14, middle + 14, INK, 3))
    if rapier:
        parts.append(f'<circle class="rapier" cx="{NAMES + rapier * scale:.1f}" cy="{middle}" '
                     f'r="5" fill="white" stroke="{INK}" stroke-width="1.5"/>')
    return parts


def key():
    """Draws the legend."""
    y = 58
    return [text(20, 30, "How many times as fast as its rivals thud is", 18, weight="bold"),
            f'<rect x="20" y="{y - 11}" width="26" height="12" fill="{GREEN}"/>',
            text(52, y, "Box2D's median step over thud's"),
            f'<rect x="304" y="{y - 11}" width="26" height="12" fill="{AMBER}"/>',
            text(336, y, "the same, short of the aim"),
            line(544, y - 14, y + 4, INK, 3), text(554, y, "the least we aim at"),
            f'<circle cx="712" cy="{y - 5}" r="5" fill="white" stroke="{INK}" '
            'stroke-width="1.5"/>', text(724, y, "Rapier's over thud's")]


def picture(scenes):
    """The bar chart as an SVG document."""
    values = [v for s in scenes for v in (ratio(s, "box2d"), ratio(s, "rapier"), s["target"]) if v]
    most = max(values, default=1)
    scale = (WIDTH - NAMES - RIGHT) / most
    bottom = TOP + ROW * len(scenes)
    parts = key()
    step = tick_step(most)
    for tick in range(0, int(most) + 1, step):
        parts.append(line(NAMES + tick * scale, TOP - 8, bottom + 4, "#e2e2e2", 1))
        parts.append(text(NAMES + tick * scale, bottom + 22, str(tick), 12, "middle", GREY))
    parts.append(line(NAMES + scale, TOP - 8, bottom + 4, GREY, 1, ' stroke-dasharray="3 3"'))
    parts.append(text(WIDTH - RIGHT, bottom + 42, "times; one thread, interleaved; 1: as fast", 12,
                      "end", GREY))
    for i, scene in enumerate(scenes):
        parts += row(scene, TOP + i * ROW, scale)
    height = bottom + 54
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
            f'width="{WIDTH}" height="{height}" font-family="sans-serif">\n'
            f'<rect width="{WIDTH}" height="{height}" fill="white"/>\n'
            + "\n".join(parts) + "\n</svg>\n")


def draw(results, path):
    with open(path, "w", encoding="utf-8") as file:
        file.write(picture(results.get("scenes", [])))


def main(words):
    if len(words) != 2 or words[0].startswith("-"):
        print(__doc__.strip())
        return 0 if words in (["-h"], ["--help"]) else 2
    try:
        with open(words[0], encoding="utf-8") as file:
            results = json.load(file)
        draw(results, words[1])
    except (OSError, ValueError) as error:
        print(f"performance_picture.py: {error}", file=sys.stderr)
        return 1
    print("wrote " + words[1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
