"""The connection graph as a record: plain values, sorted, of one configuration or of several joined.

Everything that shows, exports or compares a graph starts here. Rules look at :mod:`.connections` instead, where the places are live.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from operator import itemgetter

from launchlint.graph.connections import HUB_SIZE, HUBS, OFFERS, Channel, ConnectionGraph, Endpoint, Instance
from launchlint.graph.doubts import NO_DOUBTS, NOTHING_PARTLY, End, MayBe, Partly
from launchlint.graph.names import kind as spelling_of
from launchlint.graph.qos import qos_text
from launchlint.library.terms import evidence_text
from launchlint.model import Binary, Command, Condition, Node, Scope, Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.verdict import Verdict

SAMPLE = 200
"""Characters of a param's value that are kept."""


class Container(NamedTuple):
    """A ``group`` or ``include`` of the launch files around nodes.

    ``id`` is its place with the includes that led there, ``parent`` the id of the container around it (empty: none). ``label`` is the
    namespace of a group (empty where it has none of its own), the file of an include.
    """

    id: str
    kind: str
    label: str
    namespace: str
    place: str
    parent: str


class TopologyNode(NamedTuple):
    """A node. ``container`` is the id of the innermost group or include around it (empty: none); other fields are those of Instance.

    Several may have one name: alternatives of which one runs, or a mistake. ``conditions`` are the ``if`` and ``unless`` it stands under,
    as written; ``only`` the configurations in which it exists (args as on the command line), empty where it is in all of them.
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
    container: str
    open: tuple[tuple[str, str], ...]
    conditions: tuple[str, ...]
    only: tuple[str, ...]


class RemapStep(NamedTuple):
    """A remapping that acted on a name: both sides resolved, and where it is written (empty: in ``args``)."""

    source: str
    target: str
    place: str


class Connection(NamedTuple):
    """One node on one channel, and why: the fields are those of Endpoint.

    ``spelling`` is relative, private or global; ``only`` as in TopologyNode; ``qos`` is what is known of its quality of service, in words.
    """

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
    qos: str = ""

    @property
    def offers(self) -> bool:
        """Whether it gives: publishes or serves."""
        return self.role in OFFERS


class TopologyChannel(NamedTuple):
    """A topic, service or action. ``types`` are those its connections have; ``plumbing`` as in Channel.

    ``hub``: everybody uses it, like ``/tf``, or many say it and many hear it.
    """

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
    """A connection graph. ``entry`` is the launch file, ``configurations`` the ways of starting it that were joined (args as text).

    ``verdict`` is what roslaunch makes of the launch file, ``doubts`` and ``partly`` are those of :mod:`.doubts`; None and
    empty where that was not asked.
    """

    entry: str
    configurations: tuple[str, ...]
    complete: bool
    nodes: tuple[TopologyNode, ...]
    channels: tuple[TopologyChannel, ...]
    connections: tuple[Connection, ...]
    params: tuple[TopologyParam, ...]
    containers: tuple[Container, ...]
    verdict: Verdict | None = None
    doubts: Mapping[End, tuple[MayBe, ...]] = NO_DOUBTS
    partly: Partly = NOTHING_PARTLY


EMPTY = Topology("", ("",), True, (), (), (), (), ())
"""What a launch file that is not there starts."""


_NOT_XML = (".py", ".yaml", ".yml")
_REFERENCES = (("&quot;", '"'), ("&apos;", "'"), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&"))


def topology(graphs: Iterable[ConnectionGraph]) -> Topology:
    """The record of one graph, or of several configurations of one entry file joined; takes at least one."""
    recorded = _Recorded()
    records = [_record(graph, recorded) for graph in graphs]
    if len(records) > 1:
        return _joined(records)
    (record,) = records
    # Two nodes of one name, which is a mistake, may say the same.
    return record._replace(nodes=tuple(sorted(record.nodes)), connections=tuple(sorted(dict.fromkeys(record.connections))))


class _Recorded:
    """What was recorded of instances and nodes that several configurations share (:mod:`.earlier`): it is the same in each of them."""

    def __init__(self) -> None:
        self._nodes: dict[int, tuple[Instance, TopologyNode]] = {}
        self._connections: dict[int, tuple[Instance, list[Connection]]] = {}
        self._params: dict[tuple[str, int], tuple[Node, list[TopologyParam]]] = {}

    def node(self, instance: Instance, containers: _Containers) -> TopologyNode:
        """The node of one instance; the containers around it are made known."""
        container = containers.of(instance.node)
        known = self._nodes.get(id(instance))
        if known is None:
            known = self._nodes[id(instance)] = (instance, _node(instance, container))
        return known[1]

    def connections(self, instance: Instance) -> list[Connection]:
        """Those of one instance."""
        known = self._connections.get(id(instance))
        if known is None:  # the instance is kept, so that its number stays its own
            known = self._connections[id(instance)] = (instance, [_connection(endpoint) for endpoint in instance.endpoints])
        return known[1]

    def params(self, name: str, node: Node) -> list[TopologyParam]:
        """What a node of this name has for itself."""
        known = self._params.get((name, id(node)))
        if known is None:
            place = place_text(node.origin.place)
            own = sorted((node.own or {}).items(), key=itemgetter(0))
            params = [TopologyParam(f"{name}:{inner}", value_text(value), place, (name,), ()) for inner, (_, value) in own]
            known = self._params[name, id(node)] = (node, params)
        return known[1]


def _record(graph: ConnectionGraph, recorded: _Recorded) -> Topology:
    """The record of one graph; its nodes and connections are not sorted yet."""
    containers = _Containers(graph)
    nodes = tuple(recorded.node(instance, containers) for instance in graph.instances)
    return Topology(
        graph.launch.entry.path,
        (_spelled(graph.launch.given),),
        graph.launch.complete,
        nodes,
        tuple(_channel(channel) for channel in graph.channels.values()),
        tuple(connection for instance in graph.instances for connection in recorded.connections(instance)),
        tuple(_params(graph, recorded)),
        tuple(containers.known[key] for key in sorted(containers.known)),
    )


def _spelled(given: Sequence[tuple[str, str]]) -> str:
    return " ".join(f"{name}:={value}" for name, value in given)


def place_text(place: Place) -> str:
    """``path:line:column``."""
    return place.source.address(place.span.start)


def _node(instance: Instance, container: str) -> TopologyNode:
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
        place_text(node.places.get("name", node.origin.place)),
        container,
        tuple(sorted(instance.open.items())),
        tuple(_condition(condition) for condition in node.conditions),
        (),
    )


def _condition(condition: Condition) -> str:
    if condition.attribute in ("maybe", "unknown"):
        return f"maybe: {condition.text}"
    return f'{condition.attribute}="{_resolved(condition.place)}"'


def _resolved(place: Place) -> str:
    """What is written at ``place``, with the characters that references of XML stand for."""
    text = place.text
    if "&" not in text or place.source.path.endswith(_NOT_XML):
        return text
    for reference, character in _REFERENCES:
        text = text.replace(reference, character)
    return text


class _Containers:
    """The groups and includes around the nodes of a graph; ``known`` is by id. Linear, however deep they are nested."""

    def __init__(self, graph: ConnectionGraph) -> None:
        self.known: dict[str, Container] = {}
        self._ids: dict[int, str] = {}  # by identity: comparing scopes would walk up all of them
        self._files = {
            origin_text(include.origin): include.file if include.source is None else include.source.path
            for include in graph.launch.includes
        }

    def of(self, node: Node) -> str:
        """The id of the innermost one around a node; empty where there is none."""
        waiting: list[Scope] = []
        scope = node.scope
        while scope is not None and id(scope) not in self._ids:
            waiting.append(scope)
            scope = scope.parent
        inner = "" if scope is None else self._ids[id(scope)]
        for each in reversed(waiting):
            inner = self._ids[id(each)] = self._add(each, inner)
        return inner

    def _add(self, scope: Scope, parent: str) -> str:
        key = origin_text(scope.origin)
        namespace = scope.namespace.rstrip("/") or "/"
        if key not in self.known:
            around = self.known[parent].namespace if parent else "/"
            label = self._files.get(key, "") if scope.kind == "include" else "" if namespace == around else namespace
            self.known[key] = Container(key, scope.kind, label, namespace, place_text(scope.origin.place), parent)
        return key


def origin_text(origin: Origin) -> str:
    """Where something is written, with the includes that lead there: the id of a container."""
    return " > ".join(place_text(place) for place in (*origin.chain, origin.place))


def _connection(endpoint: Endpoint) -> Connection:
    steps = tuple(
        RemapStep(each.source, each.target, "" if each.rule.remap is None else place_text(each.rule.remap.origin.place))
        for each in endpoint.applied
    )
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
        tuple(map(evidence_text, endpoint.declaration.evidence)),
        (),
        qos_text(endpoint.qos) if endpoint.qos else "",
    )


def _channel(channel: Channel) -> TopologyChannel:
    types = tuple(sorted({endpoint.type for endpoint in (*channel.offers, *channel.uses) if endpoint.type not in ("", "*")}))
    crowded = min(len(channel.offers), len(channel.uses)) > 1 and len(channel.offers) * len(channel.uses) >= HUB_SIZE
    return TopologyChannel(channel.kind, channel.name, types, channel.name in HUBS or crowded, channel.is_plumbing)


def _params(graph: ConnectionGraph, recorded: _Recorded) -> Iterable[TopologyParam]:
    for name, node in sorted(graph.parameters.of_nodes, key=itemgetter(0)):
        yield from recorded.params(name, node)
    for name in sorted(graph.launch.parameters):
        setting = graph.launch.parameters[name]
        readers = tuple(sorted({reading.node for reading in graph.readers.get(name, ())}))
        yield TopologyParam(name, value_text(setting.value), place_text(setting.origin.place), readers, ())


def value_text(value: Any) -> str:
    """A param's value as text, at most :data:`SAMPLE` characters of it."""
    if type(value) is str and len(value) <= SAMPLE:
        return value
    if isinstance(value, Unknown):
        return f"unknown: {value.reason}"
    if isinstance(value, Command):
        text = f"output of: {value.line}"
    elif isinstance(value, Binary):
        text = f"{value.length} bytes"
    elif isinstance(value, bool):
        text = "true" if value else "false"
    elif isinstance(value, str):
        text = value
    elif isinstance(value, float):
        text = repr(value)
    else:
        text = _shortened(value)
    return text if len(text) <= SAMPLE else f"{text[: SAMPLE - 1]}…"


