"""What a project may say about its normal form."""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple


class Style(NamedTuple):
    """How launch files are written: the ``format`` key of the configuration.

    ``line_width``: characters that a start tag may take, with its indentation, before each attribute gets a line. ``indent``: blanks per
    level. ``sort_attributes``: attributes stand in the order of the dialect's tables, instead of the one they are written in.
    """

    line_width: int = 120
    indent: int = 2
    sort_attributes: bool = True
