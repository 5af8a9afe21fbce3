"""Do the formats of ``launchlint graph`` and ``graph diff`` grow with the launch, and no faster? 50, 500 and 5,000 nodes.

``python -m tests.bench.pictures``: the launch of :mod:`tests.bench.graph`; milliseconds for each format, once.
"""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path

from launchlint.graph.connect import connect
from launchlint.graph.difference import Difference, difference
from launchlint.graph.topology import Topology, topology
from launchlint.library.file import open_library
from launchlint.library.lookup import Library
from launchlint.report.graph import changes, dot, graphml, mermaid, text
from launchlint.report.graph.json import as_object, difference_as_object
from launchlint.report.graph.json import text as json_text
from tests.bench.graph import PACKAGES, SIZES, launch_of
from tests.bench.timing import milliseconds, table

SHOWN: Mapping[str, Callable[[Topology], str]] = {
    "text": text.render,
    "mermaid": mermaid.render,
    "dot": dot.render,
    "graphml": graphml.render,
    "json": lambda each: json_text(as_object(each)),
}
CHANGED: Mapping[str, Callable[[Difference], str]] = {
    "diff, text": lambda each: changes.render([each]),
    "diff, mermaid": lambda each: mermaid.render(each.after, each),
    "diff, dot": lambda each: dot.render(each.after, each),
    "diff, json": lambda each: json_text(difference_as_object(each)),
}


def record(size: int) -> Topology:
    """The topology of ``size`` nodes in nested namespaces."""
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        document = {"format": "launchlint-library", "version": 1, "packages": PACKAGES}
        (directory / "library.json").write_text(json.dumps(document), encoding="utf-8")
        library = Library([open_library(str(directory / "library.json"))], bundled=False)
        return topology([connect(launch_of(directory, size), library)])


def shaken(of: Topology) -> Topology:
    """The same with every second node gone, and every third name another one."""
    connections = (each._replace(name=f"{each.name}_") if number % 3 == 0 else each for number, each in enumerate(of.connections))
    return of._replace(nodes=of.nodes[::2], connections=tuple(connections))


def measure(size: int) -> dict[str, float]:
    """Seconds for each format, and to compare."""
    before = record(size)
    after = shaken(before)
    found: dict[str, float] = {}

    def timed(name: str, function: Callable[[], object]) -> None:
        started = time.perf_counter()
        function()
        found[name] = time.perf_counter() - started

    for name, render in SHOWN.items():
        timed(name, lambda render=render: render(before))  # type: ignore[misc]  # mypy does not see the type of the default
    timed("difference", lambda: difference(before, after))
    changed = difference(before, after)
    for name, tell in CHANGED.items():
        timed(name, lambda tell=tell: tell(changed))  # type: ignore[misc]  # as above
    return found


def main() -> None:
    """Measure and print."""
    measure(SIZES[0])  # the first run imports
    columns = [measure(size) for size in SIZES]
    rows = [[name, *(milliseconds(column[name]) for column in columns)] for name in columns[0]]
    print(table(["ms for", *(f"{size} nodes" for size in SIZES)], rows))


if __name__ == "__main__":
    main()