def _shortened(value: Any) -> str:
    """A number, list or mapping as Python writes it; of a large one the beginning."""
    from reprlib import Repr

    short = Repr()
    short.maxlevel, short.maxlist, short.maxdict, short.maxstring, short.maxlong = 4, SAMPLE, SAMPLE, SAMPLE, SAMPLE
    return short.repr(value)


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
        _marked([record.nodes for record in records], configurations, _same_node),
        tuple(channels[key] for key in sorted(channels)),
        _marked([record.connections for record in records], configurations, _same_connection),
        _marked([record.params for record in records], configurations, _same_param),
        tuple(containers[key] for key in sorted(containers)),
    )


def _same_node(node: TopologyNode) -> Any:
    return (node.name, node.program, node.place, node.container)


def _same_connection(connection: Connection) -> Any:
    return connection._replace(certain=True, when="", process="", evidence=())


def _same_param(param: TopologyParam) -> Any:
    return (param.name, param.value, param.place)


class _Group:
    """Items of several configurations that count as one: what is shown of it, and the numbers of the configurations that have it."""

    __slots__ = ("item", "numbers")

    def __init__(self, item: Any) -> None:
        self.item = item
        self.numbers: list[int] = []

    def take(self, item: Any, number: int) -> None:
        """Take in one more. The first configuration that has it says what is shown, of several items there the first in order.

        What is certain in some of them only is not certain; a param is read by all who read it in any of them.
        """
        known = self.item
        if number == self.numbers[0] and item < known:
            known, item = item, known
        if isinstance(item, Connection):
            known = known._replace(certain=False) if known.certain and not item.certain else known
        elif isinstance(item, TopologyParam) and item.readers != known.readers:
            known = known._replace(readers=tuple(sorted({*known.readers, *item.readers})))
        self.item = known


def _marked(columns: Sequence[tuple[Any, ...]], configurations: Sequence[str], same: Callable[[Any], Any]) -> tuple[Any, ...]:
    """All items of all columns, the ``same`` ones once; ``only`` says in which configurations they are, where not in all.

    Most columns share most of their items, which are looked at once.
    """
    groups: dict[Any, _Group] = {}
    group_of: dict[int, _Group] = {}
    for number, column in enumerate(columns):
        for item in column:
            group = group_of.get(id(item))
            if group is None:
                key = same(item)
                group = groups.get(key)
                if group is None:
                    group = groups[key] = _Group(item)
                else:
                    group.take(item, number)
                group_of[id(item)] = group
            if not group.numbers or group.numbers[-1] != number:
                group.numbers.append(number)
    return tuple(
        sorted(
            each.item
            if len(each.numbers) == len(columns)
            else each.item._replace(only=tuple(configurations[number] for number in each.numbers))
            for each in groups.values()
        )
    )
