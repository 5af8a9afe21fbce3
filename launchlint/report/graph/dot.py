"""The connection graph for Graphviz."""

from __future__ import annotations

from launchlint.graph.difference import Difference
from launchlint.graph.drawing import Arrow, Box, draw
from launchlint.graph.topology import Topology

_COLOURS = {"added": "#1a7f37", "removed": "#cf222e", "changed": "#9a6700"}


def render(topology: Topology, changes: Difference | None = None, *, dangling: bool = False) -> str:
    """All of it, nothing folded, in the DOT language."""
    drawing = draw(topology, None, changes, dangling=dangling)
    ids = {box.id: f"n{number}" for number, box in enumerate(drawing.boxes)}
    children: dict[str, list[Box]] = {}
    for box in drawing.boxes:
        children.setdefault(box.parent, []).append(box)
    lines = ["digraph connections {", "  rankdir=LR;", '  node [shape=box, fontname="sans-serif"];', '  edge [fontname="sans-serif"];']
    waiting: list[tuple[Box | None, int]] = [(box, 1) for box in reversed(children.get("", ()))]
    while waiting:
        each, depth = waiting.pop()
        blanks = "  " * min(depth, 20)
        if each is None:
            lines.append(f"{blanks}}}")
        elif each.kind == "namespace":
            lines.append(f"{blanks}subgraph cluster_{ids[each.id]} {{ label={_quoted(each.label)};")
            waiting.append((None, depth))
            waiting.extend((inner, depth + 1) for inner in reversed(children.get(each.id, ())))
        else:
            lines.append(f"{blanks}{ids[each.id]} [{_attributes(each)}];")
    lines += [f"  {ids[arrow.source]} -> {ids[arrow.target]} [{_arrow(arrow)}];" for arrow in drawing.arrows]
    return "\n".join([*lines, "}"]) + "\n"


def _attributes(box: Box) -> str:
    is_channel = box.kind in ("topic", "service", "action")
    found = [f"label={_quoted(box.label if is_channel else box.label + chr(10) + box.detail)}"]
    if is_channel:
        found.append("shape=ellipse")
    if box.unknown or box.conditional:
        found.append(f'style="{"dotted" if box.unknown else "dashed"}"')
    if box.mark:
        found.append(f'color="{_COLOURS[box.mark]}", penwidth=3')
    return ", ".join(found)


def _arrow(arrow: Arrow) -> str:
    found = [f"label={_quoted(arrow.label)}"] if arrow.labels else []
    if arrow.kind != "topic" or arrow.conditional:
        found.append(f'style="{"dashed" if arrow.kind == "service" or arrow.conditional else "bold"}"')
    if arrow.mark:
        found.append(f'color="{_COLOURS[arrow.mark]}", penwidth=3')
    return ", ".join(found)


def _quoted(text: str) -> str:
    """A DOT string that is text only: none of Graphviz's own escapes, no HTML."""
    shown = "".join(each if each.isprintable() or each == "\n" else "\ufffd" for each in text)
    return '"' + shown.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
