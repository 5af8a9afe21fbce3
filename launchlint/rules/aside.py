"""Directories in which people keep what is no longer used."""

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
    """The directory on the way to ``path`` that says so; empty where none does."""
    parts = path.split("/")[:-1]
    number = next((number for number, part in enumerate(parts, 1) if _ASIDE.fullmatch(part)), 0)
    return "/".join(parts[:number])
