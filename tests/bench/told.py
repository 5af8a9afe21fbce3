"""How many findings, of how many causes, do the repositories of a directory have, by rule and level? And what does a launch file cost?

``python -m tests.bench.told DIRECTORY``. Each repository is checked alone, in a process of its own, with ``launchlint check .``: *findings*
counts every place, *told* what people see once all of one cause has become one. Below that the repositories whose launch files take most
of the processor's time, without the start of Python (which ``tests.bench.configurations --corpus`` counts, too).
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import sys
import time
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from launchlint.check.causes import told_once
from launchlint.cli import output
from launchlint.finding import Finding, Severity
from tests.bench.corpus import LAUNCH_FILES
from tests.bench.timing import checked_here, table

Row = tuple[str, str]
"""A rule and a level."""


class Told(NamedTuple):
    """One repository: how many findings there are and are told, by rule and level; launch files, and seconds of the processor."""

    name: str
    findings: dict[Row, int]
    told: dict[Row, int]
    files: int
    seconds: float


def check(repository: str) -> Told:
    """Check one repository, in this process."""
    seen: list[Iterable[Finding]] = []

    def watched(findings: Iterable[Finding]) -> tuple[Finding, ...]:
        seen.append(findings)
        return told_once(findings)

    output.told_once = watched  # type: ignore[attr-defined]
    start = time.process_time()
    written = checked_here(repository, "--format", "json")
    seconds = time.process_time() - start
    told = Counter((finding["rule"], finding["severity"]) for finding in json.loads(written)["findings"])
    findings = Counter((finding.rule, finding.severity.word) for each in seen for finding in each)
    files = sum(name.endswith(LAUNCH_FILES) for _, _, names in os.walk(repository) for name in names)
    return Told(os.path.basename(repository), dict(findings), dict(told), files, seconds)


def tables(results: Iterable[Told]) -> str:
    """By level, and by rule and level: findings, and what is told."""
    findings: Counter[Row] = Counter()
    told: Counter[Row] = Counter()
    for each in results:
        findings.update(each.findings)
        told.update(each.told)
    levels = [level.word for level in sorted(Severity, reverse=True)]

    def of(counts: Counter[Row], level: str) -> str:
        return str(sum(count for (_, word), count in counts.items() if word == level))

    by_level = table(["level", "findings", "told"], [[level, of(findings, level), of(told, level)] for level in levels])
    rows = sorted(findings, key=lambda row: (row[0], levels.index(row[1])))
    by_rule = table(["rule", "level", "findings", "told"], [[*row, str(findings[row]), str(told[row])] for row in rows])
    return f"{by_level}\n\n{by_rule}"


def main() -> int:
    """Check, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Count the findings of real repositories, by rule and level.")
    parser.add_argument("directory", type=Path, help="where the repositories are")
    parser.add_argument("--shown", type=int, default=10, help="repositories to print whose launch files take most (default: 10)")
    arguments = parser.parse_args()
    repositories = [str(path) for path in sorted(arguments.directory.resolve().iterdir()) if path.is_dir()]
    with multiprocessing.get_context("fork").Pool(1, maxtasksperchild=1) as pool:
        results = pool.map(check, repositories, chunksize=1)
    print(tables(results))
    costs = sorted(((each.seconds / each.files, each) for each in results if each.files), key=lambda pair: -pair[0])
    rows = [[each.name, str(each.files), f"{1000 * cost:.1f}"] for cost, each in costs[: arguments.shown]]
    print("\n" + table(["repository", "launch files", "ms a file"], rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
