"""Launch files of ROS 1 in packages that are built for ROS 2 only."""

from __future__ import annotations

import posixpath

from launchlint.workspace.looking import content, names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages

_ONLY_ROS2 = frozenset(("2",))


def built_for_ros2(file: str, packages: Packages) -> Package | None:
    """The package of ``file`` (absolute) where ament alone builds it, so that roslaunch has no use for what lies in it; else ``None``.

    One that is switched between the two counts for neither: it keeps another manifest (``package_ros1.xml``), or its ``CMakeLists.txt``
    names catkin.
    """
    package = packages.package_of(file)
    manifest = None if package is None else package.manifest
    if package is None or manifest is None or not manifest.is_ament or manifest.ros_versions != _ONLY_ROS2:
        return None
    if any(each.lower().startswith("package") and each.endswith(".xml") and each != "package.xml" for each in names(package.directory)):
        return None
    written = (content(posixpath.join(package.directory, "CMakeLists.txt")) or b"").decode("utf-8", "replace")
    return None if any("catkin" in line.partition("#")[0] for line in written.splitlines()) else package
