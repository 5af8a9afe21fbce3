"""An installation of ROS 2."""

import os
import shutil
import subprocess
import sys
from typing import Any, Dict, Iterator, List, Optional, Tuple

from launchlint_probe import discover
from launchlint_probe.counterpart import Counterpart
from launchlint_probe.domain import Domain
from launchlint_probe.installation import Installation, Job, Record, prefixes_of
from launchlint_probe.plan import Plan
from launchlint_probe.session import Run

LOADER = ("rclcpp_components", "component_container")
"""Package and program that components are loaded into."""


class NoRclpy(Exception):
    """No Python here has rclpy."""


class Ros2(Installation):
    """See the module."""

    def __init__(self, job: Job) -> None:
        self._prefixes = job.get("prefixes") or prefixes_of("AMENT_PREFIX_PATH")
        super().__init__(discover.see(self._prefixes, job.get("sources", []), discover.ROS2))
        self._python = python_with_rclpy()
        where = [os.path.join(prefix, "lib", *LOADER) for prefix in prefixes_of("AMENT_PREFIX_PATH") + self._prefixes]
        self._loader = next((path for path in where if os.access(path, os.X_OK)), None)

    def programs(self, package: str) -> Iterator[discover.Found]:
        """Executables are only those that are installed: ROS 2 runs nothing out of sources."""
        yield from discover.executables(package, self.packages.programs[package], None, discover.ROS2)
        yield from discover.components(package, self._prefixes, self._loader)

    def opposite(self, plan: Plan) -> Counterpart:
        return Domain(plan, self._python)

    def second(self, plan: Plan) -> Plan:
        """As it is, without a name or namespace of the probe's: so the node says its own."""
        return _as(plan, with_name=False, with_namespace=False)

    def final(self, plan: Plan, second: Run) -> Optional[Plan]:
        """Several nodes in one process all get the name that one is given; so they keep theirs."""
        return _as(plan, with_name=False, with_namespace=True) if len(second.record.get("nodes", [])) > 1 else None

    def joined(self, record: Record, second: Record) -> Record:
        """With the name, and the namespace, that the first node gives itself."""
        nodes: List[Tuple[str, str]] = [tuple(each) for each in second.get("nodes", [])]
        if not nodes or second["status"] != "ok":
            return record
        namespace, name = nodes[0]
        traits: Dict[str, Any] = dict(record.get("traits", {}), node=name)
        if namespace != "/":
            traits["namespace"] = namespace
        return dict(record, traits=traits)


def _as(plan: Plan, **changes: bool) -> Plan:
    made = Plan.__new__(Plan)
    made.__dict__.update(plan.__dict__)
    made.__dict__.update(changes)
    return made


def python_with_rclpy() -> str:
    """The interpreter that can import rclpy.

    Raises:
        NoRclpy: there is none.
    """
    candidates = ["/usr/bin/python3", shutil.which("python3") or "", sys.executable]
    for candidate in dict.fromkeys(each for each in candidates if each):
        try:
            if subprocess.call([candidate, "-c", "import rclpy"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=60) == 0:
                return candidate
        except (OSError, subprocess.TimeoutExpired):
            continue
    raise NoRclpy("no Python here has rclpy, which the probe reads the graph with")
