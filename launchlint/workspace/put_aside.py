"""Directories for what is no longer used: `old`, `graveyard`, `deprecated`."""

from __future__ import annotations

import re

from launchlint.late import late

_ASIDE = late(
    r"(?:.*[_. -])?(?:deprecated|obsolete|outdated|unused|archives?|archived|backups?|bak|old|attic|trash|graveyard)"
    r"|(?:deprecated|obsolete|outdated|unused|archived|old)[_. -].*",
    re.IGNORECASE,
)
"""Names of directories for what is no longer used; `backup_camera` and `archive_tools` are none."""


def put_aside(path: str) -> str:
    """The directory on the way to ``path`` (with ``/``) that says so; empty where none does."""
    parts = path.split("/")[:-1]
    number = next((number for number, part in enumerate(parts, 1) if _ASIDE.fullmatch(part)), 0)
    return "/".join(parts[:number])


def is_out_of_use(path: str, near: str) -> bool:
    """Whether ``path`` lies in such a directory that does not hold ``near`` too: nobody who writes of ``near`` means it any more."""
    parts, beside = path.split("/")[:-1], near.split("/")[:-1]
    shared = next((at for at, (one, other) in enumerate(zip(parts, beside, strict=False)) if one != other), min(len(parts), len(beside)))
    return any(_ASIDE.fullmatch(part) for part in parts[shared:])
