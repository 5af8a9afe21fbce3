"""A drawing with places: parts that are connected each laid out by themselves, then all of them put on one sheet."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.report.graph.drawing import Arrow, Box, Drawing
from launchlint.report.picture.layers import Point, Size, layered, layers

BETWEEN_LAYERS = 34.0
BETWEEN_BOXES = 16.0
BETWEEN_PARTS = 34.0
WIDEST = 1180.0
"""Pixels after which the next part begins a new row."""


class Name(NamedTuple):
    """The names on arrows from one box, once for all of them that have the same."""

    lines: tuple[str, ...]
    mark: str


class Sheet(NamedTuple):
    """Boxes and names of arrows with their upper left corners, and the points of each line with whether it has a head at its end."""

    boxes: Sequence[tuple[Box, Point, Size]]
    names: Sequence[tuple[Name, Point, Size]]
    lines: Sequence[tuple[Arrow, Sequence[Point], bool]]
    width: float
    height: float


class _Step(NamedTuple):
    """A part of an arrow, up to its name or from there; ``ends``: with a head. ``back``: it goes from right to left."""

    source: str
    target: str
    arrow: Arrow
    ends: bool
    back: bool

    @property
    def forward(self) -> tuple[str, str]:
        """From left to right."""
        return (self.target, self.source) if self.back else (self.source, self.target)


def sheet(drawing: Drawing, size: Callable[[Box], Size], name_size: Callable[[Name], Size] | None, widest: float = WIDEST) -> Sheet:
    """Everything of a drawing but the namespaces around boxes, which are told in the boxes. Without ``name_size`` arrows have no names."""
    boxes = {box.id: box for box in drawing.boxes if box.kind != "namespace"}
    arrows = [arrow for arrow in drawing.arrows if arrow.source in boxes and arrow.target in boxes and arrow.source != arrow.target]
    names: dict[str, Name] = {}
    steps: list[_Step] = []
    known: dict[object, str] = {}
    layer_of = layers([*boxes], [(arrow.source, arrow.target) for arrow in arrows])
    for arrow in arrows:
        back = layer_of[arrow.source] > layer_of[arrow.target]  # it closes a cycle: its name stands between its boxes all the same
        if name_size is None or not arrow.labels:
            steps.append(_Step(arrow.source, arrow.target, arrow, True, back))
            continue
        key = (arrow.source, arrow.labels, arrow.kind, arrow.mark, arrow.conditional, back)
        label = known.get(key)
        if label is None:
            label = known[key] = f"name {len(names)}"
            names[label] = Name(arrow.shown, arrow.mark)
            steps.append(_Step(arrow.source, label, arrow, False, back))
        steps.append(_Step(label, arrow.target, arrow, True, back))
    sizes = {each: size(box) for each, box in boxes.items()}
    if name_size is not None:
        sizes.update((each, name_size(name)) for each, name in names.items())
    connected = {end for step in steps for end in (step.source, step.target)}
    placed: dict[str, Point] = {}
    lines: list[tuple[Arrow, Sequence[Point], bool]] = []
    shelf = _Shelf(widest)
    for part in _parts(sizes, [(step.source, step.target) for step in steps], connected):
        own = [step for step in steps if step.source in part]
        layout = layered({each: sizes[each] for each in part}, [step.forward for step in own], BETWEEN_LAYERS, BETWEEN_BOXES)
        left, top = shelf.place(layout.width, layout.height)
        placed.update((each, (left + x, top + y)) for each, (x, y) in layout.places.items())
        for step, points in zip(own, layout.lines, strict=True):
            way = [(left + x, top + y) for x, y in points]
            lines.append((step.arrow, way[::-1] if step.back else way, step.ends))
    shelf.new_row()
    for each in sizes:
        if each not in connected:
            placed[each] = shelf.place(*sizes[each], BETWEEN_BOXES)
    return Sheet(
        [(boxes[each], placed[each], sizes[each]) for each in boxes],
        [(name, placed[each], sizes[each]) for each, name in names.items()],
        lines,
        shelf.width,
        shelf.height,
    )


class _Shelf:
    """Rows of things from left to right."""

    def __init__(self, widest: float) -> None:
        self._widest = widest
        self._left = self._top = self._bottom = 0.0
        self.width = 0.0

    @property
    def height(self) -> float:
        """Of all rows."""
        return self._bottom

    def place(self, width: float, height: float, gap: float = BETWEEN_PARTS) -> Point:
        """Where the next thing goes."""
        if self._left and self._left + width > self._widest:
            self.new_row(gap)
        left = self._left
        self._left += width + gap
        self._bottom = max(self._bottom, self._top + height)
        self.width = max(self.width, left + width)
        return left, self._top

    def new_row(self, gap: float = BETWEEN_PARTS) -> None:
        """Go on below all that is there."""
        if self._left:
            self._left, self._top = 0.0, self._bottom + gap


def _parts(sizes: Mapping[str, Size], pairs: Sequence[tuple[str, str]], connected: set[str]) -> list[dict[str, None]]:
    """What is connected, the largest parts first; each in the order of ``sizes``."""
    beside: dict[str, list[str]] = {each: [] for each in sizes}
    for source, target in pairs:
        beside[source].append(target)
        beside[target].append(source)
    part_of: dict[str, int] = {}
    for each in sizes:
        if each in connected and each not in part_of:
            waiting, number = [each], len(set(part_of.values()))
            part_of[each] = number
            for at in waiting:  # grows while it is walked
                for other in beside[at]:
                    if other not in part_of:
                        part_of[other] = number
                        waiting.append(other)
    found: dict[int, dict[str, None]] = {}
    for each in sizes:
        if each in part_of:
            found.setdefault(part_of[each], {})[each] = None
    return sorted(found.values(), key=lambda part: -len(part))
