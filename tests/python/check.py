"""Makes the wheel of bindings/python as a newcomer does, installs it into an empty folder, and runs its
tests: check.py PROJECT CC.

The engine is compiled without optimisation, which takes a third of the time and gives the same bits, as
the golden hashes among the tests say. The sources are linked into a folder of their own, so that two
builds never meet."""

import os
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

PROJECT, CC = Path(sys.argv[1]).resolve(), sys.argv[2]


def run(*words, **more):
    subprocess.run([str(word) for word in words], check=True, **more)


with tempfile.TemporaryDirectory() as held:
    folder = Path(held)
    source, installed = folder / "bindings/python", folder / "installed"
    source.mkdir(parents=True)
    for name in ("engine", "tools", "LICENSE", "bindings/api.json"):
        (folder / name).symlink_to(PROJECT / name)
    for path in (PROJECT / "bindings/python").iterdir():
        if path.name not in ("build", "thud.egg-info", "LICENSE"):
            (source / path.name).symlink_to(path)
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    run(*pip, "wheel", "--no-index", "--no-deps", "--no-build-isolation", "--wheel-dir", folder, source,
        env={**os.environ, "CC": CC, "CFLAGS": "-O0 -Werror"})
    wheel = next(folder.glob("thud-*.whl"))
    with zipfile.ZipFile(wheel) as packed:
        licenses = [name for name in packed.namelist() if name.endswith("/LICENSE")]
        assert [packed.read(name) for name in licenses] == [(PROJECT / "LICENSE").read_bytes()], licenses
    run(*pip, "install", "--no-index", "--no-deps", "--target", installed, wheel)
    run(sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", source / "tests", cwd=folder,
        env={**os.environ, "PYTHONPATH": str(installed), "THUD_PROJECT": str(PROJECT), "MALLOC_PERTURB_": "90",
             "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "PYGAME_HIDE_SUPPORT_PROMPT": "1"})
