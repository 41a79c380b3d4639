"""Tests what docs/stability.md says about figures and bounds, with invented ones."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "pages"))

import envelope  # noqa: E402
import stability_page as page  # noqa: E402

ABOUT = {"date": "2026-01-02T03:04:05Z", "commit": "0123456789ab", "processor": "p"}


def figure(reached, kind=None, value=0, on=()):
    bound = {"bound": {"kind": kind, "value": value, "on": list(on)}} if kind else {}
    return {"what": "box", **bound, "reached": reached}


def results(*figures):
    return {"about": ABOUT, "quick": False,
            "extremes": [{"name": "a", "title": "A", "about": "Boxes.", "figures": list(figures)},
                         {"name": "b", "title": "B", "about": "None.", "figures": []}]}


def row(one):
    return page.table({"figures": [one]}).split("\n")[2]


class Page(unittest.TestCase):
    def test_bound_that_is_kept_says_yes(self):
        kept = figure({"exact": 1, "Box2D": 2}, "at most", 1, ["exact"])
        self.assertEqual(row(kept), "| box | ≤ 1 at exact | – | – | – | 1 | 2 | yes |")
        self.assertEqual(page.kept({"figures": [kept]}), ("1 of 1", "0 of 1"))

    def test_bound_that_is_missed_says_what_was_reached(self):
        missed = figure({"default": 12.5, "exact": None}, "at least", 99.9, ["default", "exact"])
        self.assertIn("| ≥ 99.9 at default, exact |", row(missed))
        self.assertTrue(row(missed).endswith("| **no**: default reached 12.5, exact reached fails |"))
        self.assertEqual(page.kept({"figures": [missed]}), ("0 of 1", "–"))

    def test_not_a_number_keeps_no_bound(self):
        for kind in ("at most", "at least"):
            wrong = figure({"high": "not a number"}, kind, 1, page.THUD)
            self.assertTrue(row(wrong).endswith("| **no**: high reached not a number |"), row(wrong))

    def test_figure_without_bound_is_only_told(self):
        self.assertEqual(row(figure({"draft": 3})), "| box | – | 3 | – | – | – | – | – |")

    def test_who_is_measured_in_one_extreme_alone_has_a_column_there_alone(self):
        stiff = figure({"Box2D": 2, "Box2D stiff": 1.5})
        self.assertIn("| Box2D | Box2D stiff | holds? |", page.table({"figures": [stiff]}))
        self.assertEqual(row(stiff), "| box | – | – | – | – | – | 2 | 1.5 | – |")
        self.assertNotIn("Box2D stiff", page.table({"figures": [figure({"Box2D": 2})]}))

    def test_notes_stand_below_their_extreme_with_their_figures(self):
        notes = "Opening.\n\n{{measured}}\n\n## b\n\nNone.\n\n## a\n\nIt is {{a > box > draft | .1f}}.\n"
        text = page.fill(notes, results(figure({"draft": 3})))
        self.assertTrue(text.startswith("Opening.\n\nMeasured at commit 0123456789ab on 2026-01-02, "
                                        "p.\n\n| extreme |"), text)
        table, below = text.index("| box | – |"), text.index("\nIt is 3.0.\n")
        self.assertTrue(table < below < text.index('<a id="b">'))

    def test_headings_of_no_extreme_are_found(self):
        self.assertEqual(page.stray_headings("x\n## a\ny\n## nonsense\n", ["a"]), ["nonsense"])

    def test_json_in_lines_is_the_same_json(self):
        import json
        made = results(figure({"draft": None}), figure({"draft": 1e-9}))
        self.assertEqual(json.loads(envelope.as_json(made)), made)


unittest.main()
