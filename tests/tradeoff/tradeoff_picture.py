"""Draws error over cost as SVG: a chart for each case, and an overview of all. Each point has its
name beside it instead of a legend."""

import math
from xml.sax.saxutils import escape

import tradeoff_figures as figures

# Colours that colour-blind readers can distinguish, and different signs for those who cannot.
# Pictures have a white background of their own, for pages in dark mode.
COLOURS = {"thud": "#00734d", "thud soft": "#3fae86", "thud swept": "#00734d", "box2d": "#c4541c",
           "box2d stiff": "#3a5bbf", "chipmunk": "#8a4fa3"}
SIGNS = {"thud": "circle", "thud soft": "circle", "thud swept": "ring", "box2d": "square",
         "box2d stiff": "triangle", "chipmunk": "square"}
KEY_WORDS = {"thud": "thud: draft, default, high, exact", "thud soft": "soft 4, 8, 16",
             "thud swept": "swept: default, high",
             "box2d": "Box2D v3.2: 1, 2, 4, 8, 16 substeps", "box2d stiff": "8, 16 stiffer", "chipmunk": "Chipmunk: 10, 40, 160 iterations, of joints"}
INK, GREY, PALE = "#202020", "#6b6b6b", "#e4e4e4"
# Pixels.
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 900, 540, 92, 40, 92, 64
PANEL_WIDTH, PANEL_HEIGHT, PANEL_COLUMNS, KEY = 300, 236, 3, 96
LABEL, SMALL_LABEL, CHARACTER = 14, 11, 0.63


def text(x, y, words, size=14, anchor="start", colour=INK, weight="normal", halo=False):
    around = ' stroke="white" stroke-width="3" paint-order="stroke"' if halo else ""
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{colour}" font-weight="{weight}"{around}>{escape(words)}</text>')


def rule(x1, y1, x2, y2, colour=PALE, dashes=""):
    return (f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" '
            f'stroke-width="1"{dashes}/>')


def sign(kind, x, y, radius, colour):
    """The marker of a point."""
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}"/>'
    if kind == "ring":
        return (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius - 0.5}" fill="white" '
                f'stroke="{colour}" stroke-width="2"/>')
    if kind == "square":
        return (f'<rect x="{x - radius:.1f}" y="{y - radius:.1f}" width="{2 * radius}" '
                f'height="{2 * radius}" fill="{colour}"/>')
    return (f'<path d="M {x - 1.2 * radius:.1f} {y + radius:.1f} h {2.4 * radius:.1f} '
            f'L {x:.1f} {y - 1.2 * radius:.1f} Z" fill="{colour}"/>')


class Axis:
    """Maps the logarithm of values onto pixels."""

    def __init__(self, values, start, end):
        low, high = (math.log10(f(values)) for f in (min, max))
        # A margin, and at least a decade in all, so that small differences look small.
        room = max(0.06 * (high - low), 0.5 * (1 - (high - low)))
        self.low, self.high, self.start, self.end = low - room, high + room, start, end

    def __call__(self, value):
        part = (math.log10(value) - self.low) / (self.high - self.low)
        return self.start + part * (self.end - self.start)

    def ticks(self, at_most):
        """Powers of ten and, if these are too few, their double and fivefold."""
        powers = range(math.floor(self.low), math.ceil(self.high) + 1)
        inside = [[10.0 ** k * m for k in powers for m in steps
                   if self.low <= math.log10(10.0 ** k * m) <= self.high]
                  for steps in ((1, 2, 5), (1,))]
        found = next((t for t in inside if len(t) <= at_most), inside[-1])
        return found[::math.ceil(len(found) / at_most)] if found else inside[0]


def short(value):
    """A tick's label."""
    if value >= 1e4 or value < 1e-3:
        return f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e")
    return f"{value:,.0f}" if value >= 1 else f"{value:g}"


def heights(case):
    """The error of each point; lost ones are drawn above all others."""
    errors = [figures.error(case, p) for p in case["points"]]
    finite = [e for e in errors if math.isfinite(e)]
    top = 10 * max(finite, default=1)
    return {id(p): e if math.isfinite(e) else top for p, e in zip(case["points"], errors)}


def axes_of(case, left, right, top, bottom):
    """Both axes of a case and the pixel position of each point."""
    ys = heights(case)
    x = Axis([1e3 * figures.cost(p) for p in case["points"]], left, right)
    y = Axis(list(ys.values()), bottom, top)
    return x, y, {key: (x(1e3 * figures.cost(p)), y(ys[key]))
                  for p in case["points"] for key in [id(p)]}


