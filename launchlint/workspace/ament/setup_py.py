"""What the ``setup.py`` of a package of build type ``ament_python`` installs: ``data_files``, entry points and ``scripts``."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.ament.scripts import SETUP_CFG, Script, entry_points, read_setup_cfg
from launchlint.workspace.ament.setup_statements import setup_calls
from launchlint.workspace.ament.setup_values import UNKNOWN, items
from launchlint.workspace.cmake_targets import Install
from launchlint.workspace.looking import content

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.ament.setup_values import Value

SETUP_PY = "setup.py"
_PYPROJECT = "pyproject.toml"
_SCRIPTS = ("console_scripts", "gui_scripts")


class SetupFacts(NamedTuple):
    """Files that are installed, programs, and why there may be more of each."""

    installs: tuple[Install, ...]
    reasons: tuple[str, ...]
    scripts: tuple[Script, ...]
    script_reasons: tuple[str, ...]


def read_setup(directory: str) -> SetupFacts:
    """Read ``setup.py`` and ``setup.cfg`` of the package at ``directory`` (absolute). Never raises, runs nothing."""
    data = content(os.path.join(directory, SETUP_PY))
    calls = None if data is None else setup_calls(data.decode("utf-8", "replace").removeprefix("\ufeff"), directory)
    if not calls:
        return SetupFacts((), ("setup.py cannot be followed to a call of setup()",), (), ())
    reader = _Reader(directory)
    for call in calls:
        reader.read(call)
    reader.configuration()
    return SetupFacts(tuple(reader.installs), tuple(reader.reasons), tuple(reader.scripts), tuple(reader.script_reasons))


class _Reader:
    def __init__(self, directory: str) -> None:
        self.directory = directory
        self.installs: list[Install] = []
        self.reasons: list[str] = []
        self.scripts: list[Script] = []
        self.script_reasons: list[str] = []
        self._cfg = read_setup_cfg(os.path.join(directory, SETUP_CFG))
        self._destination = None if self._cfg is None else self._cfg.destination

    def read(self, call: dict[str, Value]) -> None:
        """Note the keyword arguments of one call of ``setup()``."""
        if "**" in call:
            self.reasons.append("setup() is given what is not known")
        if "options" in call or "cmdclass" in call:
            self._destination = None
            self.reasons += ["setup() is given commands of its own"] if "cmdclass" in call else []
        for destination, sources in self._data_files(call.get("data_files", [])):
            self._data(destination, sources)
        for program in self._listed(call.get("scripts", []), "scripts"):
            self.scripts.append(Script(os.path.basename(program), (self._path(program),), self._destination))
        self._entry_points(call.get("entry_points", {}))

    def configuration(self) -> None:
        """Note what ``setup.cfg`` and ``pyproject.toml`` add."""
        if self._cfg is None or self._cfg.more:
            self.reasons.append("setup.cfg is not wholly understood")
        elif self._cfg.scripts:
            self._add(self._cfg.scripts)
        project = content(os.path.join(self.directory, _PYPROJECT))
        if project is not None and b"[project" in project:
            self.script_reasons.append("pyproject.toml is not read")

    def _data_files(self, value: Value) -> Iterator[tuple[Value, Value]]:
        listed = items(value)
        if listed is None:
            self.reasons.append("data_files are not known")
        for each in listed or ():
            if isinstance(each, (tuple, list)) and len(each) == 2 and each[0] is not UNKNOWN:
                yield each[0], each[1]
            elif isinstance(each, str):
                yield "", [each]
            else:
                self.reasons.append("some of the data_files are not known")

    def _data(self, destination: Value, sources: Value) -> None:
        where = str(destination) if isinstance(destination, (str, PurePosixPath)) else None
        for source in self._listed(sources, "data_files"):
            self.installs.append(Install(self._path(source), False, where))

    def _listed(self, value: Value, what: str) -> Iterator[str]:
        listed = items(value)
        for each in [UNKNOWN] if listed is None or isinstance(value, str) else listed:
            if isinstance(each, (str, PurePosixPath)):
                yield str(each)
            else:
                (self.script_reasons if what == "scripts" else self.reasons).append(f"some of the {what} are not known")

    def _entry_points(self, value: Value) -> None:
        if isinstance(value, dict):
            for group, lines in value.items():
                if group in _SCRIPTS:
                    listed = [each for each in lines.splitlines() if each.strip()] if isinstance(lines, str) else items(lines)
                    self._add([UNKNOWN] if listed is None else listed)
        elif isinstance(value, str):
            group = ""
            for line in value.splitlines():
                if line.strip().startswith("["):
                    group = line.strip().strip("[] ")
                elif line.strip() and group in _SCRIPTS:
                    self._add([line])
        else:
            self.script_reasons.append("entry_points are not known")

    def _add(self, lines: Iterable[object]) -> None:
        try:
            self.scripts += entry_points(lines, self.directory, self._destination)
        except ValueError as error:
            self.script_reasons.append(str(error))

    def _path(self, path: str) -> str:
        return os.path.normpath(os.path.join(self.directory, path))
