"""What the packages of a run can start and install, each looked at once."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.ament.reading import InstalledIndex
    from launchlint.workspace.executables import ExecutableIndex
    from launchlint.workspace.packages import Packages


def contents(packages: Packages) -> ExecutableIndex:
    """The index over ``packages``."""
    from launchlint.workspace.executables import ExecutableIndex

    return packages.once(ExecutableIndex)


def installs(packages: Packages) -> InstalledIndex:
    """What the packages install, as ament does."""
    from launchlint.workspace.ament.reading import InstalledIndex

    return packages.colcon.once(InstalledIndex)
