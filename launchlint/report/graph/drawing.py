"""What a picture of a topology shows: boxes in boxes, and arrows between them; folded until it can be read.

A channel with one box at one of its ends is drawn as arrows from box to box; another one is a box of its own, so that p publishers and s
subscribers make p + s arrows. Of two topologies only what changed is drawn, with what it is connected to.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.graph.difference import Difference
from launchlint.graph.topology import Topology, TopologyNode
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.report.graph.folding import Tree
from launchlint.report.graph.presence import Part, Presence, changed, whole

BUNDLE = 3
"""From so many names on, an arrow says their number instead."""
LONELY = 4
"""So many nodes of one namespace without any connection become one box."""


class Box(NamedTuple):
    """A node, a channel, a namespace (open, or folded), or ``others``: nodes without connections.

    ``members`` is the number of nodes in a folded one, ``unknown`` says whether nothing is known of what it (or all of them) does;
    ``mark`` is added, removed, changed or empty.
    """

    id: str
    parent: str
    kind: str
    label: str
    detail: str
    members: int = 0
    unknown: bool = False
    conditional: bool = False
    mark: str = ""


class Arrow(NamedTuple):
    """From box to box; ``kind`` is topic, service or action, ``labels`` the names of its channels."""

    source: str
    target: str
    kind: str
    labels: tuple[str, ...]
    conditional: bool = False
    mark: str = ""

    @property
    def shown(self) -> tuple[str, ...]:
        """The names, or how many there are."""
        return self.labels if len(self.labels) < BUNDLE else (f"{len(self.labels)} {self.kind}s",)


class Drawing(NamedTuple):
    """``left_out`` says in words what is not shown; empty where everything is."""

    boxes: tuple[Box, ...]
    arrows: tuple[Arrow, ...]
    left_out: str


class _End(NamedTuple):
    """A box at one side of a channel: when it is there (a bit for each configuration, of before and of after), and whether for certain."""

    when: int
    certain: bool


_Ends = tuple[list[tuple[str, _End]], list[tuple[str, _End]]]


def draw(topology: Topology, most: int | None = None, changes: Difference | None = None, *, dangling: bool = False) -> Drawing:
    """The drawing of a topology with at most ``most`` arrows and as many boxes; with ``changes``, of what is new or gone.

    ``dangling``: channels that nobody else uses are boxes, too. Without ``most`` nothing is folded.
    """
    if changes is None:
        presence = Presence(topology)
        picture = _Picture(whole(topology, presence, dangling=dangling), presence)
    else:
        presence = Presence(changes.before, changes.after)
        picture = _Picture(changed(changes, presence, dangling=dangling), presence)
    if most is None:
        return picture.drawn(picture.tree.namespaces, gather=False)
    order = picture.tree.order(picture.lonely, LONELY, most)
    drawing = picture.drawn(order)
    if len(drawing.arrows) > most:
        fits, too_many = 0, len(order)
        while too_many - fits > 1:
            middle = (fits + too_many) // 2
            if len(picture.drawn(order[:middle]).arrows) <= most:
                fits = middle
            else:
                too_many = middle
        drawing = picture.drawn(order[:fits])
    return drawing if max(len(drawing.arrows), len(drawing.boxes)) <= most else _cut(drawing, most)


class _Picture:
    """A topology made ready for being drawn at different levels of detail."""

    def __init__(self, part: Part, presence: Presence) -> None:
        self._part = part
        self._presence = presence
        self._nodes = {node.name: node for node in part.topology.nodes}
        self._sides: dict[tuple[str, str], _Ends] = {}
        for when, each in part.connections:
            if each.node in self._nodes:
                self._sides.setdefault((each.kind, each.name), ([], []))[not each.offers].append((each.node, _End(when, each.certain)))
        connected = set(part.marks)
        for channel, (offers, uses) in self._sides.items():
            names = {name for name, _ in (*offers, *uses)}
            if channel in part.alone or (offers and uses and len(names) > 1):
                connected |= names
        self.lonely = frozenset(self._nodes.keys() - connected)
        self.tree = Tree(self._nodes.values())

    def drawn(self, opened: Iterable[str], *, gather: bool = True) -> Drawing:
        """The drawing with these namespaces open, all others folded."""
        boxes: dict[str, Box] = {}
        box_of: dict[str, str] = {}
        open_ = frozenset(opened)
        alone: dict[str, list[TopologyNode]] = {}
        for name, node in self._nodes.items():
            path, folded = self.tree.visible(node.namespace, open_)
            parent = ""
            for namespace in path:
                key = f"namespace {namespace}"
                if key not in boxes:
                    boxes[key] = Box(key, parent, "namespace", self.tree.label(namespace), "")
                parent = key
            if folded:
                box_of[name] = key = f"folded {folded}"
                known = boxes.get(key) or Box(key, parent, "folded", self.tree.label(folded), "", unknown=True)
                mark = "changed" if known.mark or name in self._part.marks else ""
                unknown = known.unknown and node.knowledge == "unknown"
                boxes[key] = known._replace(members=known.members + 1, unknown=unknown, mark=mark)
            elif gather and name in self.lonely:
                alone.setdefault(parent, []).append(node)
            else:
                box_of[name] = self._add_node(boxes, node, parent)
        for parent, nodes in alone.items():
            if len(nodes) < LONELY:
                for node in nodes:
                    self._add_node(boxes, node, parent)
            else:
                unknown_ones = sum(node.knowledge == "unknown" for node in nodes)
                detail = f"{unknown_ones} of them unknown" if unknown_ones else ""
                label = f"{len(nodes)} nodes without known connections"
                key = f"others {parent}"
                boxes[key] = Box(key, parent, "others", label, detail, len(nodes), unknown_ones == len(nodes))
        arrows = self._arrows(boxes, box_of)
        folded_away = sum(box.members for box in boxes.values() if box.kind == "folded")
        said = [f"{counted(self._part.unchanged, 'node')} did not change and are not shown"] if self._part.unchanged else []
        said += [f"{counted(folded_away, 'node')} are folded into their namespaces"] if folded_away else []
        return Drawing(tuple(boxes[key] for key in sorted(boxes)), arrows, "; ".join(said))

    def _add_node(self, boxes: dict[str, Box], node: TopologyNode, parent: str) -> str:
        key = f"node {node.name}"
        unknown, conditional = node.knowledge == "unknown", bool(node.only or node.conditions)
        label = node.name.rpartition("/")[2]
        boxes[key] = Box(key, parent, "node", label, node.program, 0, unknown, conditional, self._part.marks.get(node.name, ""))
        return key

    def _arrows(self, boxes: dict[str, Box], box_of: Mapping[str, str]) -> tuple[Arrow, ...]:
        presence = self._presence
        found: dict[tuple[str, str, str, bool, str], dict[str, None]] = {}

        def arrow(source: str, target: str, kind: str, label: str, when: int, certain: bool) -> None:
            if kind != "topic":
                source, target = target, source
            conditional = not certain or not presence.is_always(when)
            found.setdefault((source, target, kind, conditional, presence.mark(when)), {})[label] = None

        for (kind, name), (offers, uses) in sorted(self._sides.items()):
            givers, takers = _by_box(offers, box_of), _by_box(uses, box_of)
            if not givers or not takers:
                if (kind, name) not in self._part.alone:
                    continue
            elif len(givers) == 1 or len(takers) == 1:
                for giver, first in givers.items():
                    for taker, second in takers.items():
                        if giver != taker and first.when & second.when:
                            arrow(giver, taker, kind, name, first.when & second.when, first.certain and second.certain)
                continue
            key = f"{kind} {name}"
            given, taken = _together(givers), _together(takers)
            mark = presence.mark(given & taken or given | taken)
            parent = _around([*givers, *takers], boxes)
            boxes[key] = Box(key, parent, kind, name, "", conditional=not givers or not takers, mark=mark)
            for box, end in givers.items():
                arrow(box, key, kind, "", end.when & taken or end.when, end.certain)
            for box, end in takers.items():
                arrow(key, box, kind, "", end.when & given or end.when, end.certain)
        return tuple(
            Arrow(source, target, kind, tuple(label for label in labels if label), conditional, mark)
            for (source, target, kind, conditional, mark), labels in sorted(found.items())
        )


def _by_box(ends: Iterable[tuple[str, _End]], box_of: Mapping[str, str]) -> dict[str, _End]:
    found: dict[str, _End] = {}
    for name, end in ends:
        box = box_of.get(name)
        if box is None:
            continue  # one of those that were gathered because they talk to nobody
        known = found.get(box)
        found[box] = end if known is None else _End(known.when | end.when, known.certain or end.certain)
    return found


def _around(keys: Iterable[str], boxes: Mapping[str, Box]) -> str:
    """The innermost box that holds all of these."""
    common: list[str] | None = None
    for start in dict.fromkeys(boxes[key].parent for key in keys):
        outward = []
        at = start
        while at:
            outward.append(at)
            at = boxes[at].parent
        inward = outward[::-1]
        common = inward if common is None else [one for one, other in zip(common, inward, strict=False) if one == other]
    return common[-1] if common else ""


def _together(ends: Mapping[str, _End]) -> int:
    when = 0
    for end in ends.values():
        when |= end.when
    return when


def _cut(drawing: Drawing, most: int) -> Drawing:
    """The part of a drawing that fits: changed arrows first, then those between the busiest boxes."""
    by_id = {box.id: box for box in drawing.boxes}
    busy: dict[str, int] = {}
    for arrow in drawing.arrows:
        for end in (arrow.source, arrow.target):
            busy[end] = busy.get(end, 0) + 1
    arrows: list[Arrow] = []
    kept: set[str] = set()

    def keep(*keys: str) -> bool:
        wanted: set[str] = set()
        for key in keys:
            while key and key not in kept and key not in wanted:
                wanted.add(key)
                key = by_id[key].parent
        if len(kept) + len(wanted) > most:
            return False
        kept.update(wanted)
        return True

    for arrow in sorted(drawing.arrows, key=lambda each: (not each.mark, -busy[each.source] - busy[each.target], each)):
        if len(arrows) < most and keep(arrow.source, arrow.target):
            arrows.append(arrow)
    for box in sorted(drawing.boxes, key=lambda each: (not each.mark, each.kind != "node", each.id)):
        if len(kept) >= most or not box.mark:
            break
        keep(box.id)
    gone = f"{len(drawing.arrows) - len(arrows)} arrows and {len(drawing.boxes) - len(kept)} boxes are left out"
    left_out = f"{drawing.left_out}; {gone}" if drawing.left_out else gone
    return Drawing(tuple(box for box in drawing.boxes if box.id in kept), tuple(sorted(arrows)), left_out)
