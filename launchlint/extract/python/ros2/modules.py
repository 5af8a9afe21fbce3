"""The modules of packages of ROS 2: those that ``setup.py`` names, be it by ``find_packages()``, or ``ament_python_install_package``."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from launchlint.extract.python.modules import PackageModules
from launchlint.workspace import looking

_INSTALLED = re.compile(
    r"^[ \t]*ament_python_install_package\s*\(\s*([^\s()]{1,200})(?:[^()]{0,500}?\bPACKAGE_DIR\s+\"?([^\s()\"]{1,300}))?", re.MULTILINE
)
_VARIABLE = re.compile(r"\$\{(PROJECT_NAME|CMAKE_PROJECT_NAME|CMAKE_CURRENT_SOURCE_DIR|CMAKE_SOURCE_DIR|PROJECT_SOURCE_DIR)\}")
_NEVER_INSTALLED = frozenset(("test", "tests", "launch", "build", "install", "log", "docs"))


class AmentModules(PackageModules):
    """Modules of the packages whose directories are given, by name."""

    __slots__ = ()

    def roots(self, directory: str) -> tuple[tuple[str, str], ...]:
        """Names of Python packages with their directories, the longest first; an empty name is a directory on Python's path."""
        found = dict(super().roots(directory))
        for name, path in _installed(directory, self.packages.get(directory, "")):
            if name not in found and looking.is_file(os.path.join(path, "__init__.py")):
                found[name] = path
        return tuple(sorted(found.items(), key=lambda each: (-len(each[0]), each[0])))


def _installed(directory: str, package: str) -> Iterator[tuple[str, str]]:
    """Python packages of a package with their directories: those that its CMakeLists.txt names, or all that its setup.py finds."""
    listed = looking.content(os.path.join(directory, "CMakeLists.txt")) or b""
    for name, below in _INSTALLED.findall(listed.decode("utf-8", "replace")):
        name, below = (_VARIABLE.sub(lambda match: "." if match[1].endswith("DIR") else package, each) for each in (name, below or name))
        if name.isidentifier() and "$" not in below:
            yield name, os.path.normpath(os.path.join(directory, below))
    setup = looking.content(os.path.join(directory, "setup.py")) or b""
    if b"find_packages" in setup and b"ament_python" in (looking.content(os.path.join(directory, "package.xml")) or b""):
        for name in sorted(looking.names(directory)):
            if name.isidentifier() and name not in _NEVER_INSTALLED:
                yield name, os.path.join(directory, name)
