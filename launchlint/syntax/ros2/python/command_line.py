"""``sys.argv`` in a launch file: ``ros2 launch PACKAGE FILE name:=value …`` or ``ros2 launch PATH name:=value …``.

How the command is called and where the file lies is nobody's business, but none of these words is an argument ``name:=value``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from launchlint.python.text import ANY
from launchlint.python.values import UNKNOWN, Choice, Outside, Seq, Value

SIGN = ":="


class Word(Outside):
    """A word in front of the arguments."""

    __slots__ = ()

    def template(self) -> str:
        """Any string."""
        return ANY

    def method(self, name: str, positional: Sequence[Value]) -> Value:
        """What is asked about the sign that arguments have in them."""
        first = positional[0] if len(positional) == 1 else None
        if not isinstance(first, str) or SIGN not in first:
            return UNKNOWN
        if name in ("split", "rsplit"):
            return Seq([self])
        if name in ("startswith", "endswith"):
            return False
        if name == "partition":
            return Seq([self, "", ""], is_tuple=True)
        return {"find": -1, "rfind": -1, "count": 0}.get(name, UNKNOWN)


def words(arguments: Iterable[tuple[str, str]]) -> Seq:
    """The words of a command line that gives ``arguments``."""
    package = Choice((("the launch file is named by its package", Word()),))
    return Seq([Word(), "launch", package, Word(), *(f"{name}{SIGN}{value}" for name, value in arguments)])
