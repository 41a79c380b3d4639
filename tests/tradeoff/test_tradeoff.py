"""Tests what is computed, written and drawn from the figures of thud-tradeoff, with invented ones."""

import math
import sys
import unittest
from xml.etree import ElementTree

import tradeoff_figures as figures
import tradeoff_page as page
import tradeoff_picture as picture


def point(engine, setting, ms, error, **more):
    return {"engine": engine, "curve": engine, "setting": setting, "substeps": 4,
            "contact_hertz": 30, "error": error, "ms_median": ms, "ms_mean": ms,
            "ms_total": 10 * ms, "penetration_worst": 0.01, "penetration_mean": 0.001,
            "energy_gained": 0, "lost": 0, **more}


def made(thud, box2d, floor=1e-6, chance=1):
    """A case with points (ms, error)."""
    points = [point("thud", f"quality {i}", *p) for i, p in enumerate(thud)]
    points += [point("box2d", f"{2 ** i}", *p, substeps=2 ** i) for i, p in enumerate(box2d)]
    return {"case": "made", "title": "Made up", "about": "Nothing moves.", "error": "way off",
            "unit": "m", "floor": floor, "chance": chance, "bodies": 3, "steps": 10,
            "repetitions": 2, "points": points}


def results_of(*cases):
    return {"about": {k: k for k in ("date", "commit", "processor", "processors", "system",
                                     "compiler", "box2d")},
            "quick": False, "missing": [], "cases": list(cases)}


class Verdicts(unittest.TestCase):
    def test_cheaper_and_more_accurate_holds_with_least_and_most_factors(self):
        case = made([(1, 0.1), (2, 0.01)], [(2, 0.5), (8, 0.02)])
        self.assertTrue(figures.holds(case))
        words = page.verdict(case)
        self.assertIn("Left of and below everywhere", words)
        self.assertIn("2.0 to 4.0 times as fast", words)
        self.assertIn("2.0 to 50 times less", words)

    def test_more_accurate_rival_is_named_as_out_of_reach(self):
        case = made([(1, 0.1)], [(2, 0.5), (8, 0.02)])
        self.assertFalse(figures.holds(case))
        self.assertIn("nothing of thud errs as little as Box2D 2 (0.020 m)", page.verdict(case))

    def test_cheaper_rival_is_named_with_how_much_dearer_thud_is(self):
        case = made([(3, 0.1)], [(2, 0.1)])
        self.assertFalse(figures.holds(case))
        self.assertIn("to err as little as Box2D 1 (0.10 m) thud takes 1.50 times as long.",
                      page.verdict(case))
        both = made([(3, 0.1)], [(2, 0.1), (2.5, 0.2)])
        self.assertIn("Box2D 1 (0.10 m), Box2D 2 (0.20 m) thud takes 1.20 to 1.50 times as long.",
                      page.verdict(both))

    def test_factors_have_two_digits(self):
        self.assertEqual([page.times(v) for v in (1.234, 12.6, 777182.4, math.inf)],
                         ["1.2", "13", "780,000", "∞"])

    def test_equal_errors_are_left_but_not_below(self):
        case = made([(1, 0.4)], [(2, 0.4)])
        self.assertFalse(figures.holds(case))
        self.assertIn("Left everywhere, but not below", page.verdict(case))

    def test_errors_that_count_as_none_are_equal_and_need_not_be_below(self):
        self.assertTrue(figures.holds(made([(1, 1e-9)], [(2, 1e-8)])))

    def test_lost_bodies_are_an_infinite_error_that_everything_beats(self):
        case = made([(1, 0.1)], [(2, None)])
        self.assertEqual(figures.error(case, figures.rivals(case)[0]), math.inf)
        self.assertTrue(figures.holds(case))

    def test_chipmunk_has_a_sentence_of_its_own(self):
        case = made([(1, 0.1), (2, 0.01)], [(2, 0.5), (8, 0.02)])
        self.assertEqual(page.beside_chipmunk(case), "")
        before = page.verdict(case)
        case["points"].append(point("chipmunk", "10", 3, 0.2))
        self.assertIn("At the errors of Chipmunk's 1 points thud is 3", page.beside_chipmunk(case))
        self.assertEqual(page.verdict(case), before)
        case["points"].append(point("chipmunk", "160", 0.5, 0.001))
        self.assertIn("thud does not beat** Chipmunk 160", page.beside_chipmunk(case))

    def test_without_box2d_nothing_is_claimed(self):
        case = made([(1, 0.1), (2, 0.01)], [])
        self.assertFalse(figures.holds(case))
        self.assertEqual(page.verdict(case), page.UNMEASURED)


