"""What a dialect lets stand where, as completion asks it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol


class Tables(Protocol):
    """What a dialect lets stand where."""

    def tags(self, parent: str) -> Iterator[tuple[str, tuple[str, ...], bool]]:
        """The tags that may stand in ``parent``: name, attributes that must be there, whether it holds others."""

    def attributes(self, tag: str, parent: str) -> Iterator[tuple[str, bool, str]]:
        """The attributes of a tag: name, whether it must be there, what it takes."""

    def values(self, tag: str, attribute: str) -> tuple[str, ...]:
        """The values that an attribute takes, where they are few."""
