"""Packs files into an archive of the same bytes on every machine: sorted, without owners, each file of the
time SOURCE_DATE_EPOCH (seconds since 1970; required).

usage: archive.py OUT.tar.gz NAME PATH...

Each PATH is a file, or a folder with all that it holds; in the archive its files stand in the folder NAME. If
NAME ends in .tar or .tar.gz, the files of that archive are packed, and there is no PATH."""

import gzip
import io
import os
import sys
import tarfile
from pathlib import Path

TIME = int(os.environ["SOURCE_DATE_EPOCH"])


def in_folder(name, paths):
    """(name in the archive, TarInfo, bytes) of files"""
    for path in map(Path, paths):
        for file in path.rglob("*") if path.is_dir() else [path]:
            inside = file.relative_to(path) if path.is_dir() else file.name
            if file.is_symlink() or file.is_file():
                with tarfile.TarFile(fileobj=io.BytesIO(), mode="w") as one:
                    info = one.gettarinfo(file, f"{name}/{inside}")
                yield info, file.read_bytes() if info.isfile() else b""


def in_archive(path):
    with tarfile.open(path) as archive:
        for info in archive:
            if not info.isdir():
                yield info, archive.extractfile(info).read() if info.isfile() else b""


def pack(out, entries):
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for old, content in sorted(entries, key=lambda entry: entry[0].name):
            info = tarfile.TarInfo(old.name)
            info.mtime = TIME
            info.mode = 0o755 if old.mode & 0o100 else 0o644
            if old.isfile():
                info.size = len(content)
            elif old.issym():
                info.type, info.linkname = tarfile.SYMTYPE, old.linkname
            else:
                raise SystemExit(f"archive: {old.name} is neither a file nor a symbolic link")
            archive.addfile(info, io.BytesIO(content))
    out.write_bytes(gzip.compress(packed.getvalue(), mtime=TIME))


def main():
    out, name, *paths = sys.argv[1:]
    pack(Path(out), list(in_folder(name, paths) if paths else in_archive(name)))


if __name__ == "__main__":
    main()
