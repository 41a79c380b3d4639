"""Judges the rows of ./run matrix by what they printed, and writes their table.

  verdict.py row ROW                        one row's outcome, into its folder, and a line of it
  verdict.py summary [--allow-missing] ROW...  the table of these rows; exits with 1 if any of them
                                            disagrees with the reference
  verdict.py report COMMIT                  the table of all rows, into docs/platforms.md

The folders are in build/matrix/rows, as tools/matrix.sh leaves them: of each row what it printed
(own.out), what came of the reference's snapshots (from-reference.out) and of snapshots of its own
kind (back.out); in `reference` what all of that is compared with.
"""

import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = "docs/platforms.md"
BEGIN, END = "<!-- matrix -->", "<!-- end of matrix -->"
OTHER_BUILD = "refused: restore: the snapshot is of another version or build of thud"
KINDS = ("scene", "exact", "swept", "level")


def read_rows(root=ROOT):
    """{name: {build, how, snapshots, what}} in the order of the file."""
    rows = {}
    for line in (root / "tests/matrix/rows.txt").read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            name, build, how, snapshots, what = (part.strip() for part in line.split("|", 4))
            rows[name] = {"build": build, "how": how, "snapshots": snapshots, "what": what}
    return rows


def read_runs(path):
    """{(kind, name): hash, or the reason why there is none}"""
    runs = {}
    for line in path.read_text(encoding="utf-8").splitlines() if path.is_file() else []:
        kind, name, outcome = line.split(" ", 2)
        runs[kind, name] = outcome
    return runs


def count(wanted, runs, kinds=KINDS):
    """[number of runs that agree, number of runs], and the names of those that do not agree."""
    keys = [key for key in wanted if key[0] in kinds]
    wrong = [key for key in keys if runs.get(key) != wanted[key]]
    return [len(keys) - len(wrong), len(keys)], [" ".join(key) for key in wrong]


def length_of(row, folder):
    return next((length for length in ("full", "short")
                 if (folder / f"{length}.snapshots").is_file()), "full")


def golden_faults(reference, root):
    """Scenes of the reference, at full length, whose hashes differ from those in tests/golden."""
    lines = (root / "tests/golden/hashes.txt").read_text(encoding="utf-8").split("\n")
    golden = {("scene", line.split()[0]): line.split()[1] for line in lines if line}
    runs = {key: value for key, value in reference.items() if key[0] == "scene"}
    return [" ".join(key) for key in sorted(golden.keys() | runs.keys())
            if golden.get(key) != runs.get(key)]


def judge_refusal(folder):
    path = folder / "refused"
    if not path.is_file():
        return {"verdict": "failed", "faults": ["the compiler could not be run"]}
    refused, total = map(int, path.read_text(encoding="utf-8").split())
    good = 0 < total == refused
    return {"verdict": "refused" if good else "failed",
            "faults": [] if good else [f"only {refused} of {total} files are refused by a message"]}


def judge_runs(row, first, folder, given, root):
    length = length_of(row, folder)
    wanted = read_runs(given / f"{length}.out")
    own = read_runs(folder / "own.out")
    outcome = {"length": length}
    faults = []
    if row["how"] in ("native", "native baseline"):
        if (folder / "levels").read_bytes() != (given / "levels").read_bytes():
            faults.append("the levels that it read differ from the reference's")
    for key, kinds in (("scenes", ("scene",)), ("settings", ("exact", "swept")),
                       ("levels", ("level",))):
        outcome[key], wrong = count(wanted, own, kinds)
        faults += wrong
    faults += [f"{' '.join(key)}, which the reference lacks" for key in own.keys() - wanted.keys()]
    continues = row["snapshots"] == first["snapshots"]
    theirs = wanted if continues else dict.fromkeys(wanted, OTHER_BUILD)
    taken, wrong = count(theirs, read_runs(folder / "from-reference.out"))
    faults += [f"the reference's snapshot of {name}" for name in wrong]
    back, wrong = count(wanted, read_runs(folder / "back.out"))
    faults += [f"a snapshot of {name} continued" for name in wrong]
    outcome["snapshots"] = {"from": taken, "kind": back, "continue": continues}
    if row is first:
        faults += [f"{name} is not as in tests/golden"
                   for name in golden_faults(read_runs(given / "full.out"), root)]
    if not wanted:
        faults.append("the reference printed nothing")
    return outcome | {"verdict": "failed" if faults else "agrees", "faults": faults}


