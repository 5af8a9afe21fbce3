"""Names that try to break out of whatever they are written into."""

from __future__ import annotations

from launchlint.graph.topology import Topology
from tests.graph import tiny

NAMES = (
    "plain",
    'quote"',
    "end",
    '"];click n1 "javascript:alert(1)"',
    '"]--> x',
    "</data><script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "a\nb",
    "a\r\nlinkStyle 0 stroke:red",
    "%%{init: {'securityLevel': 'loose'}}%%",
    "back\\slash\\N\\",
    "\x1b[31mred",
    "\x00nul",
    "\u202egnp.exe",
    "\ud800lone",
    "\udcff",
    "\ufffe",
    "emoji😀",
    "#35;",
    "&amp;&#x22;",
    "`**markdown**`",
    "{{rhombus}}",
    "::notice file=x::",
    "##[group]",
    "subgraph",
    "graph TD;",
    "—ẞ漢",
    "n" * 10_000,
)


def topology(size: int = 0) -> Topology:
    """All of them as names of nodes, topics, namespaces and programs; ``size`` times, each in a namespace of its own."""
    facts = []
    nodes = []
    for copy in range(max(size, 1)):
        for number, name in enumerate(NAMES):
            path = f"/c{copy}/{name}/{name}{number}" if size else f"/{name}/{name}{number}"
            nodes.append(tiny.node(path, f"pkg/{name}", conditions=(f'if="{name}"',)))
            facts.append((path, f"/{name}", ">"))
            facts.append((path, f"/{name}", "<"))
            facts.append((path, f"/{NAMES[number - 1]}", "<"))
    connections = tuple(
        tiny.connection("/a > /x" if sign == ">" else "/a < /x")._replace(
            node=node, name=name, declared=name, unremapped=name, type=name, process=node
        )
        for node, name, sign in facts
    )
    empty = tiny.topology(nodes=nodes, entry='"]\n<b>::error::.launch')
    channels = {(each.kind, each.name) for each in connections}
    shown = tuple(tiny.topology("/a > /x").channels[0]._replace(name=name, types=(name,)) for _, name in sorted(channels))
    return empty._replace(connections=tuple(sorted(connections)), channels=shown)


def changed() -> tuple[Topology, Topology]:
    """Two topologies of such names that differ in many ways."""
    before = topology()
    others = tuple(each._replace(name=f"{each.name}'") if number % 2 else each for number, each in enumerate(before.connections))
    return before, before._replace(nodes=before.nodes[::2], connections=others)
