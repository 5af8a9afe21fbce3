"""What one node may take of the machine, so that it is stopped before the others have nothing left."""

import os
import time
from typing import List, Optional, Tuple

from launchlint_probe import processes

MIB = 1024 * 1024
PAUSE = 0.25
"""Seconds between two looks at memory and disk: they take longer than others."""
MOST_FILES = 10_000


class Bounds:
    """Bytes of memory and on the disk, and processes. A file of the node is never larger than ``disk``: the kernel sees to that."""

    def __init__(self, memory: int = 1024 * MIB, disk: int = 256 * MIB, count: int = 128) -> None:
        self.memory = memory
        self.disk = disk
        self.count = count


class Usage:
    """Measures what a node takes. ``directory`` is its working directory, its home and its place for temporary files."""

    def __init__(self, bounds: Bounds, directory: str) -> None:
        self._bounds = bounds
        self._directory = directory
        self._next = 0.0

    def excess(self, alive: List[int]) -> Optional[Tuple[str, str]]:
        """Code and words where its processes take more than they may; None where all is well."""
        if len(alive) > self._bounds.count:
            return "too-many-processes", "it had more than {} processes".format(self._bounds.count)
        now = time.monotonic()
        if now < self._next:
            return None
        self._next = now + PAUSE
        if processes.memory(alive) > self._bounds.memory:
            return "too-much-memory", "it took more than {} MiB of memory".format(self._bounds.memory // MIB)
        if _size(self._directory) > self._bounds.disk:
            return "too-much-disk", "it wrote more than {} MiB".format(self._bounds.disk // MIB)
        return None


def _size(directory: str) -> int:
    """Bytes of the files in a directory and below it, of the first ones if there are very many."""
    total = looked = 0
    for folder, _, names in os.walk(directory):
        for name in names:
            looked += 1
            if looked > MOST_FILES:
                return total
            try:
                total += os.lstat(os.path.join(folder, name)).st_size
            except OSError:
                continue
    return total
