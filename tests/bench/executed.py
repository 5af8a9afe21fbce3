"""What does a launch file cost that is executed, in ROS 1 and in ROS 2?

``python -m tests.bench.executed DIRECTORY…`` checks each directory in one run, in a process of its own. An entry file executes those that
it includes, in every configuration: one of Autoware's roots some thousands, most others one or two. So beside milliseconds of processor for
an entry (the mean, and the median) stands what they are for each launch file that was executed, and for each node that was started.
"""

from __future__ import annotations

import argparse
import multiprocessing
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import mean, median
from typing import Any, NamedTuple

from launchlint.check.entry import EntryChecker
from launchlint.evaluate import configurations as evaluating
from tests.bench.timing import checked_here, table


class Cost(NamedTuple):
    """One entry file: seconds of the processor, and how many configurations, launch files and nodes that was for."""

    seconds: float
    configurations: int
    files: int
    nodes: int


def costs(directory: str) -> list[Cost]:
    """Check a directory, in this process."""
    found: list[Cost] = []
    seen: list[tuple[int, int]] = []
    check, every = EntryChecker.check, evaluating.configurations

    def counted(*words: Any) -> Iterator[Any]:
        for evaluation in every(*words):
            seen.append((max(1, len(evaluation.launch.files)), len(evaluation.launch.nodes)))
            yield evaluation

    def timed(self: EntryChecker, request: Any) -> Any:
        seen.clear()
        start = time.process_time()
        result = check(self, request)
        found.append(Cost(time.process_time() - start, len(seen), sum(files for files, _ in seen), sum(nodes for _, nodes in seen)))
        return result

    evaluating.configurations = counted  # type: ignore[assignment]
    EntryChecker.check = timed  # type: ignore[method-assign]
    checked_here(directory)
    return found


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="What does a launch file cost that is executed?")
    parser.add_argument("directories", nargs="+", type=Path)
    rows = []
    for directory in parser.parse_args().directories:
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            each = pool.apply(costs, (str(directory.resolve()),))
        if not each:
            continue
        seconds, _, files, nodes = (sum(column) for column in zip(*each, strict=True))
        own = [1000 * cost.seconds for cost in each]
        rows.append(
            [directory.name, str(len(each)), str(files), str(nodes), f"{mean(own):.1f}", f"{median(own):.1f}"]
            + [f"{1000 * seconds / max(1, count):.2f}" for count in (files, nodes)]
        )
    print(table(["directory", "entries", "files executed", "nodes", "ms an entry", "median", "ms a file executed", "ms a node"], rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
