"""Checks that the fuzzer calls the whole API: check_calls.py NM HEADERS LIBRARY.

Compares the functions that the public headers declare with the undefined symbols of the library
of operations. Prints one line for each function that no operation calls, and exits with 1 if
there is any.
"""

import re
import subprocess
import sys
from pathlib import Path

COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
# A declaration ends in ");", and types of callbacks do not have names of the form `thud_x(`.
FUNCTION = re.compile(r"\b(thud_\w+)\s*\([^;{}]*\)\s*;")


def declared(headers):
    found = set()
    # thud_recorded.h has other names for functions of the other headers.
    for path in sorted(set(headers.glob("*.h")) - {headers / "thud_recorded.h"}):
        text = COMMENT.sub(" ", path.read_text(encoding="utf-8"))
        text = re.sub(r"\btypedef\b[^;{]*;", " ", text)
        found.update(FUNCTION.findall(text))
    return found


def called(nm, library):
    output = subprocess.run([nm, "--undefined-only", library], check=True, capture_output=True,
                            text=True).stdout
    return {line.split()[-1].lstrip("_") for line in output.splitlines() if " U " in line}


def main(nm, headers, library):
    names, calls = declared(Path(headers)), called(nm, library)
    missing = sorted(names - calls)
    for name in missing:
        print(f"tests/fuzz: no operation calls {name}")
    print(f"{len(names)} public functions, {len(missing)} of which no operation calls")
    return 1 if missing or not names else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
