"""Tests what is computed, written and drawn from the figures of thud-network, with invented ones."""

import unittest
from xml.etree import ElementTree

import network_page as page
import network_picture as picture

WAYS = ["last known place", "extrapolation", "swept prediction", "resimulation"]


def spread(mean):
    return {"mean": mean, "p99": 3 * mean, "max": 10 * mean}


def run(line, delay, players=4, loss=0.02):
    ways = [{"way": way, "place": spread(delay / 1000 + i), "angle": spread(delay / 10),
             "place_jump": spread(delay / 2000), "angle_jump": spread(delay / 20)}
            for i, way in enumerate(WAYS)]
    return {"name": f"{line}, {delay} ms, {players} players", "line": line, "delay": delay,
            "players": players, "steps": 300, "jitter": 10, "loss": loss, "duplicates": 0.01,
            "held": 0.05, "held_for": 50, "lost": loss, "overtaken": 0.125, "replayed": delay / 4,
            "replayed_max": 7, "waits": 0.25, "ms_step": 0.004, "ms_median": 0.01,
            "ms_p99": delay / 100, "bytes": 6543.2, "bytes_in_all": 9999, "bytes_states": 60000,
            "ways": ways}


def results():
    return {"about": {"commit": "0" * 12, "date": "2026-01-01", "processor": "none"}, "quick": False,
            "runs": [run("ordinary", 120, players=2), run("ordinary", 120), run("ordinary", 0),
                     run("worst", 0), run("worst", 120)]}


class Tables(unittest.TestCase):
    def test_each_network_has_one_row_with_its_shares(self):
        rows = page.networks(results()).split("\n")
        self.assertEqual(len(rows), 2 + 2)
        self.assertEqual(rows[2], "| ordinary | 10 ms | 2.0 % | 1.0 % | 5.0 % by 50 ms | 2.0 % | "
                         "12.5 % |")

    def test_each_run_has_one_row_of_work(self):
        rows = page.work(results()).split("\n")
        self.assertEqual(len(rows), 2 + 5)
        self.assertEqual(rows[3], "| ordinary | 120 ms | 4 | 30.0 | 7 | 25.0 % | 4.0 | 0.0100 | "
                         "1.2000 | 6,543 | 9,999 | 60,000 |")

    def test_each_way_has_a_row_of_errors(self):
        text = page.sections(results())
        self.assertEqual(text.count("\n| 120 ms | 4 |"), 8)
        self.assertIn("| 120 ms | 4 | resimulation | 3.120 | 9.360 | 31.200 | 0.180 | 0.600 | 12.00 "
                      "| 36.00 | 120.00 | 18.00 | 60.00 |", text)

    def test_unknown_names_in_notes_are_errors(self):
        self.assertRaises(KeyError, page.fill, "{{nothing}}", results())
        self.assertRaises(ValueError, page.fill, "{{runs > steady | .0f}}", results())
        self.assertEqual(page.fill("{{runs > worst, 120 ms, 4 players > bytes | .0f}}", results()),
                         "6543")


class Pictures(unittest.TestCase):
    def test_runs_with_fewer_players_are_not_drawn_and_delays_are_in_order(self):
        lines = picture.whole(results())
        self.assertEqual([run["delay"] for run in lines["ordinary"]], [0, 120])

    def test_each_picture_names_every_way_or_network(self):
        drawn = picture.draw(results())
        self.assertEqual(len(drawn), 6)
        for name, text in drawn.items():
            ElementTree.fromstring(text)
            for word in ["ordinary", "worst"] if name in ("replayed", "frames") else WAYS:
                self.assertIn(f">{word}</text>", text)

    def test_ticks_are_round_and_reach_the_highest_value(self):
        for highest in (0.003, 0.285, 1, 3.84, 87, 1000):
            ticks = picture.ticks_to(highest)
            self.assertEqual(ticks[0], 0)
            self.assertLessEqual(len(ticks), picture.TICKS + 1)
            self.assertTrue(highest <= ticks[-1] * (1 + 1e-9) < highest + ticks[1] * (1 + 1e-9))
        self.assertEqual(picture.ticks_to(0), [0, 1])


if __name__ == "__main__":
    unittest.main()
