"""What the packages of a run can start and install, each looked at once."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.executables import ExecutableIndex
    from launchlint.workspace.packages import Packages

_latest: list[tuple[Packages, ExecutableIndex]] = []


def contents(packages: Packages) -> ExecutableIndex:
    """The index over ``packages``. A run has one set of packages, so that only the latest index is kept."""
    if not _latest or _latest[0][0] is not packages:
        from launchlint.workspace.executables import ExecutableIndex

        _latest[:] = [(packages, ExecutableIndex(packages))]
    return _latest[0][1]
