"""The tables of docs/catalogue.md, in Markdown, from the JSON of thud-catalogue."""

import page_parts
from catalogue_figures import (BROADPHASES, LEVELS, NARROWPHASE, WAYS, cheapest, dropped_at,
                               in_words, per_pair)
from performance_page import table


def ns(value):
    """A number with three digits."""
    return f"{value:,.0f}" if value >= 99.95 else f"{value:.3g}"


def count(value):
    return f"{value:,.0f}" if value == int(value) or value >= 100 else f"{value:,.1f}"


def share(value):
    return f"{100 * value:.0f} %" if value in (0, 1) else f"{100 * value:.1f} %"


def millimetres(value):
    return f"{1e3 * value:,.2f}" if value else "0"


def broadphase_cells(row):
    """For each broadphase its time and that of the step in ns per shape; the fastest is bold."""
    cells = []
    for name in BROADPHASES:
        found = row[name]
        if found["dropped"]:
            cells.append("too dear")
            continue
        price = ns(found["ns_per_shape"])
        price = f"**{price}**" if name == cheapest(row) else price
        cells.append(f"{price} ({ns(found['step_ns_per_shape'])})")
    return cells


def step_ms(rows, name, shapes):
    return ns(next(r[name]["step_ms"] for r in rows if r["shapes"] == shapes))


def growth(results):
    rows = results["growth"]
    text = table(["shapes", "pairs", *BROADPHASES],
                 [[count(r["shapes"]), count(r["grid"]["pairs"]), *broadphase_cells(r)]
                  for r in rows])
    text += "\n\n" + in_words(rows)
    for name, shapes in dropped_at(rows).items():
        text += (f" With {count(shapes)} shapes a step with {name} took "
                 f"{step_ms(rows, name, shapes)} ms, more than half a second, and it dropped out.")
    return text


def coherence(results):
    return table(["bodies that move, and their speed", *BROADPHASES],
                 [[r["case"], *broadphase_cells(r)] for r in results["coherence"]])


def sizes(results):
    return table(["largest over smallest", "pairs that overlap", *BROADPHASES],
                 [[r["case"], count(r["overlaps"]), *broadphase_cells(r)]
                  for r in results["sizes"]])


def gathering(results):
    rows = []
    for r in results["gathering"]:
        cells = [f"{ns(per_pair(r, n))} ({ns(1e6 * r[n]['first_ms'] / r['overlaps'])})"
                 for n in BROADPHASES]
        rows.append([r["case"].replace("m^2", "m²"), count(r["overlaps"]), *cells,
                     count(r["grid"]["pairs"])])
    return table(["room", "pairs that overlap", *BROADPHASES, "pairs that the grid has handed out"],
                 rows)


def detections(results):
    rows = []
    for s in results["detections"]:
        base = s["ways"]["overlap"]
        for way in WAYS:
            w = s["ways"][way]
            kept = share(w["energy_kept"]) if s["scene"] == "gas" else ""
            rows.append([f"{s['scene']}, {count(s['size'])}", way,
                         f"{w['ms_median']:.4f}", f"{w['ms_median'] / base['ms_median']:.2f}",
                         f"{w['ms_mean'] / base['ms_mean']:.2f}", f"{w['ms_max']:.3f}",
                         millimetres(w["overlap_max"]), kept, count(w["impacts"]),
                         count(w["held_bodies"]), f"{w['held_seconds']:.2f}",
                         count(w["unbisectable"])])
    return table(["scene", "detection", "median step, ms", "over overlap's", "mean over overlap's",
                  "worst step, ms", "deepest overlap, mm", "energy kept", "impacts", "held",
                  "seconds lost", "unsafe for bisection"], rows)


def walls(results):
    speeds = [f"{s['speed']:,.0f} m/s" for s in results["walls"][0]["speeds"]]
    return table(["wall", "detection", *speeds],
                 [[r["wall"], r["detection"], *(share(s["passed"]) for s in r["speeds"])]
                  for r in results["walls"]])


def throws(results):
    return table(["detection", "steps a second", "flight, mm", "hit, mean mm", "hit, worst mm",
                  "met early, mm", "met late, mm", "bend, mm", "g h²/8, mm"],
                 [[r["detection"], count(r["rate"]),
                   *(millimetres(r[k]) for k in ("flight", "mean", "worst", "early", "late", "bend",
                                                 "chord"))]
                  for r in results["throws"]])


