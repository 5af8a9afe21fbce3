"""The CMake language as far as it can be read without running it: text → commands with their arguments.

Facts from cmake-language(7): comments, bracket comments, quoted, unquoted and bracket arguments, escapes, nested parentheses.
"""

from __future__ import annotations

import re

from launchlint.late import late
from launchlint.named_tuple import NamedTuple

# One step of the tokenizer each; possessive in effect, since every alternative starts with a different character.
_SPACE = late(r"(?:[\s;]|#(?!\[=*\[)[^\n]*(?![^\n]))+")
_BRACKET = late(r"\[(=*)\[")
_IDENTIFIER = late(r"[A-Za-z_][A-Za-z0-9_]*")
_QUOTED = late(r'"((?:[^"\\]|\\.)*)"', re.DOTALL)
_UNQUOTED = late(r'(?:[^\s()#"\\;]|\\.)(?:[^\s()#"\\;]|\\.|"(?:[^"\\\n]|\\.)*")*', re.DOTALL)
_BLANK = late(r"[ \t]*")


class Argument(NamedTuple):
    """One argument as written; ``quoted`` ones are not split at semicolons, ``literal`` (bracket) ones not expanded either."""

    text: str
    quoted: bool
    literal: bool


class Command(NamedTuple):
    """One command invocation; its name in lower case, as CMake compares names."""

    name: str
    arguments: tuple[Argument, ...]
    line: int


class CMakeError(ValueError):
    """The text is not CMake; ``str(error)`` says why and in which line."""


def commands(text: str) -> list[Command]:
    """All command invocations of a CMakeLists.txt or ``*.cmake`` file in order.

    Raises:
        CMakeError: the text is not CMake.
    """
    if "\0" in text:
        raise CMakeError("it is not a text file")
    found: list[Command] = []
    position = 0
    line, counted = 1, 0
    while (position := _skip(text, position)) < len(text):
        name = _IDENTIFIER.match(text, position)
        line, counted = line + text.count("\n", counted, position), position
        if name is None:
            raise CMakeError(f"line {line}: a command name was expected")
        position = _end(_BLANK, text, name.end())
        if text[position : position + 1] != "(":
            raise CMakeError(f"line {line}: ( was expected after {name[0][:60]}")
        arguments, position = _arguments(text, position + 1, line)
        found.append(Command(name[0].lower(), tuple(arguments), line))
    return found


def _arguments(text: str, position: int, line: int) -> tuple[list[Argument], int]:
    arguments: list[Argument] = []
    depth = 1
    while (position := _skip(text, position)) < len(text):
        char = text[position]
        if char == "(":
            depth += 1
            arguments.append(Argument("(", False, True))
            position += 1
        elif char == ")":
            depth -= 1
            position += 1
            if depth == 0:
                return arguments, position
            arguments.append(Argument(")", False, True))
        elif char == '"':
            quoted = _QUOTED.match(text, position)
            if quoted is None:
                break
            arguments.append(Argument(quoted[1], True, False))
            position = quoted.end()
        elif (bracket := _BRACKET.match(text, position)) is not None:
            content, position = _bracket(text, bracket)
            arguments.append(Argument(content, True, True))
        else:
            unquoted = _UNQUOTED.match(text, position)
            if unquoted is None:
                break
            # A semicolon separates list elements, which for an unquoted argument is the same as a blank.
            arguments.append(Argument(unquoted[0], False, False))
            position = unquoted.end()
    raise CMakeError(f"line {line}: the command is not closed")


def _skip(text: str, position: int) -> int:
    """The next offset that is neither blank nor comment."""
    while position < len(text):
        end = _end(_SPACE, text, position)
        if text.startswith("#", end) and (bracket := _BRACKET.match(text, end + 1)) is not None:
            end = _bracket(text, bracket)[1]
        if end == position:
            break
        position = end
    return position


def _bracket(text: str, opening: re.Match[str]) -> tuple[str, int]:
    close = text.find(f"]{opening[1]}]", opening.end())
    if close < 0:
        raise CMakeError("a bracket argument is not closed")
    content = text[opening.end() : close]
    return content.removeprefix("\r").removeprefix("\n"), close + len(opening[1]) + 2


def _end(pattern: re.Pattern[str], text: str, position: int) -> int:
    match = pattern.match(text, position)
    return position if match is None else match.end()
