"""The connection graph as a Mermaid flowchart, within what GitHub draws: 500 edges and 50,000 characters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.graph.difference import Difference
from launchlint.graph.topology import Topology
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.report.graph.drawing import Arrow, Box, Drawing, draw
from launchlint.report.graph.words import loading

MOST = 120
"""Arrows, and boxes, of a picture that can still be read; GitHub gives up at 500 arrows."""
FEWEST = 8
"""Arrows, and boxes, that each of several pictures gets at least."""
LONGEST = 50_000
"""Characters that GitHub draws."""
LONGEST_LABEL = 60

_CLASSES = {
    "unknown": "stroke-dasharray: 2 3",
    "conditional": "stroke-dasharray: 6 4",
    "channel": "font-style:italic",
    "note": "stroke:none,fill:none",
    "refused": "stroke:#cf222e,stroke-width:2px",
    "added": "stroke:#1a7f37,stroke-width:3px",
    "removed": "stroke:#cf222e,stroke-width:3px,stroke-dasharray: 4 4",
    "changed": "stroke:#9a6700,stroke-width:3px",
}
_LINKS = {"added": "stroke:#1a7f37,stroke-width:3px", "removed": "stroke:#cf222e,stroke-width:3px,stroke-dasharray: 4 4"}
_PLAIN = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-/.,~ …→")


class Picture(NamedTuple):
    """What one flowchart shows, or one part of it; ``title`` stands above the parts where there are several."""

    title: str
    topology: Topology
    changes: Difference | None = None


def render(topology: Topology, changes: Difference | None = None, *, dangling: bool = False) -> str:
    """The flowchart of one topology, or of what changed, folded as far as needed; what is left out is said in it."""
    return render_all([Picture("", topology, changes)], dangling=dangling)


def render_all(pictures: Sequence[Picture], *, dangling: bool = False) -> str:
    """One flowchart of all ``pictures``; with less and less in each until it is small enough."""
    most = max(MOST // max(len(pictures), 1), FEWEST)
    shown = pictures[: MOST // FEWEST]
    while True:
        drawings = [draw(each.topology, most, each.changes, dangling=dangling) for each in shown]
        titles = [each.title if len(pictures) > 1 else "" for each in shown]
        text = _text(titles, [loading(each.topology) for each in shown], drawings, len(pictures) - len(shown))
        if len(text) <= LONGEST or most <= 1:
            return text
        most //= 2


class _Lines:
    """A flowchart that is being written. Every box gets a plain name of its own, whatever it stands for."""

    def __init__(self) -> None:
        self.lines = ["flowchart LR"]
        self.links: list[str] = []
        self.classes: dict[str, list[str]] = {}
        self._arrows = 0
        self._names = 0

    def name(self) -> str:
        """A name that is not in use."""
        self._names += 1
        return f"n{self._names}"

    def write(self, depth: int, text: str) -> None:
        self.lines.append("  " * min(depth, 12) + text)

    def mark(self, name: str, classes: Iterator[str]) -> None:
        for each in classes:
            self.classes.setdefault(each, []).append(name)

    def arrow(self, source: str, target: str, arrow: Arrow) -> None:
        self.write(1, f"{source} {_line(arrow)} {target}")
        if arrow.mark:
            self.links.append(f"  linkStyle {self._arrows} {_LINKS[arrow.mark]}")
        self._arrows += 1

    def text(self) -> str:
        styles = [f"  classDef {each} {_CLASSES[each]}" for each in _CLASSES if each in self.classes]
        used = [f"  class {','.join(self.classes[each])} {each}" for each in _CLASSES if each in self.classes]
        return "\n".join([*self.lines, *self.links, *styles, *used]) + "\n"


def _text(titles: Sequence[str], verdicts: Sequence[str], drawings: Sequence[Drawing], more: int) -> str:
    out = _Lines()
    for title, verdict, drawing in zip(titles, verdicts, drawings, strict=True):
        if title:
            out.write(1, f'subgraph {out.name()} ["{_label(title)}"]')
        if verdict:
            _note(out, verdict, "refused")
        _draw(out, drawing)
        if drawing.left_out:
            _note(out, drawing.left_out)
        if title:
            out.write(1, "end")
    if more:
        _note(out, f"{more} more launch files are not shown")
    elif not any(drawing.boxes for drawing in drawings):
        _note(out, "nothing to show")
    return out.text()


def _note(out: _Lines, text: str, looks: str = "note") -> None:
    name = out.name()
    out.write(1, f'{name}["{_label(text, 200)}"]')
    out.mark(name, iter([looks]))


def _draw(out: _Lines, drawing: Drawing) -> None:
    """Boxes and arrows. Without recursion: namespaces may be nested as deep as a file likes."""
    names = {box.id: out.name() for box in drawing.boxes}
    children: dict[str, list[Box]] = {}
    for box in drawing.boxes:
        children.setdefault(box.parent, []).append(box)
    waiting: list[tuple[Box | None, int]] = [(box, 1) for box in reversed(children.get("", ()))]
    while waiting:
        each, depth = waiting.pop()
        if each is None:
            out.write(depth, "end")
        elif each.kind == "namespace" and each.id in children:
            out.write(depth, f'subgraph {names[each.id]} ["{_label(each.label)}"]')
            waiting.append((None, depth))
            waiting.extend((inner, depth + 1) for inner in reversed(children[each.id]))
        else:
            out.write(depth, f"{names[each.id]}{_shape(each)}")
        if each is not None:
            out.mark(names[each.id], _classes(each))
    for arrow in drawing.arrows:
        out.arrow(names[arrow.source], names[arrow.target], arrow)


def _shape(box: Box) -> str:
    label = _label(box.label)
    if box.kind == "folded":
        return f'[["{label}<br/>{counted(box.members, "node")}"]]'
    if box.kind in ("topic", "service", "action"):
        return f'(["{label}"])'
    return f'["{label}<br/>{_label(box.detail)}"]' if box.detail else f'["{label}"]'


def _classes(box: Box) -> Iterator[str]:
    if box.unknown:
        yield "unknown"
    if box.conditional:
        yield "conditional"
    if box.kind in ("topic", "service", "action"):
        yield "channel"
    if box.mark:
        yield box.mark


def _line(arrow: Arrow) -> str:
    label = f'|"{"<br/>".join(_label(each) for each in arrow.shown)}"|' if arrow.labels else ""
    if arrow.kind == "action":
        return f"==>{label}"
    return f"-.->{label}" if arrow.conditional or arrow.kind == "service" else f"-->{label}"


def _label(text: str, longest: int = LONGEST_LABEL) -> str:
    """``text`` as the label of anything: whatever could end a label or begin markup is written as its code."""
    shown = text if len(text) <= longest else f"{text[: longest // 3]}…{text[1 + longest // 3 - longest :]}"
    return "".join(each if each in _PLAIN else f"#{ord(each)};" if each.isprintable() else "#65533;" for each in shown)