def judge(name, rows, folders, root=ROOT):
    row, folder = rows[name], folders / name
    first = next(iter(rows.values()))

    def said(file):
        path = folder / file
        return path.read_text(encoding="utf-8").strip() if path.is_file() else ""

    outcome = {"seconds": int(said("seconds") or 0), "version": ", ".join(said("version").split("\n"))}
    if said("missing"):
        return outcome | {"verdict": "not had",
                          "faults": [" ".join(line.split()) for line in said("missing").split("\n")]}
    if said("failed"):
        tail = said("log").split("\n")[-1]
        return outcome | {"verdict": "failed",
                          "faults": [f"it could not be built or run: {tail} (build/matrix/rows/{name}/log)"]}
    if row["how"] == "refused":
        return outcome | judge_refusal(folder)
    return outcome | judge_runs(row, first, folder, folders / "reference", root)


# ---- texts ----

def fraction(pair):
    return f"{pair[0]}/{pair[1]}" if pair else "–"


def snapshots_of(outcome):
    known = outcome.get("snapshots")
    if not known:
        return "–"
    if known["continue"]:
        return fraction([known["from"][0] + known["kind"][0], known["from"][1] + known["kind"][1]])
    return f"{fraction(known['kind'])}; reference's refused"


def verdict_of(outcome):
    word = outcome["verdict"]
    if word == "not had":
        return "not had: " + "; ".join(outcome["faults"])
    if word == "refused":
        return "refused when compiling, by a message"
    return word


def cells_of(name, row, outcome):
    run = "60 steps" if outcome.get("length") == "short" else "120 steps"
    return [name, row["what"], outcome.get("version", ""), run if "length" in outcome else "–",
            fraction(outcome.get("scenes")), fraction(outcome.get("settings")),
            fraction(outcome.get("levels")), snapshots_of(outcome), verdict_of(outcome)]


HEADS = ["row", "what", "by", "run", "scenes", "exact, swept", "levels", "snapshots", "verdict"]


def table_of(rows, outcomes):
    lines = [HEADS, ["---"] * len(HEADS)]
    lines += [cells_of(name, rows[name], outcome) for name, outcome in outcomes.items()]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def summary_of(rows, outcomes):
    words = []
    for name, outcome in outcomes.items():
        cells = cells_of(name, rows[name], outcome)
        words.append([cells[0], cells[2], *cells[3:8], f"{outcome['seconds']} s", cells[8]])
    words.insert(0, [HEADS[0], HEADS[2], *HEADS[3:8], "seconds", HEADS[8]])
    widths = [max(len(line[i]) for line in words) for i in range(len(words[0]))]
    text = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip()
            for line in words]
    for name, outcome in outcomes.items():
        if outcome["verdict"] == "failed":
            faults = outcome["faults"]
            text.append(f"{name}: {len(faults)} faults")
            text += [f"  {fault}" for fault in faults[:12]]
            text += ["  and more"] if len(faults) > 12 else []
    return "\n".join(text)


def with_table(page, table, commit):
    """The page's text with the table between its marks."""
    head = f"By `./run matrix --report`, at {commit}:\n\n"
    return re.sub(f"{re.escape(BEGIN)}.*?{re.escape(END)}",
                  lambda _: f"{BEGIN}\n{head}{table}{END}", page, count=1, flags=re.DOTALL)


def load(names, folders):
    return {name: json.loads((folders / name / "outcome.json").read_text(encoding="utf-8"))
            for name in names}


def main(words):
    rows, folders = read_rows(), ROOT / "build/matrix/rows"
    if words[0] == "row":
        outcome = judge(words[1], rows, folders)
        (folders / words[1] / "outcome.json").write_text(json.dumps(outcome), encoding="utf-8")
        print(f".. {words[1]}: {verdict_of(outcome)}, {outcome['seconds']} s", flush=True)
        return 0
    if words[0] == "report":
        page = ROOT / PAGE
        text = with_table(page.read_text(encoding="utf-8"), table_of(rows, load(rows, folders)),
                          words[1])
        page.write_text(text, encoding="utf-8")
        return 0
    allowed = {"agrees", "refused"} | ({"not had"} if "--allow-missing" in words else set())
    outcomes = load([word for word in words[1:] if word != "--allow-missing"], folders)
    print(summary_of(rows, outcomes))
    return 0 if all(outcome["verdict"] in allowed for outcome in outcomes.values()) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