def lines(case, places, width, radius):
    """Draws the curves, those of rivals first, so that thud's are on top."""
    parts = []
    for name in reversed(figures.CURVES):
        points = [places[id(p)] for p in figures.curve(case, name)]
        if len(points) > 1:
            way = " L ".join(f"{px:.1f} {py:.1f}" for px, py in points)
            dashes = ' stroke-dasharray="7 4"' if name == "box2d stiff" else ""
            parts.append(f'<path d="M {way}" fill="none" stroke="{COLOURS[name]}" '
                         f'stroke-width="{width}" stroke-linejoin="round"{dashes}/>')
    for p in sorted(case["points"], key=lambda p: figures.CURVES.index(p["curve"]), reverse=True):
        parts.append(sign(SIGNS[p["curve"]], *places[id(p)], radius, COLOURS[p["curve"]]))
    return parts


def along(start, end, every=6):
    """Points on the straight line between two points."""
    count = max(1, int(math.dist(start, end) / every))
    return [(start[0] + (end[0] - start[0]) * i / count, start[1] + (end[1] - start[1]) * i / count)
            for i in range(count + 1)]


def meets(a, b):
    """Whether two rectangles (left, top, right, bottom) share an area."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


# Distances of a label from its point at which a place is tried, in sizes of the text. Chosen.
DISTANCES = (0.6, 1, 1.6, 2.4, 3.4, 4.5)


class Room:
    """Finds places for labels that cover no other label, no point and no line."""

    def __init__(self, case, places, bounds, size):
        self.bounds, self.size = bounds, size
        half = 0.5 * size
        self.taken = [(px - half, py - half, px + half, py + half) for px, py in places.values()]
        for name in figures.CURVES:
            points = [places[id(p)] for p in figures.curve(case, name)]
            for start, end in zip(points, points[1:]):
                self.taken += [(px - 2, py - 2, px + 2, py + 2) for px, py in along(start, end)]

    def cost(self, box, near):
        """How bad a place is: what the box covers, and what of it is out of bounds, which counts
        more. `near` is what is taken, at least as far as the box reaches."""
        left, top, right, bottom = self.bounds
        beyond = (max(0, left - box[0]) + max(0, box[2] - right) + max(0, top - box[1])
                  + max(0, box[3] - bottom))
        covered = sum((min(box[2], b[2]) - max(box[0], b[0]))
                      * (min(box[3], b[3]) - max(box[1], b[1])) for b in near if meets(box, b))
        return 100 * beyond + covered

    def place(self, px, py, words):
        """The nearest free place around a point: x and y of the text's start."""
        width, height = CHARACTER * self.size * len(words), self.size
        # No place that is tried reaches further than this.
        reach_x = DISTANCES[-1] * self.size + width
        reach_y = DISTANCES[-1] * self.size + 2 + height
        around = (px - reach_x, py - reach_y, px + reach_x, py + reach_y)
        near = [b for b in self.taken if meets(around, b)]
        tries = []
        for far in DISTANCES:
            for dx, dy in ((1, 0), (-1, 0), (1, -1), (0, -1), (-1, -1), (0, 1), (1, 1), (-1, 1)):
                cx = px + dx * (far * self.size + width / 2)
                cy = py + dy * (far * self.size + 2)
                box = (cx - width / 2, cy - height / 2, cx + width / 2, cy + height / 2)
                tries.append((self.cost(box, near) + far * self.size, len(tries), box))
        box = min(tries)[2]
        self.taken.append(box)
        return box[0], box[3] - 0.15 * self.size


def labels(case, places, bounds):
    """The names of the points, placed where they cover least."""
    room = Room(case, places, bounds, LABEL)
    parts = []
    for p in case["points"]:
        words = figures.label(p)
        if p["error"] is None:
            words += ": lost"
        elif figures.is_none(case, p):
            words += ": none"
        lx, ly = room.place(*places[id(p)], words)
        parts.append(text(lx, ly, words, LABEL, colour=COLOURS[p["curve"]], halo=True,
                          weight="bold" if p["engine"] == "thud" else "normal"))
    return parts


