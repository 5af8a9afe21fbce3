"""What a library holds, for people who ask by name: a package, ``package/executable``, a nodelet class or a component."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.errors import UsageError
from launchlint.library.format import TABLES
from launchlint.library.lookup import Library
from launchlint.library.shipped import SEPARATORS
from launchlint.named_tuple import NamedTuple
from launchlint.spelling import did_you_mean

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Entry(NamedTuple):
    """One program of a library.

    Args:
        package: its package.
        table: ``executables``, ``nodelets`` or ``components``.
        name: the executable, nodelet class or component.
        said: all that the libraries say of it, joined.
        interface: the same, or that of the program it is like; None where its interface is not known.
        middleware: of its package: ``ros1`` or ``ros2``.
    """

    package: str
    table: str
    name: str
    said: Mapping[str, Any]
    interface: Mapping[str, Any] | None
    middleware: str


class Row(NamedTuple):
    """A package of a middleware, and how many programs of it are known: executables, and nodelet classes or components."""

    package: str
    middleware: str
    executables: int
    loadable: int


def rows(library: Library) -> list[Row]:
    """Every package, by name; one that is known in both middlewares twice."""
    each_way = {middleware: library.of(middleware) for middleware in TABLES}
    return sorted(
        Row(package, middleware, len(known.executables(package)), len(known.nodelets(package)))
        for middleware, known in each_way.items()
        for package in known.packages()
    )


def find(library: Library, names: Sequence[str]) -> list[Entry]:
    """The programs that the names mean, in their order. ``a/b`` may be several: an executable and a nodelet class, one of each middleware.

    Raises:
        UsageError: nothing is known under one of the names; the message names a near one.
    """
    found: dict[_Place, None] = {}
    each_way = {middleware: library.of(middleware) for middleware in TABLES}
    for name in names:
        places = _places(each_way, name)
        if not places:
            raise UsageError(f"nothing is known of {name}: {_hint(list(each_way.values()), name)}")
        found.update(dict.fromkeys(places))
    return [_entry(each_way, place) for place in found]


def known(library: Library, names: Iterable[str]) -> list[Entry]:
    """As :func:`find`, without those of which nothing is known; by package, table and name."""
    each_way = {middleware: library.of(middleware) for middleware in TABLES}
    places = sorted({place for name in names for place in _places(each_way, name)})
    return [_entry(each_way, place) for place in places]


class _Place(NamedTuple):
    """Which program it is."""

    package: str
    table: str
    name: str
    middleware: str


def _entry(each_way: Mapping[str, Library], place: _Place) -> Entry:
    return Entry(*place[:3], *each_way[place.middleware].described(*place[:3]), place.middleware)


def _places(each_way: Mapping[str, Library], name: str) -> list[_Place]:
    """Each program that a name means."""
    return [_Place(*place, middleware) for middleware, library in each_way.items() for place in _places_in(library, name, middleware)]


def _places_in(library: Library, name: str, middleware: str) -> list[tuple[str, str, str]]:
    """Package, table and name of each program of a middleware that a name means."""
    package, slash, executable = name.partition("/")
    loadable = TABLES[middleware][1]
    separator = SEPARATORS[middleware]
    if not slash and separator not in name:
        tables = {"executables": library.executables(name), loadable: library.nodelets(name)}
        return [(name, table, each) for table in tables for each in tables[table]]
    found = [(owner, loadable, name) for owner in library.packages_of_class(name)]
    if slash:
        found = [(package, "executables", executable), *found, *([(package, loadable, executable)] if separator in executable else [])]
    return [each for each in dict.fromkeys(found) if library.knows(*each)]


def _hint(libraries: Sequence[Library], name: str) -> str:
    package, slash, _ = name.partition("/")
    packages = sorted({each for library in libraries for each in library.packages()})
    if not slash:
        return did_you_mean(name, packages) or "launchlint library show lists the packages"
    if package not in packages:
        near = did_you_mean(package, packages)
        return near or f"there is no package {package}, and no nodelet class of that name; launchlint library show lists the packages"
    executables = [f"{package}/{each}" for library in libraries for each in library.executables(package)]
    known = [*executables, *(each for library in libraries for each in library.nodelets(package))]
    return did_you_mean(name, known) or f"launchlint library show {package} lists what is known of the package"