class Monotony(unittest.TestCase):
    def pairs(self, *errors, **more):
        case = made([(1 + i, e) for i, e in enumerate(errors)], [], **more)
        return [(a["setting"], b["setting"]) for a, b in figures.not_monotone(case)]

    def test_falling_errors_pass_and_a_rise_is_named(self):
        self.assertEqual(self.pairs(3, 2, 1), [])
        self.assertEqual(self.pairs(3, 1, 2), [("quality 1", "quality 2")])

    def test_rise_within_floor_or_chance_counts_as_none(self):
        self.assertEqual(self.pairs(1e-8, 1e-7), [])
        self.assertEqual(self.pairs(1, 1.1, chance=1.2), [])
        self.assertEqual(len(self.pairs(1, 1.3, chance=1.2)), 1)

    def test_a_lost_body_is_a_rise(self):
        self.assertEqual(len(self.pairs(1, None)), 1)


class Pages(unittest.TestCase):
    def test_page_has_verdicts_tables_and_what_is_missing(self):
        case = made([(1, 0.1)], [(2, None)])
        text = page.fill("{{thoroughness}}\n{{summary}}\n{{sections}}\n{{box2d}}",
                         {**results_of(case), "missing": ["gas"]}, "there")
        for words in ("unfinished: without gas", "[Made up](#made-up)", "(there/made.svg)",
                      "| Box2D 1 | lost |", "| **quality 0** | 0.10 m | 1,000 |"):
            self.assertIn(words, text)

    def test_unknown_name_in_the_notes_is_an_error(self):
        with self.assertRaises(KeyError):
            page.fill("{{nothing}}", results_of(), "there")

    def test_digits_are_three_whatever_the_size(self):
        self.assertEqual([page.digits(v) for v in (0, 1234.5, 12.345, 0.0012345, 1.2345e-7)],
                         ["0", "1,234", "12.3", "0.00123", "1.23e-7"])


class Pictures(unittest.TestCase):
    def test_all_points_are_named_and_within_the_picture(self):
        case = made([(1, 0.1), (2, 1e-9)], [(2, 0.5), (8, None)])
        root = ElementTree.fromstring(picture.draw_case(case))
        texts = [e for e in root.iter() if e.tag.endswith("text")]
        words = [e.text for e in texts]
        for label in ("quality 0", "quality 1: none", "Box2D 1", "Box2D 2: lost"):
            self.assertIn(label, words)
        for e in texts:
            self.assertTrue(0 < float(e.get("x")) <= picture.WIDTH, e.text)
            self.assertTrue(0 < float(e.get("y")) <= picture.HEIGHT, e.text)

    def test_labels_do_not_cover_each_other_where_points_coincide(self):
        case = made([(1, 0.1)] * 4, [(1, 0.1)] * 5)
        _, _, places = picture.axes_of(case, 0, 800, 0, 400)
        room = picture.Room(case, places, (0, 0, 800, 400), picture.LABEL)
        placed = [room.place(*places[id(p)], figures.label(p)) for p in case["points"]]
        self.assertEqual(len(set(placed)), len(placed))

    def test_dearer_is_further_right_and_worse_is_higher(self):
        case = made([(1, 0.1), (2, 0.01)], [(4, 1)])
        _, _, places = picture.axes_of(case, 0, 800, 0, 400)
        (x0, y0), (x1, y1), (x2, y2) = (places[id(p)] for p in case["points"])
        self.assertTrue(x0 < x1 < x2 and y2 < y0 < y1)

    def test_overview_has_every_case(self):
        text = picture.draw_overview([made([(1, 0.1)], [(2, 0.5)])] * 5)
        ElementTree.fromstring(text)
        self.assertEqual(text.count("Made up"), 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
