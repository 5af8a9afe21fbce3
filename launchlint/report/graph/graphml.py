"""The connection graph as GraphML, for yEd, Gephi, networkx and the like."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.graph.multigraph import multigraph
from launchlint.graph.topology import Topology
from launchlint.report.escape import xml

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" \
xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">
"""


def render(topology: Topology) -> str:
    """The multigraph of a topology (:mod:`launchlint.graph.multigraph`) in GraphML; ids are like ``topic /scan``.

    Characters that XML cannot hold, or that nobody can see, are shown as escapes; a backslash is written as two, so that no two names
    become one. networkx has a writer, but it takes seven times as long, and lets characters through that XML forbids.
    """
    graph = multigraph(topology)
    vertices = [(_id(key), attributes) for key, attributes in graph.nodes(data=True)]
    edges = [(_id(source), _id(target), key, attributes) for source, target, key, attributes in graph.edges(keys=True, data=True)]
    keys = {("node", name): f"n{number}" for number, name in enumerate(sorted({name for _, attributes in vertices for name in attributes}))}
    keys.update(
        (("edge", name), f"e{number}") for number, name in enumerate(sorted({name for *_, attributes in edges for name in attributes}))
    )
    lines = [f'  <key id="{key}" for="{what}" attr.name="{name}" attr.type="{_type(name)}"/>' for (what, name), key in keys.items()]
    lines.append('  <key id="g0" for="graph" attr.name="entry" attr.type="string"/>')
    if topology.verdict is not None:
        lines.append('  <key id="g1" for="graph" attr.name="verdict" attr.type="string"/>')
    lines.append('  <graph edgedefault="directed">')
    lines.append(f'    <data key="g0">{_text(topology.entry)}</data>')
    if topology.verdict is not None:
        lines.append(f'    <data key="g1">{_text(topology.verdict.sentence)}</data>')
    for key, attributes in vertices:
        lines += [f'    <node id="{key}">', *_data("node", attributes, keys), "    </node>"]
    for source, target, key, attributes in edges:
        lines += [f'    <edge id="{key}" source="{source}" target="{target}">', *_data("edge", attributes, keys), "    </edge>"]
    return _HEAD + "\n".join([*lines, "  </graph>", "</graphml>"]) + "\n"


def _data(what: str, attributes: Mapping[str, Any], keys: Mapping[tuple[str, str], str]) -> Iterable[str]:
    for name, value in sorted(attributes.items()):
        if value != "":
            text = _text(value) if isinstance(value, str) else "true" if value else "false"
            yield f'      <data key="{keys[what, name]}">{text}</data>'


def _type(name: str) -> str:
    return "boolean" if name in ("hub", "plumbing", "certain") else "string"


def _id(vertex: tuple[str, str]) -> str:
    return _text(" ".join(vertex))


def _text(text: str) -> str:
    return xml(text.replace("\\", "\\\\").replace("\n", "\\n"))
