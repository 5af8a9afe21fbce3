"""What a library holds, for people who ask by name: a package, ``package/executable`` or a nodelet class."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from launchlint.errors import UsageError
from launchlint.library.format import KINDS
from launchlint.library.lookup import Library
from launchlint.spelling import did_you_mean

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Entry(NamedTuple):
    """One program of a library.

    Args:
        package: its package.
        table: ``executables`` or ``nodelets``.
        name: the executable or nodelet class.
        said: all that the libraries say of it, joined.
        interface: the same, or that of the program it is like; None where its interface is not known.
    """

    package: str
    table: str
    name: str
    said: Mapping[str, Any]
    interface: Mapping[str, Any] | None


class Row(NamedTuple):
    """A package, and how many executables and nodelet classes of it are known."""

    package: str
    executables: int
    nodelets: int


def rows(library: Library) -> list[Row]:
    """Every package, by name."""
    return [Row(package, len(library.executables(package)), len(library.nodelets(package))) for package in library.packages()]


def find(library: Library, names: Sequence[str]) -> list[Entry]:
    """The programs that the names mean, in their order. ``a/b`` may be an executable and a nodelet class: then it is both.

    Raises:
        UsageError: nothing is known under one of the names; the message names a near one.
    """
    found: dict[tuple[str, str, str], None] = {}
    for name in names:
        places = _places(library, name)
        if not places:
            raise UsageError(f"nothing is known of {name}: {_hint(library, name)}")
        found.update(dict.fromkeys(places))
    return [Entry(*place, *library.described(*place)) for place in found]


def known(library: Library, names: Iterable[str]) -> list[Entry]:
    """As :func:`find`, without those of which nothing is known; by package, table and name."""
    places = sorted({place for name in names for place in _places(library, name)})
    return [Entry(*place, *library.described(*place)) for place in places]


def _places(library: Library, name: str) -> list[tuple[str, str, str]]:
    """Package, table and name of each program that a name means."""
    package, slash, executable = name.partition("/")
    if not slash:
        tables = {"executables": library.executables(name), "nodelets": library.nodelets(name)}
        return [(name, table, each) for table in KINDS for each in tables[table]]
    found = [(package, "executables", executable), *((owner, "nodelets", name) for owner in library.packages_of_class(name))]
    return [each for each in found if library.knows(*each)]


def _hint(library: Library, name: str) -> str:
    package, slash, _ = name.partition("/")
    packages = library.packages()
    if not slash:
        return did_you_mean(name, packages) or "launchlint library show lists the packages"
    if package not in packages:
        near = did_you_mean(package, packages)
        return near or f"there is no package {package}, and no nodelet class of that name; launchlint library show lists the packages"
    known = [*(f"{package}/{each}" for each in library.executables(package)), *library.nodelets(package)]
    return did_you_mean(name, known) or f"launchlint library show {package} lists what is known of the package"
