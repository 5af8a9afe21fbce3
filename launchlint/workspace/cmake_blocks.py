"""Parts of CMake commands: sections between key words, and where blocks end."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.workspace.cmake import Command
from launchlint.workspace.cmake_scope import Value
from launchlint.workspace.cmake_words import INSTALL_WORDS


def section(arguments: Sequence[Value], word: str) -> list[Value]:
    """The arguments behind the key word ``word`` up to the next key word of install()."""
    if word not in arguments:
        return []
    section: list[Value] = []
    for each in arguments[arguments.index(word) + 1 :]:
        if each in INSTALL_WORDS:
            break
        section.append(each)
    return section


def block_end(listed: Sequence[Command], start: int) -> int:
    """Position of the command that closes the block opened at ``start``; the end of the list where nothing does."""
    name = listed[start].name
    level = 0
    for position in range(start, len(listed)):
        if listed[position].name == name:
            level += 1
        elif listed[position].name == "end" + name:
            level -= 1
            if level == 0:
                return position
    return len(listed)


def never(command: Command) -> bool:
    """Whether the condition is a constant that is false."""
    return len(command.arguments) == 1 and command.arguments[0].text.upper() in ("0", "OFF", "NO", "FALSE", "N")
