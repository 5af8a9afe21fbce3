"""Packages from the time of rosbuild: what later distributions changed in public programs says nothing of them."""

from __future__ import annotations

import posixpath

from launchlint.workspace.manifest import MANIFEST_FILE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package

AS_USUAL = "its package is built with rosbuild, as was usual before ROS Groovy"
SINCE = f"{AS_USUAL}, and what is known of public programs is what they do since"


def is_of_rosbuild(home: Package | None) -> bool:
    """Whether rosbuild builds the package: it has a ``manifest.xml``, and no ``package.xml``."""
    return home is not None and posixpath.basename(home.manifest_path) == MANIFEST_FILE


def packages_named_in(value: str) -> frozenset[str]:
    """The packages that a value of a launch file of ROS 1 names, which alone rosbuild knows: by ``$(find name)``."""
    from launchlint.syntax.ros1.substitutions import parse

    return frozenset(parse(value).names("find"))
