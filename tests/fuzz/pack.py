"""Packs kept inputs of a fuzzer into one file: pack.py pack FOLDER FILE, or pack.py unpack FILE
FOLDER.

A packed file contains for each input its length in four bytes, little-endian, and its bytes, in
the order of the inputs' names; replay.c reads it.
"""

import hashlib
import sys
from pathlib import Path


def pack(folder, file):
    inputs = [path.read_bytes() for path in sorted(Path(folder).iterdir())]
    Path(file).write_bytes(b"".join(len(i).to_bytes(4, "little") + i for i in inputs))
    print(f"{file}: {len(inputs)} inputs")


def unpack(file, folder):
    data = Path(file).read_bytes()
    Path(folder).mkdir(parents=True, exist_ok=True)
    at = 0
    while at < len(data):
        end = at + 4 + int.from_bytes(data[at:at + 4], "little")
        kept = data[at + 4:end]
        Path(folder, hashlib.sha1(kept).hexdigest()).write_bytes(kept)
        at = end


def main(arguments):
    ways = {"pack": pack, "unpack": unpack}
    if len(arguments) != 3 or arguments[0] not in ways:
        print(__doc__)
        return 2
    ways[arguments[0]](*arguments[1:])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
