"""Whether sources of the workspace, of whatever program, say a name: then the other end of it may be started from another launch file."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from launchlint.workspace.looking import Looked, note
from launchlint.workspace.packages import Packages
from launchlint.workspace.texts import files_by_word

_SOURCE_ENDS = (".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".py")
_MOST_KEPT = 8
"""Files that are kept of those that say one name."""


def says(name: str, packages: Packages, *, offers: bool, besides: Collection[str] = ()) -> bool:
    """Whether any source file of the workspaces publishes (``offers``) or hears a topic that is called ``name`` in the code.

    The first part of a name in namespaces counts as little as in the code of a node that is started in one: only the last part does.
    ``besides`` are the ends of paths of files that do not count.
    """
    known, looked = packages.once(_kept)[0]
    note(looked)
    without = tuple(f"/{each}" for each in besides)
    return any(not file.endswith(without) for file in known.get(f"{'+' if offers else '-'}{name}", ()))


def _kept(packages: Packages) -> list[tuple[Mapping[str, tuple[str, ...]], Looked]]:
    """What the sources say, each with the first files that do, and what that hangs on."""
    return [files_by_word(packages.workspaces, _SOURCE_ENDS, "topics", _MOST_KEPT)]
