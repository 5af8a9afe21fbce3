"""Launch files of ROS 2 that one of ROS 1 includes: roslaunch reads them as its own, and what it says of their words is one mistake.

It is told once, at the include. Whoever reads those files wants to know nothing of what roslaunch makes of them.
"""

from __future__ import annotations

from launchlint.finding import Finding
from launchlint.model import ROS1, ROS2
from launchlint.syntax.dialect import told
from launchlint.workspace.other_ros import built_for_ros2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Set

    from launchlint.evaluate.assemble import Evaluation
    from launchlint.rules.rule import Fine
    from launchlint.source import Origin
    from launchlint.workspace.packages import Packages


OF_INCLUDES = "LL112"
"""The rule that tells it. Where nobody wants to hear of that, the others say what they have to say."""


class IncludesOfRos2:
    """The includes of one evaluation through which files of ROS 2 are read by roslaunch; ``rules`` are those that are asked for."""

    def __init__(self, evaluation: Evaluation, packages: Packages, rules: Set[str]) -> None:
        self._through: dict[str, tuple[Origin, str]] = {}
        if evaluation.launch.dialect != ROS1 or OF_INCLUDES not in rules:
            return
        for include in evaluation.launch.includes:  # in the order in which they are followed
            source, around = include.source, self._through.get(include.origin.place.source.path)
            if source is None or source.path in self._through:
                continue
            document = evaluation.documents.get(source.path)
            if around is not None:
                self._through[source.path] = around
            elif (
                document is not None
                and built_for_ros2(source.file, packages) is not None
                and told(document, ROS2, of_ros2_only=True) == ROS2
            ):
                self._through[source.path] = include.origin, source.path

    def has(self, path: str) -> bool:
        """Whether the file (as shown) is one of them."""
        return path in self._through

    def instead_of(self, finding: Finding, path: str) -> Finding:
        """What is told in place of ``finding``, what roslaunch makes of the file at ``path``, one of these: that it is included."""
        from launchlint.rules.xml.wrong_dialect import included

        return included(*self._through[path], finding)

    def without(self, found: Iterable[Finding | Fine]) -> Iterator[Finding | Fine]:
        """What was ``found``, but for what lies in one of these files."""
        return (each for each in found if not isinstance(each, Finding) or each.location.path not in self._through)
