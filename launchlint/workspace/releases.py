"""What a package needs that was never released for a distribution: then that distribution is out of its reach."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 100
_MOST_FILES = 200
_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
# No grammar, a look through whole files, comments and all: what is found is only looked up in a list of public packages.
_USED = late(r"\$\(\s*find\s+([A-Za-z][\w-]*)\s*\)|\bpkg\s*=\s*[\"']([A-Za-z][\w-]*)[\"']")
_ROS_1 = ("electric", "fuerte", "groovy", "hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic")


class Needs(NamedTuple):
    """The packages that the launch files of a package name, and the places that were looked at."""

    names: frozenset[str]
    looked: frozenset[str]


def read_needs(directory: str) -> Needs:
    """What the launch files below ``directory`` name in ``pkg`` and ``$(find …)``. Bounded; never raises."""
    found: set[str] = set()
    looked: set[str] = set()
    places = ((each, [name for name in listed if name.endswith(_LAUNCH_ENDS)]) for each, listed in walk(directory, _MOST_DIRECTORIES))
    for _, text in texts(places, _MOST_FILES, looked):
        found.update(one or other for one, other in _USED.findall(text))
    return Needs(frozenset(found), frozenset(looked))


def never_released(names: Iterable[str], distribution: str) -> str:
    """The first of ``names`` that ROS 1 distributions before ``distribution`` have, and neither it nor a later one; else empty.

    What the public list does not have at all says nothing.
    """
    known = public_names()
    for name in sorted(names):
        released = [each for each in known.get(name, ()) if each in _ROS_1]
        if released and max(released) < distribution.lower():  # they are named in the order of the alphabet
            return name
    return ""
