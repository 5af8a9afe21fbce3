"""What launch files are predicted to connect, held against what their nodes do when they are started for real.

Each file in ``live_ws/talk/launch`` runs under roslaunch with Debian's nodes; the master then says who publishes, subscribes and serves
what. Of the predicted graph everything that is certain must be there, with its type, and everything that is there must be predicted. Not
compared: clients of services (a master does not know them), params that are read, which of several processes gave a topic its type.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.graph.connect import connect
from launchlint.graph.connections import CATEGORY, ConnectionGraph, Endpoint
from launchlint.library.file import open_library
from launchlint.library.lookup import Library
from launchlint.workspace.packages import Packages
from tests.graph import live

LAUNCH = live.OWN_NODES / "talk" / "launch"
FILES = sorted(file.stem for file in LAUNCH.glob("[0-9]*.launch"))
ROLES = ("publisher", "subscriber", "server")
"""What a master knows; it is not told who calls a service."""
AT_ONCE = 3
"""Launch files that run at the same time: they mostly wait."""


class Comparison:
    """One launch file: predicted, and live as soon as somebody asks."""

    def __init__(self, name: str, pool: ThreadPoolExecutor, scratch: Path) -> None:
        self.graph = predicted(LAUNCH / f"{name}.launch")
        self.expected = frozenset(edge_of(endpoint) for endpoint in visible(self.graph) if is_sure(endpoint))
        self.possible = frozenset(edge_of(endpoint) for endpoint in visible(self.graph))
        self._live: Future[live.Live] = pool.submit(live.run, LAUNCH / f"{name}.launch", scratch, lambda edges: not self.lost(edges))

    @property
    def found(self) -> live.Live:
        return self._live.result(timeout=300)

    def lost(self, edges: Collection[live.Edge]) -> list[live.Edge]:
        """What is expected and not there. Of several servers of one name a master keeps the last: any of them will do."""
        served = {name for role, name, process in edges if role == "server" if ("server", name, process) in self.expected}
        return sorted(edge for edge in self.expected.difference(edges) if edge[0] != "server" or edge[1] not in served)

    def foreign(self, edges: Collection[live.Edge]) -> list[live.Edge]:
        """What is there and not predicted, not even as something that the library leaves open."""
        opened = {(role, live.plain(each.host)) for each in self.graph.instances for role in ROLES if CATEGORY[role] in each.open}
        return sorted(edge for edge in edges if edge not in self.possible and (edge[0], edge[2]) not in opened)


def predicted(launch: Path) -> ConnectionGraph:
    environment = {"HOME": "/home/user", "PATH": "/usr/bin:/bin"}
    packages = Packages([str(live.OWN_NODES)], environment, explicit=True)
    evaluation = evaluate(Session(packages, environment, str(launch.parent)), str(launch), ())
    return connect(evaluation.launch, Library([open_library(str(live.OWN_NODES / "library.json"))]))


def visible(graph: ConnectionGraph) -> Iterator[Endpoint]:
    """What a master could know: no clients, and actions by their topics."""
    tests = {test.full_name for test in graph.launch.tests}
    for instance in graph.instances:
        if instance.name not in tests:  # roslaunch starts none: that is for rostest
            yield from (each for each in instance.endpoints if each.role in ROLES)


def is_sure(endpoint: Endpoint) -> bool:
    return endpoint.certain and endpoint.declaration.when == "start"


def edge_of(endpoint: Endpoint) -> live.Edge:
    return endpoint.role, live.plain(endpoint.name), live.plain(endpoint.process)


@pytest.fixture(scope="module")
def comparisons(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Comparison]]:
    lost = live.missing()
    if lost:
        pytest.skip(lost)
    with ThreadPoolExecutor(AT_ONCE) as pool:
        yield {name: Comparison(name, pool, tmp_path_factory.mktemp(name)) for name in FILES}


@pytest.mark.ros
@pytest.mark.parametrize("name", FILES)
def test_the_live_graph_is_the_predicted_one(name: str, comparisons: dict[str, Comparison]) -> None:
    comparison = comparisons[name]
    assert {instance.name: instance.reason for instance in comparison.graph.instances if instance.is_unknown} == {}
    found = comparison.found
    assert (comparison.lost(found.edges), comparison.foreign(found.edges)) == ([], []), found.log


@pytest.mark.ros
@pytest.mark.parametrize("name", FILES)
def test_the_live_types_are_the_predicted_ones(name: str, comparisons: dict[str, Comparison]) -> None:
    found = comparisons[name].found
    wrong = {
        (endpoint.kind, live.plain(endpoint.name)): (endpoint.type, real)
        for endpoint in visible(comparisons[name].graph)
        if edge_of(endpoint) in found.edges
        if endpoint.type not in ("", "*")
        if (real := found.types.get((endpoint.kind, live.plain(endpoint.name)), "")) not in ("*", endpoint.type)
    }
    assert wrong == {}


def test_ci_installs_what_the_launch_files_start(root: Path) -> None:
    words = (root / ".ci" / "debian-packages").read_text(encoding="utf-8").split()
    assert [package for package in live.DEBIAN if package not in words] == []
