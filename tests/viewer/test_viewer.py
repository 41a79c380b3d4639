"""Runs thud-play without a display and checks the pictures that it writes: test_viewer.py
THUD_PLAY THUD_RUN [short] [TEST...]. `short` leaves out the tests that take longest."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from picture import read_bmp, read_png

HERE = pathlib.Path(__file__).resolve().parent
PALETTE = (HERE / "../../demo/play/draw/palette.h").read_text(encoding="utf-8")
PLAY = RUN = ""
SHORT = "short" in sys.argv[3:]
# Marks a test that takes long in a program that was built with sanitizers.
long_one = unittest.skipIf(SHORT, "takes long")

# ball.tmj is 40 x 30 m, so that 800 x 600 pixels show 20 pixels per metre. The ball has radius 1,
# begins with its centre at (20, 25) and falls freely for the first 22 m.
BALL = HERE / "ball.tmj"
PIXELS_PER_METRE = 20


def palette(name):
    """A colour of the viewer's palette, as (red, green, blue)."""
    hexadecimal = re.search(rf"#define {name}\s+RGBA?\(0x([0-9A-F]{{6}})", PALETTE).group(1)
    return tuple(bytes.fromhex(hexadecimal))


MATERIALS = re.findall("0x([0-9A-F]{6})", PALETTE.split("COLOR_MATERIALS")[1].split("}")[0])


