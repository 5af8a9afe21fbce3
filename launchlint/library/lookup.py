"""All libraries of a run as one: what is known of an executable, a nodelet class or a component.

What a person wrote comes before what was seen in a run, that before what was read from source (:mod:`.merge`); of equals the user's
libraries, the last one first, come before the one that launchlint ships. Only what is asked for is read. What the checked packages' own
sources say is asked for unless a library of the user describes the program or saw it run, and comes before what launchlint ships of the
public version (:mod:`.precedence`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property

from launchlint.library.program import Program, program
from launchlint.library.shipped import SEPARATORS, Bundled
from launchlint.library.terms import TABLES
from launchlint.model import ROS1, ROS2
from launchlint.workspace.looking import Looked, note, remembered

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Protocol

    from launchlint.library.file import LibraryFile

    Key = tuple[str, str, str]

    class Own(Protocol):
        """What the sources of the checked packages say of their programs; read when it is asked for."""

        def of(self, middleware: str) -> Own:
            """What they say of programs of another middleware."""

        def has(self, package: str) -> bool:
            """Whether a package is one of them."""

        def program(self, package: str, table: str, name: str) -> Mapping[str, Any] | None:
            """What they say of a program, as JSON; None where they say nothing."""

        def reason(self, package: str, table: str, name: str) -> str:
            """Why they say nothing; empty where the program is of no package that is here."""

        def packages_of_class(self, name: str, *, everywhere: bool) -> list[str]:
            """The packages that export a nodelet class or component: the one that it is named after, or any."""

        def asked(self) -> frozenset[Key]:
            """The programs that were asked for since this was called last."""

        def note(self, keys: Iterable[Key]) -> None:
            """Note that programs were asked for again."""


LONGEST_LIKE = 5
"""Steps from one program to another that it is said to be like."""


class Library:
    """What the nodes of a run are known to do.

    Args:
        files: the user's libraries.
        bundled: whether what launchlint ships counts.
        own: the sources of the checked packages.
        middleware: only packages of it are seen.
        borrowed: whether packages of version 1, which does not say which middleware they are of, serve ROS 2, too.
    """

    def __init__(
        self,
        files: Sequence[LibraryFile] = (),
        *,
        bundled: bool = True,
        own: Own | None = None,
        middleware: str = ROS1,
        borrowed: bool = True,
    ) -> None:
        self._files = tuple(files)
        self._bundled = Bundled(middleware) if bundled else None
        self._own = own
        self._middleware = middleware
        self._borrowed = borrowed
        self._loadable = TABLES[middleware][1]
        self._programs: dict[Key, tuple[Program | None, Looked]] = {}
        self._hangs_on: dict[Key, frozenset[Key]] = {}

    @cached_property
    def ros2(self) -> Library:
        """What the same libraries say of nodes of ROS 2."""
        own = None if self._own is None else self._own.of(ROS2)
        return Library(self._files, bundled=self._bundled is not None, own=own, middleware=ROS2)

    def of_launch(self, dialect: str) -> Library:
        """What they say of what a launch file of a dialect starts."""
        return self.ros2 if dialect == ROS2 else self

    def of(self, middleware: str) -> Library:
        """What the same libraries say of packages that are of ``middleware`` and say so, where the format lets them."""
        bundled = self._bundled is not None
        return self if middleware == ROS1 else Library(self._files, bundled=bundled, middleware=middleware, borrowed=False)

    @property
    def digests(self) -> tuple[str, ...]:
        """The SHA-256 of each of the user's libraries."""
        return tuple(file.digest for file in self._files)

    def executable(self, package: str, name: str) -> Program | None:
        """What is known of an executable; None where nothing is."""
        return self._program(package, "executables", name)

    def nodelet(self, name: str) -> Program | None:
        """What is known of a nodelet class, in ROS 2 of a component; None where nothing is."""
        for package in self.packages_of_class(name):
            found = self._program(package, self._loadable, name)
            if found is not None:
                return found
        return None

    def component(self, package: str, plugin: str) -> Program | None:
        """What is known of a component of a package; None where nothing is."""
        return self._program(package, self._loadable, plugin)

    def executables(self, package: str) -> tuple[str, ...]:
        """The executables of a package that are known, sorted: for did-you-mean."""
        return self._listed(package, "executables")

    def nodelets(self, package: str) -> tuple[str, ...]:
        """The nodelet classes (components) of a package that are known, sorted: for did-you-mean."""
        return self._listed(package, self._loadable)

    def has_all_nodelets(self, package: str) -> bool:
        """Whether some library says that it lists every nodelet class (component) of the package."""
        return any(self._loadable in known.get("complete", ()) for known in self._sources(package))

    def has_all_executables(self, package: str) -> bool:
        """Whether some library says that it lists every executable of the package."""
        return any("executables" in known.get("complete", ()) for known in self._sources(package))

    def removed(self, package: str, table: str, name: str) -> Mapping[str, str] | None:
        """The distribution that has a program no more (``in``) and what took its place (``instead``, if anything did).

        None where it was not removed, or is listed as something that is there by a library that is more trusted.
        """
        for known in self._sources(package):
            if name in known.get(table, ()):
                found: Mapping[str, str] | None = known[table][name].get("removed")
                return found
        return None

    def packages(self) -> tuple[str, ...]:
        """The names of all packages, sorted."""
        sources = (*self._files, *(() if self._bundled is None else (self._bundled,)))
        return tuple(sorted({name for source in sources for name in source.names() if source is self._bundled or self._has(name)}))

    def packages_of_class(self, name: str) -> list[str]:
        """The packages that have a nodelet class or component, those of the most trusted library first."""
        files = reversed(self._files)
        found = [package for file in files if (package := file.package_of_class(name, self._middleware)) is not None]
        bundled = None if self._bundled is None else self._bundled.package_of_class(name)
        own = [] if self._own is None else self._own.packages_of_class(name, everywhere=not found and bundled is None)
        return list(dict.fromkeys([*found, *own, *([] if bundled is None else [bundled])]))

    def described(self, package: str, table: str, name: str) -> tuple[Mapping[str, Any], Mapping[str, Any] | None]:
        """All that is said of a program that is known, as JSON, and its interface: that of another one where it is ``like`` it."""
        from launchlint.library.merge import merge_programs

        known = [each[table][name] for each in self._sources(package) if name in each.get(table, ())]
        if self._own is not None:
            known = [*self._said(package, table, name), *(each for each in known if _usable(each) is None)]
        return merge_programs(known), self._data(package, table, name, LONGEST_LIKE)

    def knows(self, package: str, table: str, name: str) -> bool:
        """Whether anything is said of a program at all."""
        return name in self._listed(package, table) or self._program(package, table, name) is not None

    def _program(self, package: str, table: str, name: str) -> Program | None:
        key = (package, table, name)
        if key not in self._programs:
            before = frozenset() if self._own is None else self._own.asked()
            remembered(self._programs, key, lambda: self._read(package, table, name))
            if self._own is not None:
                self._hangs_on[key] = self._own.asked()
                self._own.note(before)
        if self._own is not None:
            self._own.note(self._hangs_on[key])
        found, looked = self._programs[key]
        note(looked)
        return found

    def _read(self, package: str, table: str, name: str) -> Program | None:
        data = self._data(package, table, name, LONGEST_LIKE)
        return None if data is None else program(package, name, data)

    def _data(self, package: str, table: str, name: str, steps: int) -> Mapping[str, Any] | None:
        found = _joined(self._said(package, table, name))
        if found is None or "like" not in found:
            return found
        if not steps:
            return None
        other, slash, inner = found["like"].partition("/")
        if table == self._loadable and self._middleware == ROS1:
            packages = self.packages_of_class(found["like"])
            return next((data for each in packages if (data := self._data(each, table, found["like"], steps - 1)) is not None), None)
        target = inner if slash else found["like"]
        return self._data(other if slash else package, table_of(target, table, self._middleware), target, steps - 1)

    def _said(self, package: str, table: str, name: str) -> list[Mapping[str, Any]]:
        """What is said of a program, the most trusted first."""
        given, shipped = (_about(sources, table, name) for sources in (self._given(package), self._shipped(package)))
        if self._own is None or not self._own.has(package):
            return [*given, *shipped]
        from launchlint.library.precedence import heard, suffices

        own = None if suffices(given) else self._own.program(package, table, name)
        return [*given, *shipped] if own is None else heard(given, own, shipped)

    def wants_sources(self, package: str, table: str, name: str) -> bool:
        """Whether the sources of a program are what is known best of it, if it is one of the checked packages."""
        if self._own is None or not self._own.has(package):
            return False
        from launchlint.library.precedence import suffices

        return not suffices(_about(self._given(package), table, name))

    def why_unknown(self, table: str, name: str, package: str = "") -> str:
        """Why the sources of a program say nothing of it; empty where it is not of the checked packages."""
        if self._own is None:
            return ""
        reasons = [self._own.reason(each, table, name) for each in ([package] if package else self.packages_of_class(name))]
        return next((each for each in reasons if each), "")

    def _sources(self, package: str) -> Iterable[Mapping[str, Any]]:
        """What each library says of a package, the most trusted first."""
        yield from self._given(package)
        yield from self._shipped(package)

    def _given(self, package: str) -> Iterable[Mapping[str, Any]]:
        for file in reversed(self._files):
            known = file.package(package, self._middleware, borrowed=self._borrowed)
            if known is not None:
                yield known

    def _has(self, package: str) -> bool:
        return next(iter(self._given(package)), None) is not None

    def _shipped(self, package: str) -> Iterable[Mapping[str, Any]]:
        known = None if self._bundled is None else self._bundled.package(package)
        if known is not None:
            yield known

    def _listed(self, package: str, table: str) -> tuple[str, ...]:
        return tuple(sorted({name for each in self._sources(package) for name in each.get(table, ())}))


