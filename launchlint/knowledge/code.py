"""What launchlint itself is, as far as what is read of sources hangs on it: a checkout changes without a new version."""

from __future__ import annotations

import hashlib
import os
import sys
from contextlib import suppress
from functools import lru_cache

from launchlint import __version__

ROOMS = ("extract", "knowledge", "python", "workspace")
"""The rooms of launchlint that what is read hangs on."""
_READERS = "tree_sitter"
"""What the names of the installed libraries that read C++ begin with."""


@lru_cache(maxsize=1)
def code_digest() -> str:
    """Another one where these rooms, Python or the readers of C++ are others."""
    found = hashlib.sha1(f"{__version__} {sys.version}".encode(), usedforsecurity=False)
    top = os.path.dirname(os.path.dirname(__file__))
    for room in ROOMS:
        for directory, directories, files in os.walk(os.path.join(top, room)):
            directories[:] = sorted(name for name in directories if name != "__pycache__")
            for name in sorted(files):
                found.update(f"\0{name}\0".encode("utf-8", "surrogateescape"))
                with open(os.path.join(directory, name), "rb") as file:
                    found.update(file.read())
    found.update(readers().encode("utf-8", "surrogateescape"))
    return found.hexdigest()


def readers() -> str:
    """The names of the installed libraries that read C++, with their versions."""
    listed: list[str] = []
    for path in sys.path:
        with suppress(OSError):
            listed += sorted(name for name in os.listdir(path or os.curdir) if name.startswith(_READERS))
    return "\0".join(listed)
