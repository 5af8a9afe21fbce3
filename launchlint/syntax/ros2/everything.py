"""All that a launch file of ROS 2 describes, wherever in it that stands."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.source import Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.description import Description


def everything(description: Description) -> Iterator[object]:
    """Actions, conditions, params, remaps, texts and substitutions in the order in which they are written: each before what is in it."""
    waiting: list[object] = [description]
    while waiting:
        each = waiting.pop()
        if isinstance(each, tuple) and not isinstance(each, Place):
            if type(each) is not tuple:
                yield each
            waiting.extend(reversed(each))
