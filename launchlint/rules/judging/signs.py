"""What speaks for it that two loose ends were meant for each other, beside their names and their type.

- A name below the node itself (``~odom``), on which no remap acts: nobody publishes there unless he was told to. It says nothing of a node
  that listens to several such names, of which a remap leads one somewhere and leaves two or more: they are inputs to choose from.
- A remap on one of two ends that would meet without it.
- A remap in another node, where it does nothing, that would join them; or in its own, with a letter too many, too few or wrong in the name
  that it is to lead elsewhere.
- A remap that leads what a node says to the name that it hears itself, where nobody else says anything.
- A name that all other nodes of the same program have remapped.

None of these counts for the two ends of a chain of nodes: what its last one gives is of the type of what its first one takes, and is not
meant for it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cached_property

from launchlint.evaluate.problems import RemapReplaced
from launchlint.graph.connections import OFFERS, Channel, ConnectionGraph, Endpoint, Reading
from launchlint.graph.names import absolute
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.name_places import Owners, is_inside
from launchlint.rules.judging.near_names import SLIP, relation
from launchlint.rules.judging.same_definition import stands_for
from launchlint.source import Place

_MOST_NODES = 2_000
"""Of longer chains nothing is said."""
_NAMES = ("publishers", "subscribers", "services", "clients", "actions")
_OWN_AND_OTHER = 2
"""Nodes of which one at least is another than a given one."""
Role = tuple[str, str, str]
"""Program, role and the name in its code."""


class Standing(str):
    """What is said of a remap, with the ``place`` where it stands."""

    place: Place

    @classmethod
    def at(cls, place: Place, text: str) -> Standing:
        """``text`` about the remap at ``place``, with the number of its line."""
        line, _ = place.source.position(place.span.start)
        said = cls(text.format(f"{place.source.path}:{line}"))
        said.place = place
        return said


class _Stray(NamedTuple):
    """The two sides of a remap, as written, its place, and a node that it stands in (empty where it stands there twice).

    ``sure``: the node has no such name. Else not all of its names are known: a container of controllers has theirs.
    """

    source: str
    target: str
    place: Place
    node: str
    sure: bool


class _Alike(NamedTuple):
    """One end of all nodes of a program: the first two, of two nodes, and up to two nodes in which no remap leads it to somebody."""

    first: list[Endpoint]
    left: set[str]


class Signs:
    """The signs in one graph; ``owners`` as in :mod:`.places`."""

    def __init__(self, graph: ConnectionGraph, owners: Owners) -> None:
        self._graph = graph
        self._owners = owners

    def is_left_private(self, end: Endpoint) -> bool:
        """Whether it is a private name on which no remap acts."""
        return _is_private(end) and not end.applied

    def is_waiting_private(self, end: Endpoint) -> bool:
        """Whether it is left private, and none of several inputs of its node of which the launch file chose another one."""
        return self.is_left_private(end) and not (end.role == "subscriber" and end.node in self._choosing)

    def parting_remap(self, end: Endpoint, other: Endpoint) -> str:
        """What it says of the remap of one of the two, and of none of the other, that it parts them; empty where none does.

        It says nothing where what the giver says comes of what the taker hears: without that remap they are a loop.
        """
        giver, taker = (end, other) if end.role in OFFERS else (other, end)
        if bool(end.applied) == bool(other.applied) or self._leads_to(taker.node, giver.node):
            return ""
        moved, stays = (end, other) if end.applied else (other, end)
        return f"without that remap they meet on {stays.name}" if moved.unremapped == stays.name else ""

    def stray_remap(self, end: Endpoint, other: Endpoint, *, only_ends: bool) -> str:
        """What it says of a remap that does nothing in its own node and would lead one of the two to the other; empty where none does.

        ``only_ends``: both are loose ends. Then a node that may have the name, though nothing says so, is one that has not.
        """
        for moved, stays in ((end, other), (other, end)):
            namer = self._owners[id(moved)].namer
            strays = () if moved.applied else self._strays.get(moved.unremapped.rpartition("/")[2], ())
            for stray in (each for each in strays if each.sure or only_ends):
                sides = [absolute(side, namer.home, namer.node) for side in (stray.source, stray.target)]
                if sides == [moved.unremapped, stays.name]:
                    return Standing.at(stray.place, f"a remap of {stray.source} to {stray.target} stands at {{}}, where it does nothing")
        return ""

    def misspelt_remap(self, end: Endpoint, other: Endpoint) -> str:
        """What it says of a remap in the node of one of the two that would lead it to the other but for a slip; empty where none does.

        Not all of the names of that node need be known: it has this one, and on the other side just the name is left that was meant.
        """
        for moved, stays in ((end, other), (other, end)):
            namer = self._owners[id(moved)].namer
            for stray in () if moved.applied else self._strays_in.get(moved.node, ()):
                source, target = (absolute(side, namer.home, namer.node) for side in (stray.source, stray.target))
                if target == stays.name and relation(source, moved.unremapped) == SLIP:
                    said = f"a remap of {stray.source} to {stray.target} stands at {{}}; {moved.node} says {moved.declared}"
                    return Standing.at(stray.place, said)
        return ""

    def hears_itself(self, end: Endpoint) -> str:
        """What it says of a remap that leads what a node says to what it hears; empty where somebody else is there, or the code does so."""
        channel = self._graph.channels[end.kind, end.name]
        if end.role in OFFERS or not hears_itself(channel):
            return ""
        said = channel.offers[0].declared
        return f"{end.node} hears nobody but itself there: what it says as {said} and what it hears as {end.declared} is {end.name}"

    def is_led_in_vain(self, end: Endpoint, other: Endpoint) -> bool:
        """Whether a remap with the name of ``other`` stands in the node of ``end`` and acts on nothing: it is told by LL601."""
        namer = self._owners[id(end)].namer
        return any(absolute(each, namer.home, namer.node) == other.name for each in self._vain.get(end.node, ()))

    def odd_one_out(self, end: Endpoint) -> str:
        """What it says of a name that no remap acts on, while one does in all other nodes of the program, and makes them meet somebody."""
        if end.applied:
            return ""
        alike = self._alike.get(self._role(end))
        other = None if alike is None else next((each for each in alike.first if each.node != end.node), None)
        if alike is None or other is None or not alike.left <= {end.node}:
            return ""
        return f"{other.node} is the same program and has its {end.declared} remapped to {other.name}"

    def are_one_chain(self, givers: list[Endpoint], takers: list[Endpoint]) -> bool:
        """Whether what ``givers`` give follows from what ``takers`` hear, by messages of the same type alone: then it is for others."""
        type_ = stands_for(takers[0].type)
        return _is_reached({each.node for each in takers}, {each.node for each in givers}, lambda node: self._hears.get((type_, node), ()))

    def _leads_to(self, node: str, other: str) -> bool:
        """Whether what ``node`` says, or answers, goes to ``other``, by way of others or not."""
        return _is_reached({node}, {other}, lambda each: self._taken_by.get(each, ()))

    @cached_property
    def _taken_by(self) -> dict[str, dict[str, None]]:
        """For each node those that hear it or call it. What everybody hears leads nowhere."""
        found: dict[str, dict[str, None]] = {}
        for (_, giver), takers in self._hears.items():
            found.setdefault(giver, {}).update(dict.fromkeys(takers))
        return found

    @cached_property
    def _choosing(self) -> frozenset[str]:
        """The nodes with a private topic to listen to that a remap leads somewhere, and two or more that none does."""
        found: set[str] = set()
        for instance in self._graph.instances:
            inputs = [each for each in instance.endpoints if each.role == "subscriber" and not each.is_plumbing and _is_private(each)]
            left = sum(not each.applied for each in inputs)
            if 2 <= left < len(inputs):
                found.update(each.node for each in inputs)
        return frozenset(found)

    @cached_property
    def _alike(self) -> dict[Role, _Alike]:
        found: dict[Role, _Alike] = {}
        for instance in self._graph.instances:
            for each in instance.endpoints:
                if not each.certain or each.is_plumbing:
                    continue
                alike = found.setdefault(self._role(each), _Alike([], set()))
                if all(each.node != other.node for other in alike.first) and len(alike.first) < _OWN_AND_OTHER:
                    alike.first.append(each)
                if len(alike.left) < _OWN_AND_OTHER and not (each.applied and self._meets(each)):
                    alike.left.add(each.node)
        return found

    def _role(self, end: Endpoint) -> Role:
        return self._owners[id(end)].program, end.role, end.declared

    def _meets(self, end: Endpoint) -> bool:
        channel = self._graph.channels[end.kind, end.name]
        return any(each.node != end.node for each in (channel.uses if end.role in OFFERS else channel.offers))

    @cached_property
    def _strays(self) -> dict[str, list[_Stray]]:
        """Each remap inside a node that acts on none of its known names, or stands there twice, by the last part of its source."""
        acting: set[Place] = set()
        for instance in self._graph.instances:
            entries: list[Endpoint | Reading] = [*instance.endpoints, *instance.readings]
            for entry in entries:
                acting.update(each.rule.remap.origin.place for each in entry.applied if each.rule.remap is not None)
        found: dict[Place, tuple[str, str, str, bool]] = {}
        for instance in self._graph.instances:
            sure = not any(map(instance.may_have_more, _NAMES))
            for remap in () if instance.is_unknown else instance.node.remaps:
                if remap.source and remap.origin.place not in acting and is_inside(remap, instance):
                    found[remap.origin.place] = (remap.source, remap.target, instance.name, sure)
        for problem in self._graph.launch.noticed(RemapReplaced):
            if problem.old == problem.new:
                found[problem.origin.place] = (problem.key, problem.new, "", True)
        strays: dict[str, list[_Stray]] = {}
        for place, (source, target, node, sure) in found.items():
            stray = _Stray(source, target, place, node, sure)
            strays.setdefault(source.rpartition("/")[2].lstrip("~"), []).append(stray)
        return strays

    @cached_property
    def _strays_in(self) -> dict[str, list[_Stray]]:
        """The same by the node that they stand in."""
        found: dict[str, list[_Stray]] = {}
        for each in (stray for strays in self._strays.values() for stray in strays):
            found.setdefault(each.node, []).append(each)
        return found

    @cached_property
    def _vain(self) -> dict[str, list[str]]:
        """For each node both sides of the remaps inside it that act on nothing."""
        found: dict[str, list[str]] = {}
        for strays in self._strays.values():
            for each in (stray for stray in strays if stray.sure):
                found.setdefault(each.node, []).extend((each.source, each.target))
        return found

    @cached_property
    def _hears(self) -> dict[tuple[str, str], list[str]]:
        """For each type and node those that hear it say that. Of what everybody hears nothing follows."""
        found: dict[tuple[str, str], dict[str, None]] = {}
        for channel in self._graph.channels.values():
            if channel.is_hub or channel.is_plumbing:
                continue
            for giver in channel.offers:
                key = (stands_for(giver.type), giver.node)
                found.setdefault(key, {}).update((taker.node, None) for taker in channel.uses if taker.node != giver.node)
        return {key: list(others) for key, others in found.items()}


def _is_reached(nodes: set[str], wanted: set[str], following: Callable[[str], Iterable[str]]) -> bool:
    """Whether one leads from ``nodes`` to one of ``wanted``, or to more of them than are looked at."""
    waiting = list(nodes)
    while waiting and not nodes & wanted and len(nodes) < _MOST_NODES:
        more = [each for each in following(waiting.pop()) if each not in nodes]
        nodes.update(more)
        waiting += more
    return bool(nodes & wanted) or len(nodes) >= _MOST_NODES


def hears_itself(channel: Channel) -> bool:
    """Whether one node alone says and hears it, and only since a remap makes one name of two in its code."""
    ends = (*channel.offers, *channel.uses)
    if not channel.offers or not channel.uses or len({each.node for each in ends}) != 1:
        return False
    return any(each.applied for each in ends) and not {each.declared for each in channel.offers} & {each.declared for each in channel.uses}


def _is_private(end: Endpoint) -> bool:
    return end.declared.startswith("~")
