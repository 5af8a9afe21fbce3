"""What rcl refuses: a node with such a command line ends when it starts."""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.source import Source, Span


class Refused(NamedTuple):
    """Why rcl refuses a word, a file or a command line, in plain words.

    ``span`` is where that shows: in the file ``source``, or else in the word with the number ``word`` of the command line. ``instead`` is
    what to write, where that can be said.
    """

    reason: str
    span: Span = Span(0, 0)
    source: Source | None = None
    word: int = 0
    instead: str = ""
