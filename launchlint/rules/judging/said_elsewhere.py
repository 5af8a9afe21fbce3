"""Whether sources of the workspace, of whatever program, say a name: then the other end of it may be started from another launch file."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.workspace.looking import note, walk, watched
from launchlint.workspace.packages import Packages
from launchlint.workspace.texts import parts

_SOURCE_ENDS = (".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".py")
_MOST_DIRECTORIES = 2_000
_MOST_FILES = 4_000


def says(name: str, packages: Packages, *, offers: bool) -> bool:
    """Whether any source file of the workspaces publishes (``offers``) or hears a topic that is called ``name`` in the code.

    The first part of a name in namespaces counts as little as in the code of a node that is started in one: only the last part does.
    """
    known, looked = packages.once(_kept)[0]
    note(looked)
    return f"{'+' if offers else '-'}{name}" in known


def _kept(packages: Packages) -> list[tuple[frozenset[str], frozenset[str]]]:
    """What the sources say, and what that hangs on."""
    return [watched(lambda: _read(packages))]


def _read(packages: Packages) -> frozenset[str]:
    looked: set[str] = set()
    found = frozenset(word for _, words in parts(_sources(packages), _MOST_FILES, looked, "topics") for word in words)
    note(looked)
    return found


def _sources(packages: Packages) -> Iterator[tuple[str, list[str]]]:
    for workspace in packages.workspaces:
        for parent, names in walk(workspace, _MOST_DIRECTORIES):
            yield parent, [name for name in sorted(names) if name.endswith(_SOURCE_ENDS)]
