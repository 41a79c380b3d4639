"""Tests the program that writes docs/performance.md, with invented figures: what it computes, keeps
and refuses.

A small program stands in for thud-bench and answers each part with figures.
"""

import contextlib
import io
import json
import os
import stat
import sys
import tempfile
import unittest
from unittest import mock
from xml.etree import ElementTree

import performance
import performance_page as page
import performance_picture


def engine(name, median, **more):
    return {"engine": name, "ms_median": median, "ms_p99": 2 * median, "ms_max": 3 * median,
            "ratio_low": median - 0.5, "ratio_high": median + 0.5, "penetration_max": 0.0123,
            "penetration_mean": 0.004, "lost": 0, "bytes": 1500000, **more}


def scene(verdict="holds", limit=0, rapier=True):
    rivals = [engine("box2d", 4)] + ([engine("rapier", 6)] if rapier else [])
    return {"scene": "pyramid", "size": 100, "bodies": 5051, "steps": 300, "target": 3,
            "limit_ms": limit, "verdict": verdict, "engines": [engine("thud", 1)] + rivals}


RESULTS = {
    "about": {"date": "today", "commit": "abc", "processor": "p", "processors": 2, "system": "s",
              "compiler": "c", "box2d": "b"},
    "scenes": [scene()],
    "alone": {"ms_alone": 0.01, "ms_among_sleepers": 0.0105, "at_most": 1.1, "holds": True},
    "growth": [{"scene": "gas", "span": 1.6, "at_most": 1.5,
                "sizes": [{"bodies": n, "ns_per_body": t, "box2d_ns_per_body": 100 * t,
                           "bytes_per_body": 640, "box2d_bytes_per_body": 2100}
                          for n, t in ((1000, 5), (4000, 8))]}],
    "memory": [{"of": "boxes", "bytes_per_body": 500, "box2d_bytes_per_body": 2000,
                "bytes_per_contact": 300, "box2d_bytes_per_contact": 500, "at_most": 0.5}],
    "pay": [{"feature": "friction", "with": "0.6", "without": "0", "ms_with": 0.3,
             "ms_without": 0.2}],
    "workers": [{"scene": "pyramid", "ms_one_worker": 3, "ms_two_workers": 2, "at_least": 1.6}],
    "profile": [{"scene": "gas", "bodies": 1004, "ms": 0.04,
                 "percent": {"broadphase": 60.4, "solve": 39.2, "sleep": 0.4}}],
}

FAKE_BENCH = """#!{python}
import json, sys
if sys.argv[1] == "--help":
    sys.exit()
results = json.load(open({figures!r}))
path = sys.argv[sys.argv.index("--json") + 1]
open({calls!r}, "a").write(sys.argv[1] + "\\n")
keys = {{"--scenes": ["scenes", "alone"], "--growth": ["growth", "memory"]}}
wanted = keys.get(sys.argv[1], [sys.argv[1][2:]])
json.dump({{key: results[key] for key in ["about"] + wanted}}, open(path, "w"))
"""


