"""The tables of docs/performance.md, in Markdown, from the JSON of thud-bench."""

import page_parts


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def label(scene):
    return f"{scene['scene']}, {scene['size']:,}"


def engine(scene, name):
    return next((e for e in scene["engines"] if e["engine"] == name), None)


def ratio(scene, name, field):
    """Another engine's time over thud's; None if that engine did not run."""
    rival = engine(scene, name)
    if not rival:
        return None
    own = rival.get("beside") or engine(scene, "thud")
    return rival[field] / own[field]


def number(value, digits=2):
    return "" if value is None else f"{value:,.{digits}f}"


def promise(scene):
    verdict = scene["verdict"]
    if scene["limit_ms"]:
        verdict = f"no step over {scene['limit_ms']:.0f} ms: {verdict}"
    return verdict if verdict.endswith("holds") else f"**{verdict}**" if verdict else ""


def races(results):
    rows = []
    for s in results["scenes"]:
        own, box2d, rapier = (engine(s, name) for name in ("thud", "box2d", "rapier"))
        spread = f" ({box2d['ratio_low']:.2f}–{box2d['ratio_high']:.2f})" if box2d else ""
        rows.append([label(s), f"{s['bodies']:,}", number(own["ms_median"], 3),
                     number(box2d and box2d["ms_median"], 3),
                     f"**{number(ratio(s, 'box2d', 'ms_median'))}**{spread}",
                     number(ratio(s, "box2d", "ms_p99")), number(ratio(s, "box2d", "ms_max")),
                     f"{s['target']:g}" if s["target"] else "", promise(s),
                     number(rapier and rapier["ms_median"], 3),
                     number(ratio(s, "rapier", "ms_median"))])
    return table(["scene", "bodies", "thud, ms", "Box2D, ms", "ratio of medians (spread)",
                  "of p99", "of worst steps", "at least", "verdict", "Rapier, ms",
                  "ratio of medians"], rows)


def overlaps(results):
    """A table of overlap, memory and the slowest step of each engine: thud, Box2D, Rapier."""
    def each(scene, field, scale, digits):
        found = [engine(scene, name) for name in ("thud", "box2d", "rapier")]
        return " / ".join(number(e[field] * scale, digits) for e in found if e)

    return table(["scene", "worst step, ms", "deepest overlap, mm", "mean overlap, mm",
                  "memory, MB"],
                 [[label(s), each(s, "ms_max", 1, 2), each(s, "penetration_max", 1e3, 1),
                   each(s, "penetration_mean", 1e3, 2), each(s, "bytes", 1e-6, 1)]
                  for s in results["scenes"]])


def gaps(results):
    """A table of joint gaps of scenes with joints: thud, Box2D."""
    def each(scene, field, digits):
        found = [engine(scene, name) for name in ("thud", "box2d")]
        return " / ".join(number(e[field] * 1e3, digits) for e in found if e)

    return table(["scene", "widest joint, mm", "mean joint, mm"],
                 [[label(s), each(s, "gap_max", 1), each(s, "gap_mean", 2)]
                  for s in results["scenes"] if any(e.get("gap_max") for e in s["engines"])])


def holds(value, at_most):
    return f"at most {at_most:g}: " + ("holds" if value <= at_most else "**misses**")


def alone(results):
    a = results["alone"]
    times = a["ms_among_sleepers"] / a["ms_alone"]
    return (f"The hundred alone take {a['ms_alone']:.4f} ms a step, beside 20,000 asleep "
            f"{a['ms_among_sleepers']:.4f} ms: {times:.2f} times that ({holds(times, a['at_most'])}).")


