"""Whether sources of the workspace, of whatever program, say a name: then the other end of it may be started from another launch file."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from launchlint.workspace.looking import question
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
    without = tuple(f"/{each}" for each in besides)
    return any(not file.endswith(without) for file in packages.answer(_saying, f"{'+' if offers else '-'}{name}"))


@question
def _saying(packages: Packages, what: str) -> tuple[str, ...]:
    """The first files of the sources that say it."""
    return packages.once(_kept).get(what, ())


def _kept(packages: Packages) -> Mapping[str, tuple[str, ...]]:
    """What the sources say, each with the first files that do."""
    return files_by_word(packages.workspaces, _SOURCE_ENDS, "topics", _MOST_KEPT, packages.held)
