"""Many worlds, stepped at once over threads."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Iterable, List, Optional

from ._native import ffi, lib
from ._world import ThudError, World

# Parts for each thread, so that one that has finished early takes over from the others.
PARTS_PER_THREAD = 8


class Batch:
    """Worlds that are stepped together: each on one thread, many at once. Every world has the bits that
    it has alone."""

    def __init__(self, worlds: Iterable[World], threads: Optional[int] = None):
        """threads: by default one for each processor."""
        self.worlds: List[World] = list(worlds)
        if len(set(map(id, self.worlds))) != len(self.worlds):
            raise ValueError("a world stands twice in a batch")
        self.threads = threads or os.cpu_count() or 1
        if self.threads < 1:
            raise ValueError("a batch needs a thread")
        self._results = ffi.new("thud_result[]", max(len(self.worlds), 1))
        self._pool = ThreadPoolExecutor(self.threads) if self.threads > 1 else None

    def step(self, steps: int = 1) -> None:
        """Steps all worlds. If some fail, those are not stepped further and the others are; then the
        first failure is raised, and its text names the world's number."""
        pointers = ffi.new("thud_world *[]", [world.pointer for world in self.worlds])
        self._run(pointers, steps)
        for number, world in enumerate(self.worlds):
            if self._results[number] != lib.THUD_OK:
                try:
                    world._check(self._results[number])
                except ThudError as error:
                    raise ThudError(error.result, f"world {number}: {error}") from None

    def _run(self, pointers: Any, steps: int) -> None:
        count, worlds = len(self.worlds), list(self.worlds)

        def done(begin: int, end: int) -> None:
            for world in worlds[begin:end]:
                world._stepping = False

        def part(begin: int, end: int) -> None:
            try:
                lib.thud_py_step_all(pointers + begin, end - begin, steps, self._results + begin)
            finally:
                done(begin, end)

        for world in worlds:
            world._stepping = True
        if self._pool is None or count < 2:
            part(0, count)
            return
        size = -(-count // (self.threads * PARTS_PER_THREAD))
        waiting, begin = [], 0
        try:
            for begin in range(0, count, size):
                waiting.append((begin, self._pool.submit(part, begin, min(begin + size, count))))
            begin = count
            for _, one in waiting:
                one.result()
        except BaseException:
            # A part that runs, as after Ctrl-C, keeps its worlds refused until it ends.
            done(begin, count)
            for at, one in waiting:
                if one.cancel():
                    done(at, min(at + size, count))
            raise

    def close(self) -> None:
        """Ends the threads; the worlds stay."""
        if self._pool:
            self._pool.shutdown()
            self._pool = None

    def __enter__(self) -> "Batch":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()
