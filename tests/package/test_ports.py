"""Tests the packages of Debian, Conan and vcpkg: versions and licenses are thud's, and vcpkg's port finds what
CMake installs.

usage: test_ports.py SOURCE BUILD CC CONAN

With THUD_PACKAGES=full, which takes some minutes, the packages of Debian and Conan are built of a source archive
in a clean folder, and a program that refers to every public function gives the bits of CMake's build with each.
vcpkg itself is not tried: its functions are played (vcpkg.cmake)."""

import json
import os
import re
import shutil
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

import packed
from command import run

SOURCE, BUILD, CC, CONAN = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), *sys.argv[3:]
VERSION = packed.version_of(SOURCE)
FULL = os.environ.get("THUD_PACKAGES") == "full"
full = unittest.skipUnless(FULL, "THUD_PACKAGES is not full")


def text_of(path):
    return (SOURCE / path).read_text(encoding="utf-8")


def words(text):
    return " ".join(text.replace("\n .\n", "\n\n").split())


class PortsTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def unpacked(self):
        """A clean folder of the source archive."""
        name, _ = packed.archive(SOURCE, self.folder)
        with tarfile.open(self.folder / name) as archive:
            archive.extractall(self.folder)
        return self.folder / f"thud-{VERSION}"

    def said_by_cmake(self):
        """What the program says that is linked to the library of CMake's build."""
        (self.folder / "game.c").write_text(packed.program(SOURCE), encoding="utf-8")
        run(CC, "game.c", f"-I{SOURCE / 'engine/include'}", BUILD / "engine/libthud.a", "-lm", "-lpthread", "-o",
            "by_cmake", cwd=self.folder)
        return run(self.folder / "by_cmake")

    def test_versions_are_those_of_the_headers(self):
        self.assertTrue(text_of("debian/changelog").startswith(f"thud ({VERSION}) "))
        self.assertEqual(json.loads(text_of("packaging/vcpkg/thud/vcpkg.json"))["version-semver"], VERSION)
        self.assertIn(f"requires thud/{VERSION},", text_of("packaging/conan/conanfile.py"))

    def test_license_of_debian_is_that_of_the_project(self):
        license_text = text_of("LICENSE")
        self.assertIn(words(license_text[license_text.index("Permission"):]), words(text_of("debian/copyright")))
        self.assertIn(re.search(r"Copyright \(c\) (.*)", license_text)[1], text_of("debian/copyright"))

    def test_port_of_vcpkg_finds_what_is_installed(self):
        made = self.folder / "made"
        run("cmake", f"-DPORT={SOURCE / 'packaging/vcpkg/thud/portfile.cmake'}", f"-DPACKAGES={made}",
            f"-DBUILD={BUILD}", "-P", Path(__file__).parent / "vcpkg.cmake",
            env={**os.environ, "CC": CC})
        files = {str(path.relative_to(made)) for path in made.rglob("*") if path.is_file()}
        headers = {f"include/thud/{path.name}" for path in (SOURCE / "engine/include/thud").iterdir()}
        share = {f"share/thud/{name}" for name in ("copyright", "thud-config.cmake", "thud-config-version.cmake",
                                                   "thud-targets.cmake", "thud-targets-release.cmake")}
        self.assertEqual(files, headers | share | {"lib/libthud.a", "lib/pkgconfig/thud.pc",
                                                   "lib/pkgconfig/thud-threads.pc"})
        self.assertEqual((made / "share/thud/copyright").read_text(), text_of("LICENSE"))
        cache = Path(f"{made}-build/CMakeCache.txt").read_text(encoding="utf-8")
        for setting in ("THUD_DEMO:BOOL=OFF", "THUD_TESTS:BOOL=OFF", "THUD_INSTALL:BOOL=ON"):
            self.assertIn(f"\n{setting}\n", cache)
        # The helpers that the port calls are of the ports that its manifest names.
        port = text_of("packaging/vcpkg/thud/portfile.cmake")
        of_ports = {"vcpkg_cmake_configure": "vcpkg-cmake", "vcpkg_cmake_install": "vcpkg-cmake",
                    "vcpkg_cmake_config_fixup": "vcpkg-cmake-config"}
        needed = {of_ports[name] for name in re.findall(r"^(\w+)\(", port, re.MULTILINE) if name in of_ports}
        manifest = json.loads(text_of("packaging/vcpkg/thud/vcpkg.json"))
        self.assertEqual({each["name"] for each in manifest["dependencies"]}, needed)

    @full
    @unittest.skipUnless(shutil.which("dpkg-buildpackage"), "this is no Debian")
    def test_package_of_debian(self):
        tree = self.unpacked()
        run("dpkg-buildpackage", "-us", "-uc", cwd=tree)
        changes, = self.folder.glob("*.changes")
        run("lintian", "--allow-root", "--fail-on", "error,warning", changes)
        package, = self.folder.glob("libthud-dev_*.deb")
        run("dpkg-deb", "--extract", package, self.folder / "root")
        found, = (self.folder / "root").rglob("pkgconfig")
        said = self.said_by_cmake()
        flags = run("pkg-config", "--cflags", "--libs", "thud", "thud-threads",
                    env={**os.environ, "PKG_CONFIG_PATH": str(found), "PKG_CONFIG_SYSROOT_DIR": str(self.folder / "root"),
                         "PKG_CONFIG_ALLOW_SYSTEM_CFLAGS": "1", "PKG_CONFIG_ALLOW_SYSTEM_LIBS": "1"})
        run(CC, "game.c", *flags.split(), "-o", "game", cwd=self.folder)
        self.assertEqual(run(self.folder / "game"), said)

    @full
    def test_package_of_conan(self):
        tree = self.unpacked()
        said = self.said_by_cmake()
        shutil.copy(self.folder / "game.c", tree / "examples/embed.c")
        home = {**os.environ, "CONAN_HOME": str(self.folder / "conan"), "CC": CC}
        run(CONAN, "profile", "detect", env=home)
        for shared in ("False", "True"):
            made = run(CONAN, "create", tree / "packaging/conan", "--no-remote", "-o", f"thud/*:shared={shared}",
                       env=home)
            self.assertIn(f"\n{said}", made)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
