"""Tests the crates of bindings/rust where there is cargo: the suite of the safe crate, the program of the
README, the example, warnings of the compiler, and that structs have the layout of C.

usage: check.py PROJECT LIBRARY CC BUILD

Exits with 77 where cargo, or the package `cc` that thud-sys is built with, is missing. The library is
linked as it is built; tests/package compiles the engine in one file, as build.rs does without it. What
cargo makes is kept in BUILD."""

import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT, LIBRARY, CC, BUILD = Path(sys.argv[1]).resolve(), Path(sys.argv[2]), sys.argv[3], Path(sys.argv[4])
sys.path.append(str(PROJECT / "tests/package"))
from command import run  # noqa: E402

API = json.loads((PROJECT / "bindings/api.json").read_text(encoding="utf-8"))
README = (PROJECT / "bindings/rust/README.md").read_text(encoding="utf-8")
SOURCE = BUILD / "source/bindings/rust"  # so that cargo's lock file stays out of the tree
ENVIRONMENT = {**os.environ, "CARGO_TARGET_DIR": str(BUILD / "target"), "THUD_LIB_DIR": str(LIBRARY.parent),
               "THUD_PROJECT": str(PROJECT), "RUSTFLAGS": "-D warnings", "CARGO_TERM_COLOR": "never"}


def cargo(*words):
    return run("cargo", *words, "--quiet", "--offline", cwd=SOURCE, env=ENVIRONMENT)


def copy():
    for path in sorted((PROJECT / "bindings/rust").rglob("*")):
        place = SOURCE / path.relative_to(PROJECT / "bindings/rust")
        if path.suffix in (".rs", ".toml") and "target" not in path.parts and \
                (not place.is_file() or place.read_bytes() != path.read_bytes()):
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, place)
    program = re.search(r"```rust\n(.*?)```", README, re.DOTALL)[1]
    (SOURCE / "thud/examples/readme.rs").write_text(program, encoding="utf-8")
    sizes = "".join(f'    println!("{name} {{}} {{}}", size_of::<sys::{name}>(), align_of::<sys::{name}>());\n'
                    + "".join(f'    println!("{name}.{field} {{}}", offset_of!(sys::{name}, r#{field}));\n'
                              for field in fields) for name, fields in structs())
    (SOURCE / "thud/examples/layout.rs").write_text(
        f"use std::mem::{{align_of, offset_of, size_of}};\nuse thud::sys;\nfn main() {{\n{sizes}}}\n", encoding="utf-8")


def structs():
    for entry in API["structs"]:
        if not entry["opaque"]:
            yield entry["name"], [field["name"] for field in entry["fields"]]


class RustTest(unittest.TestCase):
    def test_suite_of_the_crate(self):
        cargo("test")

    def test_program_of_the_readme_prints_what_it_says(self):
        said = re.findall(r"println!\(.*\); // (.*)", README)
        self.assertEqual((len(said), len(said)), (4, README.count("println!")))
        self.assertEqual(cargo("run", "--example", "readme").splitlines(), said)

    def test_example_falls_and_bounces(self):
        said = cargo("run", "--example", "falling")
        heights = [float(y) for y in re.findall(r" y (\S+)", said)]
        self.assertEqual((len(heights), heights[0]), (80, 6.0))
        self.assertLess(min(heights), 1)
        self.assertGreater(said.count("hit at"), 1)

    def test_structs_have_the_layout_of_c(self):
        lines = "".join(f'    printf("{name} %zu %zu\\n", sizeof({name}), _Alignof({name}));\n'
                        + "".join(f'    printf("{name}.{field} %zu\\n", offsetof({name}, {field}));\n'
                                  for field in fields) for name, fields in structs())
        program = BUILD / "layout.c"
        program.write_text("#include <stddef.h>\n#include <stdio.h>\n#include <thud/thud_all.h>\n"
                           f"int main(void) {{\n{lines}}}\n", encoding="utf-8")
        run(CC, "-std=c17", f"-I{PROJECT / 'engine/include'}", program, "-o", BUILD / "layout")
        said = run(BUILD / "layout")
        self.assertGreater(len(said.splitlines()), 500)
        self.assertEqual(cargo("run", "--example", "layout"), said)


if __name__ == "__main__":
    if not shutil.which("cargo"):
        print("skipped: cargo is missing (see rustup.rs)")
        sys.exit(77)
    BUILD.mkdir(parents=True, exist_ok=True)
    copy()
    found = subprocess.run(["cargo", "metadata", "--quiet", "--offline", "--format-version", "1"], cwd=SOURCE,
                           env=ENVIRONMENT, capture_output=True, check=False)
    if found.returncode != 0:
        print("skipped: the package cc is missing: run cargo fetch in bindings/rust")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
