"""Do time and size of the topology report grow with the launch, and no faster? 50, 500 and 5,000 nodes.

``python -m tests.bench.report``: the launch of :mod:`tests.bench.graph`, from reading it to the written page; processor seconds, once.
"""

from __future__ import annotations

import json
import os
import tempfile
import time
from pathlib import Path

from launchlint.cli.commands import run
from launchlint.report.html.page import SCRIPTS
from tests.bench.graph import PACKAGES, SIZES, launch_of
from tests.bench.timing import table


def write_launch(directory: Path, size: int) -> None:
    """``main.launch`` with ``size`` nodes, and ``library.json``."""
    launch_of(directory, size)
    (directory / "library.json").write_text(
        json.dumps({"format": "launchlint-library", "version": 1, "packages": PACKAGES}), encoding="utf-8"
    )


def measure(size: int) -> tuple[float, int]:
    """Seconds to make the page of ``size`` nodes, and its bytes."""
    here = os.getcwd()
    with tempfile.TemporaryDirectory() as name:
        write_launch(Path(name), size)
        os.chdir(name)
        try:
            started = time.process_time()
            run(["report", "--quiet", "-o", "report.html", "main.launch", "--library", "library.json", "--jobs", "1"])
            return time.process_time() - started, Path("report.html").stat().st_size
        finally:
            os.chdir(here)


def main() -> None:
    """Measure and print."""
    from importlib.resources import files

    scripts = sum(len(files("launchlint.report.html").joinpath("assets", name).read_bytes()) for name in SCRIPTS)
    measure(SIZES[0])  # the first run imports
    rows = []
    for size in SIZES:
        seconds, length = measure(size)
        rows.append([str(size), f"{seconds:.2f}", f"{1e3 * seconds / size:.2f}", f"{length / 1e6:.2f}", f"{(length - scripts) / size:.0f}"])
    print(table(["nodes", "s", "ms per node", "MB", "bytes per node without scripts"], rows))


if __name__ == "__main__":
    main()
