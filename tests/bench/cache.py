"""A repository checked without the cache, with an empty one, with a full one, and when one launch file has changed since.

``python -m tests.bench.cache DIRECTORY [--runs N] [--jobs N]``. What is checked is a copy in a temporary directory, with a
cache of its own.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from pathlib import Path
from statistics import median

from tests.bench.timing import launchlint, milliseconds, plain_environment, table, timed

CHANGED = "one file changed"


def main() -> int:
    """Measure, print, and return the exit status: 1 where the outputs differ."""
    parser = argparse.ArgumentParser(description="Time launchlint check with a cold and with a warm cache.")
    parser.add_argument("directory", type=Path, help="the repository to check")
    parser.add_argument("--runs", type=int, default=5, help="runs of each, by turns (default: 5)")
    parser.add_argument("--jobs", default="1", help="processes (default: 1, so that work is compared and not cores)")
    arguments = parser.parse_args()
    seconds: dict[str, list[float]] = {"no cache": [], "empty cache": [], "full cache": [], CHANGED: []}
    outputs = set()
    with tempfile.TemporaryDirectory() as place:
        copy = Path(place, "repository")
        shutil.copytree(arguments.directory, copy, symlinks=True)
        file = min(copy.rglob("*.launch"))
        check = ["check", "--exit-zero", "--jobs", arguments.jobs, str(copy)]
        for number in range(arguments.runs):
            environment = {**plain_environment(), "XDG_CACHE_HOME": str(Path(place, f"cache{number}"))}
            for name, series in seconds.items():
                if name == CHANGED:
                    file.write_bytes(file.read_bytes() + b"<!-- changed -->\n")
                run = timed(launchlint(*check, *(["--no-cache"] if name == "no cache" else [])), environment)
                if run.status:
                    raise SystemExit(f"launchlint check ended with status {run.status}")
                series.append(run.seconds)
                outputs.add(run.output)
    cold = median(seconds["empty cache"])
    rows = [
        [name, milliseconds(median(series)), milliseconds(min(series)), f"{cold / median(series):.2f}"] for name, series in seconds.items()
    ]
    print(f"{arguments.runs} runs of each, by turns, with --jobs {arguments.jobs}\n")
    print(table(["check", "median ms", "best ms", "speed against an empty cache"], rows))
    print("\nHow to read it: 'no cache' against 'empty cache' is what writing the cache costs; 'full cache' is what a second check takes.")
    print(f"'{CHANGED}': a comment was added to {file.relative_to(copy)}, which changes no finding.")
    if len(outputs) != 1:
        print("The outputs differ: the cache changed what was told, which it must never do.")
        return 1
    print("All runs printed the same bytes.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
