"""Checks the rules of the project's structure on a source tree: house.py ROOT.

  order       a file of engine/src includes only files above it in the list of
              engine/CMakeLists.txt, and a stage no other stage; calls.py checks the same of calls
  listed      every file of engine/src has one line in that list, and every line has its file
  folders     docs/architecture.md has a row for each folder of engine/src
  cycles      no file includes itself, directly or through others
  public      a public header includes only public headers and headers of the C library
  outside     demo/ and web/ use the engine through its public headers only
  intrinsics  processor-specific code is only in engine/src/base/simd.h, but for the wait and the
              wake-up of WebAssembly, which C has not, in web/wasm/api_threads.c
  sources     the C files that the CMakeLists name are those that exist; only demo/scenes takes
              all of its files, so that a scene needs no line
  lock        a package-lock.json names versions, and no host that they were installed from
  changelog   CHANGELOG.md begins with the version of engine/include/thud/thud_version.h
  elsewhere   no text of web/ or tests/web names a folder of the machine that it was written on

Prints one line per breach and exits with 1 if there is any.
"""

import re
import sys
from collections import Counter
from pathlib import Path

from listing import LIST_FILE, read_listing

SOURCES = "engine/src"
WEB_TREES = ("web", "tests/web")
WEB_TEXTS = (".c", ".css", ".h", ".html", ".js", ".json", ".md", ".mjs", ".sh", ".ts")
LOCK_FILES = ("web/package-lock.json", "tests/web/bundlers/package-lock.json")
FROM_A_HOST = re.compile(r'"resolved": "\w+://')
ELSEWHERE = re.compile(r"(?<![\w.}])/(?:home|root|tmp|work)/")
WHOLE_FOLDER = "demo/scenes"
TREES = ("engine", "demo", "tests", "web")
SKIPPED = {"node_modules", "target", "dist", "build", "generated"}
VERSION, CHANGELOG = "engine/include/thud/thud_version.h", "CHANGELOG.md"
INTRINSICS_HOME = "engine/src/base/simd.h"
SLEEP_HOME = "web/wasm/api_threads.c"
SLEEP = re.compile(r"__builtin_wasm_memory_atomic_(?:wait32|notify)\b")
INTRINSICS = re.compile(
    r"\b(?:[a-z]*mmintrin|immintrin|x86intrin|arm_neon|arm_sve|wasm_simd128)\.h\b"
    r"|\b_mm(?:256|512)?_\w+\s*\("
    r"|\b__m(?:128|256|512)[di]?\b"
    r"|\bwasm_(?:[iuf]\d+x\d+|v128)_\w+\s*\("
    r"|\bv[a-z0-9]+q?(?:_n|_lane)?_[fsu](?:8|16|32|64)\s*\("
    r"|\b__builtin_(?:ia32|neon|wasm)_\w+")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"][^>"\n]*[>"]|\w+)', re.MULTILINE)
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\\n])*")', re.DOTALL)


def read(path):
    return path.read_text(encoding="utf-8")


def without_comments(text):
    return COMMENT.sub(lambda match: match.group(1) or " ", text)


def c_files(root):
    """Every C file of the project, as a path relative to the root."""
    found = []
    for tree in TREES:
        for path in sorted((root / tree).rglob("*")):
            relative = path.relative_to(root)
            if path.suffix in (".c", ".h", ".inl") and not SKIPPED & set(relative.parts):
                found.append(relative)
    return found


def web_texts(root):
    """All text files that people wrote for the page, its package and their tests, relative to the
    root."""
    return [path.relative_to(root)
            for tree in WEB_TREES for path in sorted((root / tree).rglob("*"))
            if path.suffix in WEB_TEXTS and not SKIPPED & set(path.relative_to(root).parts)
            and path.is_file()]


def resolve(root, includer, name):
    """The project's file that an include refers to; None for one from elsewhere."""
    places = [root / "engine/include", root / "engine/src", *sorted((root / "demo").glob("*/"))]
    if name.startswith('"'):
        places.insert(0, root / includer.parent)
    for place in places:
        candidate = (place / name[1:-1]).resolve()
        if candidate.is_file() and candidate.is_relative_to(root):
            return candidate.relative_to(root)
    return None


def include_graph(root, files):
    """{file: [(include as written, project file or None)]}"""
    return {file: [(name, resolve(root, file, name) if name[0] in '<"' else None)
                   for name in INCLUDE.findall(without_comments(read(root / file)))]
            for file in files}


def in_directory(file, directory):
    return file is not None and file.is_relative_to(directory)


def source_names(root):
    """Every file of engine/src, relative to that folder."""
    return sorted(path.relative_to(root / SOURCES).as_posix()
                  for path in (root / SOURCES).rglob("*") if path.is_file())


def check_listed(root, listing):
    names = source_names(root)
    lines = Counter(name for name, _ in listing)
    for name in names:
        if lines[name] != 1:
            yield f"listed: {SOURCES}/{name} has {lines[name]} lines in {LIST_FILE}, not 1"
    for name in sorted(set(lines) - set(names)):
        yield f"listed: {LIST_FILE} names src/{name}, which is not there"