def table_of(like: str, table: str, middleware: str) -> str:
    """The table of a program that one of ``table`` is said to be like: in ROS 2 an executable may run a component, and the names tell."""
    if middleware == ROS1:
        return table
    return TABLES[ROS2][1] if SEPARATORS[ROS2] in like or "/" in like else TABLES[ROS2][0]


def _about(sources: Iterable[Mapping[str, Any]], table: str, name: str) -> list[Mapping[str, Any]]:
    """What sources say of a program; nothing that says nothing of what it does."""
    return [data for each in sources if (data := _usable(each.get(table, {}).get(name))) is not None]


def _usable(data: Mapping[str, Any] | None) -> Mapping[str, Any] | None:
    """A program that says something of its interface; one that could not be run says nothing, one that is no node that it has none."""
    if data is None:
        return None
    says = "variants" in data or "like" in data or data.get("class") == "none"
    return None if data.get("status") == "failed" or not says else data


def _joined(known: Sequence[Mapping[str, Any]]) -> Mapping[str, Any] | None:
    if len(known) < 2:
        return known[0] if known else None
    from launchlint.library.merge import merge_programs

    return merge_programs(known)


def open_libraries(paths: Iterable[str], cache_directory: str | None = None, *, bundled: bool = True, own: Own | None = None) -> Library:
    """The libraries at ``paths``, over the one that launchlint ships unless ``bundled`` is false.

    Raises:
        LibraryError: one of them cannot be read or is not a library.
    """
    files = list(paths)
    if not files:  # the usual case goes without the reader of files: to import it takes longer than to check a launch file
        return Library(bundled=bundled, own=own)
    from launchlint.library.file import open_library

    return Library([open_library(path, cache_directory) for path in files], bundled=bundled, own=own)
