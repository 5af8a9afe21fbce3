"""Which file an ``import`` of a launch file reads: modules of Python packages that packages of the workspace have under their own name.

Of some libraries that are not in the workspace there are models (:mod:`.bundled`).
"""

from __future__ import annotations

import os
from collections.abc import Callable

from launchlint.python.modules import ModuleFinder
from launchlint.python.values import Value
from launchlint.syntax.ros2.python.bundled import model_of

_MOST = 20


class WorkspaceModules(ModuleFinder):
    """Modules of the workspace: ``share`` gives the directory of a package by its name.

    A package has its Python package in a directory of the same name, as ``ament_python_install_package`` and the usual ``setup.py`` of
    ament_python have it.
    """

    __slots__ = ("_more", "_share")

    def __init__(self, share: Callable[[str], str | None]) -> None:
        super().__init__({})
        self._share = share
        self._more: list[str] = []

    def look_in(self, directory: Value) -> None:
        """Look for modules in ``directory``, too, as ``sys.path.append`` has it."""
        if isinstance(directory, str) and directory.startswith("/") and len(self._more) < _MOST:
            self._more.append(os.path.normpath(directory))
            self._asked.clear()

    def _find(self, name: str, beside: str, package: str) -> str | None:
        parts = name.split(".")
        if not all(part.isidentifier() for part in parts) or len(parts) > 20:
            return None
        for each in self._more:
            found = self._look(each, name.replace(".", os.sep))
            if found is not None:
                return found
        directory = self._share(parts[0])
        if directory is None or self._look(directory, parts[0]) is None:
            return model_of(name)
        return self._look(directory, name.replace(".", os.sep))
