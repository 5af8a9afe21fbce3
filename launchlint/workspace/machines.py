"""The machines that launch files of a workspace define: a file that runs nodes on one of them may be a part of such a launch."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import parts

_ENDS = (".launch", ".xml", ".machine", ".machines", ".test")
_MOST_DIRECTORIES = 2_000
_MOST_FILES = 600

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


class Machines(NamedTuple):
    """Each machine that is defined by a name without substitutions, with the first file (absolute) that does, and what was looked at."""

    known: Mapping[str, str]
    looked: frozenset[str]


def read_machines(directories: Iterable[str], held: Contents | None = None) -> Machines:
    """The machines that launch files below ``directories`` define. Bounded; never raises. ``held`` may know what the files hold.

    It is no grammar, but a look through whole files: that a machine is defined somewhere is a reason for less, never for more.
    """
    found: dict[str, str] = {}
    looked: set[str] = set()
    places = (
        (directory, [name for name in listed if name.endswith(_ENDS)])
        for top in directories
        for directory, listed in walk(top, _MOST_DIRECTORIES)
    )
    for file, names in parts(places, _MOST_FILES, looked, "machines", held):
        for name in names:
            found.setdefault(name, file)
    return Machines(found, frozenset(looked))
