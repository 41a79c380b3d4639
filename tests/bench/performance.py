#!/usr/bin/env python3
"""Measures everything with thud-bench and writes docs/performance.md and its picture.

usage: performance.py THUD_BENCH [--quick] [--keep FOLDER] [--repeat N]

The hand-written sections come from performance-notes.md beside this file. JSON of every part stays in
FOLDER (build/performance), where a part that is already there is not measured again: remove the
folder to start anew.
"""

import argparse
import datetime
import json
import os
import platform
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PARTS = {"race": [], "growth": ["--growth"], "pay": ["--pay"], "profile": ["--profile"]}


def measure(arguments):
    os.makedirs(arguments.keep, exist_ok=True)
    results = {}
    for part, options in PARTS.items():
        path = os.path.join(arguments.keep, part + ".json")
        if not os.path.exists(path):
            print(f"\n== {part}", flush=True)
            command = [arguments.bench, *options, "--json", path + ".new"]
            if part == "race":
                command += ["--repeat", str(arguments.repeat)]
            if arguments.quick:
                command.append("--quick")
            subprocess.run(command, check=True)
            os.replace(path + ".new", path)
        with open(path, encoding="utf-8") as file:
            results[part] = json.load(file)
    return results


def races(results):
    """One entry a scene: its name, thud's figures and those of each rival."""
    found = {}
    for entry in results["race"]:
        race = found.setdefault((entry["scene"], entry["size"]), {"rivals": []})
        if entry["engine"] == "thud":
            race["thud"] = entry
        else:
            race["rivals"].append(entry)
    return list(found.values())


def label(entry):
    return f"{entry['scene']} {entry['size']:,}"


def verdict(target, *ratios):
    if not target:
        return ""
    return "yes" if min(ratios) >= target else "**no**"


