"""One program read: facts and doubts become what a library says of it."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from typing import Any

from launchlint.errors import UsageError
from launchlint.extract.entries import ANY, CATEGORIES, ROS1, ROS2, variant_of
from launchlint.extract.fact import ELSEWHERE, Doubt, Fact, Made
from launchlint.extract.literals import SOURCE_ENDS, Literals
from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.program import Extracted, python_program
from launchlint.extract.task import Task
from launchlint.named_tuple import NamedTuple
from launchlint.python.source import SourceError
from launchlint.workspace.looking import read_bytes, watched

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.files import Trees

_TALKS = re.compile(rb"ros::|<ros/|\"ros/|<nodelet/|actionlib|image_transport|rclcpp")


class Reading(NamedTuple):
    """What was found for one task: the program as a library has it; None where it could not be read, and then ``problem`` says why.

    ``names`` counts its entries, ``unresolved`` those of them, and of the names left open, that are not known as a whole.
    """

    task: Task
    program: dict[str, Any] | None
    problem: str
    names: int
    unresolved: int


class ProgramReader:
    """Reads programs, and keeps the files that they share: the modules of ``packages`` (directory → name), and headers."""

    def __init__(self, packages: Mapping[str, str]) -> None:
        self._packages = packages
        self._finder = PackageModules(packages)
        self._ament: PackageModules | None = None
        self._trees: Trees | None = None
        self._literals = Literals()

    def read(self, task: Task) -> Reading:
        """Read one program. Never raises for what its source says."""
        reading, looked_at = watched(lambda: _read(task, self))
        for variant in () if reading.program is None else reading.program["variants"].values():
            if "open" in variant or any(ANY in entry["name"] for category in CATEGORIES for entry in variant.get(category, ())):
                found = self._literals.among(path for path in looked_at.all() if os.path.splitext(path)[1] in SOURCE_ENDS)
                variant.update({"literals": found} if found else {})
        return reading

    def python(self, task: Task) -> Extracted:
        """What a program of Python says."""
        if task.is_of_ros2:
            from launchlint.extract.python.ros2.modules import AmentModules
            from launchlint.extract.python.ros2.program import rclpy_program

            self._ament = self._ament or AmentModules(self._packages)
            return rclpy_program(task.sources[0], task.origin.root, task.directory, self._ament, task.entry)
        return python_program(task.sources[0], task.origin.root, task.directory, self._finder)

    def cpp(self, task: Task) -> tuple[Sequence[Fact], tuple[Doubt, ...], tuple[Made, ...]]:
        """What a program of C++ says, and the nodes of ROS 2 that it makes."""
        from launchlint.extract.cpp import Trees, cpp_program

        if self._trees is None:
            self._trees = Trees()
        return cpp_program(
            task.sources,
            task.includes,
            task.origin.root,
            task.entry or None,
            task.plugins,
            task.templates,
            task.packages,
            self._trees,
            task.client,
            task.parameters,
        )


def _read(task: Task, reader: ProgramReader) -> Reading:
    options: dict[str, int] = {}
    facts: Sequence[Fact]
    nodes: Sequence[Made] = ()
    try:
        if task.client in ("rospy", "rclpy"):
            found = reader.python(task)
            facts, doubts, options, silent, nodes = found.facts, found.doubts, found.options, not found.uses_rospy, found.nodes
        else:
            facts, doubts, nodes = reader.cpp(task)
            foreign = any(each.reason.endswith(ELSEWHERE) for each in doubts)
            silent = not facts and not foreign and not any(_TALKS.search(_bytes(path)) for path in task.sources)
    except (SourceError, UsageError) as error:
        return Reading(task, None, str(error), 0, 0)
    if task.client not in ("rospy", "rclpy") and not facts and not doubts and not silent and not nodes:
        doubts = tuple(Doubt(category, "no call that makes a name was found, though ROS is used", "", 0) for category in CATEGORIES)
    doubts = (*doubts, *(Doubt(category, reason, "", 0) for reason in task.doubts for category in CATEGORIES))
    if silent and not facts and not nodes and (task.client in ("roscpp", "rclcpp") or not doubts):
        return Reading(task, {"class": "none", "variants": {"default": {}}}, "", 0, 0)
    variant, unresolved = variant_of(facts, doubts, task.origin.id, ROS2 if task.is_of_ros2 else ROS1, nodes)
    program: dict[str, Any] = {"class": task.client}
    if options:
        program["options"] = options
    program["variants"] = {"default": variant}
    return Reading(
        task, program, "", sum(entry["name"] != ANY for category in CATEGORIES for entry in variant.get(category, ())), unresolved
    )


def _bytes(path: str) -> bytes:
    try:
        return read_bytes(path)
    except OSError:
        return b""
