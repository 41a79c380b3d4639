"""Tests thud-matrix: test_program.py PROGRAM. Runs that continue from its snapshots end with the
same hashes, its plain form contains everything of a scene, and invalid input is refused."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHORT = ["--steps", "20", "--bodies", "60"]
LEVELS = ["assets/levels/quarry.tmj", "tests/levels/maps/hills.tmx"]


class ProgramTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = Path(place.name)
        cls.made = cls.start("--make-plain", cls.at("levels"), *LEVELS)
        cls.whole = cls.start(*SHORT, "--plain", cls.at("levels"), "--take", cls.at("snapshots"),
                              "--keep", cls.at("kept"))

    @classmethod
    def at(cls, name):
        return str(cls.place / name)

    @staticmethod
    def start(*words):
        return subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=ROOT, check=False)

    def test_every_scene_setting_and_level_has_its_line(self):
        self.assertEqual((self.made.returncode, self.whole.returncode), (0, 0), self.whole.stderr)
        golden = (ROOT / "tests/golden/hashes.txt").read_text(encoding="utf-8").split("\n")
        names = [line.split()[0] for line in golden if line]
        wanted = [f"{kind} {name}" for kind in ("scene", "exact", "swept") for name in names]
        wanted += [f"level {Path(path).name}" for path in LEVELS]
        lines = self.whole.stdout.splitlines()
        self.assertEqual([line.rsplit(" ", 1)[0] for line in lines], wanted)
        for line in lines:
            self.assertRegex(line, " [0-9a-f]{16}$")

    def test_settings_are_settings(self):
        runs = dict(line.rsplit(" ", 1) for line in self.whole.stdout.splitlines())
        self.assertNotEqual(runs["exact gas"], runs["swept gas"])
        longer = self.start("--steps", "22", *SHORT[2:]).stdout.splitlines()
        self.assertNotEqual(longer[0].split()[2], runs["scene pyramid"])

    def test_snapshots_continue(self):
        done = self.start(*SHORT, "--plain", self.at("levels"), "--continue", self.at("snapshots"))
        self.assertEqual(done.stdout, self.whole.stdout)

    def test_baseline_has_the_same_hashes(self):
        done = self.start(*SHORT, "--baseline", "--plain", self.at("levels"))
        self.assertEqual(done.stdout, self.whole.stdout)

    def test_plain_scenes_are_the_scenes(self):
        done = self.start(*SHORT, "--no-scenes", "--plain", self.at("kept"))
        self.assertEqual(done.stdout, self.whole.stdout)

    def test_damaged_snapshots_are_refused_by_their_reason(self):
        data = bytearray((self.place / "snapshots").read_bytes())
        data[4000] ^= 1
        (self.place / "damaged").write_bytes(data)
        done = self.start(*SHORT, "--continue", self.at("damaged"))
        self.assertTrue(done.stdout.startswith("scene pyramid refused: restore: "), done.stdout[:90])
        self.assertEqual(done.stdout.count("refused"), 1)

    def test_snapshots_that_are_packed_to_other_bytes_are_noticed(self):
        data = bytearray((self.place / "snapshots").read_bytes())
        at = 0
        for _ in range(2):  # the snapshot, and the one before
            at += 8 + int.from_bytes(data[at:at + 8], "little")
        data[at + 100] ^= 1
        (self.place / "packed").write_bytes(data)
        done = self.start(*SHORT, "--continue", self.at("packed"))
        self.assertTrue(done.stdout.startswith("scene pyramid refused: its snapshot is packed to other"),
                        done.stdout[:90])

    def test_recordings_are_played(self):
        data = bytearray((self.place / "snapshots").read_bytes())
        at = 0
        for _ in range(3):  # the snapshot, the one before, and what is packed
            at += 8 + int.from_bytes(data[at:at + 8], "little")
        self.assertEqual(data[at + 8:at + 15], b"thudrec")
        data[at + 200] ^= 1
        (self.place / "recorded").write_bytes(data)
        done = self.start(*SHORT, "--continue", self.at("recorded"))
        self.assertTrue(done.stdout.startswith("scene pyramid refused: player: the recording is damaged"),
                        done.stdout[:90])
        self.assertEqual(done.stdout.count("refused"), 1)

    def test_damaged_plain_scenes_are_refused(self):
        text = (self.place / "levels").read_text(encoding="utf-8")
        for wrong in (text[:-5], text.replace("0", "x", 1), "level\n"):
            (self.place / "wrong").write_text(wrong, encoding="utf-8")
            done = self.start(*SHORT, "--no-scenes", "--plain", self.at("wrong"))
            self.assertEqual(done.returncode, 1)
            self.assertIn("no scenes in plain form", done.stderr)

    def test_wrong_words_are_refused(self):
        for words in (["--steps", "3"], ["--steps"], ["--nothing", "1"], ["level.tmj"], ["--bodies", "0"],
                      ["--take", "a", "--continue", "b"]):
            self.assertEqual(self.start(*words).returncode, 2, words)
        self.assertEqual(self.start("--plain", self.at("nowhere")).returncode, 1)
        self.assertEqual(self.start("--make-plain", self.at("a"), "nowhere.tmj").returncode, 1)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop()
    unittest.main()
