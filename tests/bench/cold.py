"""One cold check of one launch file, against what people run today on the same file, and against a Python that does nothing or
imports what most command lines do.

``python -m tests.bench.cold [FILE] [--runs N]``
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

from tests.bench.timing import (
    by_turns,
    launchlint,
    milliseconds,
    require_output,
    ros_environment,
    ros_python,
    roslaunch_check,
    table,
    timed,
)

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
EXAMPLE = "turtles/turtle_parade/launch/parade.launch"
NODES = "import sys, roslaunch; sys.argv[0] = 'roslaunch'; roslaunch.main()"


def package_directory(file: Path) -> Path:
    """Where the packages beside the one that holds ``file`` are."""
    return next((parent.parent for parent in file.parents if (parent / "package.xml").exists()), file.parent)


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Time one cold check of one launch file against its peers.")
    parser.add_argument("file", nargs="?", type=Path, help="the launch file (default: the bundled example, in a repository of its own)")
    parser.add_argument("--runs", type=int, default=15, help="counted runs of each command (default: 15)")
    arguments = parser.parse_args()
    if arguments.file is not None:
        measure(arguments.file.resolve(), arguments.runs)
        return 0
    with tempfile.TemporaryDirectory() as directory:
        # Where it lies, the repository around it is launchlint's own, with the packages of all its test cases.
        shutil.copytree(EXAMPLES, Path(directory, "repository"))
        Path(directory, "repository", ".git").mkdir()
        measure(Path(directory, "repository", EXAMPLE), arguments.runs)
    return 0


def measure(file: Path, runs: int) -> None:
    """Measure one launch file, and print."""
    name = str(file)
    commands = {
        "python -c pass": [sys.executable, "-c", "pass"],
        "python -c 'import click, yaml'": [sys.executable, "-c", "import click, yaml"],
        "launchlint check": launchlint("check", "--no-cache", name),
    }
    require_output(timed(commands["launchlint check"]))
    interpreter, checker = ros_python(), roslaunch_check()
    if interpreter:
        commands["roslaunch --nodes"] = [interpreter, "-c", NODES, "--nodes", name]
    if checker:
        commands["roslaunch-check"] = [*checker, name]
    results = by_turns(commands, runs, ros_environment(package_directory(file)))
    own = results["launchlint check"].median
    rows = [
        [series.name, milliseconds(series.median), milliseconds(min(series.seconds)), f"{series.median / own:.2f}", str(series.status)]
        for series in results.values()
    ]
    print(f"{runs} runs of each, by turns, on {file.name}\n")
    print(table(["command", "median ms", "best ms", "times launchlint", "exit status"], rows))
    print("\nHow to read it: 'times launchlint' is how many cold checks fit into one run of that command; larger is better for launchlint.")
    print("The difference between 'launchlint check' and 'python -c pass' is what launchlint itself costs; the rest is Python's own start.")
    if not (interpreter and checker):
        print("roslaunch is not installed here, so there is nothing to compare with (Debian: python3-roslaunch, python3-rostest).")


if __name__ == "__main__":
    sys.exit(main())
