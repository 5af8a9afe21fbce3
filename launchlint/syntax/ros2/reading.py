"""Bytes to what a ROS 2 launch file describes, by the rules of launch's front ends for XML and YAML.

Which of them reads a file: the one that its name is for, then the other (``launch.frontend.Parser.load``). Both give entities
(:mod:`launchlint.syntax.ros2.entity`), and these become actions in the order in which launch reads them, depth first: a file is read to
its end before anything of it is executed, so that a mistake under ``if="false"`` is one.
"""

from __future__ import annotations

from typing import NamedTuple

from launchlint.problem import Problem
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.description import Description

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Document


class Reading(NamedTuple):
    """What was read.

    ``problems`` are in the order in which launch meets them, each with its place in this file (an origin without includes). Those with
    ``refused`` are each enough for launch to refuse the file, and the first of them is the one that it names; after a problem the reading
    goes on, so that ``description`` holds whatever could be understood.

    ``document`` is the tree of an XML file, None for YAML.
    """

    description: Description
    problems: tuple[Problem, ...]
    source: Source
    document: Document | None = None

    @property
    def refusal(self) -> Problem | None:
        """The problem for which launch refuses to load the file, if any."""
        return next((problem for problem in self.problems if problem.refused), None)


def read(data: bytes, path: str, file: str | None = None, distro: str = "jazzy") -> Reading:
    """Read the content of a launch file in XML or YAML; never raises.

    Args:
        data: the whole file.
        path: the name shown to people.
        file: the name under which the file was opened: its ending says which front end comes first.
        distro: the distribution of ROS 2 whose tags, attributes and substitutions count.
    """
    source = Source(path, data.decode("utf-8", "replace"), file)
    return Reading(Description((), Place(source, Span(0, 0))), (), source)
