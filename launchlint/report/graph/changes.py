"""What changed in the connection graph, for people in a terminal: who lost whom, then everything else."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from launchlint.graph.difference import ConnectionChange, Difference, Link, is_default, moved
from launchlint.graph.topology import Connection, Topology, TopologyNode
from launchlint.plural import counted
from launchlint.report.escape import line_start, visible
from launchlint.report.graph.words import DOES, does, listed, loading, remapped, when, wrapped

MOST_PARTNERS = 5
MOST_NAMES = 8
"""Names that a new or removed node is said to use."""

Channel = tuple[str, str, bool]


def render(changes: Sequence[Difference]) -> str:
    """All that changed; launch files in which the same did are told of together."""
    bodies: dict[str, list[str]] = {}
    for each in changes:
        if not each.is_empty:
            bodies.setdefault("\n".join(_body(each)), []).append(line_start(title(each)))
    return "\n".join(f"{_titles(titles)}\n{body}\n" for body, titles in bodies.items())


def title(changes: Difference) -> str:
    """The launch file, and what it was called before where that is another name."""
    before, after = changes.before.entry, changes.after.entry
    return after if before == after else f"{before} → {after}"


def _titles(titles: Sequence[str]) -> str:
    return titles[0] if len(titles) == 1 else f"in {len(titles)} launch files: {', '.join(titles)}"


def _body(changes: Difference) -> Iterator[str]:
    yield from _loading(changes)
    yield from _links("lost", changes.lost, changes)
    if changes.lost and changes.uncertain:
        yield "    (a node came in of which not everything is known: it may do what seems lost)"
    yield from _links("gained", changes.gained, changes)
    yield from _nodes(changes)
    yield from _channels(changes)
    for channel in changes.channels_changed:
        before, after = (" and ".join(each.types) or "unknown type" for each in channel)
        yield f"  ~ {channel.after.kind} {visible(channel.after.name)}: {visible(before)} → {visible(after)}"
    yield from _connections(changes)


def _loading(changes: Difference) -> Iterator[str]:
    """What roslaunch makes of the launch file now: where it does not load it, or did not before."""
    now = loading(changes.after)
    if now:
        yield f"  {'now' if changes.loads_otherwise else 'still' if loading(changes.before) else 'it'}: {visible(now)}"
    elif changes.loads_otherwise:
        yield f"  loads now; before: {'' if changes.before.verdict is None else visible(changes.before.verdict.brief)}"


def _links(word: str, links: Sequence[Link], changes: Difference) -> Iterator[str]:
    """One line for each channel: the loss of a publisher and that of its subscriber are one."""
    ends: dict[tuple[str, str, bool], tuple[dict[str, None], dict[str, None]]] = {}
    told: dict[tuple[str, str, bool], list[Link]] = {}
    more: dict[tuple[str, str, bool], int] = {}
    for link in links:
        key = (link.kind, link.name, link.by_default)
        offers, uses = ends.setdefault(key, ({}, {}))
        mine, theirs = (offers, uses) if link.role in ("publisher", "server", "action server") else (uses, offers)
        mine[link.node] = None
        theirs.update(dict.fromkeys(link.partners))
        told.setdefault(key, []).append(link)
        more[key] = max(more.get(key, 0), link.total - len(link.partners))
    why = _Reasons(changes)
    for key, (offers, uses) in sorted(ends.items()):
        kind, name, by_default = key
        first, second = (offers, uses) if kind == "topic" else (uses, offers)
        left, right = (listed(sorted(each)[:MOST_PARTNERS], len(each)) for each in (first, second))
        again = f" (and {more[key]} more)" if more[key] else ""
        condition = " by default" if by_default else ""
        yield f"  {word}{condition}: {left} → {right}{again} on {kind} {visible(name)}"
        if word == "lost":
            yield from (f"      {each}" for each in why.of(told[key], {**first, **second}))


class _Reasons:
    """Why links are lost."""

    def __init__(self, changes: Difference) -> None:
        self._after = changes.after
        self._running = {node.name: node for node in changes.after.nodes}
        self._moved = moved(changes)
        self._changed: dict[tuple[str, str], list[ConnectionChange]] = {}
        for change in changes.connections_changed:
            if change.before.name != change.after.name:
                self._changed.setdefault((change.before.kind, change.before.name), []).append(change)

    def of(self, links: Sequence[Link], ends: Mapping[str, None]) -> Iterator[str]:
        """Lines about the lost links of one channel, whose nodes at both ends were ``ends``."""
        for link in links:
            if link.after is None:
                yield f"{visible(link.node)} no longer {DOES[link.role].removesuffix(' action')} it"
        for before, after in self._changed.get((links[0].kind, links[0].name), ()):
            if before.node in ends:
                steps = remapped(after.remaps)
                yield f"{visible(after.node)} now {does(after)}{f', {steps}' if steps else ''}"
        for name in ends:
            node = self._running.get(name)
            if node is None:
                yield (
                    f"{visible(name)} is now {visible(self._moved[name])}"
                    if name in self._moved
                    else f"{visible(name)} is no longer started"
                )
            elif node.only and not is_default(node, self._after):
                yield f"{visible(name)} is started {when(node.only, self._after.configurations)}"


def _channels(changes: Difference) -> Iterator[str]:
    """Names that came and went; not those that only nodes that did are concerned with: they stand with these."""
    for sign, nodes, connections, channels in (
        ("-", changes.nodes_removed, changes.before.connections, changes.channels_removed),
        ("+", changes.nodes_added, changes.after.connections, changes.channels_added),
    ):
        whole = {node.name for node in nodes}
        others = {(each.kind, each.name) for each in connections if each.certain and each.node not in whole}
        kinds: dict[str, list[str]] = {}
        for each in channels:
            if (each.kind, each.name) in others:
                kinds.setdefault(each.kind, []).append(visible(each.name))
        for kind, names in kinds.items():
            yield from wrapped(f"  {sign} {kind}{'' if len(names) == 1 else 's'} ", names)


def _nodes(changes: Difference) -> Iterator[str]:
    now = moved(changes)
    came = set(now.values())
    for sign, nodes, connections, graph in (
        ("-", changes.nodes_removed, changes.connections_removed, changes.before),
        ("+", changes.nodes_added, changes.connections_added, changes.after),
    ):
        mine: dict[str, list[Connection]] = {}
        for each in connections:
            mine.setdefault(each.node, []).append(each)
        for node in nodes:
            if sign == "-" and node.name in now:
                yield f"  ~ node {visible(node.name)} is now {visible(now[node.name])}"
            elif sign == "-" or node.name not in came:
                only = f", {when(node.only, graph.configurations)}" if node.only else ""
                yield f"  {sign} node {visible(node.name)} ({visible(node.program)}{only})"
                yield from _names(mine.get(node.name, ()))
    for change in changes.nodes_changed:
        yield f"  ~ node {visible(change.after.name)}: {_changed(change.before, change.after, changes)}"


def _names(connections: Sequence[Connection]) -> Iterator[str]:
    """What a node says and hears, in short."""
    roles: dict[str, list[str]] = {}
    for each in connections:
        if each.certain and not each.action:
            roles.setdefault(each.role, []).append(visible(each.name))
    for role, names in roles.items():
        more = [f"and {len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
        yield from wrapped(f"      {DOES[role]} ", [*names[:MOST_NAMES], *more])


def _changed(before: TopologyNode, after: TopologyNode, changes: Difference) -> str:
    for what, old, new in (("program", before.program, after.program), ("process", before.host, after.host)):
        if old != new:
            return f"{what} {visible(old or 'not here')} → {visible(new or 'not here')}"
    if is_default(before, changes.before) != is_default(after, changes.after):
        return _condition(before.only, changes.before, after.only, changes.after)
    return f"{before.knowledge} → {after.knowledge}"


def _condition(before: Sequence[str], old: Topology, after: Sequence[str], new: Topology) -> str:
    return " → ".join(when(only, graph.configurations) or "always" for only, graph in ((before, old), (after, new)))


def _connections(changes: Difference) -> Iterator[str]:
    """Those of nodes that came, went or are another program now are told of there."""
    whole = {node.name for node in (*changes.nodes_added, *changes.nodes_removed)}
    perhaps = 0
    for change in changes.connections_changed:
        before, after = change
        if not before.certain and not after.certain:
            perhaps += 1
            continue
        if before.name != after.name:
            steps = remapped(after.remaps)
            what = f"{visible(after.name)} instead of {visible(before.name)}{f', {steps}' if steps else ''}"
        elif before.type != after.type:
            what = f"{visible(before.name)}: {visible(before.type or 'unknown type')} → {visible(after.type or 'unknown type')}"
        else:
            what = f"{visible(before.name)}: {_condition(before.only, changes.before, after.only, changes.after)}"
        yield f"  ~ {visible(after.node)} {DOES[after.role]} {what}"
    for sign, connections in (("-", changes.connections_removed), ("+", changes.connections_added)):
        for each in connections:
            if each.node not in whole and each.certain:
                yield f"  {sign} {visible(each.node)} {does(each)}"
            elif each.node not in whole:
                perhaps += 1
    if perhaps:
        yield f"  and {counted(perhaps, 'name')} that nodes may or may not have"
