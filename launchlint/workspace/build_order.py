"""The order in which catkin builds a workspace, as far as a further dependency would close a ring in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import note, walk, watched
from launchlint.workspace.texts import parts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.workspace.packages import Packages
    from launchlint.workspace.place import Place

    NeededBy: TypeAlias = Mapping[str, Mapping[str, bool]]

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
    if not lacking:
        return _ways(name, packages.once(_declared))
    needs = packages.once(_Needs)
    note(needs.looked)
    return _ways(name, {**needs.by, name: needs.of(name)})


def _declared(packages: Packages) -> NeededBy:
    return _needed_by(packages, {})


class _Needs:
    """``by``: package → the packages that declare it, and whether for building, or whose launch files use it.

    ``looked`` is what that hangs on. A package with more launch files than are read here may well use any.
    """

    def __init__(self, packages: Packages) -> None:
        directories = [each.directory for place in _places(packages) for each in place.everything if each.name]
        used, looked = watched(lambda: {directory: _used(directory) for directory in directories})
        self.looked = frozenset(looked.all())
        self.by = _needed_by(packages, used)
        everything = [each for place in _places(packages) for each in place.everything if each.name and each.manifest is not None]
        self._open = frozenset(each.name for each in everything if used[each.directory] is None)
        self._numbers = {each.name: number for number, each in reversed(list(enumerate(everything)))} if self._open else {}

    def of(self, name: str) -> Mapping[str, bool]:
        """The packages that need ``name``, in the order of the workspaces."""
        found = self.by.get(name, {})
        if not self._open:
            return found
        return {each: found.get(each, False) for each in sorted(found.keys() | self._open, key=self._numbers.__getitem__)}


def _places(packages: Packages) -> Sequence[Place]:
    return packages.places[: len(packages.workspaces)]


def _needed_by(packages: Packages, used: Mapping[str, frozenset[str] | None]) -> NeededBy:
    """Package → the packages that declare it, and whether for building; what is ``used`` in the directory of one counts as declared."""
    needed_by: dict[str, dict[str, bool]] = {}
    for place in _places(packages):
        for package in place.everything:
            if package.name and package.manifest is not None:
                named = used.get(package.directory) or frozenset()
                for other in sorted(package.manifest.depends(*_WITH) | named):
                    needed_by.setdefault(other, {}).setdefault(package.name, False)
                for other in sorted(package.manifest.depends(*_BEFORE)):
                    needed_by.setdefault(other, {})[package.name] = True
    return needed_by


def _ways(name: str, needed_by: NeededBy) -> dict[str, Way]:
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
