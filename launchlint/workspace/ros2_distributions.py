"""The distributions of ROS 2 that launch files are read for, and which one it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import DialectName

DISTRIBUTIONS = ("humble", "jazzy", "kilted", "rolling")
"""Oldest first."""
DEFAULT = "jazzy"
"""The newest one with long-term support."""
READ_AS = {
    "ardent": "humble", "bouncy": "humble", "crystal": "humble", "dashing": "humble", "eloquent": "humble", "foxy": "humble",
    "galactic": "humble", "humble": "humble", "iron": "jazzy", "jazzy": "jazzy", "kilted": "kilted", "rolling": "rolling",
}  # fmt: skip
"""All distributions, oldest first, each with the one that its launch files are read for: the nearest that knows no less."""
AGE = {name: number for number, name in enumerate(READ_AS)}


class Meant(NamedTuple):
    """The distribution of which launch files are: ``name`` is the one they are read for.

    ``named`` are those it was taken from, oldest first, and the last of them stands in ``file`` (absolute), which is empty where somebody
    said it, the environment does, or nothing does.
    """

    name: str
    named: tuple[str, ...] = ()
    file: str = ""

    def before(self, name: str) -> tuple[str, ...]:
        """Those that are named and older than the distribution ``name``, oldest first."""
        return tuple(each for each in self.named if AGE[each] < AGE[name])


def distribution(said: str, variables: Mapping[str, str], named: Callable[[], Mapping[str, str]]) -> Meant:
    """The one that somebody ``said`` (empty: nobody did), else the one whose environment this is, else the newest of those ``named``,
    which gives what files of the repository name, each with its file; else the default.
    """
    here = variables.get("ROS_DISTRO", "")
    if said or here in READ_AS:
        return Meant(READ_AS.get(said or here, said), (said or here,))
    found = named()
    if not found:
        return Meant(DEFAULT)
    listed = tuple(sorted(found, key=AGE.__getitem__))
    return Meant(READ_AS[listed[-1]], listed, found[listed[-1]])


def set_up(meant: Meant) -> dict[str, str]:
    """What the set-up script of a distribution sets, whatever machine it is run on (the package ros_environment)."""
    return {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": meant.named[-1] if meant.named else meant.name}


def environment_is_for(variables: Mapping[str, str]) -> DialectName | None:
    """The dialect whose set-up script has made this environment (REP 149); None where none has."""
    version = variables.get("ROS_VERSION", "")
    if version in ("1", "2"):
        return ROS1 if version == "1" else ROS2
    return ROS2 if variables.get("ROS_DISTRO", "") in DISTRIBUTIONS else None
