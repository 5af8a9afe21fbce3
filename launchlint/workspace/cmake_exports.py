"""CMake commands that a package gives to those that find it: macros and functions of the files behind ``CFG_EXTRAS``.

``catkin_package(CFG_EXTRAS nodelet.cmake)`` installs ``cmake/nodelet.cmake``, or what is made of ``cmake/nodelet.cmake.in`` or ``.em``, and
``find_package`` of another package includes it. Of a package that ament builds it is the files behind ``CONFIG_EXTRAS``, which include
others: here, all in the directory ``cmake``.
"""

from __future__ import annotations

import os
import posixpath
from collections.abc import Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.cmake import CMakeError, Command, commands
from launchlint.workspace.cmake_blocks import block_end
from launchlint.workspace.looking import is_file, names, read_bytes

_MOST_EXTRAS = 20
_MOST_COMMANDS = 500
_KEY_WORDS = frozenset(
    """INCLUDE_DIRS LIBRARIES CATKIN_DEPENDS DEPENDS CFG_EXTRAS EXPORTED_TARGETS SKIP_CMAKE_CONFIG_GENERATION
    CONFIG_EXTRAS CONFIG_EXTRAS_POST INSTALL_TO_SHARE INSTALL_TO_PATH""".split()
)
_EXTRAS = ("CFG_EXTRAS", "CONFIG_EXTRAS", "CONFIG_EXTRAS_POST")
_EXTRA_LISTS = ("${PROJECT_NAME}_CONFIG_EXTRAS", "${PROJECT_NAME}_CONFIG_EXTRAS_POST")
_ENDINGS = ("", ".in", ".em", ".develspace.em", ".develspace.in")


class Exported(NamedTuple):
    """What a package exports: its directory, and the body and parameters of each command, by lower-case name."""

    directory: str
    commands: dict[str, tuple[Sequence[Command], tuple[str, ...]]]


def exported_commands(directory: str) -> Exported:
    """The macros and functions that the package at ``directory`` exports. Never raises."""
    found: dict[str, tuple[Sequence[Command], tuple[str, ...]]] = {}
    for command in _commands(os.path.join(directory, "CMakeLists.txt")):
        words = [each.text for each in command.arguments]
        ament = command.name.endswith(("ament_package", "ament_auto_package"))
        if command.name == "list" and words[:1] == ["APPEND"] and words[1:2] and words[1] in _EXTRA_LISTS:
            ament, words = True, ["CONFIG_EXTRAS", *words[2:]]
        if ament or command.name == "catkin_package":
            extras = [posixpath.basename(each) for each in _extras(words)]
            more = [each for each in names(os.path.join(directory, "cmake")) if each.endswith(".cmake")] if ament and extras else []
            for name in [*extras, *more][:_MOST_EXTRAS]:
                for path in (os.path.join(directory, folder, name + ending) for folder in ("cmake", "") for ending in _ENDINGS):
                    listed = _commands(path) if is_file(path) and within(path, directory) else ()
                    if listed:
                        found.update(_definitions(listed))
                        break
    return Exported(os.path.abspath(directory), found)


def _extras(words: Sequence[str]) -> list[str]:
    taken: list[str] = []
    takes = False
    for word in words:
        if word in _KEY_WORDS:
            takes = word in _EXTRAS
        elif takes and "$" not in word and "\0" not in word:
            taken.append(word)
    return taken


def _definitions(listed: Sequence[Command]) -> dict[str, tuple[Sequence[Command], tuple[str, ...]]]:
    found: dict[str, tuple[Sequence[Command], tuple[str, ...]]] = {}
    for position, command in enumerate(listed):
        if command.name in ("function", "macro") and command.arguments and len(found) < _MOST_COMMANDS:
            name, *parameters = (each.text for each in command.arguments)
            found[name.lower()] = (listed[position + 1 : block_end(listed, position)], tuple(parameters))
    return found


def _commands(path: str) -> Sequence[Command]:
    try:
        text = read_bytes(path).decode("utf-8", "replace")
        if path.endswith(".em"):  # lines that empy takes away: @[if DEVELSPACE]@
            text = "\n".join("" if line.lstrip().startswith("@[") else line for line in text.splitlines())
        return commands(text)
    except (OSError, CMakeError):
        return ()


def within(path: str, directory: str) -> bool:
    """Whether a file lies in a directory, links followed."""
    return os.path.realpath(path).startswith(os.path.realpath(directory) + os.sep)
