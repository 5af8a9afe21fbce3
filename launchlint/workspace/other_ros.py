"""Launch files of ROS 1 in packages that are built for ROS 2 only, or that wait in a workspace of ROS 2 for being ported."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from launchlint.workspace.looking import content, is_file, names, question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages

_ONLY_ROS2 = frozenset(("2",))
_CATKIN = "catkin"
_LEFT = "${catkin_"
"""Before the names of variables that are empty where nothing looks for catkin: what is left of a port."""
_INSTALLED = posixpath.join("install", ".colcon_install_layout")


def left_over(file: str, packages: Packages) -> Package | None:
    """The package of the launch file ``file`` (absolute) of ROS 1, where roslaunch has no use for it; else ``None``."""
    return built_for_ros2(file, packages) or _unported(file, packages)


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
    return None if any(_CATKIN in line.partition("#")[0].replace(_LEFT, "") for line in written.splitlines()) else package


def is_all_of_ros2(packages: Packages, launch_files: Iterable[str]) -> bool:
    """Whether ament builds packages of the workspaces, and catkin none; where no manifest says how, whether all launch files are such as
    roslaunch never reads.
    """
    own = [each for place in packages.places[: len(packages.workspaces)] for each in place.everything if each.manifest is not None]
    if own:
        return any(each.manifest.is_ament for each in own if each.manifest) and not any(map(_is_of_catkin, own))
    files = list(launch_files)
    return bool(files) and all(file.endswith((".py", ".yaml", ".yml")) for file in files)


def _unported(file: str, packages: Packages) -> Package | None:
    """The package of ``file`` where catkin alone builds it, in a workspace of ROS 2: nobody builds it, or starts what is in it."""
    package = packages.package_of(file)
    if package is None or not _is_of_catkin(package):
        return None
    return package if packages.answer(is_ros2, "") else None


def _is_of_catkin(package: Package) -> bool:
    manifest = package.manifest
    return manifest is not None and manifest.is_catkin and not manifest.is_ament


@question
def is_ros2(packages: Packages, _: str) -> bool:
    """Whether the workspaces are of ROS 2: ament builds at least as many packages as half of those that catkin does, nothing names a
    distribution of ROS 1, and something names one of ROS 2, or colcon has built here.
    """
    own = [each for place in packages.places[: len(packages.workspaces)] for each in place.everything]
    kinds = [each.kind for each in own]
    ament = sum(each.ros_versions == _ONLY_ROS2 for each in kinds)
    if not ament or 2 * ament < sum(each.is_catkin and not each.is_ament for each in kinds):
        return False
    from launchlint.workspace.named_distributions import named_distributions

    roots = packages.workspaces
    built = any(is_file(posixpath.join(root, _INSTALLED)) for root in roots)
    if not (built or named_distributions(roots, [each.directory for each in own])):
        return False
    return not packages.distributions().named
