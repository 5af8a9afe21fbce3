"""The ROS that is installed here: which programs it has, how a node of it is run, and what is known when it has been."""

import os
import subprocess
from typing import Any, Dict, Iterator, List, Optional

from launchlint_probe import discover
from launchlint_probe.counterpart import Counterpart
from launchlint_probe.plan import Plan
from launchlint_probe.session import Run

Job = Dict[str, Any]
Record = Dict[str, Any]


class Installation:
    """What both kinds have. ``packages`` are those that can be seen."""

    runs_launch_files = False

    def __init__(self, packages: discover.Packages) -> None:
        self.packages = packages

    def programs(self, package: str) -> Iterator[discover.Found]:
        """The programs of a package."""
        raise NotImplementedError

    def opposite(self, plan: Plan) -> Counterpart:
        """What a node talks to."""
        raise NotImplementedError

    def second(self, plan: Plan) -> Plan:
        """How a node is run for the second time."""
        return plan

    def final(self, plan: Plan, second: Run) -> Optional[Plan]:
        """How it is run once more, where its second run has shown that the first cannot tell all; else None."""
        return None

    def joined(self, record: Record, second: Record) -> Record:
        """The record of a first run, with what only the second one can tell."""
        return record

    def messages(self, record: Record) -> Dict[str, Dict[str, str]]:
        """The definitions of the messages that a record names."""
        return {}


def is_ros2() -> bool:
    """Whether the ROS of this environment is ROS 2."""
    return bool(os.environ.get("AMENT_PREFIX_PATH"))


def here(job: Job) -> Installation:
    """The installation that the environment leads to; ``prefixes`` and ``sources`` of the job may name others."""
    if is_ros2():
        from launchlint_probe.ros2 import Ros2

        return Ros2(job)
    from launchlint_probe.ros1 import Ros1

    return Ros1(job)


def about() -> Dict[str, str]:
    """Middleware and distribution."""
    distro = os.environ.get("ROS_DISTRO", "")
    if is_ros2():
        places = os.environ["AMENT_PREFIX_PATH"].split(os.pathsep)
        named = [os.path.basename(place) for place in places if os.path.dirname(place) == "/opt/ros"]
        return {"middleware": "ros2", "distro": (distro or (named or [""])[-1]).lower()}
    return {"middleware": "ros1", "distro": (distro or _debian()).lower()}


def _debian() -> str:
    try:
        done = subprocess.run(
            ["dpkg-query", "-W", "-f", "${Version}", "libroscpp4d", "python3-rospy"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=10,
        )
        version = done.stdout.decode("ascii", "replace").strip()
        return "debian" if version else ""
    except (OSError, subprocess.TimeoutExpired):
        return ""


def prefixes_of(variable: str) -> List[str]:
    """The directories that a variable of the environment lists."""
    return [each for each in os.environ.get(variable, "").split(os.pathsep) if each]