def end_labels(case, places, bounds):
    """The same for a small picture, where only the ends of the curves are labelled."""
    room = Room(case, places, bounds, SMALL_LABEL)
    parts = []
    for name in figures.CURVES:
        points = [p for p in case["points"] if p["curve"] == name]
        for p in points[:1] + points[1:][-1:]:
            words = p["setting"].replace("default swept", "swept")
            lx, ly = room.place(*places[id(p)], words)
            parts.append(text(lx, ly, words, SMALL_LABEL, colour=COLOURS[name], halo=True))
    return parts


def frame(x, y, bounds, at_most, size):
    """The grid and tick labels of a chart."""
    left, top, right, bottom = bounds
    parts = []
    for tick in x.ticks(at_most):
        parts.append(rule(x(tick), top, x(tick), bottom))
        parts.append(text(x(tick), bottom + size + 5, short(tick) + " µs", size, "middle", GREY))
    for tick in y.ticks(at_most):
        parts.append(rule(left, y(tick), right, y(tick)))
        parts.append(text(left - 7, y(tick) + 4, short(tick), size, "end", GREY))
    return parts


def svg(width, height, title, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" font-family="sans-serif" role="img">\n'
            f'<title>{escape(title)}</title>\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n'
            + "\n".join(parts) + "\n</svg>\n")


def unit(case):
    return f", {case['unit']}" if case["unit"] else ""


def draw_case(case):
    bounds = (LEFT, TOP, WIDTH - RIGHT, HEIGHT - BOTTOM)
    x, y, places = axes_of(case, LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM)
    parts = [text(20, 34, f"{case['title']}: what accuracy costs", 18, weight="bold"),
             text(20, 56, case["about"], 13, colour=GREY),
             text(LEFT, TOP - 12, f"{case['error']}{unit(case)}", 13, colour=INK),
             text(WIDTH - RIGHT, HEIGHT - BOTTOM + 42, "time a step", 13, "end"),
             text(LEFT, HEIGHT - BOTTOM + 42, "better: to the left and further down", 13,
                  colour=GREY)]
    parts += frame(x, y, bounds, 9, 12)
    parts += lines(case, places, 2.5, 5)
    parts += labels(case, places, bounds)
    return svg(WIDTH, HEIGHT, f"{case['title']}: error over cost", parts)


def key(width):
    """Draws the names of the curves beside their signs."""
    parts = [text(20, 34, "What accuracy costs: error over time a step", 18, weight="bold"),
             text(width - 20, 34, "better: to the left and further down", 13, "end", GREY)]
    at, line = 20, 56
    for name, words in KEY_WORDS.items():
        if at + 16 + 0.58 * 12 * len(words) > width - 20:
            at, line = 20, line + 17
        parts.append(sign(SIGNS[name], at + 6, line, 5, COLOURS[name]))
        parts.append(text(at + 16, line + 4, words, 12, colour=COLOURS[name],
                          weight="bold" if name == "thud" else "normal"))
        at += 16 + 0.58 * 12 * len(words) + 14
    return parts


def panel(case, column, row):
    """One case's small chart in the overview."""
    left, top = column * PANEL_WIDTH + 52, KEY + row * PANEL_HEIGHT + 46
    bounds = (left, top, (column + 1) * PANEL_WIDTH - 14, KEY + (row + 1) * PANEL_HEIGHT - 26)
    x, y, places = axes_of(case, bounds[0], bounds[2], bounds[1], bounds[3])
    parts = [text(left, top - 24, case["title"], 14, weight="bold"),
             text(left, top - 9, f"{case['error']}{unit(case)}", 11, colour=GREY)]
    return parts + frame(x, y, bounds, 5, 10) + lines(case, places, 1.8, 3.5) \
        + end_labels(case, places, bounds)


def draw_overview(cases):
    rows = math.ceil(len(cases) / PANEL_COLUMNS)
    width, height = PANEL_COLUMNS * PANEL_WIDTH, KEY + rows * PANEL_HEIGHT
    parts = key(width)
    for i, case in enumerate(cases):
        parts += panel(case, i % PANEL_COLUMNS, i // PANEL_COLUMNS)
    return svg(width, height, "What accuracy costs, in all cases", parts)


def draw(results, only=None):
    """The pictures of all cases, or of the case `only`, and the overview, by their file names."""
    pictures = {f"{case['case']}.svg": draw_case(case) for case in results["cases"]
                if only in (None, case["case"])}
    return {**pictures, "overview.svg": draw_overview(results["cases"])}
