"""The order in which catkin builds a workspace, as far as a further dependency would close a ring in it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from launchlint.workspace.looking import note, walk, watched
from launchlint.workspace.texts import parts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.packages import Packages

_LAUNCH_ENDS = (".launch", ".xml", ".test")
_MOST_DIRECTORIES = 1_000
_MOST_FILES = 1_000
_BEFORE = ("build", "buildtool", "test")
_WITH = ("exec", "build_export")


class Way(NamedTuple):
    """How one package needs another already: the names on the way, both ends included, and whether building hangs on it."""

    names: tuple[str, ...]
    built: bool


def ways_to(name: str, packages: Packages, *, lacking: bool = False) -> dict[str, Way]:
    """The packages of the workspaces that need package ``name`` already, each with the way; where building hangs on one, that one.

    ``lacking``: what the launch files of a package use counts as what it needs to run: it may yet declare that.

    A package is built after what it declares for building and testing, and after all that those need to run, over any number of steps
    (catkin_pkg.topological_order: calculate_depends_for_topological_order). A ring is refused where one step of it is of the first kind;
    what only needs each other to run is built in any order. Linear in the number of dependencies.
    """
    return _ways(name, _needed_by(packages, name if lacking else None))


def _needed_by(packages: Packages, lacking: str | None) -> dict[str, dict[str, bool]]:
    """Package → the packages that declare it, and whether for building; with ``lacking`` also those whose launch files use it.

    A package with more launch files than are read here may well use ``lacking``.
    """
    used: Mapping[str, frozenset[str] | None] = {}
    if lacking is not None:
        used, looked = packages.once(_all_used)
        note(looked)
    needed_by: dict[str, dict[str, bool]] = {}
    for place in packages.places[: len(packages.workspaces)]:
        for package in place.everything:
            if package.name and package.manifest is not None:
                found = used.get(package.directory, frozenset())
                named = found if found is not None else frozenset({lacking or ""})
                for other in sorted(package.manifest.depends(*_WITH) | named):
                    needed_by.setdefault(other, {}).setdefault(package.name, False)
                for other in sorted(package.manifest.depends(*_BEFORE)):
                    needed_by.setdefault(other, {})[package.name] = True
    return needed_by


def _ways(name: str, needed_by: Mapping[str, Mapping[str, bool]]) -> dict[str, Way]:
    start = (name, False)
    towards: dict[tuple[str, bool], tuple[str, bool]] = {start: start}
    waiting = [start]
    for each in waiting:  # grows: the shortest ways come first
        for other, before in needed_by.get(each[0], {}).items():
            step = (other, before or each[1])
            if step not in towards:
                towards[step] = each
                waiting.append(step)
    found: dict[str, Way] = {}
    for state in waiting:
        if state[0] != name and (state[1] or (state[0], True) not in towards):
            names = [state[0]]
            while state != start:
                state = towards[state]
                names.append(state[0])
            found[names[0]] = Way(tuple(names), (names[0], True) in towards)
    return found


def _all_used(packages: Packages) -> tuple[Mapping[str, frozenset[str] | None], frozenset[str]]:
    """What the launch files of each package use, and what that hangs on."""
    directories = [each.directory for place in packages.places[: len(packages.workspaces)] for each in place.everything if each.name]
    return watched(lambda: {directory: _used(directory) for directory in directories})


def _used(directory: str) -> frozenset[str] | None:
    """The packages that the launch files below ``directory`` name; ``None`` of a very large one, which may name any."""
    found: set[str] = set()
    places = [(each, [name for name in names if name.endswith(_LAUNCH_ENDS)]) for each, names in walk(directory, _MOST_DIRECTORIES)]
    if len(places) >= _MOST_DIRECTORIES or sum(len(names) for _, names in places) > _MOST_FILES:
        return None
    looked: set[str] = set()
    for _, named in parts(places, _MOST_FILES, looked, "packages"):
        found.update(named)
    note(looked)
    return frozenset(found)
