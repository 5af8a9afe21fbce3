"""The connection graph for Graphviz."""

from __future__ import annotations

from launchlint.graph.difference import Difference
from launchlint.graph.topology import Topology
from launchlint.report.graph.drawing import Arrow, Box, draw
from launchlint.report.graph.words import loading

LONGEST_LABEL = 1_000

_COLOURS = {"added": "#1a7f37", "removed": "#cf222e", "changed": "#9a6700"}


def render(topology: Topology, changes: Difference | None = None, *, title: str = "", dangling: bool = False) -> str:
    """All of it, nothing folded, in the DOT language; what changed is coloured, what is gone is dashed."""
    drawing = draw(topology, None, changes, dangling=dangling)
    ids = {box.id: f"n{number}" for number, box in enumerate(drawing.boxes, 1)}
    children: dict[str, list[Box]] = {}
    for box in drawing.boxes:
        children.setdefault(box.parent, []).append(box)
    lines = ["digraph connections {", "  rankdir=LR;", '  node [shape=box, fontname="sans-serif"];', '  edge [fontname="sans-serif"];']
    caption = "; ".join(filter(None, (title, loading(topology), drawing.left_out)))
    if caption:
        lines.append(f"  label={_quoted(caption)};")
    waiting: list[tuple[Box | None, int]] = [(box, 1) for box in reversed(children.get("", ()))]
    while waiting:
        each, depth = waiting.pop()
        blanks = "  " * min(depth, 12)
        if each is None:
            lines.append(f"{blanks}}}")
        elif each.kind == "namespace":
            lines.append(f"{blanks}subgraph cluster_{ids[each.id]} {{ label={_quoted(each.label)};")
            waiting.append((None, depth))
            waiting.extend((inner, depth + 1) for inner in reversed(children.get(each.id, ())))
        else:
            lines.append(f"{blanks}{ids[each.id]} [{_attributes(each)}];")
    for arrow in drawing.arrows:
        attributes = _arrow(arrow)
        lines.append(f"  {ids[arrow.source]} -> {ids[arrow.target]}{f' [{attributes}]' if attributes else ''};")
    return "\n".join([*lines, "}"]) + "\n"


def _attributes(box: Box) -> str:
    found = [f"label={_quoted(box.label, box.detail)}"]
    if box.kind in ("topic", "service", "action"):
        found.append("shape=ellipse")
    if box.unknown or box.conditional or box.mark == "removed":
        found.append(f'style="{"dotted" if box.unknown else "dashed"}"')
    if box.mark:
        found.append(f'color="{_COLOURS[box.mark]}", penwidth=3')
    return ", ".join(found)


def _arrow(arrow: Arrow) -> str:
    found = [f"label={_quoted(*arrow.shown)}"] if arrow.labels else []
    if arrow.kind == "service" or arrow.conditional or arrow.mark == "removed":
        found.append('style="dashed"')
    elif arrow.kind == "action":
        found.append('style="bold"')
    if arrow.mark:
        found.append(f'color="{_COLOURS[arrow.mark]}", penwidth=3')
    return ", ".join(found)


def _quoted(*lines: str) -> str:
    """A DOT string that is text only, in these lines: none of Graphviz's own escapes, no HTML, no character references."""
    shown = (line if len(line) <= LONGEST_LABEL else f"{line[: LONGEST_LABEL - 1]}…" for line in lines if line)
    return '"' + "\\n".join("".join(_harmless(each) for each in line) for line in shown) + '"'


def _harmless(character: str) -> str:
    if character in '\\"':
        return f"\\{character}"
    return "&amp;" if character == "&" else character if character.isprintable() else "\ufffd"
