"""Running commands by turns, and printing what that took."""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from statistics import median
from typing import NamedTuple

LAUNCHLINT_MAIN = "import sys; from launchlint.cli import main; sys.argv[0] = 'launchlint'; main()"
ROSLAUNCH_CHECK = ("/usr/share/roslaunch/scripts/roslaunch-check", "/opt/ros/noetic/share/roslaunch/scripts/roslaunch-check")


class Timed(NamedTuple):
    """One run: seconds on the clock, exit status, standard output."""

    seconds: float
    status: int
    output: bytes


class Series(NamedTuple):
    """All runs of one command: seconds of each, and the exit status of the last."""

    name: str
    seconds: tuple[float, ...]
    status: int

    @property
    def median(self) -> float:
        """Median of the runs, in seconds."""
        return median(self.seconds)


def launchlint(*arguments: str) -> list[str]:
    """The command line of the launchlint beside this Python."""
    script = Path(sys.executable).with_name("launchlint")
    start = [str(script)] if script.exists() else [sys.executable, "-c", LAUNCHLINT_MAIN]
    return [*start, *arguments]


def ros_python() -> str | None:
    """A Python that can import roslaunch; none where ROS 1 is not installed."""
    for name in ("/usr/bin/python3", "python3"):
        interpreter = shutil.which(name)
        if interpreter and subprocess.run([interpreter, "-c", "import roslaunch"], capture_output=True, check=False).returncode == 0:
            return interpreter
    return None


def roslaunch_check() -> list[str] | None:
    """The command line of roslaunch-check; none where it is not installed."""
    interpreter = ros_python()
    script = next(filter(os.path.exists, ROSLAUNCH_CHECK), None)
    return [interpreter, script] if interpreter and script else None


def plain_environment() -> dict[str, str]:
    """The environment for launchlint: this one, but Python may keep its compiled modules, as it does wherever launchlint is installed."""
    return {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def ros_environment(packages: Path) -> dict[str, str]:
    """The environment for every command compared: packages are looked for in ``packages``."""
    return {**plain_environment(), "ROS_PACKAGE_PATH": str(packages), "ROS_MASTER_URI": "http://localhost:11311"}


def timed(command: Sequence[str], environment: Mapping[str, str] | None = None, stdin: bytes = b"") -> Timed:
    """Run ``command`` once, its standard error thrown away."""
    variables = plain_environment() if environment is None else environment
    start = time.perf_counter()
    run = subprocess.run(command, env=variables, input=stdin, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    return Timed(time.perf_counter() - start, run.returncode, run.stdout)


def checked_here(directory: str, *options: str) -> str:
    """What ``launchlint check .`` writes of a directory, which becomes that of this process: for those that watch how it is worked out."""
    from launchlint.cli import main

    os.chdir(directory)
    sys.argv = ["launchlint", "check", "--no-cache", "--jobs", "1", "--exit-zero", *options, "."]
    written = io.StringIO()
    with contextlib.redirect_stdout(written), contextlib.suppress(SystemExit):
        main()
    return written.getvalue()


def require_output(run: Timed) -> None:
    """Stop where launchlint itself failed: it then ends with a status of its own, or with status 1 and nothing told."""
    if run.status not in (0, 1) or (run.status == 1 and not run.output):
        raise SystemExit(f"launchlint ended with status {run.status} and printed {len(run.output)} bytes: nothing to measure")


def by_turns(commands: Mapping[str, Sequence[str]], runs: int, environment: Mapping[str, str] | None = None) -> dict[str, Series]:
    """Run all ``commands`` A B C A B C …, ``runs`` times each after one round that is not counted."""
    seconds: dict[str, list[float]] = {name: [] for name in commands}
    status: dict[str, int] = {}
    for number in range(runs + 1):
        for name, command in commands.items():
            run = timed(command, environment)
            status[name] = run.status
            if number:
                seconds[name].append(run.seconds)
    return {name: Series(name, tuple(seconds[name]), status[name]) for name in commands}


def milliseconds(seconds: float) -> str:
    """Seconds as text in milliseconds."""
    return f"{seconds * 1000:,.1f}"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Rows of text in columns; the first column to the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
    lines = []
    for row in (head, ["-" * width for width in widths], *rows):
        cells = [
            cell.ljust(width) if number == 0 else cell.rjust(width) for number, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)
