"""All that a launch file of ROS 2 describes, wherever in it that stands."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.source import Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.description import Description


def everything(description: Description) -> Iterator[object]:
    """Actions, conditions, params, remaps, texts and substitutions in the order in which they are written: each before what is in it.

    What a program has put into several places comes once: what it holds may stand in all of them, and be more than anybody could count.
    """
    waiting: list[object] = [description]
    met: set[int] = set()
    while waiting:
        each = waiting.pop()
        if isinstance(each, tuple) and not isinstance(each, Place) and id(each) not in met:
            met.add(id(each))
            if type(each) is not tuple:
                yield each
            waiting.extend(reversed(each))
