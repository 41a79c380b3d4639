"""Tests the program that writes docs/catalogue.md, with invented figures: what it computes, draws
and refuses.

A small program stands in for thud-catalogue.
"""

import contextlib
import io
import json
import math
import os
import stat
import sys
import tempfile
import unittest
from xml.etree import ElementTree

import catalogue
import catalogue_chart as chart
import catalogue_figures as figures
import catalogue_page as page
import catalogue_picture as picture


def priced(shapes, grid, sweep, every, **more):
    """A row with the ns per shape of each broadphase; None: left out as too slow."""
    row = {"case": f"{shapes}", "shapes": shapes, **more}
    for name, ns in zip(figures.BROADPHASES, (grid, sweep, every)):
        row[name] = {"first_ms": 1, "pairs": 7, "dropped": ns is None}
        row[name].update({"step_ms": 700} if ns is None
                         else {"ns_per_shape": ns, "step_ns_per_shape": 2 * ns})
    return row


def way(mean):
    return {"ms_median": mean / 2, "ms_mean": mean, "ms_max": 2 * mean, "overlap_max": 0.0123,
            "overlap_mean": 0.001, "energy_kept": 0.5, "impacts": 100, "held_bodies": 3,
            "held_seconds": 0.25, "unbisectable": 4, "motion_pairs": 800, "motion_circles": 400,
            "motion_boxes": 200, "motion_exact": 100}


def wall(kind, detection, shares):
    return {"wall": kind, "detection": detection, "lanes": 64,
            "speeds": [{"speed": 10.0 ** (i + 1), "passed": s} for i, s in enumerate(shares)]}


RESULTS = {
    "about": {"date": "today", "commit": "abc", "processor": "p", "processors": 2, "system": "s",
              "compiler": "c"},
    "quick": False,
    "growth": [priced(10, 40, 30, 20), priced(100, 20, 30, 80), priced(1000, 20, 60, None),
               priced(100000, 25, 90, None)],
    "coherence": [priced(100, 2, 1, 3)],
    "sizes": [priced(100, 2, 1, 3, overlaps=50)],
    "gathering": [priced(100, 2, 1, 3, overlaps=50), priced(100, 20, 10, 30, overlaps=5000)],
    "detections": [{"scene": s, "size": 100, "steps": 200,
                    "ways": {w: way(10 ** i) for i, w in enumerate(figures.WAYS)}}
                   for s in ("gas", "bullets", "circle_pit", "smash")],
    "walls": [wall(kind, detection, shares) for kind in ("static", "dynamic")
              for detection, shares in (("overlap", (0.125, 1)), ("continuous", (0, 0)),
                                        ("bisect", (0, 1)), ("swept", (0, 0)))],
    "throws": [{"detection": "swept", "rate": 60, "flight": 0.025, "mean": 0.02, "worst": 0.03,
                "early": 0, "late": 0.004, "bend": 0.000347, "chord": 0.000347}],
    "prices": [{"scene": scene, "detection": detection, "rate": rate, "us": us * rate,
                "error": error / rate}
               for scene in ("shuttle", "hop") for rate in (60, 120)
               for detection, us, error in (("overlap", 10, 24), ("continuous", 12, 18),
                                            ("bisect", 20, 2), ("swept", 30, 1.2))],
    "levels": [{"scene": "gas", "size": 100, "pairs": 1000, "circles": 100, "boxes": 20,
                "oriented": 20, "exact": 10, "bounds": 60, "sieved": 33, "near": 31,
                "contacts": 30}],
    "volumes": [{"call": "volume_merge", "ns": {"circle": 5, "AABB": 6, "OBB": 70}}],
    "calls": [{"call": "geometry_approach", "ns": {"circle, circle": 25}},
              {"call": "geometry_overlap", "ns": {"circle, circle": 9.87, "OBB, OBB": 123.4}}],
    "tolerances": [{"bits": 5, "ns": {"circle, circle": 50, "OBB, OBB": 300}}],
    "grounds": [{"ground": "flat", "vertices": 100, "spacing": 1, "ns": {"sample_at": 3}},
                {"ground": "uniform", "vertices": 100000, "spacing": 0.05,
                 "ns": {"sample_at": 11}}],
    "digging": [{"ground": "uniform", "vertices": 100, "spacing": 1,
                 "dig": {"median": 200, "worst": 900}, "raise": {"median": 150, "worst": 800}}],
    "queries": [{"query": "ray", "found": 0.97, "grid": 600, "plane sweep": 700,
                 "all pairs": 2500}],
    "mover": [{"mover": "circle", "ns": 650}],
}

