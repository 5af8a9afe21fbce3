"""Nodes of ROS 2 whose program is certainly not where launch looks for it: in ``lib/PKG`` of the installed package."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.package_contents import contents, installs
from launchlint.workspace.looking import is_file
from launchlint.workspace.put_aside import is_out_of_use
from launchlint.workspace.surveys import placing_scripts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import Launch, Node
    from launchlint.workspace.ament.installed import Installed
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages

_BUILD_FILES = {"ament_cmake": "CMakeLists.txt", "ament_python": "setup.py"}


class Missing(NamedTuple):
    """A node whose program ``lib/PKG`` lacks. ``built``: the directory below the prefix where a program of that name is, empty where it is
    built and not installed, ``None`` where none is. ``file`` is a file of that name in the package (absolute), which is not installed.
    """

    node: Node
    package: Package
    installed: Installed
    built: str | None
    file: str | None


def missing_programs(launch: Launch, packages: Packages) -> Iterator[Missing]:
    """The nodes of ``launch`` whose program is not there, in order (launch_ros.substitutions.ExecutableInPackage).

    A program that a shell script of the workspace copies there is passed over.
    """
    for node in launch.nodes:
        name = node.executable
        if node.kind == "composable" or not node.knows("package", "executable") or not node.package or not name.strip() or "/" in name:
            continue
        package = packages.colcon.get(node.package, launch.entry.file)
        if package is None:
            continue
        installed = installs(packages).of(package)
        if installed.lacks_program(name) and not is_placed(package.name, name, packages):
            built = installed.elsewhere(name)
            yield Missing(node, package, installed, None if built is None else built.destination, _file(package, name, packages))


def build_file(package: Package) -> str:
    """The name of the file that says what ``package`` installs."""
    types = () if package.manifest is None else package.manifest.under({"ROS_VERSION": "2"}).build_types
    return next((_BUILD_FILES[each] for each in types if each in _BUILD_FILES), "CMakeLists.txt")


def is_placed(package: str, name: str, packages: Packages) -> bool:
    """Whether a script that copies programs to the install or devel space names both the package and the program."""
    scripts = packages.answer(placing_scripts, name)
    return bool(scripts) and not set(scripts).isdisjoint(packages.answer(placing_scripts, package))


def _file(package: Package, name: str, packages: Packages) -> str | None:
    found = [
        posixpath.join(directory, name)
        for directory, listed in contents(packages).directories(package)
        if name in listed and is_file(posixpath.join(directory, name))
    ]
    return next((each for each in found if not is_out_of_use(each, package.manifest_path)), None)
