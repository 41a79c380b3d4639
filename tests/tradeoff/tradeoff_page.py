"""docs/tradeoff.md and tradeoff.csv, from the JSON of thud-tradeoff."""

import csv
import io
import math
import os
import re
import sys

import tradeoff_figures as figures

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "pages"))

import measured  # noqa: E402
import page_figures  # noqa: E402
import prose  # noqa: E402

COLUMNS = ["case", "engine", "curve", "setting", "substeps", "contact_hertz", "error",
           "ms_median", "ms_mean", "ms_total", "penetration_worst", "penetration_mean",
           "energy_gained", "lost"]
UNMEASURED = "Box2D was not part of this run."


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def digits(value, count=3):
    """The number with `count` digits; with an exponent only if it is very small or large."""
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return "lost"
    if not 1e-4 <= abs(value) < 1e6:
        return f"{value:.{count - 1}e}".replace("e-0", "e-").replace("e+0", "e")
    places = max(0, count - 1 - math.floor(math.log10(abs(value))))
    return f"{value:,.{places}f}"


def amount(case, point):
    """An error with its unit."""
    if figures.is_none(case, point):
        return "none"
    text = digits(figures.error(case, point), 2)
    return f"{text} {case['unit']}".strip() if text != "lost" else text


def times(value):
    """A factor with two digits; infinite if the point of Box2D lost bodies."""
    if not math.isfinite(value):
        return "∞"
    if value < 10:
        return f"{value:.1f}"
    return f"{round(value, 1 - math.floor(math.log10(value))):,.0f}"


def span(values):
    """A range of factors in words, or one factor."""
    low, high = times(min(values)), times(max(values))
    return low if low == high else f"{low} to {high}"


def named(case, rivals):
    return ", ".join(f"{figures.label(r)} ({amount(case, r)})" for r in rivals)


def exceptions(case):
    """A text that names the points of Box2D which are not beaten, and why; empty if all are."""
    missed = figures.unbeaten(case)
    out_of_reach = [r for r in missed if figures.cheapest_as_accurate(case, r) is None]
    dearer = [r for r in missed if figures.cheapest_as_accurate(case, r)]
    parts = []
    if out_of_reach:
        least = min(figures.own(case), key=lambda p: figures.error(case, p))
        parts.append(f"nothing of thud errs as little as {named(case, out_of_reach)}; "
                     f"{least['setting']} has {amount(case, least)}")
    if dearer:
        factors = [1 / figures.times_cheaper(case, r) for r in dearer]
        low, high = f"{min(factors):.2f}", f"{max(factors):.2f}"
        parts.append(f"to err as little as {named(case, dearer)} thud takes "
                     f"{low if low == high else low + ' to ' + high} times as long")
    return "; ".join(parts)


def verdict(case):
    """One sentence: whether thud's curve is left of and below Box2D's, or where it is not."""
    rivals = figures.rivals(case)
    if not rivals:
        return UNMEASURED
    beaten = [r for r in rivals if figures.is_beaten(case, r)]
    cheaper = [figures.times_cheaper(case, r) for r in beaten]
    missed = exceptions(case)
    if missed:
        text = f"**Not left of and below everywhere**: {missed}."
        if beaten:
            text += f" At the errors of the other {len(beaten)} points of Box2D thud is " \
                    f"{span(cheaper)} times as fast."
        return text
    better = [figures.times_more_accurate(case, r) for r in rivals]
    if figures.holds(case):
        return f"**Left of and below everywhere**: at the error of each of Box2D's {len(rivals)} " \
               f"points thud is {span(cheaper)} times as fast, and at the cost of each it errs " \
               f"{span(better)} times less."
    even = ", ".join(figures.label(r) for r in figures.ties(case))
    return f"**Left everywhere, but not below**: at the error of each of Box2D's {len(rivals)} " \
           f"points thud is {span(cheaper)} times as fast, but errs as much as {even} at " \
           "the same cost."


def beside_chipmunk(case):
    """One sentence: whether thud's curve is left of and below Chipmunk's, if Chipmunk ran."""
    points = figures.chipmunks(case)
    unbeaten = [p for p in points if not figures.is_beaten(case, p)]
    if not points:
        return ""
    if unbeaten:
        return f" **Of Chipmunk's points thud does not beat** {named(case, unbeaten)}."
    cheaper = [figures.times_cheaper(case, p) for p in points]
    return f" At the errors of Chipmunk's {len(points)} points thud is {span(cheaper)} times as fast."


