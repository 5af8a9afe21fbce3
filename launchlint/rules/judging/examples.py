"""What others of their kind do: which of two loose ends were meant for each other is shown by two others that meet.

- In another launch file of the workspace a remap leads the same name of the same program to the other one; or, where both are left
  alone, that of another program.
- Two others like them meet in this launch: copies of their programs, or names of the same nodes that differ in one word (`left/image`
  and `right/image`).
- Another node that says the same name in its code is led to the other one by a remap.
"""

from __future__ import annotations

import posixpath
from collections.abc import Mapping, Sequence
from functools import cached_property

from launchlint.graph.connections import CATEGORY, OFFERS, Endpoint
from launchlint.graph.names import absolute
from launchlint.late import late
from launchlint.model import ROS1
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.name_places import Owners
from launchlint.rules.judging.near_names import NAMESPACE, SLIP, relation
from launchlint.rules.judging.same_definition import is_known, stands_for
from launchlint.rules.view import GraphView
from launchlint.workspace.looking import question
from launchlint.workspace.packages import Packages
from launchlint.workspace.texts import files_by_word

_LAUNCH_ENDS = (".launch", ".xml", ".test")
_MOST_FILES = 8
"""Files that are kept of those that have one remap."""
_WITH_ARGS = "$("
"""Stands for the last part of a name in which args are read."""
_SEPARATORS = late("[/_]+|(?<=[A-Za-z])(?=[0-9])")
_ARG = late(r"\$\(\s*arg\s+([^\s()]+)\s*\)")


class _Written(NamedTuple):
    """A remap of some program as it is written, and the first files (absolute) that have it."""

    source: str
    target: str
    files: tuple[str, ...]


class Examples:
    """The examples for the ends of one graph; ``owners`` as in :mod:`.name_places`."""

    def __init__(self, view: GraphView, owners: Owners) -> None:
        self._view = view
        self._owners = owners
        self._words: dict[str, list[str]] = {}

    def elsewhere(self, end: Endpoint, other: Endpoint) -> str:
        """What it says of a remap of one of the two that stands in another launch file of the workspace and would join them; else empty."""
        if self._view.dialect.name != ROS1:
            return ""
        for moved, stays in ((end, other), (other, end)):
            if moved.applied and stays.applied and relation(moved.name, stays.name) not in (NAMESPACE, SLIP):
                continue  # both are led somewhere here, as for another robot
            instance = self._owners[id(moved)]
            namer = instance.namer
            last = moved.unremapped.rpartition("/")[2]
            for written in (each for end_of in (last, _WITH_ARGS) for each in self._of_program(instance.program, end_of)):
                sides = [absolute(self._filled(side), namer.home, namer.node) for side in (written.source, written.target)]
                if sides == [moved.unremapped, stays.name] and (file := self._other(written.files)):
                    return f"{file} starts {instance.program}, too, and remaps {written.source} to {written.target} there"
        return ""

    def of_others(self, end: Endpoint, other: Endpoint) -> str:
        """What it says of a remap of another program, in another launch file, that is just what would lead the one that takes to the other.

        That it leads the one that gives to the name that is missing says less: others may give that, too.
        """
        if self._view.dialect.name != ROS1:
            return ""
        giver, taker = (end, other) if end.role in OFFERS else (other, end)
        namer = self._owners[id(taker)].namer
        for program, written in () if taker.applied else self._view.packages.answer(_of_source, taker.declared):
            joins = absolute(self._filled(written.target), namer.home, namer.node) == giver.name
            if joins and (file := self._other(written.files)) and self._has_name(program, taker):
                return f"{file} starts {program} and remaps {written.source} to {written.target} there"
        return ""

    def _has_name(self, program: str, end: Endpoint) -> bool:
        """Whether ``program`` is known to have the name of ``end`` in the same role."""
        package, _, name = program.partition("/")
        known = self._view.library.executable(package, name) or self._view.library.nodelet(program)
        declarations = () if known is None else (each for variant in known.variants for each in variant.declarations)
        return any((each.category, each.name) == (CATEGORY[end.role], end.declared) for each in declarations)

    def _other(self, files: Sequence[str]) -> str:
        """The first file that is none of this launch."""
        found = next((file for file in files if file not in self._own), "")
        inside = max((each for each in self._view.packages.workspaces if found.startswith(f"{each}/")), key=len, default="")
        return found[len(inside) :].lstrip("/")

    @cached_property
    def _own(self) -> frozenset[str]:
        return frozenset(posixpath.abspath(each.source.file) for each in self._view.documents.values())

    def _filled(self, text: str) -> str:
        """``text`` with the values that args have here."""
        return _ARG.sub(lambda found: self._args.get(found[1], found[0]), text)

    @cached_property
    def _args(self) -> Mapping[str, str]:
        """The args that have one value in all of the launch."""
        found: dict[str, set[object]] = {}
        for each in self._view.launch.declared:
            found.setdefault(each.name, set()).add(each.default if each.value is None else each.value)
        return {name: value for name, values in found.items() for value in values if len(values) == 1 and isinstance(value, str)}

    def _of_program(self, program: str, last: str) -> Sequence[_Written]:
        """The remaps of a program in the launch files of the workspace, by the last part of the name that they lead elsewhere."""
        return self._view.packages.answer(_of_last_part, f"{program}\t{last}")

    def counterparts(self, end: Endpoint, other: Endpoint) -> str:
        """What it says of two others like these two that meet each other in this launch; empty where there are none."""
        giver, taker = (end, other) if end.role in OFFERS else (other, end)
        if self._owners[id(giver)].program == self._owners[id(taker)].program:
            return ""  # the links of a chain are all alike, and its two ends are for others
        for takes in self._meeting.get((self._owners[id(taker)].program, stands_for(taker.type)), ()):
            if not self._are_alike(taker, takes):
                continue
            for gives in self._view.graph.channels[takes.kind, takes.name].offers:
                same = self._owners[id(gives)].program == self._owners[id(giver)].program
                alike = same and self._are_alike(giver, gives) and _change_alike((giver, gives), (taker, takes))
                alike = alike and (is_known(taker.type) or gives.declared == giver.declared)  # who takes any type takes any of them
                alike = alike and (taker.node != takes.node or _is_named_for(giver, taker))
                if gives.node != takes.node and alike and gives.name != giver.name:
                    return f"{takes.node} and {gives.node} meet on {takes.name} as these two do not"
        return ""

    def namesake(self, end: Endpoint, other: Endpoint) -> str:
        """What it says of another node with the name of ``end`` in its code that a remap leads to ``other``; else empty."""
        if end.applied:
            return ""
        for each in self._view.graph.channels[other.kind, other.name].uses:
            if each.node != end.node and each.certain and each.applied and each.declared.strip("~/") == end.declared.strip("~/"):
                return f"{each.node} says {each.declared}, too, which a remap leads to {other.name}"
        return ""

    def _are_alike(self, end: Endpoint, other: Endpoint) -> bool:
        """Whether they are the same name of two nodes, or two names of one node that differ in one word or number.

        The same is what the code says so, and the only one that it takes from the same argument or param. Of two results of one node the
        names must have a word in common.
        """
        if end.node == other.node:
            words, others = self._words_of(end), self._words_of(other)
            apart = sum(one != two for one, two in zip(words, others, strict=False))
            return len(words) == len(others) and apart == 1 and (len(words) > 1 or end.role not in OFFERS)
        said = end.declaration.name
        return end.declared == other.declared or (self._is_only_one(end, said) and self._is_only_one(other, said))

    def _words_of(self, end: Endpoint) -> list[str]:
        if end.declared not in self._words:
            self._words[end.declared] = _SEPARATORS.split(end.declared.lstrip("~/"))
        return self._words[end.declared]

    def _is_only_one(self, end: Endpoint, said: str) -> bool:
        """Whether ``said`` is what the code says for the name, and for no other one in that role; not where it takes any type."""
        beside = (each for each in self._owners[id(end)].endpoints if each.role == end.role and each.declaration.name == said)
        return is_known(end.type) and end.declaration.name == said and sum(1 for _ in beside) == 1

    @cached_property
    def _meeting(self) -> Mapping[tuple[str, str], Sequence[Endpoint]]:
        """By program and type those that take what somebody else gives."""
        found: dict[tuple[str, str], list[Endpoint]] = {}
        for channel in self._view.graph.channels.values():
            if not channel.is_hub and not channel.is_plumbing:
                for each in channel.uses if channel.offers else ():
                    if each.certain:
                        found.setdefault((self._owners[id(each)].program, stands_for(each.type)), []).append(each)
        return found


