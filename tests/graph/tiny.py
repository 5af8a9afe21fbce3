"""Topologies as tests write them down, in a few words, and random ones."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from hypothesis import strategies as st

from launchlint.graph.topology import Connection, Container, Topology, TopologyChannel, TopologyNode

ROLES = {
    ">": ("publisher", "topic"),
    "<": ("subscriber", "topic"),
    "serves": ("server", "service"),
    "calls": ("client", "service"),
    "does": ("action server", "action"),
    "asks": ("action client", "action"),
}


def node(name: str, program: str = "demo/node", **others: object) -> TopologyNode:
    """A node that the file ``demo.launch`` starts."""
    namespace = name.rpartition("/")[0] or "/"
    package, _, executable = program.partition("/")
    fields = TopologyNode(
        name, program, package, executable, "node", "known", "", name, namespace, False, "demo.launch:1:1", "", (), (), ()
    )
    return fields._replace(**others)  # type: ignore[arg-type]  # the caller names fields of a node


def connection(fact: str) -> Connection:
    """``/a > /x``: /a publishes /x; also ``<``, ``serves``, ``calls``, ``does``, ``asks``. A ? behind it: perhaps; ``@sim:=true``: only so.

    ``/a > x=/y``: the code says x, the name on the graph is /y.
    """
    fact, _, only = fact.partition(" @")
    name, sign, channel = fact.split(" ")
    role, kind = ROLES[sign]
    channel, certain = channel.rstrip("?"), not channel.endswith("?")
    declared, _, real = channel.rpartition("=")
    configurations = tuple("" if each == "-" else each for each in only.split(",")) if only else ()
    return Connection(name, role, kind, real, declared or real, "global", real, (), "", certain, "start", name, "", (), configurations)


def topology(
    *facts: str,
    nodes: Iterable[TopologyNode] = (),
    configurations: Sequence[str] = ("",),
    containers: Iterable[Container] = (),
    hubs: Iterable[str] = (),
    plumbing: Iterable[str] = (),
    entry: str = "demo.launch",
) -> Topology:
    """A topology of these connections; ``nodes`` are given where there is more to say of them than their names."""
    connections = sorted(connection(fact) for fact in facts)
    named = {each.name for each in nodes}
    others = (node(name) for name in sorted({each.node for each in connections} - named))
    channels = sorted({(each.kind, each.name) for each in connections})
    return Topology(
        entry,
        tuple(configurations),
        True,
        tuple(sorted((*nodes, *others))),
        tuple(TopologyChannel(kind, name, (), name in hubs, name in plumbing) for kind, name in channels),
        tuple(connections),
        (),
        tuple(sorted(containers)),
    )


CONFIGURATIONS = ("", "sim:=true", "slow:=true")
NAMESPACES = ("", "/a", "/a/b", "/a/b/c", "/d", "/d/e/f")


@st.composite
def topologies(draw: st.DrawFn) -> Topology:
    """Some nodes in some namespaces, on few channels, in up to three configurations."""
    configurations = CONFIGURATIONS[: draw(st.integers(1, 3))]
    names = draw(st.lists(st.tuples(st.sampled_from(NAMESPACES), st.sampled_from("mnop")), min_size=1, max_size=9, unique=True))
    paths = [f"{namespace}/{last}" for namespace, last in names]
    when = st.one_of(st.just(()), st.lists(st.sampled_from(configurations), min_size=1, max_size=2, unique=True))
    sign = st.sampled_from(sorted(ROLES))
    facts = draw(st.lists(st.tuples(st.sampled_from(paths), sign, st.sampled_from("xyz"), st.booleans(), when), max_size=24))
    words = []
    for path, how, channel, certain, only in facts:
        chosen = sorted(only, key=configurations.index)
        shown = "" if not only or len(chosen) == len(configurations) else " @" + ",".join(each or "-" for each in chosen)
        words.append(f"{path} {how} /{channel}{'' if certain else '?'}{shown}")
    unknown = draw(st.sets(st.sampled_from(paths)))
    nodes = [node(path, knowledge="unknown" if path in unknown else "known") for path in paths]
    return topology(*dict.fromkeys(words), nodes=nodes, configurations=configurations)


def pairs(of: Topology) -> set[tuple[str, str, str, str]]:
    """Every giver, kind and name of a channel, and taker that meet in some configuration: pairwise, the slow and plain way."""
    return {
        (one.node, one.kind, one.name, other.node)
        for one in of.connections
        for other in of.connections
        if one.offers and not other.offers and (one.kind, one.name) == (other.kind, other.name) and one.node != other.node
        if set(one.only or of.configurations) & set(other.only or of.configurations)
    }
