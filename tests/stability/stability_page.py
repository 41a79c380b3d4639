"""Makes docs/stability.md, in Markdown, from the JSON of thud-envelope."""

import re

import page_figures
import measured
import prose

THUD = ["draft", "default", "high", "exact"]
USUAL = THUD + ["Box2D"]
ENTRANTS = USUAL + ["Box2D stiff", "Chipmunk", "Chipmunk 160"]
HEADING = re.compile(r"^## (.+)\n", re.MULTILINE)


def number(value):
    """The number with four digits; null means that the structure fell or a body was lost."""
    return "fails" if value is None else value if isinstance(value, str) else f"{value:.4g}"


def holds(figure, entrant, binds=None):
    """Whether the entrant keeps the bound, or is not bound. `binds`: entrants to apply it to
    instead."""
    bound = figure.get("bound")
    if not bound or entrant not in (binds or bound["on"]) or entrant not in figure["reached"]:
        return True
    reached = figure["reached"][entrant]
    if not isinstance(reached, (int, float)):
        return False
    return reached <= bound["value"] if bound["kind"] == "at most" else reached >= bound["value"]


def bound_text(figure):
    bound = figure.get("bound")
    if not bound:
        return "–"
    sign = "≤" if bound["kind"] == "at most" else "≥"
    who = "all" if set(THUD) <= set(bound["on"]) else ", ".join(bound["on"])
    return f"{sign} {number(bound['value'])} at {who}"


def verdict(figure):
    if "bound" not in figure:
        return "–"
    missed = [f"{e} reached {number(figure['reached'][e])}" for e in ENTRANTS if not holds(figure, e)]
    return "**no**: " + ", ".join(missed) if missed else "yes"


def entrants_of(extreme):
    """The columns of the table: USUAL, and further entrants that were measured."""
    return [e for e in ENTRANTS
            if e in USUAL or any(e in figure["reached"] for figure in extreme["figures"])]


def table(extreme):
    entrants = entrants_of(extreme)
    lines = ["| extreme | bound | " + " | ".join(entrants) + " | holds? |",
             "|---" * (len(entrants) + 3) + "|"]
    for figure in extreme["figures"]:
        reached = [number(figure["reached"][e]) if e in figure["reached"] else "–" for e in entrants]
        lines.append(" | ".join(["| " + figure["what"], bound_text(figure), *reached,
                                 verdict(figure) + " |"]))
    return "\n".join(lines)


def kept(extreme):
    """"n of m" bounds that thud keeps, and the same for those at which Box2D was measured."""
    bounds = [f for f in extreme["figures"] if "bound" in f]
    own = sum(all(holds(f, e) for e in ENTRANTS) for f in bounds)
    rival = [f for f in bounds if "Box2D" in f["reached"]]
    its = sum(holds(f, "Box2D", ["Box2D"]) for f in rival)
    return f"{own} of {len(bounds)}", f"{its} of {len(rival)}" if rival else "–"


def summary(results):
    lines = ["| extreme | bounds that thud keeps | that Box2D would keep |", "|---|---|---|"]
    for extreme in results["extremes"]:
        lines.append(f"| [{extreme['title']}](#{extreme['name']}) | "
                     + " | ".join(kept(extreme)) + " |")
    return "\n".join(lines)


def notes_of(notes):
    """The notes' introduction, and the text below each heading by its name."""
    opening, *rest = HEADING.split(notes)
    return opening, {name: text.strip("\n") for name, text in zip(rest[::2], rest[1::2])}


def stray_headings(notes, names):
    return [name for name in notes_of(notes)[1] if name not in names]


def fill(notes, results):
    """The page. The text below an extreme's name in the notes goes below its table."""
    opening, below = notes_of(prose.strip_given(notes))
    opening = opening.replace("{{measured}}", measured.line(results["about"]))
    parts = [opening.rstrip("\n") + "\n\n" + summary(results) + "\n"]
    for extreme in results["extremes"]:
        name = extreme["name"]
        parts.append(f'<a id="{name}"></a>\n\n## {extreme["title"]}\n\n{extreme["about"]}\n\n'
                     + table(extreme) + "\n" + (f"\n{below[name]}\n" if below.get(name) else ""))
    return page_figures.fill("\n".join(parts), results, whole=not results["quick"])
