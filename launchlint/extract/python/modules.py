"""The modules of ROS packages, and what else a package says of what its programs import.

catkin makes importable what ``setup.py`` names, from where its ``package_dir`` says (``{'': 'src'}`` nearly always), rosbuild what is in
``src``.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from launchlint.extract.python.foreign import declared_libraries
from launchlint.python.modules import ModuleFinder
from launchlint.workspace import looking

GENERATED = frozenset(("msg", "srv", "cfg"))
"""Modules of a package that catkin makes of messages, services and configurations."""


class PackageModules(ModuleFinder):
    """Modules of the packages whose directories are given, by name.

    Args:
        packages: directory of each package → its name, those that win first.
    """

    __slots__ = ("_libraries",)

    def __init__(self, packages: Mapping[str, str]) -> None:
        super().__init__(packages, GENERATED)
        self._libraries: dict[tuple[str, str], tuple[frozenset[str], looking.Looked]] = {}

    def libraries(self, package: str, root: str) -> frozenset[str]:
        """The libraries of Python that a package says it needs, by its manifest or a list of requirements in it or in ``root``."""
        key = (package, root)
        if key not in self._libraries:
            self._libraries[key] = looking.watched(lambda: _declared(package, root))
        found, looked = self._libraries[key]
        looking.note(looked)
        return found

    def configuration(self, package: str, name: str) -> str | None:
        """The ``.cfg`` file that makes ``package.cfg.<name>Config``."""
        for directory, owner in self.packages.items():
            for below in ("cfg", "") if owner == package else ():
                path = os.path.join(directory, below, f"{name}.cfg")
                if looking.is_file(path):
                    return path
        return None


def _declared(package: str, root: str) -> frozenset[str]:
    manifest = looking.content(os.path.join(package, "package.xml")) or b""
    listed = [looking.content(os.path.join(each, "requirements.txt")) or b"" for each in dict.fromkeys((package, root))]
    return declared_libraries(manifest, b"\n".join(listed))
