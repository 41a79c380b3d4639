"""Names of the figures of thud-catalogue, and values computed from them."""

import math

BROADPHASES = ["grid", "plane sweep", "all pairs"]
WAYS = ["overlap", "continuous", "bisect", "swept"]
# The tests that a pair has passed, from first to last, and their names in tables and pictures.
LEVELS = {"pairs": "all", "circles": "circles", "boxes": "AABBs", "oriented": "OBBs",
          "exact": "overlap"}
# The same for the tests of the narrowphase.
NARROWPHASE = {"pairs": "all", "bounds": "fat bounds", "sieved": "sieve", "near": "exact test",
               "contacts": "contacts that the world has"}


def kept(rows, name):
    """The rows in which a broadphase was not left out as too slow."""
    return [row for row in rows if not row[name]["dropped"]]


def crossing(x0, x1, a0, a1, b0, b1):
    """The x in [x0, x1] at which two lines, straight on logarithmic scales, cross. Line a has the
    values a0, a1 at the ends, and line b the values b0, b1, in the opposite order."""
    gap0, gap1 = math.log(a0 / b0), math.log(a1 / b1)
    part = gap0 / (gap0 - gap1)
    return math.exp(math.log(x0) + part * (math.log(x1) - math.log(x0)))


def cheapest(row, field="ns_per_shape"):
    """The broadphase with the least value in a row, of those that were measured."""
    here = [name for name in BROADPHASES if not row[name]["dropped"]]
    return min(here, key=lambda name: row[name][field])


def reigns(rows):
    """The fastest broadphase over the number of shapes: [name, from, to], in order. Where it
    changes between two rows, the boundary is the crossing of the two lines."""
    found = [[cheapest(rows[0]), rows[0]["shapes"], rows[0]["shapes"]]]
    for before, row in zip(rows, rows[1:]):
        last, name = found[-1][0], cheapest(row)
        at = row["shapes"]
        if name != last:
            at = before["shapes"] if row[last]["dropped"] else crossing(
                before["shapes"], row["shapes"], before[last]["ns_per_shape"],
                row[last]["ns_per_shape"], before[name]["ns_per_shape"], row[name]["ns_per_shape"])
            found[-1][2] = at
            found.append([name, at, row["shapes"]])
        found[-1][2] = row["shapes"]
    return found


def rounded(value):
    """Rounds to two digits, the accuracy of a crossing of noisy lines."""
    digits = 1 - math.floor(math.log10(value))
    return f"{round(value, digits):,.0f}"


def in_words(rows):
    """Sentences that say at which numbers of shapes each broadphase is the cheapest."""
    found = reigns(rows)
    parts = []
    for i, (name, start, end) in enumerate(found):
        if i == 0:
            where = f"up to about {rounded(end)} shapes" if len(found) > 1 else "at every size"
        elif i == len(found) - 1:
            where = f"from about {rounded(start)} on"
        else:
            where = f"from about {rounded(start)} to {rounded(end)}"
        parts.append(f"{name} {where}")
    never = [name for name in BROADPHASES if name not in [f[0] for f in found]]
    text = "Cheapest is " + ", ".join(parts) + "."
    if never:
        text += " Never cheapest here: " + ", ".join(never) + "."
    return text


def dropped_at(rows):
    """The number of shapes at which each broadphase was left out as too slow."""
    return {name: row["shapes"] for row in reversed(rows) for name in BROADPHASES
            if row[name]["dropped"]}


def per_pair(row, name):
    """Nanoseconds of the broadphase for each pair that overlaps."""
    return row[name]["ns_per_shape"] * row["shapes"] / row["overlaps"]
