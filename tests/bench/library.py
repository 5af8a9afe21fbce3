"""A large library read anew and from its index, and what looking up a node costs in libraries of several sizes.

``python -m tests.bench.library [--nodes N] [--runs N]``. Library and index live in a temporary directory of their own.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

from launchlint.library.file import LibraryFile, open_library
from launchlint.library.lookup import Library
from tests.bench.timing import milliseconds, table

SIZES = (50, 500, 5_000)
IN_PACKAGE = 20


def library(nodes: int) -> dict[str, Any]:
    """A library with so many executables, each with twenty names, and nodelets; the same for the same number."""
    packages: dict[str, Any] = {}
    for number in range(nodes):
        package = packages.setdefault(f"package_{number // IN_PACKAGE:04}", {"executables": {}, "nodelets": {}})
        package["executables"][f"node_{number:05}"] = _program(number, "roscpp")
        if number % 5 == 0:
            package["nodelets"][f"package_{number // IN_PACKAGE:04}/Nodelet{number:05}"] = _program(number, "nodelet")
    return {"format": "launchlint-library", "version": 1, "packages": packages}


def _program(number: int, client: str) -> dict[str, Any]:
    evidence = [
        {"by": "dynamic", "run": f"run-{number:05}"},
        {"by": "static", "at": f"owner/repository@0a1b2c3d4e5f:package/src/node_{number:05}.cpp:{number % 997 + 1}"},
    ]
    topics = [
        {"name": f"topic_{index}", "type": "sensor_msgs/Image", "md5": "060021388200f6f0f447d0fcd9c64743", "queue": 10}
        for index in range(6)
    ]
    params = [{"name": f"~param_{index}", "type": "double", "default": index / 8} for index in range(8)]
    interface = {
        "publishers": [{**entry, "evidence": evidence} for entry in topics[:3]],
        "subscribers": [{**entry, "evidence": evidence} for entry in topics[3:]],
        "services": [{"name": f"~service_{index}", "type": "std_srvs/Empty", "evidence": evidence} for index in range(6)],
        "params": [{**entry, "evidence": evidence} for entry in params],
    }
    return {"class": client, "variants": {"default": interface}}


def best(function: Callable[[], object], runs: int) -> tuple[float, float]:
    """Median and best of some runs, in seconds."""
    seconds = []
    for _ in range(runs):
        start = time.perf_counter()
        function()
        seconds.append(time.perf_counter() - start)
    return median(seconds), min(seconds)


def lookup_microseconds(open_: Callable[[], LibraryFile], nodes: int, runs: int) -> float:
    """What the first question about a package costs, in a library just opened: the median over packages, best of the runs."""
    packages = nodes // IN_PACKAGE
    numbers = [number * IN_PACKAGE for number in range(0, packages, max(1, packages // 50))]
    found = []
    for _ in range(runs):
        known = Library([open_()], bundled=False)
        seconds = []
        for number in numbers:
            start = time.perf_counter()
            program = known.executable(f"package_{number // IN_PACKAGE:04}", f"node_{number:05}")
            seconds.append(time.perf_counter() - start)
            assert program is not None
        found.append(median(seconds))
    return min(found) * 1e6


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Time reading a library and looking into it.")
    parser.add_argument("--nodes", type=int, default=5_000, help="executables of the large library (default: 5000)")
    parser.add_argument("--runs", type=int, default=5, help="runs of each (default: 5)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as directory:
        path, cache = str(Path(directory, "library.json")), str(Path(directory, "cache"))
        text = json.dumps(library(arguments.nodes))
        Path(path).write_text(text, encoding="utf-8")
        anew = best(lambda: open_library(path), arguments.runs)
        open_library(path, cache)
        indexed = best(lambda: open_library(path, cache), arguments.runs)
        raw = best(lambda: json.loads(Path(path).read_bytes()), arguments.runs)
        rows = [
            [name, milliseconds(series[0]), milliseconds(series[1]), f"{raw[0] / series[0]:.2f}"]
            for name, series in (("json.loads alone", raw), ("open_library, no index", anew), ("open_library, indexed", indexed))
        ]
        print(f"a library of {arguments.nodes} executables, {len(text) / 2**20:.1f} MiB; {arguments.runs} runs of each\n")
        print(table(["read", "median ms", "best ms", "speed against json.loads"], rows))
        rows = []
        first = 0.0
        for size in SIZES:
            Path(path).write_text(json.dumps(library(size)), encoding="utf-8")
            open_library(path, cache)
            memory = lookup_microseconds(lambda: open_library(path), size, arguments.runs)
            index = lookup_microseconds(lambda: open_library(path, cache), size, arguments.runs)
            first = first or memory
            rows.append([f"{size:,} executables", f"{memory:.1f}", f"{index:.1f}", f"{memory / first:.2f}"])
    print()
    print(table(["first look at an executable in", "in memory µs", "indexed µs", "against the smallest"], rows))
    print(
        "\nHow to read it: an indexed library costs the digest of its file, whatever is in it; a look into it must not grow with its size."
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
