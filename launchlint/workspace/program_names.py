"""Which packages of the workspaces have a program of a name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages


def packages_having(packages: Packages, programs: Callable[[Package], Iterable[str]]) -> Mapping[str, Sequence[str]]:
    """Name of a program → the packages of the workspaces, by name and sorted, among whose ``programs`` it is; all are looked at."""
    found: dict[str, set[str]] = {}
    for place in packages.places[: len(packages.workspaces)]:
        for copies in place.by_name.values():
            for package in copies:
                for program in programs(package):
                    found.setdefault(program, set()).add(package.name)
    return {each: sorted(names) for each, names in found.items()}