def monotony(case):
    """The page's sentence about pairs of qualities of which the higher one has the larger error."""
    worse = figures.not_monotone(case)
    if not worse:
        return "More quality buys accuracy throughout."
    pairs = "; ".join(f"{b['setting']} ({amount(case, b)}) errs more than {a['setting']} "
                      f"({amount(case, a)})" for a, b in worse)
    return f"**More quality does not always buy accuracy here**: {pairs}."


def row(case, point):
    cells = [figures.label(point), amount(case, point), digits(1e3 * point["ms_mean"]),
             digits(1e3 * point["ms_median"]), digits(point["ms_total"]),
             digits(1e3 * point["penetration_worst"]), digits(1e3 * point["penetration_mean"]),
             digits(100 * point["energy_gained"], 2), str(point["lost"])]
    return [f"**{cell}**" for cell in cells[:1]] + cells[1:] if point["engine"] == "thud" else cells


def section(case, folder):
    head = ["", case["error"], "µs a step", "median step, µs", "all steps, ms",
            "deepest overlap, mm", "mean overlap, mm", "energy gained, %", "bodies lost"]
    return "\n\n".join([
        f"## {case['title']}",
        f"{case['about']} {case['bodies']:,} bodies, {case['steps']:,} steps. "
        f"Error: {case['error']}; up to {case['floor']:g} {case['unit']}".rstrip()
        + " it counts as none.",
        f"![{case['title']}: error over cost]({folder}/{case['case']}.svg)",
        f"{verdict(case)}{beside_chipmunk(case)} {monotony(case)}",
        table(head, [row(case, p) for p in case["points"]])])


def sections(results, folder):
    return "\n\n".join(section(case, folder) for case in results["cases"])


def range_of(values, missing):
    """The range of the values that are not None, and how the page names the others."""
    found = [v for v in values if v is not None]
    return span(found) + (f" ({missing})" if len(found) < len(values) else "") if found else missing


def summary(results):
    """A row for each case: the verdict in a word, and the figures behind it."""
    rows = []
    for case in results["cases"]:
        rivals = figures.rivals(case)
        word = "yes" if figures.holds(case) else "**no**" if figures.unbeaten(case) else "left only"
        least = min(figures.own(case), key=lambda p: figures.error(case, p))
        least_rival = min(rivals, key=lambda p: figures.error(case, p), default=None)
        rows.append([
            f"[{case['title']}](#{anchor(case['title'])})", case["error"],
            word if rivals else "",
            range_of([figures.times_cheaper(case, r) for r in rivals],
                     "not at all of them") if rivals else "",
            range_of([figures.times_more_accurate(case, r) for r in rivals],
                     "not at all of them") if rivals else "",
            f"{amount(case, least)} ({least['setting']})",
            f"{amount(case, least_rival)} ({figures.label(least_rival)})" if rivals else "",
            "yes" if not figures.not_monotone(case) else "**no**"])
    return table(["", "error", "left of and below Box2D", "times as fast at its errors",
                  "times as accurate at its costs", "least error of thud", "of Box2D",
                  "monotone"], rows)


def anchor(title):
    """The anchor that GitHub makes for a heading."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def thoroughness(results):
    text = "a quick run of small scenes, which compares little" if results["quick"] else "a full run"
    if results["missing"]:
        text += "; unfinished: without " + ", ".join(results["missing"])
    return text


def fill(notes, results, folder):
    """The notes with every {{name}} replaced; an unknown name is an error."""
    made = {"thoroughness": thoroughness, "summary": summary,
            "sections": lambda r: sections(r, folder), "folder": lambda _: folder,
            "measured": lambda r: measured.line(r["about"])}

    def text_of(match):
        name = match.group(1)
        return made[name](results) if name in made else str(results["about"][name])

    text = re.sub(r"\{\{(\w+)\}\}", text_of, prose.strip_given(notes))
    return page_figures.fill(text, results, whole=not (results["quick"] or results["missing"]))


def comma_separated(results):
    out = io.StringIO()
    writer = csv.DictWriter(out, COLUMNS + ["error_unit"], extrasaction="ignore",
                            lineterminator="\n")
    writer.writeheader()
    for case in results["cases"]:
        for point in case["points"]:
            shown = {**point, "case": case["case"], "error_unit": case["unit"],
                     "error": "inf" if point["error"] is None else point["error"]}
            writer.writerow(shown)
    return out.getvalue()
