"""An installation of ROS 1."""

import os
from typing import Dict, Iterator, List

from launchlint_probe import discover
from launchlint_probe.counterpart import Counterpart
from launchlint_probe.installation import Installation, Job, Record, prefixes_of
from launchlint_probe.master import Master
from launchlint_probe.messages import Definitions, used
from launchlint_probe.plan import Plan


class Ros1(Installation):
    """See the module."""

    runs_launch_files = True

    def __init__(self, job: Job) -> None:
        prefixes = job.get("prefixes") or discover.default_prefixes()
        super().__init__(discover.see(prefixes, job.get("sources", [])))
        paths = [os.path.join(directory, "nodelet") for directory in self.packages.programs.get("nodelet", [])]
        self._loader = next((path for path in paths if os.access(path, os.X_OK)), None)
        self._definitions = Definitions(self.packages.shares, _module_directories(prefixes))

    def programs(self, package: str) -> Iterator[discover.Found]:
        seen = self.packages
        yield from discover.executables(package, seen.programs[package], seen.sources.get(package))
        yield from discover.nodelets(package, seen.shares.get(package, []), self._loader)

    def opposite(self, plan: Plan) -> Counterpart:
        return Master(plan, self._definitions)

    def messages(self, record: Record) -> Dict[str, Dict[str, str]]:
        return used([record], self._definitions)


def _module_directories(prefixes: List[str]) -> List[str]:
    """Where Python modules of messages are."""
    found = prefixes_of("PYTHONPATH")
    for prefix in prefixes:
        found.append(os.path.join(prefix, "lib", "python3", "dist-packages"))
        found.append(os.path.join(prefix, "lib", "python2.7", "dist-packages"))
    return [each for each in dict.fromkeys(found) if os.path.isdir(each)]