def run(*arguments):
    """Runs thud-play without the environment variables that a desktop sets."""
    environment = {k: v for k, v in os.environ.items()
                   if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    return subprocess.run([PLAY, *map(str, arguments)], env=environment, capture_output=True,
                          text=True, timeout=300, check=False)


def colourful(pixel):
    """Whether a pixel is part of a moving body: sky, ground and static bodies are nearly grey."""
    return max(pixel) - min(pixel) > 45


def centre_of_colour(picture, wanted=colourful):
    """The mean position of the pixels for which `wanted` holds."""
    colours = set(filter(wanted, set(picture.pixels())))
    places = [(x, y) for y, row in enumerate(picture.rows) for x, pixel in enumerate(row)
              if pixel in colours]
    assert places, "nothing of that colour in sight"
    return (sum(x + 0.5 for x, _ in places) / len(places),
            sum(y + 0.5 for _, y in places) / len(places))


class Viewer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def shoot(self, *arguments, suffix="bmp", size="800x600"):
        path = self.folder / f"shot.{suffix}"
        result = run(*arguments, "--size", size, "--screenshot", path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        picture = (read_png if suffix == "png" else read_bmp)(path)
        self.assertEqual(f"{picture.width}x{picture.height}", size)
        return picture

    def shoot_bare(self, *arguments, size="800x600"):
        return self.shoot(*arguments, "--bare", size=size)

    def test_ball_at_start_is_where_level_says(self):
        x, y = centre_of_colour(self.shoot_bare(BALL, "--frames", 0))
        self.assertAlmostEqual(x, 400, delta=1)
        self.assertAlmostEqual(y, 300 - (25 - 15) * PIXELS_PER_METRE, delta=1)

    def test_ball_after_60_frames_has_fallen_5_metres(self):
        x, y = centre_of_colour(self.shoot_bare(BALL, "--frames", 60))
        self.assertAlmostEqual(x, 400, delta=1)
        # g t^2 / 2 = 5 m; substeps of 1/240 s add 1/240 of that. A pixel is 5 cm.
        self.assertAlmostEqual(y, 300 - (20 - 15) * PIXELS_PER_METRE, delta=2)

    def test_paused_world_does_not_move(self):
        _, y = centre_of_colour(self.shoot_bare(BALL, "--frames", 60, "--paused"))
        self.assertAlmostEqual(y, 300 - (25 - 15) * PIXELS_PER_METRE, delta=1)

    def test_character_stands_on_its_ledge_half_a_second_later(self):
        # The view is 20 m high and centred at the character's start (31, 18); its feet fall from
        # 17.25 to the ledge at 17.
        orange = palette("COLOR_CHARACTER")
        x, y = centre_of_colour(
            self.shoot_bare("platform", "--frames", 30),
            lambda pixel: all(abs(a - b) < 10 for a, b in zip(pixel, orange)))
        self.assertAlmostEqual(x, 400, delta=2)  # its eyes, to the right, are not orange
        self.assertAlmostEqual(y, 300 + 0.24 * 600 / 20, delta=3)

    def test_tall_stack_stands_as_coloured_column(self):
        """600 pixels show 40 m around height 15: the boxes have 15 pixels, from y = 525 upwards."""
        picture = self.shoot_bare("tall_stack", "--frames", 30, "--overlay", "none")
        for box in range(30):
            y = round(525 - (box + 0.5) * 15)
            self.assertTrue(colourful(picture.rows[y][400]), f"box {box} is missing")
            self.assertFalse(colourful(picture.rows[y][375]), f"left of box {box}")
            self.assertFalse(colourful(picture.rows[y][425]), f"right of box {box}")
        self.assertFalse(colourful(picture.rows[525 - 33 * 15][400]), "above the stack")

    def test_terrain_is_filled_below_its_line(self):
        picture = self.shoot_bare("mixed_terrain")
        deep = palette("COLOR_GROUND_DEEP")
        self.assertGreater(sum(pixel == deep for pixel in picture.rows[-1]), 700)
        self.assertEqual(sum(pixel == deep for pixel in picture.rows[0]), 0)
        self.assertGreater(picture.count_near(palette("COLOR_SURFACE"), 10), 800)

    def test_overlays_add_their_colour(self):
        """Bodies rest on each other in this scene, so that every overlay has something to draw."""
        plain = self.shoot_bare("tall_stack", "--frames", 30, "--overlay", "none")
        for name in ("contact", "normal", "bounds", "cell"):
            with self.subTest(overlay=name):
                overlay = name if name == "bounds" else name + "s"
                shown = self.shoot_bare("tall_stack", "--frames", 30, "--overlay", overlay)
                # Lines are thin and slightly transparent; no colour of the scene is as close to
                # theirs.
                color, distance = palette(f"COLOR_{name.upper()}"), 110
                self.assertGreater(shown.count_near(color, distance),
                                   plain.count_near(color, distance) + 30)

    def test_joints_are_drawn_and_so_is_what_they_bear(self):
        """A load hangs from a crane by ropes, below a trolley on its rail."""
        plain, joints, forces = (
            self.shoot_bare("crane", "--frames", 60, "--overlay", overlay)
            for overlay in ("none", "joints", "forces"))
        for shown, color in ((joints, "COLOR_JOINT"), (forces, "COLOR_FORCE")):
            with self.subTest(color=color):
                self.assertGreater(shown.count_near(palette(color), 60),
                                   plain.count_near(palette(color), 60) + 100)

    def test_texture_of_the_ground_is_drawn_and_what_feet_stand_on(self):
        """Grass and ice are on the ground at the walker's start."""
        picture = self.shoot_bare("textured", "--frames", 120)
        grass, ice = (tuple(bytes.fromhex(color)) for color in MATERIALS[1:3])
        for color in (grass, ice):
            self.assertGreater(picture.count_near(color, 20), 500)
        plain = self.shoot_bare("walker", "--frames", 120)
        self.assertLess(plain.count_near(ice, 20), picture.count_near(ice, 20) / 2)

    def test_joint_that_broke_is_drawn_no_more_and_nothing_complains(self):
        """The joint that breaks is the sling of the trebuchet."""
        picture = self.shoot("trebuchet", "--frames", 150)
        self.assertLess(picture.count_near(palette("COLOR_ERROR"), 60), 20)  # bricks' edges

    def test_water_lies_over_what_is_in_it_and_lets_it_be_seen(self):
        """The lake of the boats: 800 pixels show 41 m, and its surface is at height 0."""
        picture = self.shoot_bare("boats", "--frames", 0)
        deep, sky = picture.rows[300 + 80][420], picture.rows[300 - 150][420]
        self.assertGreater(deep[2] - deep[0], 40 + sky[2] - sky[0])
        surface = palette("COLOR_SURFACE_OF_WATER")
        lines = [y for y in range(350) if sum(abs(a - b) for a, b in
                                              zip(picture.rows[y][560], surface)) < 350]
        self.assertTrue(lines and all(abs(y - 312) < 4 for y in lines), lines)
        # The buoy is half in the water; its lower half has the same colour, but bluer.
        x = round(400 + (-1.6 - 0.35) * 800 / 41)
        above, below = picture.rows[312 - 9][x], picture.rows[312 + 2][x]
        self.assertTrue(colourful(above) and colourful(below) and above != below)

    def test_explosion_leaves_a_ring_for_a_moment(self):
        blast = palette("COLOR_BLAST")
        before, during, over = (self.shoot_bare("explosion", "--frames", frames, "--overlay", "none")
                                .count_near(blast, 170) for frames in (60, 63, 105))
        self.assertGreater(during, before + 100)
        self.assertLess(abs(over - before), 100)

    def test_scene_wider_than_the_window_is_seen_whole(self):
        picture = self.shoot_bare("chain", "--frames", 1, size="400x600")
        rightmost = max(x for row in picture.rows for x, pixel in enumerate(row)
                        if colourful(pixel))
        self.assertTrue(350 < rightmost < 395, rightmost)

    def changed_by(self, overlay, *arguments):
        """The positions of the pixels that an overlay changes."""
        plain = self.shoot_bare(*arguments, "--overlay", "none").rows
        shown = self.shoot_bare(*arguments, "--overlay", overlay).rows
        return [(x, y) for y in range(600) if plain[y] != shown[y]
                for x in range(800) if plain[y][x] != shown[y][x]]

    def test_pairs_join_the_centres_of_boxes_that_touch(self):
        """The line goes from the ground's centre, at y = -1 and 15 pixels per metre, to that of the
        30th box."""
        places = self.changed_by("pairs", "tall_stack", "--frames", 30)
        self.assertLessEqual(max(abs(x - 400) for x, _ in places), 2)
        lines = {y for _, y in places}
        self.assertAlmostEqual(min(lines), 525 - 29.5 * 15, delta=3)
        self.assertGreater(len(lines), 0.95 * (max(lines) - min(lines)))

    def test_motions_are_drawn_of_what_is_fast_and_of_nothing_else(self):
        self.assertGreater(len(self.changed_by("motions", "bullets", "--frames", 30)), 300)
        self.assertEqual(self.changed_by("motions", "tall_stack", "--frames", 30), [])

    def test_cells_belong_to_the_grid_and_intervals_to_the_plane_sweep(self):
        for broadphase, has_cells, has_bars in (("grid", True, False), ("sweep", False, True),
                                                ("all", False, False)):
            with self.subTest(broadphase=broadphase):
                arguments = ("broadphases", "--frames", 20, "--broadphase", broadphase)
                plain, cells, bars = (
                    self.shoot_bare(*arguments, "--overlay", overlay, size="320x240")
                    for overlay in ("none", "cells", "axes"))
                self.assertEqual(cells.rows != plain.rows, has_cells)
                self.assertEqual(bars.rows != plain.rows, has_bars)
                # Bars are at the lower edge: the upper part does not change.
                self.assertEqual(bars.rows[:120], plain.rows[:120])

    def test_scene_brings_the_overlays_that_it_is_about(self):
        shown, same, none = (
            self.shoot_bare("broadphases", "--frames", 20, *more, size="320x240").rows
            for more in ([], ["--overlay", "cells,axes,sleeping"], ["--overlay", "none"]))
        self.assertEqual(shown, same)
        self.assertNotEqual(shown, none)

    def test_minkowski_sums_are_drawn_about_the_first_shapes(self):
        """The view is 17 m high around (0.4, 0): the first shapes of pairs are 4 m above or below
        its middle, and a sum extends to 3 m from there."""
        picture = self.shoot_bare("minkowski")
        color, scale = palette("COLOR_SUM"), 600 / 17
        for y in (300 - 4 * scale, 300 + 4 * scale):
            x = 400 - 1.2 * scale
            places = [(column, row) for row in range(round(y - 2.6 * scale), round(y + 2.6 * scale))
                      for column in range(round(x - 3.2 * scale), round(x + 2.4 * scale))
                      if all(abs(a - b) < 60 for a, b in zip(picture.rows[row][column], color))]
            self.assertGreater(len(places), 300)
            left, right = min(place[0] for place in places), max(place[0] for place in places)
            self.assertLess(left, x - 1.5 * scale)
            self.assertGreater(right, x + 1.5 * scale)

    def test_pairs_show_what_is_looked_at(self):
        """The first pair's first box is 3 by 1.6 m, so that its bounding circle has a radius of 1.7
        m."""
        colors = {"sum": "COLOR_SUM", "closest": "COLOR_TOUCHING", "bounds": "COLOR_INTERVAL"}
        seen = {look: self.shoot_bare("minkowski", "--look", look) for look in colors}
        for look, picture in seen.items():
            with self.subTest(look=look):
                counts = {other: picture.count_near(palette(color), 40)
                          for other, color in colors.items()}
                self.assertGreater(counts.pop(look), 50)
                self.assertLess(max(counts.values()), 20)
        picture, scale = seen["bounds"], 600 / 17
        x, y = round(400 - 1.2 * scale), 300 - 4 * scale
        for edge in (y - 1.7 * scale, y + 1.7 * scale):
            column = [picture.rows[round(edge) + k][x] for k in range(-2, 3)]
            self.assertTrue(any(sum(abs(a - b) for a, b in zip(pixel, palette("COLOR_INTERVAL"))) < 90
                                for pixel in column))

    def test_detection_decides_who_passes_thin_walls(self):
        """A bullet at 10 km/s in a room of its own, the fourth from above, 24 m wide."""
        def colourful_pixels(detection):
            picture = self.shoot_bare("bullets", "--frames", 30, "--overlay", "none",
                                      "--detection", detection)
            row = round(300 - (4 * 2 - 0) * 600 / 33)  # its middle
            return sum(colourful(pixel) for line in picture.rows[row - 14:row + 14]
                       for pixel in line)
        self.assertEqual(colourful_pixels("overlap"), 0)
        self.assertGreater(colourful_pixels("continuous"), 3)
        self.assertGreater(colourful_pixels("swept"), 3)

    def test_what_bisection_may_miss_is_told_where_it_bisects(self):
        """The text is in a line below the title and the numbers, where a narrow window has it."""
        def told(detection):
            picture = self.shoot(BALL, "--frames", 1, "--overlay", "none", "--detection", detection)
            lines = [row[240:] for row in picture.rows[90:112]]
            color = palette("COLOR_TIMINGS")
            return sum(sum(abs(a - b) for a, b in zip(pixel, color)) < 60
                       for line in lines for pixel in line)
        self.assertEqual(told("overlap"), 0)
        self.assertGreater(told("bisect"), 100)

    def test_bound_of_bisection_is_red_where_the_greatest_speed_breaks_it(self):
        """The ball is more than 1 mm thick and less than 10 m."""
        def told(rate, speed, color):
            picture = self.shoot(BALL, "--frames", 1, "--overlay", "none",
                                 "--rate", rate, "--top-speed", speed)
            return sum(sum(abs(a - b) for a, b in zip(pixel, palette(color))) < 60
                       for row in picture.rows[90:112] for pixel in row[240:])
        self.assertGreater(told(60, 1000, "COLOR_OPEN"), 100)
        self.assertEqual(told(60, 1000, "COLOR_TIMINGS"), 0)
        self.assertGreater(told(1000, 1, "COLOR_TIMINGS"), 100)
        self.assertEqual(told(1000, 1, "COLOR_OPEN"), 0)

    def test_islands_give_one_stack_one_colour(self):
        shown = self.shoot_bare("tall_stack", "--frames", 30, "--overlay", "islands")
        colors = {shown.rows[round(525 - (box + 0.5) * 15)][400] for box in range(30)}
        self.assertEqual(len(colors), 1)
        self.assertTrue(colourful(colors.pop()))

    @long_one
    def test_sleeping_bodies_are_dimmed(self):
        """The boxes of this scene are asleep after one second; its circles never sleep."""
        awake = self.shoot_bare("asleep", "--frames", 90, "--overlay", "none")
        dimmed = self.shoot_bare("asleep", "--frames", 90, "--overlay", "sleeping")
        light = [sum(sum(pixel) for pixel in picture.pixels()) for picture in (awake, dimmed)]
        self.assertLess(light[1], light[0])

    def test_timings_are_drawn_in_lower_right_corner(self):
        plain = self.shoot_bare(BALL, "--frames", 30)
        shown = self.shoot_bare(BALL, "--frames", 30, "--overlay", "timings")
        changed = [(x, y) for y in range(600) for x in range(800)
                   if plain.rows[y][x] != shown.rows[y][x]]
        self.assertGreater(len(changed), 10000)
        self.assertGreater(min(x for x, _ in changed), 400)
        self.assertGreater(min(y for _, y in changed), 250)

    def test_panel_shows_list_and_controls(self):
        picture = self.shoot("tall_stack")
        self.assertEqual(picture.rows[595][5], palette("COLOR_PANEL"))
        self.assertGreater(picture.count_near(palette("COLOR_WIDGET_ON"), 0), 1000)
        self.assertGreater(picture.count_near(palette("COLOR_TEXT"), 30), 300)

    def test_png_and_bmp_of_same_scene_are_equal(self):
        png = self.shoot("cradle", "--frames", 5, "--bare", suffix="png")
        bmp = self.shoot("cradle", "--frames", 5, "--bare", suffix="bmp")
        self.assertEqual(png.rows, bmp.rows)

    @long_one
    def test_same_scene_twice_gives_same_picture(self):
        first = self.shoot_bare("smash", "--frames", 20)
        self.assertEqual(first.rows, self.shoot_bare("smash", "--frames", 20).rows)

    @long_one
    def test_everything_listed_is_drawn(self):
        listed = run("--list")
        self.assertEqual(listed.returncode, 0)
        names = [line.split()[0] for line in listed.stdout.splitlines()]
        self.assertGreaterEqual(len(names), 20)
        for name in names:
            with self.subTest(scene=name):
                picture = self.shoot(name, "--frames", 1, "--bare", size="320x200")
                self.assertGreater(sum(map(colourful, picture.pixels())), 10)

    def test_workers_do_not_change_the_picture(self):
        shown = [self.shoot("pyramid", "--frames", 60, "--bare", "--workers", workers)
                 for workers in (1, 3)]
        self.assertEqual(shown[0].rows, shown[1].rows)

    def record(self, *arguments):
        path = self.folder / "run.rec"
        subprocess.run([RUN, *map(str, arguments), "--record", path], check=True, timeout=300,
                       capture_output=True)
        return path

    def test_recording_is_shown_where_its_level_was(self):
        recording = self.record(BALL, "--steps", 70)
        for frames in (0, 60):
            with self.subTest(frames=frames):
                x, y = centre_of_colour(self.shoot_bare(recording, "--frames", frames))
                self.assertEqual((x, y), centre_of_colour(self.shoot_bare(BALL, "--frames", frames)))

    def test_joints_and_overlays_of_a_recording_are_drawn(self):
        recording = self.record("crane", "--steps", 60)
        for overlay in ("joints", "forces", "contacts"):
            with self.subTest(overlay=overlay):
                shown, plain = (self.shoot_bare(file, "--frames", 60, "--overlay", overlay)
                                for file in (recording, "crane"))
                color = palette(f"COLOR_{overlay.upper().rstrip('S')}")
                self.assertGreater(plain.count_near(color, 60), 40)
                self.assertEqual(shown.count_near(color, 60), plain.count_near(color, 60))

    def test_calls_of_a_step_are_listed(self):
        """Crates break after some 50 steps, which the scene does by calls."""
        recording = self.record("crates", "--steps", 70)
        def told(frames, *more):
            picture = self.shoot("--replay", recording, "--frames", frames, *more)
            lines = [row[300:] for row in picture.rows[130:400]]
            color = palette("COLOR_TEXT")
            return sum(sum(abs(a - b) for a, b in zip(pixel, color)) < 60
                       for line in lines for pixel in line)
        counts = {frames: told(frames, "--calls") for frames in range(49, 53)}
        most = max(counts, key=counts.get)
        self.assertEqual(min(counts.values()), 0)
        self.assertGreater(counts[most], 300)
        self.assertEqual(told(most), 0)

    def test_foreign_and_damaged_recordings_give_message_and_failure(self):
        recording = self.record(BALL, "--steps", 5)
        short = self.folder / "short.rec"
        short.write_bytes(recording.read_bytes()[:-9])
        for path, words in ((short, "damaged"), (BALL, "no recording"),
                            (self.folder / "none", "cannot be read"), (self.folder, "cannot be read")):
            with self.subTest(path=path):
                result = run("--replay", path, "--screenshot", self.folder / "shot.png")
                self.assertEqual(result.returncode, 1)
                self.assertIn(words, result.stderr)
                self.assertFalse((self.folder / "shot.png").exists())

    def test_bad_arguments_give_message_and_failure(self):
        for arguments in (["nowhere"], ["missing.tmj"], ["--bogus"], ["--frames"],
                          ["--frames", "-1"], ["--frames", "1x"], ["--size", "800"],
                          ["--size", "1x1"], ["--quality", "perfect"], ["--detection", "magic"],
                          ["--detection"], ["--broadphase", "tree"], ["--overlay", "shadows"], ["--look", "mass"],
                          ["--rate", "0"], ["--rate", "1001"], ["--top-speed", "fast"], ["--top-speed"],
                          ["--workers", "0"], ["--workers", "65"], ["--replay"], ["pyramid", "--replay", "x.rec"],
                          ["--screenshot", "picture.jpg"], ["pyramid", "gas"],
                          ["--screenshot", self.folder / "no" / "folder.png"]):
            with self.subTest(arguments=arguments):
                result = run(*arguments)
                self.assertEqual(result.returncode, 1)
                self.assertRegex(result.stderr, r"(?m)^thud-play: .{10}")

    def test_malformed_level_gives_message_and_failure(self):
        path = self.folder / "broken.tmj"
        path.write_text('{"layers": [', encoding="utf-8")
        result = run(path, "--screenshot", self.folder / "shot.png")
        self.assertEqual(result.returncode, 1)
        self.assertIn("broken.tmj", result.stderr)

    def test_level_without_what_cannot_be_modelled_is_shown_and_that_is_listed(self):
        wrong = pathlib.Path(__file__).parents[1] / "levels" / "maps" / "wrong.tmx"
        result = run(wrong, "--screenshot", self.folder / "wrong.png")
        self.assertEqual(result.returncode, 0, result.stderr)
        for number in (2, 4, 7, 11, 13):
            self.assertIn(f"object {number}: ", result.stderr)

    def test_help_names_every_option(self):
        result = run("--help")
        self.assertEqual(result.returncode, 0)
        for option in ("--list", "--size", "--quality", "--overlay", "--detection",
                       "--broadphase", "--frames", "--screenshot", "--look", "--rate", "--top-speed",
                       "--workers", "--paused", "--bare", "--replay", "--calls"):
            self.assertIn(option, result.stdout)
        for beside in (["--bogus", "--help"], ["--size", "1", "-h"], ["--frames", "--help"], ["--list", "--help"],
                       ["pyramid", "gas", "--help"]):
            with self.subTest(beside=beside):
                self.assertEqual(run(*beside).stdout, result.stdout)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PLAY, RUN = (str(pathlib.Path(sys.argv.pop(1)).resolve()) for _ in range(2))
    if SHORT:
        sys.argv.remove("short")
    unittest.main()