FAKE = """#!{python}
import sys
if {fails}:
    sys.exit(3)
path = sys.argv[sys.argv.index("--json") + 1]
open(path, "w").write(open({figures!r}).read())
"""


def row_of(text, start):
    line = next(line for line in text.splitlines() if line.startswith("| " + start))
    return [cell.strip() for cell in line.strip("|").split("|")]


class Figures(unittest.TestCase):
    def test_crossing_of_straight_lines_is_where_they_meet(self):
        # On logarithmic scales a = 1000 / x and b = x / 10 meet at 100.
        self.assertAlmostEqual(figures.crossing(10, 10000, 100, 0.1, 1, 1000), 100)

    def test_reigns_hand_over_at_crossings(self):
        (first, _, end), (last, start, upto) = figures.reigns(RESULTS["growth"])
        self.assertEqual((first, last, upto), ("all pairs", "grid", 100000))
        # From 40 to 20 against 20 to 80: the ratio falls from 2 to 1/4 and is 1 at a third of the
        # way.
        self.assertAlmostEqual(end, 10 * 10 ** (1 / 3))
        self.assertEqual(start, end)

    def test_reign_ends_where_its_holder_drops_out(self):
        rows = [priced(10, 3, 2, 1), priced(100, 3, 2, None)]
        self.assertEqual(figures.reigns(rows), [["all pairs", 10, 10], ["plane sweep", 10, 100]])

    def test_words_name_every_reign_and_who_has_none(self):
        text = figures.in_words(RESULTS["growth"])
        self.assertIn("all pairs up to about 22 shapes", text)
        self.assertIn("grid from about 22 on", text)
        self.assertIn("Never cheapest here: plane sweep", text)
        self.assertIn("grid at every size", figures.in_words([priced(10, 1, 2, 3)]))

    def test_cost_per_pair_counts_pairs_that_overlap(self):
        self.assertEqual(figures.per_pair(RESULTS["gathering"][1], "plane sweep"), 0.2)

    def test_dropped_at_is_the_first_size_that_was_too_dear(self):
        rows = RESULTS["growth"] + [priced(9000, 1, None, None)]
        self.assertEqual(figures.dropped_at(rows), {"all pairs": 1000, "plane sweep": 9000})


class Page(unittest.TestCase):
    def test_prices_name_the_most_accurate_and_the_cheapest_that_is_near(self):
        text = page.prices(RESULTS)
        self.assertIn("In *hop* swept at 120 steps a second is the most accurate, 10.00 mm off",
                      text)
        # Within 20 mm are swept at both rates and bisect at 120: 1800, 3600 and 2400 µs.
        self.assertIn("the cheapest within 20.00 mm is swept at 60 steps a second.", text)
        self.assertEqual(row_of(text, "shuttle | swept | 60")[3:], ["1,800", "20.00"])

    def test_broadphases_mark_the_cheapest_and_who_dropped_out(self):
        text = page.growth(RESULTS)
        self.assertEqual(row_of(text, "10 ")[2:], ["40 (80)", "30 (60)", "**20** (40)"])
        self.assertEqual(row_of(text, "1,000 ")[2:], ["**20** (40)", "60 (120)", "too dear"])
        self.assertIn("With 1,000 shapes a step with all pairs took 700 ms", text)

    def test_detections_are_compared_with_overlap(self):
        cells = row_of(page.detections(RESULTS), "smash, 100 | bisect")
        self.assertEqual(cells[3:7], ["100.00", "100.00", "200.000", "12.30"])
        self.assertEqual(cells[7], "", "only the gas ought to keep its energy")
        self.assertEqual(row_of(page.detections(RESULTS), "gas, 100 | swept")[7], "50.0 %")

    def test_motions_are_per_step(self):
        self.assertEqual(row_of(page.motions(RESULTS), "gas")[1:], ["4", "2", "1", "0.5", "0.5"])

    def test_levels_say_how_many_tests_an_overlap_takes(self):
        self.assertEqual(row_of(page.levels(RESULTS), "gas")[-1], "100")
        self.assertEqual(row_of(page.narrowphase(RESULTS), "gas")[1:],
                         ["1,000", "60", "33", "31", "30"])

    def test_calls_leave_out_pairs_that_a_function_does_not_take(self):
        self.assertEqual(row_of(page.calls(RESULTS), "`thud_geometry_approach")[1:], ["25", ""])
        self.assertEqual(row_of(page.calls(RESULTS), "`thud_geometry_overlap")[1:], ["9.87", "123"])

    def test_grounds_name_their_spacing_where_it_is_unusual(self):
        self.assertIn("| uniform, 100,000, 5 cm apart |", page.grounds(RESULTS))

    def test_notes_get_every_section(self):
        with open(os.path.join(catalogue.HERE, "catalogue-notes.md"), encoding="utf-8") as file:
            notes = file.read()
        text = page.fill(notes, {**RESULTS, "quick": True})
        self.assertNotIn("{{", text)
        self.assertNotIn(page.page_parts.NOT_MEASURED, text)
        for name in page.SECTIONS:
            self.assertIn("{{" + name + "}}", notes)

    def test_missing_part_is_said_and_unknown_name_refused(self):
        part = {"about": RESULTS["about"], "quick": True}
        self.assertEqual(page.fill("{{walls}}", part), page.page_parts.NOT_MEASURED)
        with self.assertRaises(KeyError):
            page.fill("{{no_such}}", RESULTS)


