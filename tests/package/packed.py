"""What the tests of packages share: the source archive of a release, and a program that refers to every
public function and lets a ball fall."""

import hashlib
import re
import sys
import tarfile
from pathlib import Path

sys.path.append(str(Path(__file__).parent.parent / "fuzz"))
from check_calls import declared  # noqa: E402

# What packages are built of; the source archive has all else, too.
BUILT_OF = ("CMakeLists.txt", "LICENSE", "cmake", "debian", "engine", "examples/embed.c", "meson.build", "packaging")
FALLS = """#include <stdio.h>
#include <thud/thud_all.h>
typedef void any(void);
any *all[] = {CALLS};
int main(void) {
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    thud_body_options moving = {.kind = THUD_BODY_DYNAMIC};
    thud_body_make(world, thud_aabb_at(0, -1, 20, 1), NULL);
    thud_body_make(world, thud_circle_at(0, 4, 0.5), &moving);
    for (int i = 0; i < 120; i++) {
        thud_world_step(world);
    }
    printf("%d functions, hash %016llx\\n", (int)(sizeof all / sizeof *all), (unsigned long long)thud_hash_of(world));
    thud_world_destroy(world);
    return 0;
}
"""


def version_of(source):
    text = (source / "engine/include/thud/thud_version.h").read_text(encoding="utf-8")
    return ".".join(re.findall(r"^#define THUD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text, re.MULTILINE))


def program(source):
    functions = sorted(declared(source / "engine/include/thud"))
    return FALLS.replace("CALLS", ", ".join(f"(any *){name}" for name in functions))


def archive(source, folder):
    """Makes thud-VERSION.tar.gz in a folder: its name and its sum."""
    name = f"thud-{version_of(source)}"
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz", compresslevel=1) as made:
        for path in BUILT_OF:
            made.add(source / path, f"{name}/{path}",
                     filter=lambda entry: None if "__pycache__" in entry.name else entry)
    return f"{name}.tar.gz", hashlib.sha256((folder / f"{name}.tar.gz").read_bytes()).hexdigest()
