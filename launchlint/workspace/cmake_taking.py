"""Which files an ``install()`` takes."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.cmake_targets import Install


def takes(install: Install, path: str) -> bool:
    """Whether ``install`` takes the file at ``path`` (absolute)."""
    if not install.is_directory:
        return path == install.path
    start = install.path.rstrip("/") + "/"
    if not path.startswith(start):
        return False
    # A pattern is held against the end of the path, from a directory separator on (cmake install(DIRECTORY)).
    parts = path[len(start) :].split("/")
    name = parts[-1]
    if any(matches(pattern, parts[: end + 1]) for pattern in install.without for end in range(len(parts))):
        return False
    return not install.only or any(fnmatchcase(name, pattern) or matches(pattern, parts) for pattern in install.only)


def matches(pattern: str, parts: Sequence[str]) -> bool:
    """Whether a pattern of ``install(DIRECTORY)`` is that of the file with these ``parts`` of a path."""
    wanted = pattern.strip("/").split("/")
    return len(wanted) <= len(parts) and all(map(fnmatchcase, parts[-len(wanted) :], wanted))
