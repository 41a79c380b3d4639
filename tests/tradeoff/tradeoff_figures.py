"""Values computed from the figures of thud-tradeoff: curves, and which engine is faster and more
accurate."""

import math

# The curves of a picture; "box2d stiff" begins with the points of "box2d" up to SHARED_SUBSTEPS,
# see settings.c.
CURVES = ["thud", "thud soft", "thud swept", "box2d", "box2d stiff", "chipmunk"]
SHARED_SUBSTEPS = 4


def cost(point):
    """Milliseconds per step, the mean of the run; a median would ignore the slow steps."""
    return point["ms_mean"]


def error(case, point):
    """The error, at least the case's floor; infinite if a body was lost."""
    return math.inf if point["error"] is None else max(point["error"], case["floor"])


def is_none(case, point):
    """Whether a point's error is within the case's floor, which counts as no error."""
    return error(case, point) <= case["floor"]


def curve(case, name):
    """The points of a curve, from the cheapest setting to the most expensive."""
    points = [p for p in case["points"] if p["curve"] == name]
    if name == "box2d stiff" and points:
        points = [p for p in case["points"]
                  if p["curve"] == "box2d" and p["substeps"] <= SHARED_SUBSTEPS] + points
    return points


def rivals(case):
    """The points of Box2D."""
    return [p for p in case["points"] if p["engine"] == "box2d"]


def chipmunks(case):
    """The points of Chipmunk, which runs scenes with joints only; they do not count as rivals."""
    return [p for p in case["points"] if p["engine"] == "chipmunk"]


def own(case):
    """The points of thud."""
    return [p for p in case["points"] if p["engine"] == "thud"]


def label(point):
    engine = {"thud": "", "box2d": "Box2D ", "chipmunk": "Chipmunk "}[point["engine"]]
    return engine + point["setting"]


def cheapest_as_accurate(case, rival):
    """thud's cheapest point whose error is at most the rival's; None if there is none."""
    able = [p for p in own(case) if error(case, p) <= error(case, rival)]
    return min(able, key=cost, default=None)


def most_accurate_as_cheap(case, rival):
    """thud's most accurate point whose cost is at most the rival's; None if there is none."""
    able = [p for p in own(case) if cost(p) <= cost(rival)]
    return min(able, key=lambda p: error(case, p), default=None)


def is_beaten(case, rival):
    """Whether a quality of thud has at most the rival's cost and at most its error."""
    match = cheapest_as_accurate(case, rival)
    return match is not None and cost(match) <= cost(rival)


def times_cheaper(case, rival):
    """How many times cheaper thud is at the rival's accuracy; None if no point matches."""
    match = cheapest_as_accurate(case, rival)
    return cost(rival) / cost(match) if match else None


def times_more_accurate(case, rival):
    """How many times smaller thud's error is at the rival's cost; None if no point matches."""
    match = most_accurate_as_cheap(case, rival)
    return error(case, rival) / error(case, match) if match else None


def unbeaten(case):
    """Box2D's points that no point of thud beats."""
    return [r for r in rivals(case) if not is_beaten(case, r)]


def ties(case):
    """Box2D's points that thud beats in cost only, with equal error."""
    return [r for r in rivals(case) if is_beaten(case, r) and times_more_accurate(case, r) == 1]


def holds(case):
    """Whether thud's curve is left of and below Box2D's: for each of its points thud is cheaper at
    equal error and more accurate at equal cost. If both have no error, cheaper is enough."""
    return bool(rivals(case)) and not unbeaten(case) and all(is_none(case, r) for r in ties(case))


def not_monotone(case):
    """Pairs of thud's qualities of which the finer has a larger error, beyond the case's `chance`."""
    points = curve(case, "thud")
    return [(a, b) for i, a in enumerate(points) for b in points[i + 1:]
            if error(case, b) > max(case["floor"], case["chance"] * error(case, a))]
