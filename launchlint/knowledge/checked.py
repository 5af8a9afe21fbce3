"""A program that was read, held to the format of libraries: what is no name in it is left out, and its category open."""

from __future__ import annotations

from collections.abc import Mapping
from copy import deepcopy

from launchlint.library.format import FORMAT, LISTS, VERSION_2
from launchlint.library.validate import faults
from launchlint.model import ROS1

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_ROUNDS = 3
"""Not all faults of a program are told at once."""


def checked(program: Mapping[str, Any], table: str, middleware: str = ROS1) -> tuple[Mapping[str, Any] | None, str]:
    """The program without entries that no library may have; None, with the reason, where it is none even so."""
    for _ in range(_ROUNDS):
        found = faults({"format": FORMAT, "version": VERSION_2, "packages": {"own": {"middleware": middleware, table: {"own": program}}}})
        found = [each for each in found if "evidence" not in each.path]
        if not found:
            return program, ""
        wrong = {(each.path[5], each.path[6], each.path[7]) for each in found if len(each.path) > 8 and each.path[6] in LISTS}
        if not wrong:
            break
        program = deepcopy(dict(program))
        for variant, category in sorted({each[:2] for each in wrong}):
            entries = program["variants"][variant][category]
            kept = [entry for index, entry in enumerate(entries) if (variant, category, index) not in wrong]
            program["variants"][variant][category] = kept
            program["variants"][variant].setdefault("open", {}).setdefault(category, "a name that is not known")
    return None, f"launchlint failed to read it: {found[0].message}"
