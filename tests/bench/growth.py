"""Processor time and memory of ``check`` for each construct of a launch file, from 1,000 to 100,000 of it.

``python -m tests.bench.growth [--command check] [--sizes 1000,10000] [NAME…]``. The exponent is that of the last step, without what the
program itself takes. Ends with status 1 where it is above 1.2 (a text ten times as long may take 16 times as long), or a run takes more
than 1 GiB or 120 seconds. :mod:`tests.growth.test_growth` counts calls instead of seconds, and is what CI runs.
"""

from __future__ import annotations

import argparse
import os
import resource
import sys
import tempfile
from math import log
from pathlib import Path
from typing import NamedTuple

from tests.bench.timing import launchlint, plain_environment, table
from tests.growth import ros1, ros2, ros2_python
from tests.growth.workspace import Construct, build

SECONDS = 120
MEMORY = 1 << 30
STEEPEST = 1.2
SOON = 1.0
"""What takes no more seconds than this says nothing about growth."""


class Cost(NamedTuple):
    """Processor seconds and greatest resident memory in bytes; none where it was ended after :data:`SECONDS`."""

    seconds: float | None
    memory: int


def cost(command: list[str], directory: Path) -> Cost:
    """Run ``command`` in ``directory``, its output thrown away."""
    child = os.fork()
    if child == 0:
        os.chdir(directory)
        quiet = os.open(os.devnull, os.O_WRONLY)
        os.dup2(quiet, 1)
        os.dup2(quiet, 2)
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
        os.execve(command[0], command, plain_environment())
    _, status, usage = os.wait4(child, 0)
    ended = os.WIFSIGNALED(status)
    return Cost(None if ended else usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024)


def measure(construct: Construct, sizes: list[int], words: list[str]) -> list[Cost]:
    """What ``launchlint WORDS`` takes for each size, up to the first that is not ended in time."""
    found: list[Cost] = []
    for size in sizes:
        with tempfile.TemporaryDirectory() as directory:
            build(construct, size, Path(directory))
            found.append(cost([*launchlint(*words), construct.entry], Path(directory)))
        if found[-1].seconds is None:
            break
    return found


def exponent(sizes: list[int], costs: list[Cost], start: float) -> float | None:
    """The exponent of the last step; none where all takes little."""
    if len(costs) < 2 or costs[-1].seconds is None or costs[-2].seconds is None or costs[-1].seconds - start < SOON:
        return None
    grown = (costs[-1].seconds - start) / max(costs[-2].seconds - start, 0.01)
    return log(grown) / log(sizes[len(costs) - 1] / sizes[len(costs) - 2])


def main() -> int:
    """Print a line for each construct."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", default="check --no-cache --jobs 1", help="the command and its options")
    parser.add_argument("--sizes", default="1000,10000,100000")
    parser.add_argument("names", nargs="*", metavar="NAME")
    given = parser.parse_args()
    words = str(given.command).split()
    sizes = [int(size) for size in str(given.sizes).split(",")]
    with tempfile.TemporaryDirectory() as directory:
        start = cost(launchlint("--version"), Path(directory)).seconds or 0.0
    rows, bad = [], 0
    for construct in (*ros1.CONSTRUCTS, *ros2.CONSTRUCTS, *ros2_python.CONSTRUCTS):
        if given.names and construct.name not in given.names:
            continue
        tried = [size for size in sizes if size <= construct.most] or [construct.most]
        costs = measure(construct, tried, words)
        power = exponent(tried, costs, start)
        memory = max(each.memory for each in costs)
        bad += (power or 0) > STEEPEST or memory > MEMORY or costs[-1].seconds is None
        told = [f"over {SECONDS}" if each.seconds is None else f"{each.seconds:.2f}" for each in costs]
        rows.append((construct.name, *told, *[""] * (len(sizes) - len(told)), "" if power is None else f"{power:.2f}", f"{memory >> 20}"))
        print(*rows[-1], sep="\t", file=sys.stderr, flush=True)
    print(table(("construct", *(f"{size:,}: s" for size in sizes), "exponent", "MiB"), rows))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
