"""Draws line charts as SVG, with each line's name at its end instead of a legend."""

import math
from xml.sax.saxutils import escape

# Pixels.
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 900, 440, 80, 190, 84, 60
LABEL_GAP = 17
INK, GREY, PALE = "#202020", "#757575", "#e2e2e2"
COLOURS = ["#2a7f62", "#b5561d", "#3d5a9e", "#8a3d7c", "#7a6a12"]
# A value that is only this much (in decades) beyond a power of ten gets no further decade.
SLACK = 1e-3


def text(x, y, words, size=14, anchor="start", colour=INK, weight="normal"):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{colour}" font-weight="{weight}">{escape(words)}</text>')


def rule(x1, y1, x2, y2):
    return (f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{PALE}" '
            'stroke-width="1"/>')


def short(value):
    """The number with at most three digits after the point for small values, and none for others."""
    return f"{value:,.0f}" if value >= 1 else f"{value:g}"


def decades(low, high):
    """The powers of ten from the last one below `low` to the first one above `high`."""
    first = math.floor(math.log10(low) + SLACK)
    last = max(math.ceil(math.log10(high) - SLACK), first + 1)
    return [10.0 ** k for k in range(first, last + 1)]


def spread(wanted, gap, low, high):
    """Positions close to the wanted ones, in their order, at least `gap` apart."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    places = [0.0] * len(wanted)
    at = low - gap
    for i in order:
        at = max(wanted[i], at + gap)
        places[i] = at
    limit = high
    for i in reversed(order):
        places[i] = min(places[i], limit)
        limit = places[i] - gap
    return places


class Scale:
    """Maps values, or their logarithms, to pixels between the first and the last tick."""

    def __init__(self, ticks, start, end, logarithmic):
        self.ticks, self.start, self.end = ticks, start, end
        self.of = math.log10 if logarithmic else float

    def __call__(self, value):
        low, high = self.of(self.ticks[0]), self.of(self.ticks[-1])
        return self.start + (self.of(value) - low) / (high - low) * (self.end - self.start)


def axes(x, y, x_names, y_names, x_title, y_title):
    """The grid lines, tick labels and titles of both axes."""
    parts = []
    for tick, name in zip(y.ticks, y_names):
        parts.append(rule(LEFT, y(tick), WIDTH - RIGHT, y(tick)))
        parts.append(text(LEFT - 8, y(tick) + 4, name, 12, "end", GREY))
    for tick, name in zip(x.ticks, x_names):
        parts.append(rule(x(tick), TOP, x(tick), HEIGHT - BOTTOM))
        parts.append(text(x(tick), HEIGHT - BOTTOM + 18, name, 12, "middle", GREY))
    parts.append(text(LEFT, TOP - 14, y_title, 12, "start", GREY))
    parts.append(text(WIDTH - RIGHT, HEIGHT - BOTTOM + 40, x_title, 12, "end", GREY))
    return parts


def line(points, x, y, colour, joined):
    """A curve with a dot at each point, or larger dots alone if the points are not joined."""
    places = [f"{x(a):.1f} {y(b):.1f}" for a, b in points]
    way = (f'<path d="M {" L ".join(places)}" fill="none" stroke="{colour}" stroke-width="2.5"/>'
           if joined else "")
    radius = 3 if joined else 6
    return way + "".join(f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" r="{radius}" fill="{colour}"/>'
                         for a, b in points)


def chart(title, series, x, y, names, joined=True):
    """Draws a chart. `series`: name, colour and points of each line. `names`: those of the ticks
    and axes, in the order of axes()."""
    labels = spread([y(points[-1][1]) for _, _, points in series], LABEL_GAP, TOP, HEIGHT - BOTTOM)
    parts = [text(20, 34, title, 18, weight="bold")] + axes(x, y, *names)
    for label, (name, colour, points) in zip(labels, series):
        parts.append(line(points, x, y, colour, joined))
        parts.append(text(x(points[-1][0]) + 12, label + 5, name, 14, colour=colour, weight="bold"))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            f'width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>\n'
            + "\n".join(parts) + "\n</svg>\n")


def horizontal(ticks, is_logarithmic=True):
    """The scale of the x axis, pixels."""
    return Scale(ticks, LEFT, WIDTH - RIGHT, is_logarithmic)


def vertical(ticks, is_logarithmic=True):
    """The scale of the y axis, pixels."""
    return Scale(ticks, HEIGHT - BOTTOM, TOP, is_logarithmic)
