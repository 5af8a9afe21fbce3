"""The machines that launch files of a workspace define: a file that runs nodes on one of them may be a part of such a launch."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import texts

_ENDS = (".launch", ".xml", ".machine", ".machines", ".test")
_MOST_DIRECTORIES = 2_000
_MOST_FILES = 600
# No grammar, a look through whole files: that a machine is defined somewhere is a reason for less, never for more.
_MACHINE = late(r"<machine\b[^<>]{0,1000}?\bname\s*=\s*[\"']([^\"'$<>]{1,200})[\"']")


class Machines(NamedTuple):
    """Each machine that is defined by a name without substitutions, with the first file (absolute) that does, and what was looked at."""

    known: Mapping[str, str]
    looked: frozenset[str]


def read_machines(directories: Iterable[str]) -> Machines:
    """The machines that launch files below ``directories`` define. Bounded; never raises."""
    found: dict[str, str] = {}
    looked: set[str] = set()
    places = (
        (directory, [name for name in listed if name.endswith(_ENDS)])
        for top in directories
        for directory, listed in walk(top, _MOST_DIRECTORIES)
    )
    for file, text in texts(places, _MOST_FILES, looked):
        for match in _MACHINE.finditer(text):
            found.setdefault(match[1].strip(), file)
    return Machines(found, frozenset(looked))
