"""Conditions of ``if`` in CMake files, as far as they are known without running CMake."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.workspace.cmake import Command

_TRUE = frozenset(("1", "ON", "YES", "TRUE", "Y"))
_FALSE = frozenset(("0", "OFF", "NO", "FALSE", "N"))


def truth(command: Command, constants: Mapping[str, bool]) -> bool | None:
    """Whether the branch that an ``if``, ``elseif`` or ``else`` opens is taken once it is come to; ``None``: it cannot be known here.

    Known are constants, in capitals or not (cmake-command(if)), and the variables in ``constants``; either behind a ``NOT``, too.
    """
    if command.name == "else":
        return True
    words = [each.text for each in command.arguments if not (each.quoted or each.literal)]
    negated = words[:1] == ["NOT"]
    if len(words) != 1 + negated or len(words) != len(command.arguments):
        return None
    found = constant(words[-1])
    if found is None:
        found = constants.get(words[-1])
    return not found if negated and found is not None else found


def constant(text: str) -> bool | None:
    """Whether the word is true or false to CMake; ``None``: it is the name of a variable, or something else."""
    word = text.upper()
    return True if word in _TRUE else False if word in _FALSE else None