class Tables(unittest.TestCase):
    def test_scene_row_has_both_ratios_and_the_verdict(self):
        row = page.races(RESULTS).split("\n")[2]
        self.assertEqual(row, "| pyramid, 100 | 5,051 | 1.000 | 4.000 | **4.00** (3.50–4.50) | 4.00 "
                         "| 4.00 | 3 | holds | 6.000 | 6.00 |")

    def test_scene_without_rapier_leaves_its_cells_empty(self):
        row = page.races({"scenes": [scene(rapier=False)]}).split("\n")[2]
        self.assertTrue(row.endswith("| holds |  |  |"), row)

    def test_rival_that_does_not_run_a_scene_adds_nothing_to_it(self):
        own = [scene(rapier=False), scene(rapier=False)]
        race = [{"engines": [engine("thud", 2)]}, {"engines": [engine("thud", 2), engine("rapier", 6)]}]
        performance.add_rival(own, race)
        self.assertEqual([len(s["engines"]) for s in own], [2, 3])
        self.assertEqual(page.ratio(own[1], "rapier", "ms_median"), 3)

    def test_gaps_are_told_of_scenes_with_joints_alone(self):
        joined = {**scene(), "scene": "chain", "engines": [
            engine("thud", 1, gap_max=0, gap_mean=0), engine("box2d", 4, gap_max=0.0123, gap_mean=0.004)]}
        rows = page.gaps({"scenes": [scene(), joined]}).split("\n")[2:]
        self.assertEqual(rows, ["| chain, 100 | 0.0 / 12.3 | 0.00 / 4.00 |"])

    def test_miss_and_limit_are_plain_to_see(self):
        self.assertEqual(page.promise(scene("misses: p99")), "**misses: p99**")
        self.assertEqual(page.promise(scene("holds", limit=50)), "no step over 50 ms: holds")
        self.assertEqual(page.promise(scene("")), "")

    def test_growth_span_beyond_its_limit_misses(self):
        self.assertIn("gas 1.60 (at most 1.5: **misses**); up to 4,000 bodies 1.60, Box2D's 1.60", page.growth(RESULTS))

    def test_growth_without_a_rival_leaves_its_cells_empty(self):
        alone = {"bodies": 1000000, "ns_per_body": 9, "bytes_per_body": 640}
        gas = dict(RESULTS["growth"][0], sizes=RESULTS["growth"][0]["sizes"] + [alone])
        text = page.growth({"growth": [gas]})
        self.assertIn("| gas | 1,000,000 | 9.0 | – | 640 | – |", text)
        self.assertIn("up to 4,000 bodies 1.60, Box2D's 1.60", text)

    def test_memory_judges_body_and_contact_apart(self):
        body, contact = page.memory(RESULTS).split("\n")[2:]
        self.assertTrue(body.endswith("| 0.25 | at most 0.5: holds |"), body)
        self.assertTrue(contact.endswith("| 0.60 | at most 0.5: **misses** |"), contact)

    def test_sleepers_are_held_against_the_hundred_alone(self):
        self.assertIn("1.05 times that (at most 1.1: holds)", page.alone(RESULTS))

    def test_workers_that_gain_too_little_miss(self):
        self.assertTrue(page.workers(RESULTS).endswith("| 1.50 | at least 1.6: **misses** |"))

    def test_wasm_row_misses_what_is_below_four(self):
        run = {"where": "node", "scene": "gas", "size": 1000,
               "thud": {"median": 1, "p99": 1, "max": 2}, "box2d": {"median": 4, "p99": 5, "max": 7}}
        row = page.wasm({"wasm": [run]}).split("\n")[2]
        self.assertEqual(row, "| Node | gas, 1,000 | 1.000 | 4.000 | **4.00** | 5.00 | 3.50 | "
                         "**misses: worst** |")

    def test_profile_leaves_out_what_rounds_to_nothing(self):
        self.assertTrue(page.profile(RESULTS).endswith("| 60 | 39 |  |"))


class Picture(unittest.TestCase):
    def shapes(self, scenes):
        root = ElementTree.fromstring(performance_picture.picture(scenes))
        found = [dict(e.attrib, tag=e.tag.split("}")[1]) for e in root.iter() if "class" in e.attrib]
        return [e for e in found if e["tag"] == "rect"], [e for e in found if e["tag"] == "circle"]

    def test_bars_are_as_long_as_the_ratios_and_end_where_the_circle_would(self):
        slow = scene()
        slow["engines"][1]["ms_median"] = 2
        bars, circles = self.shapes([scene(), slow])
        lengths = [float(bar["width"]) for bar in bars]
        self.assertAlmostEqual(lengths[0] / lengths[1], 2, 2)
        end = float(circles[0]["cx"]) - float(bars[0]["x"])
        self.assertAlmostEqual(end / lengths[0], 6 / 4, 2)
        self.assertNotEqual(bars[0]["fill"], bars[1]["fill"])

    def test_scene_without_rapier_or_aim_has_neither_sign(self):
        bare = scene(rapier=False)
        bare["target"] = 0
        bars, circles = self.shapes([bare])
        self.assertEqual((len(bars), len(circles)), (1, 0))

    def test_no_scenes_are_an_empty_picture(self):
        self.assertEqual(self.shapes([]), ([], []))

    def test_wrong_arguments_are_told(self):
        with contextlib.redirect_stdout(io.StringIO()) as out, \
                contextlib.redirect_stderr(io.StringIO()) as err:
            self.assertEqual(performance_picture.main([]), 2)
            self.assertEqual(performance_picture.main(["--help"]), 0)
            self.assertEqual(performance_picture.main(["no/such.json", "x.svg"]), 1)
        self.assertIn("usage", out.getvalue())
        self.assertIn("no/such.json", err.getvalue())


