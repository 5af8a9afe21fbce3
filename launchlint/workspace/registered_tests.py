"""Which ``.test`` files the build of a package starts: those that its ``CMakeLists.txt`` names (``add_rostest`` …)."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import content

CMAKE_FILE = "CMakeLists.txt"
TEST_END = ".test"

_LONGEST_LINE = 1_000
_CALLED = late(r"\b(\w+)[ \t]*\(")
_NAMES_TEST = late(r"(?<![\w.-])[\w.-]+\.(?:test|launch)\b")
_COMMAND = late(r"\b(\w+)[ \t]*\(([^()]*)\)")
_TESTS = late(r"(?:^|/)tests?/")
_WORD = late(r"[\w./+-]+")
_ELSEWHERE = late(r"(?i)\b(?:add_subdirectory|foreach|include)[ \t]*\(|\bGLOB|\*\.test|\}[\w.-]*\.test")
"""What may register tests that cannot be seen here."""


class Registering(NamedTuple):
    """A ``command`` that registers tests: what stands in its brackets, as it is written, and whether that names a file or a directory
    above it.
    """

    command: str
    text: str
    names_it: bool


def why_not_started(directory: str, file: str) -> str | None:
    """Why nothing starts the test ``file`` of the package at ``directory`` (both absolute); ``None`` where something may.

    Its command is commented out in ``CMakeLists.txt``, or other tests are registered there and this one is not.
    """
    name = os.path.basename(file)
    if not name.endswith(TEST_END):
        return None
    written = (content(os.path.join(directory, CMAKE_FILE)) or b"").decode("utf-8", "replace")
    lines = [line[:_LONGEST_LINE].partition("#") for line in written.splitlines()]
    active = "\n".join(code for code, _, _ in lines)
    stem = name.removesuffix(TEST_END)
    if re.search(rf"(?<![\w.-]){re.escape(stem)}(?![\w-])", active):
        return None
    for number, (_, _, comment) in enumerate(lines, 1):
        if name in _NAMES_TEST.findall(comment) and _registers(comment):
            return f"nothing starts this test: its command is commented out in {CMAKE_FILE}, line {number}"
    if not _registers(active) or _ELSEWHERE.search(active):
        return None
    if not any(each.endswith(TEST_END) for each in _NAMES_TEST.findall(active)):
        return None
    return f"nothing starts this test: {CMAKE_FILE} registers others, and not this one"


def _registers(code: str) -> bool:
    """Whether a command is called that has to do with rostest."""
    return any("rostest" in command for command in _CALLED.findall(code))


def is_only_checked(directory: str, file: str) -> bool:
    """Whether the launch ``file`` among the tests of the package at ``directory`` (both absolute) is loaded there, but never started.

    It, or a directory above it, is given to ``roslaunch_add_file_check`` (roslaunch.scripts.check), and to no ``add_rostest``.
    """
    inside = os.path.relpath(file, directory)
    if inside.endswith(TEST_END) or _TESTS.search(inside) is None or inside.startswith(os.pardir):
        return False
    return {"rostest" not in each.command.lower() for each in registering(directory, inside) if each.names_it} == {True}


def registering(directory: str, inside: str) -> Iterator[Registering]:
    """The commands of ``CMakeLists.txt`` in ``directory`` (absolute) that have to do with rostest or roslaunch, and which name the file
    ``inside`` (relative to it).
    """
    written = (content(os.path.join(directory, CMAKE_FILE)) or b"").decode("utf-8", "replace")
    code = "\n".join(line.partition("#")[0] for line in written.splitlines())
    above = {inside}
    while inside := os.path.dirname(inside):
        above.add(inside)
    for command, text in _COMMAND.findall(code):
        if "rostest" in command or "roslaunch" in command:
            names_it = any(word.rstrip("/").removeprefix("./") in above for word in _WORD.findall(text))
            yield Registering(command, text, names_it)
