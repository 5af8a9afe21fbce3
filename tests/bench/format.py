"""One cold format of one launch file, as on every save, against one cold check of it.

``python -m tests.bench.format [FILE] [--runs N]``
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

from tests.bench.cold import EXAMPLE, EXAMPLES
from tests.bench.timing import by_turns, launchlint, milliseconds, plain_environment, require_output, table, timed

LARGEST_RATIO = 1.5


def main() -> int:
    """Measure, print, and return the exit status: 1 where formatting takes more than 1.5 times as long as checking."""
    parser = argparse.ArgumentParser(description="Time one cold format of one launch file against one cold check of it.")
    parser.add_argument("file", nargs="?", type=Path, help="the launch file (default: the bundled example, in a repository of its own)")
    parser.add_argument("--runs", type=int, default=15, help="counted runs of each command (default: 15)")
    arguments = parser.parse_args()
    if arguments.file is not None:
        return measure(arguments.file.resolve(), arguments.runs)
    with tempfile.TemporaryDirectory() as directory:
        shutil.copytree(EXAMPLES, Path(directory, "repository"))
        Path(directory, "repository", ".git").mkdir()
        return measure(Path(directory, "repository", EXAMPLE), arguments.runs)


def measure(file: Path, runs: int) -> int:
    """Measure one launch file, and print."""
    name = str(file)
    commands = {
        "python -c pass": [sys.executable, "-c", "pass"],
        "launchlint check": launchlint("check", "--no-cache", name),
        "launchlint format --check": launchlint("format", "--check", name),
        "launchlint format --diff": launchlint("format", "--diff", name),
    }
    require_output(timed(commands["launchlint format --diff"]))
    results = by_turns(commands, runs, plain_environment())
    check = results["launchlint check"].median
    rows = [
        [series.name, milliseconds(series.median), milliseconds(min(series.seconds)), f"{series.median / check:.2f}", str(series.status)]
        for series in results.values()
    ]
    print(f"{runs} runs of each, by turns, on {file.name}\n")
    print(table(["command", "median ms", "best ms", "times a check", "exit status"], rows))
    print(f"\nHow to read it: format --check does all that format does but the writing, and may take {LARGEST_RATIO} times a check.")
    return int(results["launchlint format --check"].median > LARGEST_RATIO * check)


if __name__ == "__main__":
    sys.exit(main())