class Pictures(unittest.TestCase):
    def test_decades_reach_around_what_is_drawn(self):
        self.assertEqual(chart.decades(14, 100004), [10, 100, 1000, 10000, 100000])
        self.assertEqual(chart.decades(0.4, 0.5), [0.1, 1])

    def test_labels_keep_their_distance_and_stay_in_the_picture(self):
        places = chart.spread([100, 101, 400, 399], 17, 0, 400)
        ordered = sorted(places)
        self.assertTrue(all(b - a >= 17 for a, b in zip(ordered, ordered[1:])), places)
        self.assertLessEqual(max(places), 400)
        self.assertLess(places[0], places[1])

    def test_scale_maps_ends_and_middle(self):
        x = chart.Scale([1, 100], 0, 50, True)
        self.assertTrue(math.isclose(x(1), 0) and math.isclose(x(10), 25) and
                        math.isclose(x(100), 50))

    def test_every_picture_names_its_lines_within_its_frame(self):
        drawn = picture.draw(RESULTS)
        self.assertEqual(len(drawn), 8)
        for name, svg in drawn.items():
            root = ElementTree.fromstring(svg)
            for element in root.iter():
                for key, limit in (("x", chart.WIDTH), ("cx", chart.WIDTH), ("y", chart.HEIGHT),
                                   ("cy", chart.HEIGHT)):
                    self.assertTrue(0 <= float(element.get(key, 0)) <= limit, (name, element.attrib))
        for label in figures.BROADPHASES:
            self.assertIn(f">{label}</text>", drawn["broadphases"])
        self.assertIn(">continuous and swept</text>", drawn["walls-static"])

    def test_who_dropped_out_has_no_point(self):
        self.assertEqual(picture.broadphases(RESULTS).count("<circle"), 10)


class Program(unittest.TestCase):
    def run_in(self, folder, *options, fails=False):
        figures_path = os.path.join(folder, "figures.json")
        program = os.path.join(folder, "fake")
        with open(figures_path, "w", encoding="utf-8") as file:
            json.dump(RESULTS, file)
        with open(program, "w", encoding="utf-8") as file:
            file.write(FAKE.format(python=sys.executable, fails=fails, figures=figures_path))
        os.chmod(program, stat.S_IRWXU)
        out = os.path.join(folder, "docs")
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = catalogue.main([program, "--out", out, *options])
        return code, out, said.getvalue()

    def test_page_pictures_and_figures_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            code, out, said = self.run_in(folder)
            self.assertEqual((code, said.count("wrote")), (0, 1), said)
            self.assertEqual(catalogue.read(os.path.join(out, "catalogue.json")), RESULTS)
            self.assertEqual(len(os.listdir(os.path.join(out, "pictures"))), 8)
            with open(os.path.join(out, "catalogue.md"), encoding="utf-8") as file:
                text = file.read()
            for name in os.listdir(os.path.join(out, "pictures")):
                self.assertIn(f"(pictures/{name})", text)
            code, _, _ = self.run_in(folder, "--again", fails=True)
            self.assertEqual(code, 0, "--again measures nothing")

    def test_failure_to_measure_is_told_and_writes_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            code, out, said = self.run_in(folder, fails=True)
            self.assertEqual(code, 1)
            self.assertIn("catalogue.py: ", said)
            self.assertFalse(os.path.exists(os.path.join(out, "catalogue.md")))


if __name__ == "__main__":
    unittest.main()
