"""For which of the distributions that a workspace is for a package was released: elsewhere rosdep does not find it."""

from __future__ import annotations

import re

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.public_packages import public_names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.manifest import Manifest
    from launchlint.workspace.packages import Packages

_RECENT = ("kinetic", "melodic", "noetic")
"""What a workspace of ROS 1 that names no distribution is taken to be for."""
_CONDITION = late(r"\scondition\s*=\s*[\"']([^<>]*)")
_DISTRIBUTION = late(r"\b(?:indigo|jade|kinetic|lunar|melodic|noetic)\b", re.IGNORECASE)
"""In the conditions of a ``package.xml`` of format 3: it is for all distributions that these tell apart."""
_WORD = late(r"[a-z]+")
_WITH_CONDITIONS = 3
"""The format of ``package.xml`` from which on a dependency may have a condition (REP 149)."""


class Lacking(NamedTuple):
    """The distributions without the package, and those of the rest for which the ``package.xml`` can ask for it with a ``condition``."""

    distributions: tuple[str, ...] = ()
    condition: str = ""

    def why(self, name: str) -> str:
        """What to say of package ``name``."""
        return f"{name} was never released for {', '.join(each.title() for each in self.distributions)}: rosdep does not find it there"


def lacking(name: str, manifest: Manifest, packages: Packages) -> Lacking:
    """The distributions that the workspace, or a condition in ``manifest``, names and that have never had the package ``name``.

    Nothing where the package lies here, or was never released at all.
    """
    if packages.has(name):
        return Lacking()
    if manifest.is_ament:
        return _of_ros2(name, manifest, packages)
    from launchlint.workspace.releases import never_released

    named = {each.lower() for text in _CONDITION.findall(manifest.source.text) for each in _DISTRIBUTION.findall(text)}
    meant = named | packages.distributions().meant
    found = sorted(each for each in meant or _RECENT if never_released((name,), each))
    return Lacking(tuple(found)) if meant or len(found) == len(_RECENT) else Lacking()


def _of_ros2(name: str, manifest: Manifest, packages: Packages) -> Lacking:
    from launchlint.workspace.named_distributions import named_in
    from launchlint.workspace.ros2_distributions import AGE

    released = set(public_names().get(name, ())) & AGE.keys()
    words = {each for text in _CONDITION.findall(manifest.source.text) for each in _WORD.findall(text.lower())}
    named = sorted((words | packages.answer(named_in, "").keys()) & AGE.keys(), key=AGE.__getitem__)
    without = tuple(each for each in named if each not in released)
    having = [each for each in named if each in released]
    if not released or not without:
        return Lacking()
    condition = " or ".join(f"$ROS_DISTRO == '{each}'" for each in having) if manifest.format >= _WITH_CONDITIONS else ""
    return Lacking(without, condition)