def race_table(results):
    lines = ["| scene | bodies | against | its ms | thud ms | ratio (spread) | p99 | worst step | "
             "at least | median holds | p99 and worst hold | deepest overlap, its / thud, mm | mean | "
             "memory, MB |", "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for race in races(results):
        own = race["thud"]
        for rival in race["rivals"]:
            ratio = rival["ms_median"] / own["ms_median"]
            p99 = rival["ms_p99"] / own["ms_p99"]
            worst = rival["ms_max"] / own["ms_max"]
            target = own["target"] if rival["engine"] == "box2d" else 0
            lines.append(
                f"| {label(own)} | {own['bodies']:,} | {rival['engine']} | {rival['ms_median']:.3f} | "
                f"{own['ms_median']:.3f} | **{ratio:.2f}** ({rival['ratio_low']:.2f}–"
                f"{rival['ratio_high']:.2f}) | {p99:.2f} | {worst:.2f} "
                f"({own['ms_max']:.2f} ms) | {target or ''} | {verdict(target, ratio)} | "
                f"{verdict(target, p99, worst)} | "
                f"{rival['penetration_max'] * 1e3:.0f} / {own['penetration_max'] * 1e3:.0f} | "
                f"{rival['penetration_mean'] * 1e3:.2f} / {own['penetration_mean'] * 1e3:.2f} | "
                f"{rival['bytes'] * 1e-6:.1f} / {own['bytes'] * 1e-6:.1f} |")
    return "\n".join(lines)


def growth_table(results):
    lines = ["| scene | bodies | thud, ns a body | Box2D | thud, bytes a body | Box2D | pairs a body |",
             "|---|---|---|---|---|---|---|"]
    for r in results["growth"]:
        lines.append(f"| {r['scene']} | {r['bodies']:,} | {r['ns_per_body']:.1f} | "
                     f"{r['box2d_ns_per_body']:.1f} | {r['bytes_per_body']:.0f} | "
                     f"{r['box2d_bytes_per_body']:.0f} | {r['pairs_per_body']:.2f} |")
    factors = []
    for scene in dict.fromkeys(r["scene"] for r in results["growth"]):
        for key, name in (("ns_per_body", "thud"), ("box2d_ns_per_body", "Box2D")):
            times = [r[key] for r in results["growth"] if r["scene"] == scene]
            factors.append(f"{scene}, {name}: {max(times) / min(times):.2f}")
    return "\n".join(lines) + "\n\nDearest over cheapest body: " + "; ".join(factors) + "."


def pay_table(results):
    lines = ["| feature | with | ms | without | ms | ratio |", "|---|---|---|---|---|---|"]
    for r in results["pay"]:
        lines.append(f"| {r['feature']} | {r['with']} | {r['ms_with']:.4f} | {r['without']} | "
                     f"{r['ms_without']:.4f} | {r['ms_with'] / r['ms_without']:.2f} |")
    return "\n".join(lines)


def profile_table(results):
    stages = [k for k in results["profile"][0] if k not in ("scene", "bodies", "ms")]
    lines = ["| scene | bodies | ms, mean | " + " | ".join(stages) + " |",
             "|---" * (3 + len(stages)) + "|"]
    for r in results["profile"]:
        cells = " | ".join(f"{r[s]:.0f}" if r[s] >= 0.5 else "" for s in stages)
        lines.append(f"| {r['scene']} | {r['bodies']:,} | {r['ms']:.3f} | {cells} |")
    return "\n".join(lines)


def draw(results, path):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "thud"
    import matplotlib.pyplot as plot

    rows = [(label(r["thud"]), next(x for x in r["rivals"] if x["engine"] == "box2d"), r["thud"])
            for r in races(results)]
    rows.reverse()
    figure, axes = plot.subplots(figsize=(9, 0.42 * len(rows) + 1.4))
    for y, (name, rival, own) in enumerate(rows):
        ratio = rival["ms_median"] / own["ms_median"]
        holds = ratio >= own["target"]
        axes.barh(y, ratio, color="#2a7f62" if holds else "#c9822b", height=0.62)
        axes.text(ratio + 0.08, y, f"{ratio:.1f}", va="center", fontsize=10)
        if own["target"]:
            axes.plot([own["target"]] * 2, [y - 0.42, y + 0.42], color="#202020", lw=2)
    axes.axvline(1, color="#808080", lw=1, ls=":")
    axes.set_yticks(range(len(rows)), [name for name, _, _ in rows])
    axes.set_xlim(0, max(r["ms_median"] / o["ms_median"] for _, r, o in rows) + 1)
    axes.set_xlabel("times as fast as Box2D v3.2, median step, one thread; black: the least we aim at")
    axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def compiler():
    cc = os.environ.get("CC", "cc")
    return subprocess.run([cc, "--version"], capture_output=True, text=True,
                          check=False).stdout.split("\n")[0]


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
        return f"{names[0]}, {len(names)} threads"
    except (OSError, IndexError):
        return platform.processor() or "unknown"


def write(results, path):
    with open(os.path.join(HERE, "performance-notes.md"), encoding="utf-8") as file:
        notes = file.read()
    measured = {
        "races": race_table(results), "growth": growth_table(results), "pay": pay_table(results),
        "profile": profile_table(results),
        "when": datetime.date.today().isoformat(), "machine": processor(), "compiler": compiler(),
    }
    for name, text in measured.items():
        assert "{{" + name + "}}" in notes, name
        notes = notes.replace("{{" + name + "}}", text)
    with open(path, "w", encoding="utf-8") as file:
        file.write(notes)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("bench", metavar="THUD_BENCH")
    parser.add_argument("--quick", action="store_true", help="shows that it runs, compares little")
    parser.add_argument("--repeat", type=int, default=3, help="repetitions of every race (3)")
    parser.add_argument("--keep", default=os.path.join(ROOT, "build", "performance"),
                        help="where the JSON of the parts stays")
    parser.add_argument("--out", default=os.path.join(ROOT, "docs"), help="where the page goes")
    arguments = parser.parse_args()
    results = measure(arguments)
    os.makedirs(os.path.join(arguments.out, "pictures"), exist_ok=True)
    draw(results, os.path.join(arguments.out, "pictures", "performance.svg"))
    write(results, os.path.join(arguments.out, "performance.md"))
    print("wrote " + os.path.join(arguments.out, "performance.md"))


if __name__ == "__main__":
    sys.exit(main())
