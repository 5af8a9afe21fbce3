"""Programs that a ``CMakeLists.txt`` builds only where somebody switches them on."""

from __future__ import annotations

import os

from launchlint.workspace.cmake import Argument, CMakeError, Command, commands
from launchlint.workspace.cmake_comments import CMAKE_FILE
from launchlint.workspace.cmake_conditions import constant
from launchlint.workspace.looking import content

_LARGEST = 200_000
_BUILDS = "add_executable"


def switch_of(directory: str, package: str, program: str) -> str:
    """The ``option()`` that is off (cmake-command(option)) and in whose ``if()`` the only commands stand that build ``program``.

    Read is the ``CMakeLists.txt`` of the package at ``directory``; empty where there is no such option. Never raises.
    """
    text = (content(os.path.join(directory, CMAKE_FILE)) or b"")[:_LARGEST].decode("utf-8", "replace")
    if "option" not in text.lower():
        return ""
    try:
        listed = commands(text)
    except CMakeError:
        return ""
    off = {each.arguments[0].text for each in listed if each.name == "option" and _is_off(each.arguments)}
    found: set[str] = set()
    branches: list[str] = []
    for command in listed:
        if command.name == "if":
            branches.append(_asked(command))
        elif command.name in ("elseif", "else") and branches:
            branches[-1] = ""
        elif command.name == "endif" and branches:
            branches.pop()
        elif command.name == _BUILDS and [each.text.replace("${PROJECT_NAME}", package) for each in command.arguments[:1]] == [program]:
            found.add(next((each for each in branches if each in off), ""))
    return found.pop() if len(found) == 1 else ""


def _is_off(arguments: tuple[Argument, ...]) -> bool:
    """``option(NAME "help" [value])``: off where no value is given."""
    return bool(arguments) and (len(arguments) == 2 or (len(arguments) == 3 and constant(arguments[2].text) is False))


def _asked(command: Command) -> str:
    """The variable that an ``if`` asks, where it asks for nothing else."""
    words = command.arguments
    return words[0].text if len(words) == 1 and not (words[0].quoted or words[0].literal) else ""
