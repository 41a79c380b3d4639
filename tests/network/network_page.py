"""docs/network.md, from the JSON of thud-network."""

import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "pages"))

import measured  # noqa: E402
import page_figures  # noqa: E402
import prose  # noqa: E402

MEASURES = [("place", "place_jump", 3), ("angle", "angle_jump", 2)]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def lines_of(results):
    """The runs of each network, in their order."""
    lines = {}
    for run in results["runs"]:
        lines.setdefault(run["line"], []).append(run)
    return lines


def percent(share):
    return f"{100 * share:.1f} %"


def networks(results):
    rows = []
    for name, runs in lines_of(results).items():
        run = runs[0]
        late = f"{percent(run['held'])} by {run['held_for']:g} ms" if run["held"] else "none"
        rows.append([name, f"{run['jitter']:g} ms", percent(run["loss"]),
                     percent(run["duplicates"]), late, percent(run["lost"]),
                     percent(run["overtaken"])])
    return table(["network", "jitter, up to", "lost", "delivered twice", "held up",
                  "lost in the run", "overtaken in the run"], rows)


def work(results):
    rows = []
    for run in results["runs"]:
        rows.append([run["line"], f"{run['delay']:g} ms", f"{run['players']}",
                     f"{run['replayed']:.1f}", f"{run['replayed_max']:.0f}", percent(run["waits"]),
                     f"{1e3 * run['ms_step']:.1f}", f"{run['ms_median']:.4f}", f"{run['ms_p99']:.4f}",
                     f"{run['bytes']:,.0f}", f"{run['bytes_in_all']:,.0f}",
                     f"{run['bytes_states']:,.0f}"])
    return table(["network", "delay", "players", "steps run again a second", "most in a frame",
                  "frames waited", "a step, µs", "a frame, ms: median", "99th percentile",
                  "inputs, bytes a second", "with heads", "states instead, bytes a second"], rows)


def errors(runs):
    rows = []
    for run in runs:
        for way in run["ways"]:
            cells = [f"{run['delay']:g} ms", f"{run['players']}", way["way"]]
            for off, jump, places in MEASURES:
                cells += [f"{way[off][key]:.{places}f}" for key in ("mean", "p99", "max")]
                cells += [f"{way[jump]['p99']:.{places}f}", f"{way[jump]['max']:.{places}f}"]
            rows.append(cells)
    spread = ["mean", "99th percentile", "largest", "correction, 99th percentile",
              "largest correction"]
    return table(["delay", "players", "shown by", f"lengths off: {spread[0]}", *spread[1:],
                  f"degrees off: {spread[0]}", *spread[1:]], rows)


def sections(results):
    return "\n\n".join(f"### On the {name} network\n\n{errors(runs)}"
                       for name, runs in lines_of(results).items())


def fill(notes, results):
    """The notes with every {{name}} replaced; an unknown name is an error."""
    made = {"networks": networks, "work": work, "errors": sections,
            "thoroughness": lambda r: "a quick run, which compares little" if r["quick"]
            else "a full run",
            "measured": lambda r: measured.line(r["about"])}

    def text_of(match):
        name = match.group(1)
        return made[name](results) if name in made else str(results["about"][name])

    text = re.sub(r"\{\{(\w+)\}\}", text_of, prose.strip_given(notes))
    return page_figures.fill(text, results, whole=not results["quick"])