def won(rows):
    """A sentence: which setting came closest, and the cheapest one of those that came within a
    centimetre, or within twice the least error if none did."""
    def named(row):
        return f"{row['detection']} at {count(row['rate'])} steps a second"
    closest = min(rows, key=lambda r: r["error"])
    bound = max(0.01, 2 * closest["error"])
    cheapest_one = min((r for r in rows if r["error"] <= bound), key=lambda r: r["us"])
    return (f"In *{rows[0]['scene']}* {named(closest)} is the most accurate, "
            f"{millimetres(closest['error'])} mm off; the cheapest within "
            f"{millimetres(bound)} mm is {named(cheapest_one)}.")


def prices(results):
    rows = results["prices"]
    text = table(["scene", "detection", "steps a second", "µs for a second", "error, mm"],
                 [[r["scene"], r["detection"], count(r["rate"]), ns(r["us"]),
                   millimetres(r["error"])] for r in rows])
    scenes = dict.fromkeys(r["scene"] for r in rows)
    return text + "\n\n" + " ".join(won([r for r in rows if r["scene"] == s]) for s in scenes)


def levels(results):
    return table(["scene", *LEVELS.values(), "1 overlap in"],
                 [[f"{r['scene']}, {count(r['size'])}", *(count(r[k]) for k in LEVELS),
                   count(round(r["pairs"] / r["exact"])) if r["exact"] else ""]
                  for r in results["levels"]])


def narrowphase(results):
    return table(["scene", *NARROWPHASE.values()],
                 [[f"{r['scene']}, {count(r['size'])}", *(count(r[k]) for k in NARROWPHASE)]
                  for r in results["levels"]])


def motions(results):
    rows = []
    for s in results["detections"]:
        w = s["ways"]["swept"]
        rows.append([f"{s['scene']}, {count(s['size'])}",
                     *(count(w[k] / s["steps"]) for k in (
                         "motion_pairs", "motion_circles", "motion_boxes", "motion_exact",
                         "impacts"))])
    return table(["scene", "pairs", "circles met", "boxes met", "times worked out", "impacts"],
                 rows)


def by_pair(rows, head, name):
    """A table of times with a column for each pair of shape kinds and a row for each entry."""
    pairs = max((list(r["ns"]) for r in rows), key=len)
    return table([head, *pairs],
                 [[name(r), *(ns(r["ns"][p]) if p in r["ns"] else "" for p in pairs)]
                  for r in rows])


def volumes(results):
    return by_pair(results["volumes"], "function, ns", lambda r: f"`thud_{r['call']}`")


def calls(results):
    return by_pair(results["calls"], "function, ns", lambda r: f"`thud_{r['call']}`")


def tolerances(results):
    return by_pair(results["tolerances"], "tolerance, ns",
                   lambda r: f"2<sup>-{r['bits']:.0f}</sup>")


def ground(row):
    far = f", {row['spacing'] * 100:.0f} cm apart" if row["spacing"] < 1 else ""
    return row["ground"] if row["ground"] == "flat" else \
        f"{row['ground']}, {count(row['vertices'])}{far}"


def grounds(results):
    return by_pair(results["grounds"], "ground, ns", ground)


def digging(results):
    return table(["ground, ns", "dig", "worst", "raise", "worst"],
                 [[ground(r), *(ns(r[what][k]) for what in ("dig", "raise")
                                for k in ("median", "worst"))] for r in results["digging"]])


def queries(results):
    return table(["query, ns", "finds", *BROADPHASES],
                 [[r["query"], f"{r['found']:.2f}", *(ns(r[n]) for n in BROADPHASES)]
                  for r in results["queries"]])


def mover(results):
    return "; ".join(f"{m['mover']} {ns(m['ns'])} ns" for m in results["mover"])


# For each placeholder of the notes: the part of the results that it needs, and the function that
# makes its text.
SECTIONS = {f.__name__: (needs, f) for needs, f in [
    ("growth", growth), ("coherence", coherence), ("sizes", sizes), ("gathering", gathering),
    ("detections", detections), ("walls", walls), ("throws", throws), ("prices", prices),
    ("levels", levels), ("levels", narrowphase),
    ("detections", motions), ("volumes", volumes), ("calls", calls), ("tolerances", tolerances), ("grounds", grounds),
    ("digging", digging), ("queries", queries), ("mover", mover)]}


def fill(notes, results):
    """The notes with every {{...}} replaced; an unknown name is an error."""
    thoroughness = "a quick run, which compares little" if results["quick"] else "a full run"
    return page_parts.fill(notes, results, SECTIONS, {"thoroughness": thoroughness})
