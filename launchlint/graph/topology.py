"""The connection graph as a record: plain values, sorted, of one configuration or of several joined.

Everything that shows, exports or compares a graph starts here. Rules look at :mod:`.connections` instead, where the places are live.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from launchlint.graph.connections import OFFERS, Channel, ConnectionGraph, Endpoint, Instance
from launchlint.graph.names import kind as spelling_of
from launchlint.model import Binary, Command, Condition, Node, Scope, Unknown
from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

SAMPLE = 200
"""Characters of a param's value that are kept."""


class Container(NamedTuple):
    """A ``group`` or ``include`` of the launch files around nodes. ``id`` is its place with the includes that led there."""

    id: str
    kind: str
    label: str
    namespace: str
    place: str
    parent: str


class TopologyNode(NamedTuple):
    """A node. ``containers`` are the ids of groups and includes around it, outermost first; the other fields are those of Instance.

    ``conditions`` are the ``if`` and ``unless`` it stands under, as written; ``only`` the configurations in which it exists (args as on
    the command line), empty where it is in all of them.
    """

    name: str
    program: str
    package: str
    executable: str
    kind: str
    knowledge: str
    reason: str
    host: str
    namespace: str
    is_test: bool
    place: str
    containers: tuple[str, ...]
    open: tuple[tuple[str, str], ...]
    conditions: tuple[str, ...]
    only: tuple[str, ...]


class RemapStep(NamedTuple):
    """A remapping that acted on a name: both sides resolved, and where it is written (empty: in ``args``)."""

    source: str
    target: str
    place: str


class Connection(NamedTuple):
    """One node on one channel, and why: the fields are those of Endpoint; ``spelling`` is relative, private or global."""

    node: str
    role: str
    kind: str
    name: str
    declared: str
    spelling: str
    unremapped: str
    remaps: tuple[RemapStep, ...]
    type: str
    certain: bool
    when: str
    process: str
    action: str
    evidence: tuple[str, ...]
    only: tuple[str, ...]

    @property
    def offers(self) -> bool:
        """Whether it gives: publishes or serves."""
        return self.role in OFFERS


class TopologyChannel(NamedTuple):
    """A topic, service or action. ``types`` are those its connections have; ``hub`` and ``plumbing`` as in Channel."""

    kind: str
    name: str
    types: tuple[str, ...]
    hub: bool
    plumbing: bool


class TopologyParam(NamedTuple):
    """A param that the launch files set, and the nodes known to read it."""

    name: str
    value: str
    place: str
    readers: tuple[str, ...]
    only: tuple[str, ...]


class Topology(NamedTuple):
    """A connection graph. ``entry`` is the launch file, ``configurations`` the ways of starting it that were joined (args as text)."""

    entry: str
    configurations: tuple[str, ...]
    complete: bool
    nodes: tuple[TopologyNode, ...]
    channels: tuple[TopologyChannel, ...]
    connections: tuple[Connection, ...]
    params: tuple[TopologyParam, ...]
    containers: tuple[Container, ...]


EMPTY = Topology("", ("",), True, (), (), (), (), ())
"""What a launch file that is not there starts."""


def topology(graphs: Iterable[ConnectionGraph]) -> Topology:
    """The record of one graph, or of several configurations of one entry file joined; takes at least one."""
    records = [_record(graph) for graph in graphs]
    return records[0] if len(records) == 1 else _joined(records)


def _record(graph: ConnectionGraph) -> Topology:
    containers: dict[str, Container] = {}
    nodes = [_node(instance, containers) for instance in graph.instances]
    connections = [_connection(endpoint) for instance in graph.instances for endpoint in instance.endpoints]
    return Topology(
        graph.launch.entry.path,
        (_spelled(graph.launch.given),),
        graph.launch.complete,
        tuple(sorted(nodes)),
        tuple(_channel(channel) for channel in graph.channels.values()),
        tuple(sorted(connections)),
        tuple(_params(graph)),
        tuple(containers[key] for key in sorted(containers)),
    )


def _spelled(given: Sequence[tuple[str, str]]) -> str:
    return " ".join(f"{name}:={value}" for name, value in given)


def place_text(place: Place) -> str:
    """``path:line:column``."""
    line, column = place.source.position(place.span.start)
    return f"{place.source.path}:{line}:{column}"


