"""Builds the package: the engine is compiled from the project's sources, and every declaration is
made from bindings/api.json. Needs a C compiler, and a checkout of the whole project or a source
distribution, which has thud.c, thud.h and api.json beside this file."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

from cffi import FFI
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

HERE = Path(__file__).absolute().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))

import declare  # noqa: E402

PACKED = (HERE / "thud.c").is_file()
API_FILE = HERE / "api.json" if PACKED else ROOT / "bindings/api.json"
API = json.loads(API_FILE.read_text(encoding="utf-8"))
MADE = HERE / "build/made"
if not PACKED:
    shutil.copyfile(ROOT / "LICENSE", HERE / "LICENSE")  # setuptools packs only what stands in this folder


def engine_to(folder):
    """Writes thud.c and thud.h, the engine in one file."""
    folder.mkdir(parents=True, exist_ok=True)
    if PACKED:
        for name in ("thud.c", "thud.h"):
            shutil.copyfile(HERE / name, folder / name)
    else:
        subprocess.run([sys.executable, "-B", ROOT / "tools/amalgamate.py", "--source", ROOT, folder],
                       check=True)


class PackSources(sdist):
    """Packs what is made of the project's other folders, and no file of an earlier build."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, [name for name in files if not name.startswith("build/")])
        folder = Path(base_dir)
        engine_to(MADE)
        for source in (MADE / "thud.c", MADE / "thud.h", API_FILE, HERE / "declare.py", HERE / "helper.c",
                       HERE / "helper.h", HERE / "LICENSE" if PACKED else ROOT / "LICENSE"):
            (folder / source.name).unlink(missing_ok=True)  # it may be a link to the source
            shutil.copyfile(source, folder / source.name)


class BuildWithRecords(build_py):
    """Adds thud/_records.py, the enums and structs of the headers as Python types."""

    def run(self):
        super().run()
        folder = Path(self.get_package_dir("thud") if self.editable_mode else
                      Path(self.build_lib) / "thud")
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "_records.py").write_text(declare.records(API), encoding="utf-8")


class BuildNative(build_ext):
    """Makes the sources of thud._native: the engine in one file, and calls of all public functions."""

    def build_extensions(self):
        engine_to(MADE)
        builder = FFI()
        builder.cdef(declare.cdef(API) + declare.CALLED + (HERE / "helper.h").read_text(encoding="utf-8"))
        builder.set_source("thud._native", '#include "thud.h"\n#include "helper.c"\n')
        builder.emit_c_code(str(MADE / "native.c"))
        super().build_extensions()


numbers = {entry["name"]: entry["value"] for entry in API["constants"]}
extension = Extension(
    "thud._native", sources=[str((MADE / name).relative_to(HERE)) for name in ("native.c", "thud.c")],
    include_dirs=[str(MADE), str(HERE)], libraries=["m"],
    # The engine's own flags; and cffi takes addresses of constants.
    extra_compile_args=["-std=c17", "-ffp-contract=off", "-fno-math-errno", "-Wno-psabi",
                        "-Wno-discarded-qualifiers", "-Wno-unknown-warning-option",
                        "-Wno-incompatible-pointer-types-discards-qualifiers"])
setup(version=".".join(str(numbers[f"THUD_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH")),
      ext_modules=[extension], cmdclass={"build_ext": BuildNative, "build_py": BuildWithRecords, "sdist": PackSources})
