"""The order in which catkin builds a workspace, as far as a further dependency would close a ring in it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from launchlint.workspace.looking import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.packages import Packages

_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
_MOST_DIRECTORIES = 1_000
_BEFORE = ("build", "buildtool", "test")
_WITH = ("exec", "build_export")


class Way(NamedTuple):
    """How one package needs another already: the names on the way, both ends included, and whether building hangs on it."""

    names: tuple[str, ...]
    built: bool


def ways_to(name: str, packages: Packages, *, lacking: bool = False) -> dict[str, Way]:
    """The packages of the workspaces that need package ``name`` already, each with the way; where building hangs on one, that one.

    ``lacking``: every package with launch files counts as one that needs it to run: it may yet declare what leads there.

    A package is built after what it declares for building and testing, and after all that those need to run, over any number of steps
    (catkin_pkg.topological_order: calculate_depends_for_topological_order). A ring is refused where one step of it is of the first kind;
    what only needs each other to run is built in any order. Linear in the number of dependencies.
    """
    return _ways(name, _needed_by(packages, name if lacking else None))


def _needed_by(packages: Packages, lacking: str | None) -> dict[str, dict[str, bool]]:
    """Package → the packages that declare it, and whether for building; packages with launch files as if they declared ``lacking``."""
    needed_by: dict[str, dict[str, bool]] = {}
    for place in packages.places[: len(packages.workspaces)]:
        for package in place.everything:
            if package.name and package.manifest is not None:
                named = {lacking} if lacking is not None and _has_launch_files(package.directory) else set[str]()
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


def _has_launch_files(directory: str) -> bool:
    """Whether there are launch files below ``directory``; of a very large one only a part is looked at, and the answer is yes."""
    left = _MOST_DIRECTORIES
    for _, names in walk(directory, _MOST_DIRECTORIES):
        left -= 1
        if left <= 0 or any(name.endswith(_LAUNCH_ENDS) for name in names):
            return True
    return False