def growth(results):
    rows, spans = [], []
    for g in results["growth"]:
        for s in g["sizes"]:
            rival = "box2d_ns_per_body" in s
            rows.append([g["scene"], f"{s['bodies']:,}", number(s["ns_per_body"], 1),
                         number(s["box2d_ns_per_body"], 1) if rival else "–",
                         number(s["bytes_per_body"], 0),
                         number(s["box2d_bytes_per_body"], 0) if rival else "–"])
        both = [s for s in g["sizes"] if "box2d_ns_per_body" in s]
        own, theirs = ([s[key] for s in both] for key in ("ns_per_body", "box2d_ns_per_body"))
        spans.append(f"{g['scene']} {g['span']:.2f} ({holds(g['span'], g['at_most'])}); "
                     f"up to {both[-1]['bodies']:,} bodies {max(own) / min(own):.2f}, Box2D's "
                     f"{max(theirs) / min(theirs):.2f}")
    return (table(["scene", "bodies", "thud, ns a body", "Box2D", "thud, bytes a body", "Box2D"],
                  rows) + "\n\nDearest over cheapest body: " + "; ".join(spans) + ".")


def memory(results):
    rows = []
    for m in results["memory"]:
        for what in ("body", "contact"):
            own, its = m[f"bytes_per_{what}"], m[f"box2d_bytes_per_{what}"]
            rows.append([f"a {what} of {m['of']}", number(own, 0), number(its, 0),
                         number(own / its), holds(own / its, m["at_most"])])
    return table(["bytes of", "thud", "Box2D", "part", "verdict"], rows)


def pay(results):
    return table(["feature", "with", "ms", "without", "ms", "ratio"],
                 [[p["feature"], p["with"], number(p["ms_with"], 4), p["without"],
                   number(p["ms_without"], 4), number(p["ms_with"] / p["ms_without"])]
                  for p in results["pay"]])


def workers(results):
    rows = []
    for w in results["workers"]:
        gain = w["ms_one_worker"] / w["ms_two_workers"]
        rows.append([w["scene"], number(w["ms_one_worker"], 3), number(w["ms_two_workers"], 3),
                     number(gain), f"at least {w['at_least']:g}: "
                     + ("holds" if gain >= w["at_least"] else "**misses**")])
    return table(["scene", "one worker, ms", "two workers, ms", "gain", "verdict"], rows)


def profile(results):
    stages = list(results["profile"][0]["percent"])
    return table(["scene", "bodies", "ms, mean", *stages],
                 [[p["scene"], f"{p['bodies']:,}", number(p["ms"], 3),
                   *(f"{p['percent'][s]:.0f}" if p["percent"][s] >= 0.5 else "" for s in stages)]
                  for p in results["profile"]])


WASM_TARGET = 4  # bound on box2d3-wasm "deluxe"'s time over thud's, in Node and in Chromium


def wasm(results):
    rows = []
    for r in results["wasm"]:
        ratios = [r["box2d"][key] / r["thud"][key] for key in ("median", "p99", "max")]
        missed = [name for name, value in zip(("median", "p99", "worst"), ratios)
                  if value < WASM_TARGET]
        rows.append([r["where"].capitalize(), f"{r['scene']}, {r['size']:,}",
                     number(r["thud"]["median"], 3), number(r["box2d"]["median"], 3),
                     f"**{number(ratios[0])}**", number(ratios[1]), number(ratios[2]),
                     "**misses: " + ", ".join(missed) + "**" if missed else "holds"])
    return table(["in", "scene", "thud, ms", "box2d3-wasm, ms", "ratio of medians", "of p99",
                  "of worst steps", f"at least {WASM_TARGET}"], rows)


# For each placeholder of the notes: the part of the results that it needs, and the function that
# makes its text.
SECTIONS = {"races": ("scenes", races), "overlaps": ("scenes", overlaps),
            "gaps": ("scenes", gaps), "alone": ("alone", alone),
            "growth": ("growth", growth), "memory": ("memory", memory), "pay": ("pay", pay),
            "workers": ("workers", workers), "profile": ("profile", profile),
            "wasm": ("wasm", wasm)}


def fill(notes, results):
    """The notes with every {{...}} replaced; an unknown name is an error."""
    return page_parts.fill(notes, results, SECTIONS)