def _change_alike(givers: tuple[Endpoint, Endpoint], takers: tuple[Endpoint, Endpoint]) -> bool:
    """Whether the words in which two names of one node differ are the same on both sides, where both sides are of one node each."""
    if any(one.node != other.node for one, other in (givers, takers)):
        return True
    given, taken = ([set(_SEPARATORS.split(each.declared.lstrip("~/"))) for each in pair] for pair in (givers, takers))
    return [given[0] - given[1], given[1] - given[0]] == [taken[0] - taken[1], taken[1] - taken[0]]


def _is_named_for(giver: Endpoint, taker: Endpoint) -> bool:
    """Whether a name of one word, beside which its node hears others of that type, is one that the other end has, too.

    Else the two are of one type and mean different things: a cloud of obstacles is not the map, though a filter gives both of two clouds.
    """
    words = _SEPARATORS.split(taker.declared.lstrip("~/"))
    return len(words) > 1 or not {words[0], *_SEPARATORS.split(taker.name)[-1:]}.isdisjoint(_SEPARATORS.split(f"{giver.node}{giver.name}"))


class _Remaps(NamedTuple):
    """Those inside the nodes of all launch files of the workspaces, by program and last part, and by the name as it is written."""

    of_programs: Mapping[str, Sequence[_Written]]
    of_sources: Mapping[str, Sequence[tuple[str, _Written]]]


@question
def _of_last_part(packages: Packages, what: str) -> Sequence[_Written]:
    """The remaps of a program, by the last part of the name that they lead elsewhere."""
    return packages.once(_remaps).of_programs.get(what, ())


@question
def _of_source(packages: Packages, name: str) -> Sequence[tuple[str, _Written]]:
    """The remaps of all programs, by the name that they lead elsewhere, as it is written."""
    return packages.once(_remaps).of_sources.get(name, ())


def _remaps(packages: Packages) -> _Remaps:
    of_programs: dict[str, list[_Written]] = {}
    of_sources: dict[str, list[tuple[str, _Written]]] = {}
    grouped: dict[tuple[str, str], list[_Written]] = {}
    for word, files in files_by_word(packages.workspaces, _LAUNCH_ENDS, "remaps", _MOST_FILES, packages.held).items():
        program, _, names = word.partition("\t")
        source, _, target = names.partition("\t")
        last = _WITH_ARGS if "$(" in source else source.rstrip("/").rpartition("/")[2].lstrip("~")
        grouped.setdefault((program, last), []).append(_Written(source, target, files))
    for (program, last), remaps in grouped.items():
        of_programs[f"{program}\t{last}"] = remaps
        for each in remaps:
            of_sources.setdefault(each.source, []).append((program, each))
    return _Remaps(of_programs, of_sources)
