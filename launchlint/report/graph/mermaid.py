"""The connection graph as a Mermaid flowchart, within what GitHub draws: 500 edges and 50,000 characters."""

from __future__ import annotations

from launchlint.graph.difference import Difference
from launchlint.graph.drawing import Arrow, Box, Drawing, draw
from launchlint.graph.topology import Topology

MOST_ARROWS = 120
"""Arrows and boxes of a picture that can still be read; GitHub gives up at 500."""
LONGEST = 50_000
"""Characters that GitHub draws."""
LONGEST_LABEL = 80

_CLASSES = (
    "classDef unknown stroke-dasharray: 2 3",
    "classDef conditional stroke-dasharray: 6 4",
    "classDef topic font-style:italic",
    "classDef added stroke:#1a7f37,stroke-width:3px",
    "classDef removed stroke:#cf222e,stroke-width:3px,stroke-dasharray: 4 4",
    "classDef changed stroke:#9a6700,stroke-width:3px",
)
_COLOURS = {"added": "#1a7f37", "removed": "#cf222e"}


def render(topology: Topology, changes: Difference | None = None, *, dangling: bool = False) -> str:
    """The flowchart, folded as far as needed; what is left out is said in a comment at its end."""
    most = MOST_ARROWS
    while True:
        text = _text(draw(topology, most, changes, dangling=dangling))
        if len(text) <= LONGEST or most <= 1:
            return text
        most //= 2


def _text(drawing: Drawing) -> str:
    ids = {box.id: f"n{number}" for number, box in enumerate(drawing.boxes)}
    children: dict[str, list[Box]] = {}
    for box in drawing.boxes:
        children.setdefault(box.parent, []).append(box)
    lines = ["flowchart LR", *_boxes(children, ids)]
    links: list[str] = []
    for number, arrow in enumerate(drawing.arrows):
        lines.append(f"  {ids[arrow.source]} {_line(arrow)} {ids[arrow.target]}")
        if arrow.mark in _COLOURS:
            links.append(f"  linkStyle {number} stroke:{_COLOURS[arrow.mark]},stroke-width:3px")
    lines += links
    used = [line for line in _CLASSES if any(f"class {ids[box.id]} {line.split()[1]}" in _classes(box, ids) for box in drawing.boxes)]
    lines += [f"  {line}" for line in used]
    lines += [f"  {each}" for box in drawing.boxes for each in _classes(box, ids)]
    if drawing.left_out:
        lines.append(f"  %% {drawing.left_out}")
    return "\n".join(lines) + "\n"


def _boxes(children: dict[str, list[Box]], ids: dict[str, str]) -> list[str]:
    """The boxes, with what is in them, without recursion: namespaces may be nested as deep as a file likes."""
    lines: list[str] = []
    waiting: list[tuple[Box | None, int]] = [(box, 1) for box in reversed(children.get("", ()))]
    while waiting:
        box, depth = waiting.pop()
        blanks = "  " * min(depth, 20)
        if box is None:
            lines.append(f"{blanks}end")
        elif box.kind == "namespace":
            lines.append(f'{blanks}subgraph {ids[box.id]} ["{_label(box.label)}"]')
            waiting.append((None, depth))
            waiting.extend((inner, depth + 1) for inner in reversed(children.get(box.id, ())))
        elif box.kind == "node":
            lines.append(f'{blanks}{ids[box.id]}["{_label(box.label)}<br/><small>{_label(box.detail)}</small>"]')
        elif box.kind == "folded":
            lines.append(
                f'{blanks}{ids[box.id]}[["{_label(box.label)}<br/><small>{box.members} node{"" if box.members == 1 else "s"}</small>"]]'
            )
        else:
            lines.append(f'{blanks}{ids[box.id]}(["{_label(box.label)}"])')
    return lines


def _classes(box: Box, ids: dict[str, str]) -> list[str]:
    names = [name for name, holds in (("unknown", box.unknown), ("conditional", box.conditional)) if holds]
    if box.kind in ("topic", "service", "action"):
        names.append("topic")
    return [f"class {ids[box.id]} {name}" for name in (*names, *([box.mark] if box.mark else []))]


def _line(arrow: Arrow) -> str:
    label = f'|"{_label(arrow.label)}"|' if arrow.labels else ""
    if arrow.kind == "action":
        return f"==>{label}"
    return f"-.->{label}" if arrow.conditional or arrow.kind == "service" else f"-->{label}"


def _label(text: str) -> str:
    """``text`` as the label of anything: whatever could end a label or begin markup is written as its code."""
    shown = text if len(text) <= LONGEST_LABEL else f"{text[: LONGEST_LABEL - 1]}…"
    plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-/.,~ …"
    return "".join(each if each in plain else f"#{ord(each)};" if each.isprintable() else "#65533;" for each in shown)
