"""Libraries for people and programs: what a program does on the graph, what changed, what is wrong."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from launchlint.report.escape import line_start, visible


def faults(lines: Iterable[str]) -> str:
    """What is wrong with a library, one line for each."""
    return "".join(f"{line_start(line)}\n" for line in lines)


def summary(path: str, library: Mapping[str, Any]) -> str:
    """One line: a library that is in order, and how much it knows."""
    packages = library["packages"].values()
    counts = [
        _counted(len(packages), "package"),
        _counted(sum(len(package.get("executables", ())) for package in packages), "executable"),
        _counted(sum(len(package.get("nodelets", ())) for package in packages), "nodelet class", "nodelet classes"),
    ]
    return f"{visible(path)}: ok: {', '.join(counts)}\n"


def _counted(number: int, one: str, several: str = "") -> str:
    return f"{number} {one if number == 1 else several or one + 's'}"
