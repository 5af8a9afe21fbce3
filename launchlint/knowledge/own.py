"""The door: what the workspaces' own sources say of a program. Whatever costs time is imported when a program of theirs is asked for."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import Looked, question, remembered
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.knowledge.entry import Key, Known
    from launchlint.knowledge.programs import Digest, Programs
    from launchlint.workspace.states import Look, States


_CONDITIONS = {"ROS_VERSION": "2"}


class Home(NamedTuple):
    """A package, the workspace that it lies in, and how many packages of that name there are in it to be built."""

    package: Package
    root: str
    copies: int


class OwnSources:
    """What the packages of the workspaces say of their programs, those of one middleware. Never raises.

    Args:
        packages: where they are; of these only those of the workspaces count.
        root: the directory that places are told relative to.
        directory: where what was read is kept; None: nowhere.
        moved: the beginning of a path, and what people shall see instead: sources of another state lie in another place.
        middleware: packages that are built for another one only do not count.
    """

    def __init__(
        self,
        packages: Packages,
        root: str,
        directory: str | None = None,
        moved: tuple[str, str] | None = None,
        middleware: str = ROS1,
    ) -> None:
        self._packages = packages.colcon if middleware == ROS2 else packages
        self._root = root
        self._directory = directory
        self._moved = moved
        self.middleware = middleware
        self._others: dict[str, OwnSources] = {middleware: self}
        self._homes: dict[str, Home | None] = {}
        self._classes: dict[str, tuple[frozenset[str], Looked]] = {}
        self._asked: set[Key] = set()
        self._states: States | None = None

    def use(self, states: States) -> None:
        """Take ``states`` for what there is on disk, for programs of any middleware; before anything is asked for."""
        for each in self.all:
            each._states = states

    def of(self, middleware: str) -> OwnSources:
        """What the same workspaces say of programs of another middleware."""
        if middleware not in self._others:
            other = OwnSources(self._packages, self._root, self._directory, self._moved, middleware)
            other._others, other._states = self._others, self._states
            self._others[middleware] = other
        return self._others[middleware]

    @property
    def all(self) -> tuple[OwnSources, ...]:
        """Those of each middleware that was asked for."""
        return tuple(self._others[name] for name in sorted(self._others))

    def has(self, package: str) -> bool:
        """Whether a package is one of them."""
        return self.home(package) is not None

    def program(self, package: str, table: str, name: str) -> Mapping[str, Any] | None:
        """What the sources say of a program, as a library has it; None where they say nothing, or where it is not of these packages."""
        known, home = self.known((package, table, name)), self.home(package)
        return None if known is None or known.program is None or home is None else self._placed(known.program, home.root)

    def known(self, key: Key) -> Known | None:
        """What the sources say of a program, with places relative to its workspace; None where it is not of these packages."""
        home = self.home(key[0])
        if home is None:
            return None
        self._asked.add(key)
        return self._programs.known(key, home)

    def take(self, key: Key, known: Known) -> None:
        """What another process has read of a program."""
        self._programs.take(key, known)

    def keep_in(self, directory: str) -> None:
        """Keep what was read so far in ``directory``, too."""
        self._programs.keep_in(directory)

    def reason(self, package: str, table: str, name: str) -> str:
        """Why the sources say nothing of a program; empty where it is not of these packages."""
        home = self.home(package)
        return "" if home is None else self._programs.known((package, table, name), home).reason

    def packages_of_class(self, name: str, *, everywhere: bool) -> list[str]:
        """The packages that export a nodelet class: the one that it is named after, or any. Of ROS 2 the one that it is named after."""
        if self.middleware == ROS2:
            return [each for each in [name.partition("::")[0]] if self.has(each)]
        first = name.partition("/")[0]
        if name in self._classes_of(first):
            return [first]
        return list(self._packages.answer(_exporting, name)) if everywhere else []

    def asked(self) -> frozenset[Key]:
        """The programs of these packages that were asked for since this was called last."""
        taken = frozenset(self._asked)
        self._asked.clear()
        return taken

    def note(self, keys: Iterable[Key]) -> None:
        """Note that programs were asked for again."""
        self._asked.update(keys)

    def digest(self, key: Key) -> str:
        """Another one where what is known of a program may be another; empty where it is not known yet and would have to be read."""
        home = self.first(key[0])  # which middleware it is of, its manifest says, which what was read hangs on
        return "" if home is None else self._programs.digest(key, home)

    def looked(self, key: Key) -> tuple[Look, ...]:
        """All that the digest of a program hangs on, by absolute paths."""
        home = self.first(key[0])
        return () if home is None else self._programs.looks(key, home)

    def remember(self, digests: Mapping[str, Digest]) -> None:
        """Take ``digests`` of an earlier run, each as long as its looks are true."""
        self._programs.remembered.update(digests)

    @property
    def digests(self) -> dict[str, Digest]:
        """The digests of all programs that were asked for in this run."""
        return self._programs.digests

    def home(self, name: str) -> Home | None:
        """The package of this name in the first workspace that has one, if it is of the middleware."""
        found = self.first(name)
        return found if found is not None and self._is_ours(found.package) else None

    def first(self, name: str) -> Home | None:
        """The package of this name in the first workspace that has one, whatever it is of; of several those of the middleware count."""
        self._packages.copies(name)  # which notes who asks
        if name not in self._homes:
            places = ((place.root, place.by_name) for place in self._packages.own_places)
            found = ((root, self._ours(packages[name])) for root, packages in places if name in packages)
            self._homes[name] = next((Home(copies[0], root, len(copies)) for root, copies in found), None)
        return self._homes[name]

    def _ours(self, copies: Sequence[Package]) -> list[Package]:
        seen = [each.under(_CONDITIONS) for each in copies] if self.middleware == ROS2 else list(copies)
        return [each for each in seen if self._is_ours(each)] or seen if len(seen) > 1 else seen

    def _is_ours(self, package: Package) -> bool:
        is_ament = package.kind.is_ament
        return is_ament is (self.middleware == ROS2)

    def places(self) -> Iterator[tuple[str, Mapping[str, list[Package]]]]:
        """Each workspace with its packages by name."""
        for place in self._packages.places[: len(self._packages.workspaces)]:
            yield place.root, place.by_name

    def names(self) -> list[str]:
        """The names of all packages, sorted."""
        return sorted({name for _, packages in self.places() for name in packages})

    @cached_property
    def _programs(self) -> Programs:
        from launchlint.knowledge.programs import Programs

        return Programs(self, self._directory, self._states)

    def _classes_of(self, name: str) -> frozenset[str]:
        return remembered(self._classes, name, lambda: self._read_classes(name))

    def by_class(self) -> Mapping[str, Sequence[str]]:
        """The packages that export each nodelet class."""
        found: dict[str, list[str]] = {}
        for package in self.names():
            for name in self._classes_of(package):
                found.setdefault(name, []).append(package)
        return found

    def _read_classes(self, name: str) -> frozenset[str]:
        home = self.home(name)
        if home is None:
            return frozenset()
        from launchlint.workspace.nodelets import read_nodelet_classes

        return frozenset(read_nodelet_classes(home.package)[0])

    def _placed(self, program: Mapping[str, Any], root: str) -> Mapping[str, Any]:
        """The program with the places of its evidence as people see them."""
        if self._moved is not None:
            root = moved(root, *self._moved)

        def place(at: str) -> str:
            return os.path.relpath(os.path.join(root, at.removeprefix(":")), self._root).replace(os.sep, "/")

        return {**program, "variants": {name: _placed(variant, place) for name, variant in program.get("variants", {}).items()}}


@question
def _exporting(packages: Packages, name: str) -> Sequence[str]:
    """The packages of ROS 1 that export a nodelet class."""
    return packages.once(_by_class).get(name, ())


def _by_class(packages: Packages) -> Mapping[str, Sequence[str]]:
    return OwnSources(packages, "").by_class()


def moved(path: str, start: str, goal: str) -> str:
    """An absolute path that begins with ``start``, with ``goal`` instead; others stay."""
    return goal + path[len(start) :] if f"{path}/".startswith(f"{start.rstrip('/')}/") else path


def _placed(variant: Mapping[str, Any], place: Callable[[str], str]) -> dict[str, Any]:
    return {key: [_told(entry, place) for entry in value] if isinstance(value, list) else value for key, value in variant.items()}


def _told(entry: Any, place: Callable[[str], str]) -> Any:
    if not isinstance(entry, Mapping) or "evidence" not in entry:
        return entry
    return {**entry, "evidence": [{**each, "at": place(each["at"]), "here": "yes"} for each in entry["evidence"]]}
