"""What is computed of the figures of thud-tradeoff: curves, and who is cheaper and more accurate."""

import math

# The curves of a picture; "box2d stiff" begins with the points of "box2d" up to SHARED_SUBSTEPS,
# see settings.c.
CURVES = ["thud", "thud soft", "thud swept", "box2d", "box2d stiff", "chipmunk"]
SHARED_SUBSTEPS = 4


def cost(point):
    """Milliseconds a step, over all of the run: a median would leave its hard moments out."""
    return point["ms_mean"]


def error(case, point):
    """What is too small to tell from none counts as the least that can be told; lost: infinite."""
    return math.inf if point["error"] is None else max(point["error"], case["floor"])


def is_none(case, point):
    return error(case, point) <= case["floor"]


def curve(case, name):
    """The points of one curve, from cheap to dear settings."""
    points = [p for p in case["points"] if p["curve"] == name]
    if name == "box2d stiff" and points:
        points = [p for p in case["points"]
                  if p["curve"] == "box2d" and p["substeps"] <= SHARED_SUBSTEPS] + points
    return points


def rivals(case):
    return [p for p in case["points"] if p["engine"] == "box2d"]


def chipmunks(case):
    """Points of Chipmunk, which joints alone have; what is said of rivals is not said of them."""
    return [p for p in case["points"] if p["engine"] == "chipmunk"]


def own(case):
    return [p for p in case["points"] if p["engine"] == "thud"]


def label(point):
    engine = {"thud": "", "box2d": "Box2D ", "chipmunk": "Chipmunk "}[point["engine"]]
    return engine + point["setting"]


def cheapest_as_accurate(case, rival):
    """thud's cheapest point that errs no more than the rival's; None if each errs more."""
    able = [p for p in own(case) if error(case, p) <= error(case, rival)]
    return min(able, key=cost, default=None)


def most_accurate_as_cheap(case, rival):
    """thud's most accurate point that costs no more than the rival's; None if each costs more."""
    able = [p for p in own(case) if cost(p) <= cost(rival)]
    return min(able, key=lambda p: error(case, p), default=None)


def is_beaten(case, rival):
    """Some quality of thud both costs and errs no more."""
    match = cheapest_as_accurate(case, rival)
    return match is not None and cost(match) <= cost(rival)


def times_cheaper(case, rival):
    match = cheapest_as_accurate(case, rival)
    return cost(rival) / cost(match) if match else None


def times_more_accurate(case, rival):
    match = most_accurate_as_cheap(case, rival)
    return error(case, rival) / error(case, match) if match else None


def unbeaten(case):
    return [r for r in rivals(case) if not is_beaten(case, r)]


def ties(case):
    """Points of Box2D that thud beats in cost alone: nothing as cheap errs less."""
    return [r for r in rivals(case) if is_beaten(case, r) and times_more_accurate(case, r) == 1]


def holds(case):
    """thud's curve is left of and below Box2D's: cheaper at equal error, and more accurate at equal
    cost, for each of its points. Where neither can be told from no error, cheaper is enough."""
    return bool(rivals(case)) and not unbeaten(case) and all(is_none(case, r) for r in ties(case))


def not_monotone(case):
    """Pairs of thud's qualities of which the finer errs more, beyond what chance explains."""
    points = curve(case, "thud")
    return [(a, b) for i, a in enumerate(points) for b in points[i + 1:]
            if error(case, b) > max(case["floor"], case["chance"] * error(case, a))]
