"""What the scripts share that make files of the repository from others: writing them, or comparing."""

import argparse
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def parser_of(text):
    """A parser of the arguments of a script that `text` describes, in its first line."""
    parser = argparse.ArgumentParser(description=text.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help="write nothing; compare")
    return parser


def write(files, check, script, source="bindings/api.json"):
    """Writes the files, {path: text}, where they differ. With `check` it writes nothing and names those that
    differ. Returns the exit status: 1 where `check` found one."""
    old = [path for path, text in files.items()
           if not path.is_file() or path.read_text(encoding="utf-8") != text]
    for path in old:
        if check:
            print(f"{path.relative_to(ROOT)} is not what is made of {source}: run tools/{script}")
        else:
            path.write_text(files[path], encoding="utf-8")
    return 1 if check and old else 0
