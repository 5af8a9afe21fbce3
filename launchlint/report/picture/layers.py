"""Boxes in layers from left to right, so that arrows point one way; the lines between them go around what stands in their way.

The usual four steps (Sugiyama, Tagawa and Toda, 1981): turn the arrows that close a cycle, give every box a layer, order each layer so that
few lines cross, and move the boxes of a layer towards what they are connected with.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from launchlint.named_tuple import NamedTuple

Point = tuple[float, float]
Size = tuple[float, float]

SWEEPS = 6
"""How often the layers are ordered by what stands before or after them."""


class Layout(NamedTuple):
    """Where each box has its upper left corner, and the points that each arrow passes, from side to side; in the order of the arrows."""

    places: Mapping[str, Point]
    lines: Sequence[Sequence[Point]]
    width: float
    height: float


def layered(sizes: Mapping[str, Size], arrows: Sequence[tuple[str, str]], between_layers: float, between_boxes: float) -> Layout:
    """The layout of boxes that arrows connect. An arrow from a box to itself has no points."""
    layer_of = layers([*sizes], arrows)
    full = dict(sizes)
    chains: list[list[str]] = []
    for number, (source, target) in enumerate(arrows):
        if source == target:
            chains.append([])
            continue
        first, last = (source, target) if layer_of[source] < layer_of[target] else (target, source)
        chain = [first]
        for layer in range(layer_of[first] + 1, layer_of[last]):
            passed = f"{number} {layer}"  # no id of a box begins with a number
            layer_of[passed] = layer
            full[passed] = (0.0, 0.0)
            chain.append(passed)
        chain.append(last)
        chains.append(chain)
    columns: list[list[str]] = [[] for _ in range(1 + max(layer_of.values(), default=0))]
    for box in sizes:
        columns[layer_of[box]].append(box)
    for chain in chains:
        for passed in chain[1:-1]:
            columns[layer_of[passed]].append(passed)
    before, after = _neighbours(chains)
    for sweep in range(SWEEPS):
        _order(columns, before if sweep % 2 == 0 else after, forward=sweep % 2 == 0)
    middles = _middles(columns, full, before, after, between_boxes)
    widths = [max((full[box][0] for box in layer), default=0.0) for layer in columns]
    starts = [sum(widths[:at]) + at * between_layers for at in range(len(columns))]
    places = {
        box: (starts[at] + (widths[at] - full[box][0]) / 2, middles[box] - full[box][1] / 2)
        for at, layer in enumerate(columns)
        for box in layer
    }
    top = min((y for _, y in places.values()), default=0.0)
    places = {box: (x, y - top) for box, (x, y) in places.items()}
    lines = [_line(chain, arrow, places, full, starts, widths, layer_of) for chain, arrow in zip(chains, arrows, strict=True)]
    height = max((places[box][1] + full[box][1] for box in places), default=0.0)
    return Layout({box: places[box] for box in sizes}, lines, starts[-1] + widths[-1], height)


def layers(boxes: Sequence[str], arrows: Sequence[tuple[str, str]]) -> dict[str, int]:
    """The layer of each box: behind all that point at it, but for arrows that close a cycle; as near to what it points at as can be."""
    following: dict[str, list[str]] = {box: [] for box in boxes}
    for source, target in arrows:
        if source != target:
            following[source].append(target)
    done: dict[str, None] = {}  # in the order in which they are left: whatever is reached first, last
    forward: dict[str, list[str]] = {box: [] for box in boxes}
    entered: set[str] = set()
    targets = {target for source, target in arrows if source != target}
    for start in sorted(boxes, key=lambda box: box in targets):
        stack = [(start, iter(following[start]))] if start not in entered else []
        entered.add(start)
        while stack:
            box, rest = stack[-1]
            for each in rest:
                if each not in entered:
                    forward[box].append(each)
                    entered.add(each)
                    stack.append((each, iter(following[each])))
                    break
                if each in done:
                    forward[box].append(each)
                else:
                    forward[each].append(box)  # it would close a cycle
            else:
                done[box] = None
                stack.pop()
    order = _topological(forward)
    layer = dict.fromkeys(order, 0)
    for box in order:
        for each in forward[box]:
            layer[each] = max(layer[each], layer[box] + 1)
    pointed = {each for those in forward.values() for each in those}
    for box in reversed(order):
        if forward[box] and box not in pointed:
            layer[box] = min(layer[each] for each in forward[box]) - 1
    return layer


def _topological(forward: Mapping[str, Sequence[str]]) -> list[str]:
    waiting = dict.fromkeys(forward, 0)
    for those in forward.values():
        for each in those:
            waiting[each] += 1
    order = [box for box, count in waiting.items() if count == 0]
    for box in order:  # grows while it is walked
        for each in forward[box]:
            waiting[each] -= 1
            if waiting[each] == 0:
                order.append(each)
    return order


def _neighbours(chains: Sequence[Sequence[str]]) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    before: dict[str, list[str]] = {}
    after: dict[str, list[str]] = {}
    for chain in chains:
        for left, right in pairwise(chain):
            after.setdefault(left, []).append(right)
            before.setdefault(right, []).append(left)
    return before, after


def _order(columns: list[list[str]], beside: Mapping[str, Sequence[str]], *, forward: bool) -> None:
    """Order each layer by the mean place of what each of its boxes is connected with; what is connected with nothing keeps its place."""
    steps = list(pairwise(columns))
    pairs = steps if forward else [(right, left) for left, right in reversed(steps)]
    for fixed, moved in pairs:
        place = {box: at for at, box in enumerate(fixed)}
        wanted = {}
        for at, box in enumerate(moved):
            near = [place[each] for each in beside.get(box, ()) if each in place]
            wanted[box] = sum(near) / len(near) if near else float(at)
        moved.sort(key=lambda box: wanted[box])


def _middles(
    columns: Sequence[Sequence[str]], sizes: Mapping[str, Size], before: Mapping[str, Sequence[str]], after: Mapping[str, Sequence[str]],
    gap: float,
) -> dict[str, float]:  # fmt: skip
    """The height at which the middle of each box is."""
    middle: dict[str, float] = {}
    for layer in columns:
        at = 0.0
        for box in layer:
            middle[box] = at + sizes[box][1] / 2
            at += sizes[box][1] + gap
    for turn in range(SWEEPS):
        for layer in columns if turn % 2 == 0 else reversed(columns):
            near = [[*before.get(box, ()), *after.get(box, ())] for box in layer]
            wanted = [
                sum(middle[each] for each in those) / len(those) if those else middle[box] for box, those in zip(layer, near, strict=True)
            ]
            middle.update(zip(layer, _apart(wanted, [sizes[box][1] for box in layer], gap), strict=True))
    return middle


def _apart(wanted: Sequence[float], heights: Sequence[float], gap: float) -> list[float]:
    """The places nearest to those wanted (least squares) that keep the order and the gaps: neighbours that collide move as one."""
    offsets = [0.0]
    for one, other in pairwise(heights):
        offsets.append(offsets[-1] + (one + other) / 2 + gap)
    pools: list[tuple[float, int]] = []  # mean of what its boxes want, and how many they are
    for want, offset in zip(wanted, offsets, strict=False):
        mean, count = want - offset, 1
        while pools and pools[-1][0] > mean:
            other, number = pools.pop()
            mean, count = (mean * count + other * number) / (count + number), count + number
        pools.append((mean, count))
    means = [mean for mean, count in pools for _ in range(count)]
    return [mean + offset for mean, offset in zip(means, offsets, strict=False)]


def _line(
    chain: Sequence[str], arrow: tuple[str, str], places: Mapping[str, Point], sizes: Mapping[str, Size], starts: Sequence[float],
    widths: Sequence[float], layer_of: Mapping[str, int],
) -> list[Point]:  # fmt: skip
    if not chain:
        return []
    (left, left_top), (right, right_top) = places[chain[0]], places[chain[-1]]
    points = [(left + sizes[chain[0]][0], left_top + sizes[chain[0]][1] / 2)]
    for passed in chain[1:-1]:
        layer, height = layer_of[passed], places[passed][1]
        points += [(starts[layer], height), (starts[layer] + widths[layer], height)]
    points.append((right, right_top + sizes[chain[-1]][1] / 2))
    return points if chain[0] == arrow[0] else points[::-1]
