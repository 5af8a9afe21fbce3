"""Tables that take in what a file holds are as if the file had been read into them."""

from __future__ import annotations

import itertools
from typing import Any

import pytest

from launchlint.rcl import parameter_files
from launchlint.rcl.table import Table
from launchlint.source import Source

TEXTS = {
    "plain": "n:\n  ros__parameters: {a: 1, b: 1}\n",
    "other type": "n:\n  ros__parameters: {a: 2.5, c: x}\n/**:\n  ros__parameters: {a: 3}\n",
    "nested": "n:\n  ros__parameters: {a: {b: 1}, d: {e: {f: 2}}}\n",
    "nested again": "n:\n  ros__parameters: {d: {e: {f: 3}, g: 4}}\n",
    "dotted": "n:\n  ros__parameters: {a.b: 7, d.e.f: 8}\n",
    "namespace": "n:\n  ros__parameters: {d: 5}\n",
    "empty list": "n:\n  ros__parameters: {a: []}\nm:\n  ros__parameters: {a: 1}\n",
}


def shown(table: Table) -> list[Any]:
    """All that a table says, in order."""
    return [
        (key.name, [(each.name, each.value, each.written._replace(order=table.order(key, each))) for each in key.parameters])
        for key in table.keys.values()
    ]


@pytest.mark.parametrize("names", [*itertools.product(TEXTS, repeat=3)], ids=" + ".join)
def test_merged_tables_are_as_read_one_after_the_other(names: tuple[str, ...]) -> None:
    sources = [Source(name, TEXTS[name]) for name in names]
    read, merged, before = Table(), Table(), []
    for source in sources:
        assert parameter_files.add(source, read) is None
        alone = parameter_files.read(source)
        assert isinstance(alone, Table)
        if not merged.merge(alone):
            assert parameter_files.add(source, merged) is None
        before.append((alone, shown(alone)))
    assert shown(merged) == shown(read)
    assert all(shown(alone) == said for alone, said in before)  # what was taken in is as it was