def check_folders(root):
    folders = {Path(name).parent.as_posix() for name in source_names(root)}
    page = root / "docs/architecture.md"
    text = read(page) if page.is_file() else ""
    for folder in sorted(folders):
        if not re.search(rf"^\| `{re.escape(folder)}` \|", text, re.MULTILINE):
            yield f"folders: docs/architecture.md has no row for {SOURCES}/{folder}"


def check_order(graph, listing):
    place = {Path(SOURCES, name): i for i, (name, _) in enumerate(listing)}
    stages = {Path(SOURCES, name).with_suffix("") for name, stage in listing if stage}
    for file, includes in graph.items():
        if not in_directory(file, SOURCES):
            continue
        for name, target in includes:
            if name[0] not in '<"':
                yield f"order: {file} includes the macro {name}, which no reader can follow"
            elif name[0] == '"' and target is None:
                yield f"order: {file} includes {name}, which is not in the tree"
            if file not in place or target not in place:
                continue
            here, there = file.with_suffix(""), target.with_suffix("")
            if place[target] > place[file]:
                yield f"order: {file} includes {target}, which stands below it in the list"
            if here != there and here in stages and there in stages:
                yield f"order: the stage {file} includes the stage {target}"


def check_cycles(graph):
    done, trail = set(), []

    def visit(file):
        if file in trail:
            loop = trail[trail.index(file):] + [file]
            yield "cycles: " + " -> ".join(map(str, loop))
        elif file not in done:
            trail.append(file)
            for _, target in graph.get(file, ()):
                if target is not None:
                    yield from visit(target)
            trail.pop()
            done.add(file)

    for file in graph:
        yield from visit(file)


def check_public(graph):
    for file, includes in graph.items():
        if in_directory(file, "engine/include"):
            for name, target in includes:
                if not in_directory(target, "engine/include") and (target or name[0] != "<"):
                    yield f"public: {file} includes {name}, which is no public header"
        if in_directory(file, "demo") or in_directory(file, "web"):
            for name, target in includes:
                if in_directory(target, "engine/src"):
                    yield f"outside: {file} includes {name}, which is internal to the engine"


def check_intrinsics(root, files):
    for file in files:
        if file.as_posix() != INTRINSICS_HOME:
            text = without_comments(read(root / file))
            if file.as_posix() == SLEEP_HOME:
                text = SLEEP.sub("", text)
            found = INTRINSICS.search(text)
            if found:
                yield f"intrinsics: {file} has {found.group().rstrip('( ')}"


def check_sources(root, files):
    named = set()
    for tree in TREES:
        for cmake in sorted((root / tree).rglob("CMakeLists.txt")):
            text = re.sub(r"#[^\n]*", "", read(cmake))
            text = text.replace("${CMAKE_CURRENT_SOURCE_DIR}/", "")
            text = text.replace("${PROJECT_SOURCE_DIR}", str(root))
            for name in re.findall(r"[^\s()\"]+\.c(?=[\s)\"])", text):
                source = (cmake.parent / name).resolve()
                folder = cmake.parent.relative_to(root)
                if name == "*.c" and folder.as_posix() == WHOLE_FOLDER:
                    named.update(file for file in files
                                 if file.suffix == ".c" and file.parent == folder)
                elif "*" in name or "${" in name:
                    yield f"sources: {cmake.relative_to(root)} does not name {name} outright"
                elif source.is_relative_to(root):
                    named.add(source.relative_to(root))
    present = {file for file in files if file.suffix == ".c"}
    for file in sorted(present - named):
        yield f"sources: {file} is in no CMakeLists.txt"
    for file in sorted(named - present):
        yield f"sources: a CMakeLists.txt names {file}, which is not there"


def check_lock(root):
    for name in LOCK_FILES:
        lock = root / name
        if lock.is_file() and FROM_A_HOST.search(read(lock)):
            yield f"lock: {name} names a host; see omit-lockfile-registry-resolved in web/.npmrc"


def check_elsewhere(root):
    for file in web_texts(root):
        found = ELSEWHERE.search(read(root / file))
        if found:
            yield f"elsewhere: {file} has {found.group()}"


def check_changelog(root):
    numbers = re.findall(r"^#define THUD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", read(root / VERSION), re.MULTILINE)
    sections = re.findall(r"^## (\d+\.\d+\.\d+)\b", read(root / CHANGELOG), re.MULTILINE)
    if sections[:1] != [".".join(numbers)]:
        yield f"changelog: {CHANGELOG} begins with {', '.join(sections[:1])}, and {VERSION} has {'.'.join(numbers)}"


def breaches(root):
    root = root.resolve()
    listing = read_listing(read(root / LIST_FILE))
    files = c_files(root)
    graph = include_graph(root, files)
    return [*check_listed(root, listing), *check_folders(root), *check_order(graph, listing),
            *check_cycles(graph), *check_public(graph), *check_intrinsics(root, files),
            *check_sources(root, files), *check_lock(root), *check_changelog(root), *check_elsewhere(root)]


def main(arguments):
    if len(arguments) != 1 or arguments[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if arguments and arguments[0] in ("-h", "--help") else 2
    found = breaches(Path(arguments[0]))
    for line in found:
        print(line)
    print(f"{len(found)} breaches of the rules of the house")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