def _node(instance: Instance, containers: dict[str, Container]) -> TopologyNode:
    node = instance.node
    return TopologyNode(
        instance.name,
        instance.program,
        node.package,
        node.executable,
        instance.kind,
        instance.knowledge,
        instance.reason,
        instance.host,
        node.namespace.rstrip("/") or "/",
        node.is_test,
        place_text(node.attributes.get("name", node.origin.place)),
        _containers(node, containers),
        tuple(sorted(instance.open.items())),
        tuple(_condition(condition) for condition in node.conditions),
        (),
    )


def _condition(condition: Condition) -> str:
    return f'{condition.attribute}="{condition.place.text}"'


def _containers(node: Node, known: dict[str, Container]) -> tuple[str, ...]:
    """The ids of the groups and includes around a node, outermost first; what is new goes into ``known``."""
    scopes: list[Scope] = []
    scope = node.scope
    while scope is not None:
        scopes.append(scope)
        scope = scope.parent
    ids: list[str] = []
    for scope in reversed(scopes):
        key = _id(scope.origin)
        ids.append(key)
        if key not in known:
            place = place_text(scope.origin.place)
            label = scope.namespace.rstrip("/") or "/"
            known[key] = Container(key, scope.kind, label, label, place, ids[-2] if len(ids) > 1 else "")
    return tuple(ids)


def _id(origin: Origin) -> str:
    return " > ".join(place_text(place) for place in (*origin.chain, origin.place))


def _connection(endpoint: Endpoint) -> Connection:
    steps = tuple(
        RemapStep(each.source, each.target, "" if each.rule.remap is None else place_text(each.rule.remap.origin.place))
        for each in endpoint.applied
    )
    evidence = tuple(f"{each['by']}: {each.get('at') or each.get('run') or ''}" for each in endpoint.declaration.evidence)
    return Connection(
        endpoint.node,
        endpoint.role,
        endpoint.kind,
        endpoint.name,
        endpoint.declared,
        spelling_of(endpoint.declared),
        endpoint.unremapped,
        steps,
        endpoint.type,
        endpoint.certain,
        endpoint.declaration.when,
        endpoint.process,
        endpoint.action,
        evidence,
        (),
    )


def _channel(channel: Channel) -> TopologyChannel:
    types = tuple(sorted({endpoint.type for endpoint in (*channel.offers, *channel.uses) if endpoint.type not in ("", "*")}))
    return TopologyChannel(channel.kind, channel.name, types, channel.is_hub, channel.is_plumbing)


def _params(graph: ConnectionGraph) -> Iterable[TopologyParam]:
    for name in sorted(graph.launch.parameters):
        setting = graph.launch.parameters[name]
        readers = tuple(sorted({reading.node for reading in graph.readers.get(name, ())}))
        yield TopologyParam(name, _value(setting.value), place_text(setting.origin.place), readers, ())


def _value(value: Any) -> str:
    if isinstance(value, Unknown):
        return f"unknown: {value.reason}"
    if isinstance(value, Command):
        text = f"output of: {value.line}"
    elif isinstance(value, Binary):
        text = f"{value.length} bytes"
    else:
        text = value if isinstance(value, str) else repr(value)
    return text if len(text) <= SAMPLE else f"{text[: SAMPLE - 1]}…"


def _joined(records: Sequence[Topology]) -> Topology:
    """What is in any of the records, each with the configurations it is in."""
    first = records[0]
    configurations = tuple(record.configurations[0] for record in records)
    channels: dict[tuple[str, str], TopologyChannel] = {}
    for record in records:
        for channel in record.channels:
            known = channels.get((channel.kind, channel.name))
            if known is not None:
                types = tuple(sorted({*known.types, *channel.types}))
                channel = TopologyChannel(*channel[:2], types, known.hub or channel.hub, known.plumbing and channel.plumbing)
            channels[channel.kind, channel.name] = channel
    containers = {container.id: container for record in records for container in record.containers}
    return Topology(
        first.entry,
        configurations,
        all(record.complete for record in records),
        _marked([record.nodes for record in records], configurations),
        tuple(channels[key] for key in sorted(channels)),
        _marked([record.connections for record in records], configurations),
        _marked([record.params for record in records], configurations),
        tuple(containers[key] for key in sorted(containers)),
    )


def _marked(columns: Sequence[tuple[Any, ...]], configurations: Sequence[str]) -> tuple[Any, ...]:
    """All items of all columns, each once; ``only`` says in which configurations, where not in all."""
    where: dict[Any, list[str]] = {}
    for column, configuration in zip(columns, configurations, strict=True):
        for item in dict.fromkeys(column):
            where.setdefault(item, []).append(configuration)
    return tuple(
        sorted(item if len(found) == len(columns) else item._replace(only=tuple(found)) for item, found in where.items())
    )  # fmt: skip
