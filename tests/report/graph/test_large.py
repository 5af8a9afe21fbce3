"""Five thousand nodes, and whatever else hostile files do to size: every format takes seconds, not minutes."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from launchlint.graph.difference import difference
from launchlint.graph.topology import Topology
from launchlint.graph.topology import topology as record
from tests.bench.pictures import CHANGED, SHOWN, shaken
from tests.bench.pictures import record as nested
from tests.graph import sample

SECONDS = 15
"""Of processor time; on a free machine no format takes more than three."""
PACKAGES = {
    "d": {
        "executables": {
            "both": sample.program(publishers=[{"name": "out"}, {"name": "/all"}], subscribers=[{"name": "in"}, {"name": "/all"}]),
            "one": sample.program(publishers=[{"name": "/hub"}]),
            "other": sample.program(subscribers=[{"name": "/hub"}]),
        }
    }
}


def deep(directory: Path) -> Topology:
    """A chain of nodes down through 150 namespaces, and 2,000 nodes at the bottom."""
    remaps = '<remap from="out" to="/c{0}"/><remap from="in" to="/c{1}"/>'
    cell = f'<group ns="n{{0}}"><node pkg="d" type="both" name="m">{remaps}</node>'
    chain = "".join(cell.format(number, number - 1) for number in range(150))
    bottom = "".join(f'<node pkg="d" type="both" name="b{number}"/>' for number in range(2000))
    return record([sample.graph(directory, chain + bottom + "</group>" * 150, PACKAGES)])


def hub(directory: Path) -> Topology:
    """A topic with 2,500 publishers and as many subscribers, all in one namespace."""
    nodes = "".join(f'<node pkg="d" type="{("one", "other")[number % 2]}" name="n{number}"/>' for number in range(5000))
    return record([sample.graph(directory, nodes, PACKAGES)])


@pytest.mark.parametrize("shape", ["nested", "deep", "hub"])
def test_every_format_in_seconds(shape: str, tmp_path: Path) -> None:
    topology = nested(5000) if shape == "nested" else {"deep": deep, "hub": hub}[shape](tmp_path)
    assert len(topology.nodes) == {"nested": 5000, "deep": 2150, "hub": 5000}[shape]
    changed = difference(topology, shaken(topology))
    for name, render in {**SHOWN, **{name: (lambda _, tell=tell: tell(changed)) for name, tell in CHANGED.items()}}.items():
        started = time.process_time()
        out = render(topology)
        assert time.process_time() - started < SECONDS, name
        if "mermaid" in name:
            assert len(out) <= 50_000
