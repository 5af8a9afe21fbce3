"""Which findings belong to which nodes, params and channels of an entry file."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Mapping, Sequence

from launchlint.finding import Finding
from launchlint.graph.topology import Connection, Topology
from launchlint.source import Span


class Attachment:
    """Finds what findings are about, by where they stand.

    ``findings`` are those of the entry file with their indexes, ``extents`` says from where to where the element of a place goes.
    """

    def __init__(self, findings: Sequence[tuple[int, Finding]], extents: Mapping[str, Span]) -> None:
        self._findings = findings
        self._extents = extents
        self._by_path: dict[str, list[tuple[int, int]]] = {}
        self._pointing: dict[str, list[tuple[int, int]]] = {}
        for index, finding in findings:
            self._by_path.setdefault(finding.location.path, []).append((finding.location.start, index))
            for related in finding.related:
                at = related.location
                self._pointing.setdefault(at.path, []).append((at.start, index))
        for by_path in (self._by_path, self._pointing):
            for places in by_path.values():
                places.sort()

    def inside(self, place: str) -> list[int]:
        """The findings inside the element at a place, in order."""
        return self._within(place, self._by_path)

    def pointing_at(self, place: str) -> list[int]:
        """The findings that stand elsewhere and speak of the element at a place, too, in order."""
        inside = self.inside(place)
        return [index for index in self._within(place, self._pointing) if index not in inside]

    def _within(self, place: str, by_path: Mapping[str, list[tuple[int, int]]]) -> list[int]:
        span = self._extents.get(place)
        places = by_path.get(place.rsplit(":", 2)[0]) if place else None
        if span is None or places is None:
            return []
        first = bisect_left(places, (span.start, -1))
        last = bisect_left(places, (span.end, -1), lo=first)
        return sorted({index for _, index in places[first:last]})

    def of_containers(self, topology: Topology) -> Mapping[str, list[int]]:
        """The findings that stand in a group or include and in no node: at the innermost element around, else at the file's include."""
        in_nodes = {index for node in topology.nodes for index in self.inside(node.place)}
        elements: dict[str, dict[Span, list[str]]] = {}
        files: dict[str, list[str]] = {}
        for container in topology.containers:
            span = self._extents.get(container.place)
            if span is not None:
                path = container.place.rsplit(":", 2)[0]
                elements.setdefault(path, {}).setdefault(span, []).append(container.id)
            if container.kind == "include":
                files.setdefault(container.label, []).append(container.id)
        found: dict[str, list[int]] = {}
        for path, places in self._by_path.items():
            spans = sorted(elements.get(path, {}), key=lambda span: (span.start, -span.end))
            around: list[Span] = []
            at = 0
            for start, index in places:
                while at < len(spans) and spans[at].start <= start:
                    around.append(spans[at])
                    at += 1
                while around and around[-1].end <= start:
                    around.pop()
                if index not in in_nodes:
                    for container_id in elements[path][around[-1]] if around else files.get(path, ()):
                        found.setdefault(container_id, []).append(index)
        return {container_id: sorted(set(indexes)) for container_id, indexes in found.items()}

    def of_channels(self, topology: Topology) -> Mapping[tuple[str, str], list[int]]:
        """The findings about each channel: those that name it, and those at a remap that leads to it."""
        names: dict[str, list[tuple[str, str]]] = {}
        for channel in topology.channels:
            names.setdefault(channel.name, []).append((channel.kind, channel.name))
        found: dict[tuple[str, str], set[int]] = {}
        for index, finding in self._findings:
            # What tells findings of one rule apart is what they are about: of rules on connections the name of the channel is a word of it.
            words = finding.topic.split(" ") if finding.rule.startswith("LL6") else ()
            kinds = {word for word in words if word in ("topic", "service", "action")}
            for key in (key for word in words for key in names.get(word, ())):
                if not kinds or key[0] in kinds:
                    found.setdefault(key, set()).add(index)
        for place, keys in _remaps(topology.connections).items():
            for index in self.inside(place):
                for key in keys:
                    found.setdefault(key, set()).add(index)
        return {key: sorted(indexes) for key, indexes in found.items()}


def _remaps(connections: Iterable[Connection]) -> Mapping[str, set[tuple[str, str]]]:
    found: dict[str, set[tuple[str, str]]] = {}
    for connection in connections:
        for step in connection.remaps:
            if step.place:
                found.setdefault(step.place, set()).add((connection.kind, connection.name))
    return found
