"""Draws the figures of thud-network over the delay, as SVG."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "pages"))

import catalogue_chart as charts  # noqa: E402

# The network of which errors are drawn.
DRAWN = "ordinary"
TICKS = 6  # on the y axis, at most


def ticks_to(highest):
    """Round values from 0 to one that is at least `highest`."""
    if highest <= 0:
        return [0, 1]
    rough = highest / (TICKS - 1)
    unit = 10.0 ** math.floor(math.log10(rough))
    step = next(f * unit for f in (1, 2, 2.5, 5, 10) if f * unit >= rough * (1 - 1e-9))
    return [step * k for k in range(math.ceil(highest / step - 1e-9) + 1)]


def whole(results):
    """The runs with as many players as most have, by network, and by delay within it."""
    players = max(run["players"] for run in results["runs"])
    lines = {}
    for run in results["runs"]:
        if run["players"] == players:
            lines.setdefault(run["line"], []).append(run)
    return {name: sorted(runs, key=lambda run: run["delay"]) for name, runs in lines.items()}


def over_delay(title, unit, series):
    """A chart of series [(name, [(delay, value)])]."""
    delays = sorted({delay for _, points in series for delay, _ in points})
    x = charts.horizontal(delays if len(delays) > 1 else [0, *delays, 1], False)
    ticks = ticks_to(max(value for _, points in series for _, value in points))
    y = charts.vertical(ticks, False)
    names = ([f"{d:g} ms" for d in x.ticks], [f"{t:g}" for t in ticks],
             "delay, one way", unit)
    coloured = [(name, charts.COLOURS[i % len(charts.COLOURS)], points)
                for i, (name, points) in enumerate(series)]
    return charts.chart(title, coloured, x, y, names)


def by_way(runs, measure, key):
    ways = [way["way"] for way in runs[0]["ways"]]
    return [(name, [(run["delay"], run["ways"][i][measure][key]) for run in runs])
            for i, name in enumerate(ways)]


def draw(results):
    """The pictures by their names."""
    lines = whole(results)
    drawn = lines.get(DRAWN) or next(iter(lines.values()))
    network = drawn[0]["line"]
    by_line = [[(name, [(run["delay"], run[key]) for run in runs]) for name, runs in lines.items()]
               for key in ("replayed", "ms_p99")]
    return {
        "error": over_delay(f"Mean distance from the truth ({network} network)", "lengths",
                            by_way(drawn, "place", "mean")),
        "error-angle": over_delay(f"Mean angle from the truth ({network} network)", "degrees",
                                  by_way(drawn, "angle", "mean")),
        "correction": over_delay(f"Largest correction from frame to frame ({network} network)",
                                 "lengths", by_way(drawn, "place_jump", "max")),
        "correction-angle": over_delay(
            f"Largest correction of an angle from frame to frame ({network} network)", "degrees",
            by_way(drawn, "angle_jump", "max")),
        "replayed": over_delay("Steps run again, a second and player", "steps a second", by_line[0]),
        "frames": over_delay("A frame's time, 99th percentile", "ms", by_line[1]),
    }
