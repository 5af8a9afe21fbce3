"""The distributions of ROS 2 that launch files are read for, and which one it is."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.model import ROS1, ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import DialectName

DISTRIBUTIONS = ("humble", "jazzy", "kilted", "rolling")
"""Oldest first."""
DEFAULT = "jazzy"
"""The newest one with long-term support."""


def distribution(said: str, variables: Mapping[str, str]) -> str:
    """The one that somebody ``said`` (empty: nobody did), else the one whose environment this is, else the default."""
    here = variables.get("ROS_DISTRO", "")
    return said or (here if here in DISTRIBUTIONS else DEFAULT)


def environment_is_for(variables: Mapping[str, str]) -> DialectName | None:
    """The dialect whose set-up script has made this environment (REP 149); None where none has."""
    version = variables.get("ROS_VERSION", "")
    if version in ("1", "2"):
        return ROS1 if version == "1" else ROS2
    return ROS2 if variables.get("ROS_DISTRO", "") in DISTRIBUTIONS else None
