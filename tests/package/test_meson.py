"""Tests meson.build and the wrap: a project that has thud as a subproject finds it by dependency('thud'), with
the files and flags of CMake's build.

usage: test_meson.py SOURCE BUILD CC

With THUD_PACKAGES=full, which takes a minute or two, the project is built, with thud static and shared, and
its program refers to every public function and gives CMake's bits; so does one that finds thud by pkg-config
where Meson installed it. Exits with 77 where Meson is missing."""

import json
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import packed
from command import run

SOURCE, BUILD, CC = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), sys.argv[3]
FULL = os.environ.get("THUD_PACKAGES") == "full"
GAME = """project('game', 'c')
executable('game', 'game.c', dependencies: [dependency('thud'), dependency('thud-threads')])
"""


class MesonTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held = tempfile.TemporaryDirectory()
        cls.game = Path(cls.held.name)
        files = cls.game / "subprojects/packagefiles"
        files.mkdir(parents=True)
        name, total = packed.archive(SOURCE, files)
        wrap = (SOURCE / "packaging/meson/thud.wrap.in").read_text(encoding="utf-8")
        wrap = wrap.replace("@VERSION@", packed.version_of(SOURCE)).replace("@SHA256@", total)
        (cls.game / "subprojects/thud.wrap").write_text(wrap, encoding="utf-8")
        (cls.game / "meson.build").write_text(GAME, encoding="utf-8")
        (cls.game / "game.c").write_text(packed.program(SOURCE), encoding="utf-8")
        cls.setup("build", "--default-library=static")

    @classmethod
    def tearDownClass(cls):
        cls.held.cleanup()

    @classmethod
    def setup(cls, name, *words, source="."):
        return run("meson", "setup", "--wrap-mode=nodownload", *words, name, source, cwd=cls.game,
                   env={**os.environ, "CC": CC})

    def targets(self):
        found = json.loads(run("meson", "introspect", "--targets", "build", cwd=self.game))
        return {target["name"]: target["target_sources"][0] for target in found if target["name"] != "game"}

    def test_version_is_that_of_the_headers(self):
        version, = re.findall(r"version: '([\d.]+)'", (SOURCE / "meson.build").read_text(encoding="utf-8"))
        self.assertEqual(version, packed.version_of(SOURCE))

    def test_files_are_those_of_cmake(self):
        made = {name: sorted(re.search(r"/engine/(.*)", path)[1] for path in target["sources"])
                for name, target in self.targets().items()}
        listing = (SOURCE / "engine/CMakeLists.txt").read_text(encoding="utf-8")
        block = re.search(r"set\(THUD_SOURCES\n(.*?)\)", listing, re.DOTALL)[1]
        paths = re.findall(r"^\s*(src/\S+\.c)\b", block, re.MULTILINE)
        kernels = [path for path in paths if "/wide_" in path]
        self.assertEqual(made["thud"], sorted(set(paths) - set(kernels)))
        for name in set(made) - {"thud"}:
            self.assertEqual(made[name], sorted(kernels))
        archives = {path.stem for path in (BUILD / "engine/CMakeFiles").glob("thud-*.dir") if
                    path.stem != "thud-threads"}
        self.assertEqual(set(made), archives | {"thud"})

    def test_flags_that_decide_bits_are_those_of_cmake(self):
        helpers = (SOURCE / "cmake/thud.cmake").read_text(encoding="utf-8")
        wanted = re.findall(r"-f[\w=-]+", "".join(re.findall(r"target_compile_options\([^)]*\)", helpers)))
        self.assertIn("-ffp-contract=off", wanted)
        for name, target in self.targets().items():
            flags = target["parameters"]
            self.assertEqual([flag for flag in wanted if flag not in flags], [], name)
            self.assertIn("-std=c17", flags)
            self.assertEqual("-mavx2" in flags, name == "thud-avx2")

    @unittest.skipUnless(FULL, "THUD_PACKAGES is not full")
    def test_program_that_refers_to_every_function_gives_the_bits_of_cmake(self):
        run("meson", "compile", "-C", "build", cwd=self.game)
        said = run(self.game / "build/game")
        run(CC, "game.c", f"-I{SOURCE / 'engine/include'}", BUILD / "engine/libthud.a", "-lm", "-lpthread", "-o",
            "by_cmake", cwd=self.game)
        self.assertEqual(said, run(self.game / "by_cmake"))
        prefix = self.game / "prefix"
        self.setup("alone", "--default-library=shared", f"--prefix={prefix}", "--libdir=lib",
                   source=next((self.game / "subprojects").glob("thud-*")))
        run("meson", "install", "-C", "alone", cwd=self.game)
        words = run("pkg-config", "--cflags", "--libs", "thud", "thud-threads",
                    env={**os.environ, "PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}).split()
        run(CC, "game.c", *words, "-lm", f"-Wl,-rpath,{prefix / 'lib'}", "-o", "installed", cwd=self.game)
        self.assertEqual(said, run(self.game / "installed"))
        self.assertIn("libthud.so.0.2", run("ldd", self.game / "installed"))


if __name__ == "__main__":
    if not shutil.which("meson"):
        print("skipped: there is no meson")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
