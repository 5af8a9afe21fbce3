"""Whether two texts describe the same, wherever it is written in them: then launch does the same with both, in every configuration."""

from __future__ import annotations

from launchlint.source import Place
from launchlint.syntax.ros2.reading import Reading


def difference(before: Reading, after: Reading) -> str:
    """What would change first, in one plain sentence without a full stop; empty where nothing does."""
    refused = [sorted(problem.kind for problem in each.problems if problem.refused) for each in (before, after)]
    if refused[0] != refused[1]:
        more = next((kind for kind in refused[1] if refused[1].count(kind) > refused[0].count(kind)), "")
        if more:
            return f"ros2 launch would refuse the file for another reason ({more.replace('-', ' ')})"
        return "ros2 launch would no longer see one reason to refuse the file"
    return "" if _in_line(before.description.actions) == _in_line(after.description.actions) else "the file would describe something else"


def _in_line(described: object) -> list[object]:
    """All that is described, without places, in a line: equal for equal trees, however deep these are."""
    found: list[object] = []
    waiting = [described]
    while waiting:
        item = waiting.pop()
        if isinstance(item, Place):
            continue
        if isinstance(item, tuple):
            found.append((type(item).__name__, len(item)))
            waiting.extend(reversed(item))
        else:
            found.append((type(item).__name__, item))
    return found
