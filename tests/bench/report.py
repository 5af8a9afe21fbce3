"""Do time and size of the topology report grow with the launch, and no faster? 50, 500 and 5,000 nodes; and is it quick for a repository?

``python -m tests.bench.report``: the launch of :mod:`tests.bench.graph`, from reading it to the written page; processor seconds, once.
``python -m tests.bench.report DIRECTORY…``: of each repository, by turns, the processor seconds of ``check`` and of ``report``, the ratio,
and (where Chromium is) the processor milliseconds until the page can be used, and until the first launch file on it is opened.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from launchlint.cli.commands import run
from launchlint.report.html.page import SCRIPTS
from tests.bench.graph import PACKAGES, SIZES, launch_of
from tests.bench.timing import table

TURNS = 3


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


def spent(directory: Path, *words: str) -> float:
    """Processor seconds of a run of launchlint."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-m", "launchlint", *words], cwd=directory, capture_output=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def opening(page: Path) -> tuple[str, str]:
    """Processor milliseconds of the page's thread until it can be used, and until its first card is opened."""
    from playwright.sync_api import sync_playwright

    from tests.bench.report_drawing import ready
    from tests.conftest import find_chromium

    executable = find_chromium()
    if executable is None:
        return "", ""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=["--no-sandbox"])
        landing = median(ready(browser, page)[1] for _ in range(TURNS))
        opened = median(ready(browser, page, "#hubs=no")[1] for _ in range(TURNS))
        browser.close()
    return f"{landing:.0f}", f"{opened:.0f}"


def compare(directory: Path) -> list[str]:
    """The row of one repository."""
    with tempfile.TemporaryDirectory() as name:
        page = Path(name, "report.html")
        checks, reports = [], []
        for _ in range(TURNS):
            checks.append(spent(directory, "check", "--no-cache", "--jobs", "1", "."))
            reports.append(spent(directory, "report", "--quiet", "--jobs", "1", "-o", str(page), "."))
        check, report = median(checks), median(reports)
        size = f"{page.stat().st_size / 1e6:.1f}"
        return [directory.name, f"{check:.2f}", f"{report:.2f}", f"{report / check:.2f}", size, *opening(page)]


def main() -> None:
    """Measure and print."""
    if sys.argv[1:]:
        heads = ["repository", "check s", "report s", "ratio", "MB", "ready ms", "opened ms"]
        print(table(heads, [compare(Path(each).resolve()) for each in sys.argv[1:]]))
        return
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
