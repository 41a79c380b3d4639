"""Tests ./run release: two clones of a commit in different folders, with different times, modes and settings,
give the same bytes, times are the commit's, the source archive is the commit, and a tree with changes is
refused.

usage: test_release.py SOURCE [PART...]: the parts that are made; as a rule those that nothing is compiled for

Exits with 77 where SOURCE is not a repository of git, whose files are copied into a new one."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

from command import run

SOURCE, PARTS = Path(sys.argv[1]).resolve(), sys.argv[2:] or ["source", "one-file"]
TIME = 1700000000
GIT = ["git", "-c", "user.name=nobody", "-c", "user.email=nobody@example.invalid", "-c", "commit.gpgsign=false",
       "-c", "core.autocrlf=false"]
DATES = {"GIT_AUTHOR_DATE": f"{TIME} +0000", "GIT_COMMITTER_DATE": f"{TIME} +0000"}


def release(folder, *words, **more):
    return subprocess.run([folder / "run", "release", *words], capture_output=True, text=True, check=False,
                          env={**os.environ, **more})


def files_of(folder):
    made = folder / "build/release-files"
    return {str(path.relative_to(made)): path.read_bytes() for path in made.rglob("*") if path.is_file()}


class ReleaseTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held = tempfile.TemporaryDirectory()
        held = Path(cls.held.name)
        cls.first, cls.second = held / "first", held / "another folder"
        names = run("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", cwd=SOURCE)
        cls.names = sorted(name for name in names.split("\0") if (SOURCE / name).is_file())
        for name in cls.names:
            (cls.first / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / name, cls.first / name)
        run(*GIT, "init", "--quiet", cls.first)
        run(*GIT, "add", "--all", cwd=cls.first)
        run(*GIT, "commit", "--quiet", "--message", "All", cwd=cls.first, env={**os.environ, **DATES})
        run(*GIT, "clone", "--quiet", cls.first, cls.second, umask=0o077)
        run("git", "config", "tar.umask", "0077", cwd=cls.second)
        for name in cls.names[::7]:
            os.utime(cls.second / name, (1, 1))
        cls.done = [release(cls.first, *PARTS),
                    release(cls.second, *PARTS, TZ="Pacific/Auckland", SOURCE_DATE_EPOCH="99")]
        for done in cls.done:
            if done.returncode != 0:
                raise AssertionError(done.stdout + done.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.held.cleanup()

    def test_two_clones_give_the_same_bytes(self):
        first, second = files_of(self.first), files_of(self.second)
        self.assertEqual(list(first), list(second))
        self.assertGreater(len(first), len(PARTS))
        for name, content in first.items():
            self.assertTrue(content == second[name], f"{name} differs")

    def test_sums_are_those_of_the_files(self):
        files = files_of(self.first)
        sums = files.pop("SHA256SUMS").decode()
        self.assertEqual(sums, "".join(f"{hashlib.sha256(content).hexdigest()}  {name}\n"
                                       for name, content in sorted(files.items())))
        self.assertTrue(self.done[0].stdout.endswith(sums), self.done[0].stdout)

    def test_archives_are_sorted_and_of_the_commits_time(self):
        for path in (self.first / "build/release-files").rglob("*.tar.gz"):
            with tarfile.open(path) as archive:
                entries = archive.getmembers()
            self.assertEqual([entry.name for entry in entries], sorted(entry.name for entry in entries), path)
            self.assertEqual({(entry.mtime, entry.uid, entry.gid, entry.uname, entry.mode & 0o777 | 0o111)
                              for entry in entries}, {(TIME, 0, 0, "", 0o755)}, path)
            self.assertEqual(int.from_bytes(path.read_bytes()[4:8], "little"), TIME, path)

    def test_source_archive_is_the_commit(self):
        version = json.loads((SOURCE / "web/package/package.json").read_text(encoding="utf-8"))["version"]
        folder = f"thud-{version}"
        path = self.first / f"build/release-files/{folder}.tar.gz"
        with tarfile.open(path) as archive:
            self.assertEqual(sorted(entry.name for entry in archive), [f"{folder}/{name}" for name in self.names])
            for name in ("run", "engine/CMakeLists.txt", "assets/levels/" + os.listdir(SOURCE / "assets/levels")[0]):
                self.assertEqual(archive.extractfile(f"{folder}/{name}").read(), (SOURCE / name).read_bytes())
            self.assertEqual(archive.getmember(f"{folder}/run").mode, 0o755)

    def test_wrap_of_meson_is_of_the_source_archive(self):
        files = files_of(self.first)
        name, = (name for name in files if re.fullmatch(r"thud-[\d.]+\.tar\.gz", name))
        wrap = files["thud.wrap"].decode()
        self.assertIn(f"\ndirectory = {name[:-len('.tar.gz')]}\nsource_filename = {name}\n"
                      f"source_hash = {hashlib.sha256(files[name]).hexdigest()}\n", wrap)
        self.assertNotIn("@", wrap)

    def test_one_file_archive_has_headers_source_and_license(self):
        path, = (self.first / "build/release-files").glob("*-one-file.tar.gz")
        with tarfile.open(path) as archive:
            self.assertEqual([Path(entry.name).name for entry in archive],
                             ["LICENSE", "thud.c", "thud.h", "thud.hpp", "thud_recorded.h"])

    def test_crates_have_the_license(self):
        for path in (self.first / "build/release-files").glob("*.crate"):
            with tarfile.open(path) as archive:
                text = archive.extractfile(f"{path.stem}/LICENSE").read()
            self.assertEqual(text, (SOURCE / "LICENSE").read_bytes(), path)

    def test_changes_are_refused(self):
        made = files_of(self.second)
        (self.second / "new").write_text("", encoding="utf-8")
        done = release(self.second, "source")
        (self.second / "new").unlink()
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("not committed:\n?? new", done.stderr)
        self.assertEqual(files_of(self.second), made)

    def test_help_tells_of_every_part_and_others_are_refused(self):
        parts = re.findall(r"^  ([a-z-]+)  ", release(SOURCE, "--help").stdout, re.MULTILINE)
        self.assertEqual(parts, ["source", "one-file", "npm", "python", "rust", "site"])
        done = release(SOURCE, "source", "apk")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(f"no part 'apk', only: {' '.join(parts)}", done.stderr)


if __name__ == "__main__":
    if not shutil.which("git") or subprocess.run(["git", "rev-parse", "HEAD"], cwd=SOURCE, capture_output=True,
                                                 check=False).returncode != 0:
        print("skipped: this is not a repository of git")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
