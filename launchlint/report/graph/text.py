"""The connection graph for people in a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from launchlint.graph.partners import Partners, meet
from launchlint.graph.topology import Connection, Topology, TopologyNode, TopologyParam
from launchlint.library.terms import READ_FROM
from launchlint.plural import counted
from launchlint.report.escape import line_start, visible
from launchlint.report.graph.words import DOES, doubted, listed, loading, missed, place, remapped, when, wrapped

MOST_PARTNERS = 6
"""Names of partners on one line."""
MOST_PARAMS = 12
"""Params of a node that are shown."""
LONGEST_VALUE = 40
WIDEST_NAME = 44
"""Columns that are kept free for names, so that partners stand below each other."""


def render(topology: Topology, complete: Topology | None = None, *, dangling: bool = False) -> str:
    """One block for each node: what it says and hears, who is at the other end, and what renamed it.

    ``complete`` is the topology from which this one was selected. With ``dangling`` names that a node may have and nobody else uses are
    shown, too.
    """
    mine: dict[str, list[Connection]] = {}
    for connection in topology.connections:
        mine.setdefault(connection.node, []).append(connection)
    read: dict[str, list[TopologyParam]] = {}
    for param in topology.params:
        for reader in param.readers:
            read.setdefault(reader, []).append(param)
    partners = Partners(topology)
    hidden = {connection.node for connection in (complete or topology).connections}
    lines = [f"{line_start(topology.entry)}: {_counts(topology)}"]
    if loading(topology):
        lines.append(f"    {visible(loading(topology))}")
    before: dict[str, TopologyNode] = {}
    for node in topology.nodes:
        if node.name in before and meet(before[node.name].only, node.only):
            lines += ["", _head(node, topology), "    has the same name as the one above, where stands what both say and hear"]
            continue
        before[node.name] = node
        here = [connection for connection in mine.get(node.name, ()) if meet(connection.only, node.only)]
        rows = [
            *_unknown(node),
            *_partly(node, topology),
            *_rows(here, partners, node, topology, dangling=dangling),
            *_params(read.get(node.name, ()), node, topology),
        ]
        if not rows:
            rows = ["    " + ("says and hears only what is not shown here" if node.name in hidden else "says and hears nothing")]
        lines += ["", _head(node, topology), *rows]
    if complete is not None:
        lines += _not_shown(topology, complete)
    return "\n".join(lines) + "\n"


def _counts(topology: Topology) -> str:
    names = {node.name for node in topology.nodes}
    unknown = len({node.name for node in topology.nodes if node.knowledge == "unknown"})
    nodes = counted(len(names), "node") + (f" ({unknown} unknown)" if unknown else "")
    offered = {(each.kind, each.name) for each in topology.connections if each.offers}
    used = {(each.kind, each.name) for each in topology.connections if not each.offers}
    kinds = []
    for kind in ("topic", "service", "action"):
        every = sum(each.kind == kind for each in topology.channels)
        if every:
            kinds.append(f"{sum(each[0] == kind for each in offered & used)} of {counted(every, kind)}")
    said = [nodes]
    if kinds:
        said.append(f"{', '.join(kinds[:-1])}{' and ' if len(kinds) > 1 else ''}{kinds[-1]} connected")
    if len(topology.configurations) > 1:
        said.append(f"{len(topology.configurations)} configurations")
    if not topology.complete:
        what = "not everything could be followed" if topology.entry.endswith(".py") else "an include could not be followed"
        said.append(f"{what}, so there may be more")
    return "; ".join(said)


def _head(node: TopologyNode, topology: Topology) -> str:
    details = [visible(node.program)]
    if node.kind in ("nodelet", "component"):
        details.append(
            f"in {visible(node.host)}"
            if node.host and node.host != node.name
            else f"its {'manager' if node.kind == 'nodelet' else 'container'} is not here"
            if not node.host
            else "standalone"
        )
    elif node.kind == "container":
        details.append("component container")
    elif node.kind == "manager":
        details.append("nodelet manager")
    if node.is_test:
        details.append("test")
    if node.conditions:
        details.append(visible(" ".join(node.conditions)))
    if node.only:
        details.append(when(node.only, topology.configurations))
    return f"{visible(node.name)}  {', '.join(details)}  {place(node.place)}"


def _unknown(node: TopologyNode) -> Iterator[str]:
    if node.knowledge == "unknown":
        yield f"    what it does is not known: {visible(node.reason)}"
    reasons: dict[str, list[str]] = {}
    for category, reason in node.open:
        reasons.setdefault(reason, []).append(category)
    for reason, categories in reasons.items():
        every = f"{', '.join(categories[:-1])} and {categories[-1]}" if len(categories) > 1 else categories[0]
        yield f"    may have more {every}: {visible(reason)}"


def _partly(node: TopologyNode, topology: Topology) -> Iterator[str]:
    names = [f"{category} {visible(pattern)}" for category, pattern in topology.partly.get((node.name, node.place), ())]
    if names:
        yield from wrapped("    names known only in part: ", names)


def _rows(
    connections: Sequence[Connection], partners: Partners, node: TopologyNode, topology: Topology, *, dangling: bool
) -> Iterator[str]:
    met: list[Connection] = []
    alone: list[Connection] = []
    itself: dict[str, None] = {}
    for each in connections:
        if partners.count(each) or (each.certain and remapped(each.remaps) and not partners.is_its_own(each)):
            met.append(each)
        elif partners.is_its_own(each):
            itself[visible(each.name)] = None
        else:
            alone.append(each)
    verbs = [_verb(each) for each in met]
    first = max(map(len, verbs), default=0)
    second = min(max((len(visible(each.name)) for each in met), default=0), WIDEST_NAME)
    for each, verb in zip(met, verbs, strict=True):
        arrow = "→" if each.offers else "←"
        known = [each.type, each.qos, *(text for text in each.evidence[:1] if text.startswith(READ_FROM))]
        type_ = f"  ({visible(', '.join(filter(None, known)))})" if any(known) else ""
        only = "" if each.only == node.only else f"  [{when(each.only, topology.configurations)}]" if each.only else ""
        yield f"    {verb:{first}}  {visible(each.name):{second}}  {arrow} {_partners(each, partners, topology)}{type_}{only}"
        if remapped(each.remaps):
            yield f"    {'':{first}}    {remapped(each.remaps, node.place)}"
    if itself:
        yield from wrapped("    talks to itself: ", list(itself))
    yield from _alone(alone, node, topology, dangling=dangling)


def _verb(connection: Connection) -> str:
    return DOES[connection.role] if connection.certain else f"perhaps {DOES[connection.role]}"


def _partners(connection: Connection, partners: Partners, topology: Topology) -> str:
    others = listed(partners.of(connection, MOST_PARTNERS), partners.count(connection))
    if others or partners.is_its_own(connection):
        return ", ".join(filter(None, (others, "itself" if partners.is_its_own(connection) else "")))
    who = doubted(topology.doubts.get((connection.kind, connection.name, not connection.offers), ()))
    return f"nobody here, but {visible(who)} may" if who else "nobody"


def _alone(connections: Iterable[Connection], node: TopologyNode, topology: Topology, *, dangling: bool) -> Iterator[str]:
    lists: dict[str, dict[str, None]] = {}
    perhaps = 0
    for each in connections:
        if not each.certain and not dangling:
            perhaps += 1
            continue
        only = "" if each.only == node.only or not each.only else f" [{when(each.only, topology.configurations)}]"
        said = f"{'' if each.certain else 'perhaps, and '}{missed(each, topology)}"
        lists.setdefault(said, {})[visible(each.name) + only] = None
    for said, names in lists.items():
        yield from wrapped(f"    {said}: ", list(names))
    if perhaps:
        yield f"    perhaps {counted(perhaps, 'more name')} that nobody else uses (--dangling shows {'it' if perhaps == 1 else 'them'})"


def _params(params: Sequence[TopologyParam], node: TopologyNode, topology: Topology) -> Iterator[str]:
    words = []
    for param in params[:MOST_PARAMS]:
        private = param.name.startswith(f"{node.name}/")
        name = f"~{param.name[len(node.name) + 1 :]}" if private else param.name
        value = param.value if len(param.value) <= LONGEST_VALUE else f"{param.value[: LONGEST_VALUE - 1]}…"
        only = f" [{when(param.only, topology.configurations)}]" if param.only and param.only != node.only else ""
        words.append(visible(f"{name} = {value}" if value else f'{name} = ""') + only)
    if len(params) > MOST_PARAMS:
        words.append(f"and {len(params) - MOST_PARAMS} more")
    if words:
        yield from wrapped("    reads ", words)


def _not_shown(topology: Topology, complete: Topology) -> Iterator[str]:
    """Which names were left out, where no more than a kind of names was."""
    shown = {(each.kind, each.name) for each in topology.channels}
    left = [each for each in complete.channels if (each.kind, each.name) not in shown]
    hubs = [each.name for each in left if each.hub]
    plumbing = sum(each.plumbing and not each.hub for each in left)
    said = []
    if hubs:
        said.append(f"{listed(hubs[:MOST_PARTNERS], len(hubs))} (--hubs)")
    if plumbing:
        said.append(f"{counted(plumbing, 'name')} of plumbing (--plumbing)")
    if said:
        yield ""
        yield f"not shown: {', '.join(said)}"
