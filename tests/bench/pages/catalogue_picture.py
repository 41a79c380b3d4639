"""The pictures of docs/catalogue.md, from the JSON of thud-catalogue."""

from catalogue_chart import COLOURS, chart, decades, horizontal, short, vertical
from catalogue_figures import BROADPHASES, LEVELS, WAYS, kept, per_pair

WALL_TITLES = {"static": "Who passes through a standing wall, 2 cm thick",
               "dynamic": "Who passes through a wall that gives way, 2 cm thick"}


PRICE_TITLES = {"shuttle": "Balls between two walls: error over time, at 60 to 960 steps a second",
                "hop": "Balls that hop on a floor: error over time, at 60 to 960 steps a second"}
# Millimetres: an error of 0 cannot be drawn on a logarithmic scale.
LEAST_ERROR = 1e-3


def values(series):
    """All y values of several curves."""
    return [value for _, _, points in series for _, value in points]


def over_broadphases(rows, x_of, y_of):
    """A curve for each broadphase, of the rows in which it was measured."""
    return [(name, COLOURS[i], [(x_of(r), y_of(r, name)) for r in kept(rows, name)])
            for i, name in enumerate(BROADPHASES) if kept(rows, name)]


def logarithmic(title, series, x_title, y_title):
    """A chart with both axes logarithmic."""
    xs = [x for _, _, points in series for x, _ in points]
    x_ticks, y_ticks = (decades(min(v), max(v)) for v in (xs, values(series)))
    return chart(title, series, horizontal(x_ticks), vertical(y_ticks),
                 ([short(v) for v in x_ticks], [short(v) for v in y_ticks], x_title, y_title))


def broadphases(results):
    """Draws the broadphase's time per shape over the number of shapes."""
    series = over_broadphases(results["growth"], lambda r: r["shapes"],
                              lambda r, name: r[name]["ns_per_shape"])
    return logarithmic("What a shape costs in the broadphase, as there are more of them", series,
                       "shapes in a uniform gas", "ns per shape and step")


def gathering(results):
    """Draws the broadphase's time per overlapping pair over the number of overlaps of a shape."""
    series = over_broadphases(results["gathering"], lambda r: 2 * r["overlaps"] / r["shapes"],
                              per_pair)
    return logarithmic("What an overlapping pair costs, as everything gathers in one place", series,
                       "others that a shape overlaps, on average",
                       "ns of the broadphase per overlapping pair and step")


def walls(results, wall):
    """Draws the share that passes through a wall over the speed; detections with equal results
    share a line."""
    lines = {}
    for row in results["walls"]:
        if row["wall"] == wall:
            points = tuple((s["speed"], 100 * s["passed"]) for s in row["speeds"])
            lines.setdefault(points, []).append(row["detection"])
    series = [(" and ".join(names), COLOURS[WAYS.index(names[0])], points)
              for points, names in lines.items()]
    xs, ys = [speed for speed, _ in series[0][2]], [0, 25, 50, 75, 100]
    return chart(WALL_TITLES[wall], series, horizontal(xs), vertical(ys, is_logarithmic=False),
                 ([short(v) for v in xs], [f"{v} %" for v in ys], "m/s",
                  "share that is beyond the wall afterwards"))


def by_name(title, series, names, y_title, joined):
    """A chart whose x axis has names instead of numbers."""
    ticks = decades(min(values(series)), max(values(series)))
    places = horizontal(list(range(len(names))), is_logarithmic=False)
    return chart(title, series, places, vertical(ticks),
                 (names, [short(v) for v in ticks], "", y_title), joined)


def levels(results):
    """Draws how many pairs each bounding volume leaves, with a line for each scene."""
    # A count of 0 cannot be drawn on a logarithmic scale.
    series = [(row["scene"].replace("_", " "), COLOURS[k % len(COLOURS)],
               [(i, row[name]) for i, name in enumerate(LEVELS) if row[name] > 0])
              for k, row in enumerate(results["levels"])]
    return by_name("How many pairs are left after each test", series, list(LEVELS.values()),
                   "pairs, on average over the looks", True)


def ways(results):
    """Draws the mean step over that of overlap, for each scene."""
    scenes = results["detections"]
    series = [(way, COLOURS[k], [(i, s["ways"][way]["ms_mean"] / s["ways"]["overlap"]["ms_mean"])
                                 for i, s in enumerate(scenes)]) for k, way in enumerate(WAYS)]
    return by_name("What a way of detection costs: its mean step over that of overlap", series,
                   [s["scene"].replace("_", " ") for s in scenes], "times", False)


def prices(results, scene):
    """Draws the error of each detection over the time that it takes, a point for each step rate."""
    rows = [r for r in results["prices"] if r["scene"] == scene]
    series = [(way, COLOURS[k], sorted((r["us"], max(1e3 * r["error"], LEAST_ERROR))
                                       for r in rows if r["detection"] == way))
              for k, way in enumerate(WAYS)]
    return logarithmic(PRICE_TITLES[scene], series, "µs of processor time for a simulated second",
                       "mm from the closed form")


def draw(results):
    """All pictures for which there are figures, by the end of their file names."""
    makers = [("broadphases", "growth", broadphases), ("gathering", "gathering", gathering),
              ("levels", "levels", levels), ("detections", "detections", ways),
              ("prices-shuttle", "prices", lambda r: prices(r, "shuttle")),
              ("prices-hop", "prices", lambda r: prices(r, "hop")),
              ("walls-static", "walls", lambda r: walls(r, "static")),
              ("walls-dynamic", "walls", lambda r: walls(r, "dynamic"))]
    return {name: make(results) for name, needs, make in makers if needs in results}
