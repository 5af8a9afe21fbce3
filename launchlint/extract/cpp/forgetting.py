"""What a function that is not followed may have assigned is not known any more."""

from __future__ import annotations

import re
from functools import lru_cache

from launchlint.extract.cpp import classes, places
from launchlint.extract.cpp.declarations import Function
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.values import UNKNOWN, Thing, choices

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_ASSIGNED = re.compile(r"(?:(?<![\w.>])|(?<=this->))([A-Za-z_]\w*)((?:\.[A-Za-z_]\w*){0,4})\s*=(?!=)")
"""A variable or a member that is assigned, or a part of one: not one behind a pointer or another object."""


def forget(machine: Machine, function: Function, this: Thing | None) -> None:
    """What ``function`` assigns to members of its own object ``this``, and to variables outside of functions, as its words say."""
    if function.body is None:
        return
    frame = Frame(function.path, function.scope, this, {})
    for name, parts in _assigned(function.body.text):
        cell = classes.member(machine, this, name) or places.of_program(machine, name, frame)
        for part in filter(None, parts.split(".")):
            thing = None if cell is None else next((each for _, each in choices(cell.value) if isinstance(each, Thing)), None)
            cell = classes.member(machine, thing, part)
        if cell is not None and not cell.constant:
            machine.write(cell, UNKNOWN)


@lru_cache(maxsize=4096)
def _assigned(text: str) -> tuple[tuple[str, str], ...]:
    """What a body assigns: the variable or member, and the parts of it behind that, each with its dot."""
    return tuple(dict.fromkeys(_ASSIGNED.findall(text)))
