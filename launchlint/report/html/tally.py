"""What became of an entry file since a revision, in a few words for its card: who talks to whom no more, nodes, params, findings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from launchlint.graph.topology import Topology
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.report.html.material import EntryMaterial

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_PAIRS = 4_000
"""Pairs of nodes on one channel that are told apart; of a channel with more only its ends are."""

MINUS = "\N{MINUS SIGN}"
Pair = tuple[str, str, str, str]


class Tally(NamedTuple):
    """How many there are of each. A connection is a pair of nodes that meet on a channel; one of everybody's (``/tf``) does not count."""

    connections_lost: int = 0
    connections_gained: int = 0
    nodes_gone: int = 0
    nodes_new: int = 0
    nodes_changed: int = 0
    params_changed: int = 0
    findings_new: int = 0
    findings_fixed: int = 0
    verdict: str = ""

    @property
    def words(self) -> list[tuple[str, str]]:
        """Each number that is not zero with its looks (``removed``, ``added`` or ``changed``), the weightiest first."""
        return [
            *([("changed", self.verdict)] if self.verdict else []),
            *_count(self.connections_lost, MINUS, "connection", "removed"),
            *_count(self.connections_gained, "+", "connection", "added"),
            *_count(self.nodes_gone, MINUS, "node", "removed"),
            *_count(self.nodes_new, "+", "node", "added"),
            *([("changed", f"{counted(self.nodes_changed, 'node')} changed")] if self.nodes_changed else []),
            *([("changed", f"{counted(self.params_changed, 'param')} changed")] if self.params_changed else []),
            *([("removed", counted(self.findings_new, "new finding"))] if self.findings_new else []),
            *([("added", f"{counted(self.findings_fixed, 'finding')} fixed")] if self.findings_fixed else []),
        ]


def _count(number: int, sign: str, word: str, looks: str) -> list[tuple[str, str]]:
    return [(looks, f"{sign}{counted(number, word)}")] if number else []


def tally(material: EntryMaterial, nodes: Sequence[Mapping[str, Any]], params: Sequence[Mapping[str, Any]], new: int) -> Tally:
    """What changed. ``nodes`` and ``params`` are the data of the entry file, in which they are marked; ``new`` counts its new findings."""
    before, after = material.before, material.topology
    old: Mapping[Pair, None] = {} if before is None else dict.fromkeys(_pairs(before))
    now: Mapping[Pair, None] = {} if after is None else dict.fromkeys(_pairs(after))
    marks = [each.get("mark", "") for each in nodes]
    was, verdict = material.verdict_before, material.verdict
    return Tally(
        sum(pair not in now for pair in old),
        sum(pair not in old for pair in now),
        marks.count("removed"),
        marks.count("added"),
        marks.count("changed"),
        sum("mark" in each for each in params),
        new,
        len(material.fixed),
        f"{was.word} → {verdict.word}" if was is not None and was.word != verdict.word else "",
    )


def _pairs(topology: Topology) -> Iterator[Pair]:
    quiet = {(each.kind, each.name) for each in topology.channels if each.hub or each.plumbing}
    sides: dict[tuple[str, str], tuple[dict[str, None], dict[str, None]]] = {}
    for each in topology.connections:
        if (each.kind, each.name) not in quiet and not each.action:
            sides.setdefault((each.kind, each.name), ({}, {}))[not each.offers][each.node] = None
    for (kind, name), (offers, uses) in sides.items():
        if len(offers) * len(uses) <= MOST_PAIRS:
            yield from ((kind, name, one, other) for one in offers for other in uses if one != other)
