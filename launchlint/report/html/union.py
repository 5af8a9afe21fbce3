"""Two states of one launch file as one: what is there now and what has gone, each with its mark."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from launchlint.graph.difference import difference
from launchlint.graph.topology import EMPTY, Connection, Container, Topology, TopologyChannel, TopologyNode, TopologyParam
from launchlint.named_tuple import NamedTuple

Item = TypeVar("Item")

ADDED, REMOVED, CHANGED = "added", "removed", "changed"


@dataclass(frozen=True)
class Marked(Generic[Item]):
    """Something of a launch file with its mark (empty: as it was). ``base``: its places are those of the revision compared with."""

    item: Item
    mark: str
    base: bool


class Union(NamedTuple):
    """All of both states. ``containers`` is by id; those of the former state that are there now, too, stand once, under both ids."""

    configurations: tuple[str, ...]
    nodes: list[Marked[TopologyNode]]
    channels: list[Marked[TopologyChannel]]
    connections: list[Marked[Connection]]
    params: list[Marked[TopologyParam]]
    containers: Mapping[str, Marked[Container]]


def alone(topology: Topology, mark: str = "") -> Union:
    """One state; all of it has the same mark."""
    base = mark == REMOVED

    def all_(items: Iterable[Item]) -> list[Marked[Item]]:
        return [Marked(each, mark, base) for each in items]

    containers = {each.id: Marked(each, mark, base) for each in topology.containers}
    containers.update({f"base {id_}": each for id_, each in containers.items()} if base else {})
    return Union(
        topology.configurations,
        all_(topology.nodes),
        all_(topology.channels),
        all_(topology.connections),
        all_(topology.params),
        containers,
    )


def united(before: Topology | None, after: Topology | None) -> Union:
    """Both states; None where there was, or is, no such file."""
    if before is None or after is None:
        return alone(before or after or EMPTY, ADDED if before is None else REMOVED)
    found = difference(before, after)
    nodes = _marks(after.nodes, found.nodes_added, (change.after for change in found.nodes_changed))
    channels = _marks(after.channels, found.channels_added, (change.after for change in found.channels_changed))
    connections = _marks(after.connections, found.connections_added, (change.after for change in found.connections_changed))
    moved_away = [change.before for change in found.connections_changed if change.before.name != change.after.name]
    return Union(
        tuple(dict.fromkeys((*after.configurations, *before.configurations))),
        [*nodes, *_gone(found.nodes_removed)],
        [*channels, *_gone(found.channels_removed)],
        [*connections, *_gone((*found.connections_removed, *moved_away))],
        _params(before.params, after.params),
        _containers(before.containers, after.containers),
    )


def _marks(items: Sequence[Item], added: Iterable[Item], changed: Iterable[Item]) -> list[Marked[Item]]:
    new, other = set(added), set(changed)
    return [Marked(each, ADDED if each in new else CHANGED if each in other else "", False) for each in items]


def _gone(items: Iterable[Item]) -> list[Marked[Item]]:
    return [Marked(each, REMOVED, True) for each in items]


def _params(before: Sequence[TopologyParam], after: Sequence[TopologyParam]) -> list[Marked[TopologyParam]]:
    """Params by name: a param whose values are not those it had has changed."""
    values: tuple[dict[str, list[str]], dict[str, list[str]]] = ({}, {})
    for side, params in zip(values, (before, after), strict=True):
        for param in params:
            side.setdefault(param.name, []).append(param.value)
    old, new = values
    marks = [ADDED if each.name not in old else "" if _same(old[each.name], new[each.name]) else CHANGED for each in after]
    marked = [Marked(each, mark, False) for each, mark in zip(after, marks, strict=True)]
    return [*marked, *_gone(each for each in before if each.name not in new)]


def _same(before: Sequence[str], after: Sequence[str]) -> bool:
    """Whether the values are the same; of those that are cut, whether what is left of both is."""
    return len(before) == len(after) and all(
        one == other or ("…" in (one[-1:], other[-1:]) and (one.startswith(other[:-1]) or other.startswith(one[:-1])))
        for one, other in zip(sorted(before), sorted(after), strict=True)
    )


def _containers(before: Sequence[Container], after: Sequence[Container]) -> Mapping[str, Marked[Container]]:
    """A group or include is the same one where its kind, label and namespace are, and what is around it, whatever line it stands in."""
    found = {each.id: Marked(each, "", False) for each in after}
    old, new = {each.id: each for each in before}, {each.id: each for each in after}
    same: dict[tuple[object, ...], str] = {}
    for each in _outermost_first(new):
        same.setdefault((each.kind, each.label, each.namespace, each.parent), each.id)
    stands_for = {"": ""}
    for each in _outermost_first(old):
        parent = stands_for[each.parent]
        key = (each.kind, each.label, each.namespace, parent)
        known = same.get(key)
        if known is None:
            known = same[key] = f"{each.id} "  # no place ends so: no id of the present state can be the same
            found[known] = Marked(each._replace(id=known, parent=parent), REMOVED, True)
        stands_for[each.id] = known
        found.setdefault(f"base {each.id}", found[known])
    return found


def _outermost_first(containers: Mapping[str, Container]) -> list[Container]:
    """Those around others before them, else in order; linear, however deep they are nested."""
    done: dict[str, Container] = {}
    for each in containers.values():
        waiting = []
        inner: Container | None = each
        while inner is not None and inner.id not in done:
            waiting.append(inner)
            inner = containers.get(inner.parent)
        done.update((outer.id, outer) for outer in reversed(waiting))
    return list(done.values())