class Notes(unittest.TestCase):
    def test_text_between_the_figures_stays_word_for_word(self):
        text = page.fill("By hand {, {x} and 5 % -- {{measured}} {{rapier}}.\n\n{{wasm}}\n", RESULTS)
        self.assertEqual(text, "By hand {, {x} and 5 % -- Measured at commit abc on today, p. not built.\n\n"
                         + page.page_parts.NOT_MEASURED + "\n")

    def test_unknown_placeholder_is_refused(self):
        with self.assertRaises(KeyError):
            page.fill("{{no_such}}", RESULTS)

    def test_own_notes_have_every_section_once_and_the_two_by_hand(self):
        with open(os.path.join(performance.HERE, "performance-notes.md"), encoding="utf-8") as file:
            notes = file.read()
        for name in page.SECTIONS:
            self.assertEqual(notes.count("{{" + name + "}}"), 1, name)
        self.assertIn("## The gap to the machine's limit", notes)
        self.assertIn("## What was tried and did not help", notes)
        self.assertNotIn("{{", page.fill(notes, RESULTS))


class Report(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name
        self.figures, self.calls = self.path("figures.json"), self.path("calls")
        with open(self.figures, "w", encoding="utf-8") as file:
            json.dump(RESULTS, file)
        with open(self.path("bench"), "w", encoding="utf-8") as file:
            file.write(FAKE_BENCH.format(python=sys.executable, figures=self.figures,
                                         calls=self.calls))
        os.chmod(self.path("bench"), stat.S_IRWXU)

    def path(self, name):
        return os.path.join(self.folder, name)

    def report(self, *more, commit="abc"):
        """Runs the report; returns its exit code and the parts that were measured."""
        with open(self.calls, "w", encoding="utf-8"):
            pass
        words = [self.path("bench"), "--skip", "wasm", "--keep", self.path("keep"), "--out",
                 self.path("docs"), *more]
        with mock.patch.dict(os.environ, {"THUD_COMMIT": commit}), \
                contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()):
            code = performance.main(words)
        with open(self.calls, encoding="utf-8") as file:
            return code, file.read().split()

    def test_page_and_figures_are_written_and_parts_of_the_same_commit_kept(self):
        every = ["--scenes", "--growth", "--pay", "--workers", "--profile"]
        self.assertEqual(self.report(), (0, every))
        with open(self.path("docs/performance.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file), RESULTS)
        with open(self.path("docs/performance.md"), encoding="utf-8") as file:
            self.assertIn("**4.00** (3.50–4.50)", file.read())
        self.assertTrue(os.path.exists(self.path("docs/pictures/performance.svg")))
        self.assertEqual(self.report(), (0, []))
        os.remove(self.path("keep/pay.json.label"))
        self.assertEqual(self.report(), (0, ["--pay"]))

    def test_other_commit_or_changed_tree_or_thoroughness_is_measured_anew(self):
        self.assertEqual(len(self.report()[1]), 5)
        self.assertEqual(len(self.report(commit="def")[1]), 5)
        self.assertEqual(len(self.report("--quick", commit="def")[1]), 5)
        for unsure in ("def-dirty", "unknown"):
            self.assertEqual(len(self.report(commit=unsure)[1]), 5)
            self.assertEqual(len(self.report(commit=unsure)[1]), 5)

    def test_again_measures_nothing(self):
        self.report()
        os.remove(self.path("docs/performance.md"))
        self.assertEqual(self.report("--again", commit="def"), (0, []))
        self.assertTrue(os.path.exists(self.path("docs/performance.md")))

    def test_failing_bench_or_nothing_to_write_again_is_an_error(self):
        self.assertEqual(self.report("--again")[0], 1)
        os.remove(self.figures)
        self.assertEqual(self.report()[0], 1)
        self.assertFalse(os.path.exists(self.path("docs")))


if __name__ == "__main__":
    unittest.main()
