"""What was made of texts that several nodes, configurations and entry files have in common: the params of a launch are few texts, often."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Hashable
    from typing import Any, TypeVar

    Made = TypeVar("Made")

MOST_CHARACTERS = 2_000_000
"""Of all texts of which something is kept: what is made of a text takes up to fifty times as much memory as the text."""


class ByText:
    """What was made of texts, by the text, for as long as the texts come to no more than ``most`` characters: what was not asked for
    longest is forgotten first.

    It may only be asked for what follows from the text and the key alone. What it gives is given to others, too: nobody changes it.
    """

    __slots__ = ("_characters", "_kept", "_most")

    def __init__(self, most: int = MOST_CHARACTERS) -> None:
        self._most = most
        self._characters = 0
        self._kept: dict[tuple[str, Hashable], Any] = {}

    def __len__(self) -> int:
        return len(self._kept)

    def once(self, text: str, key: Hashable, make: Callable[[], Made]) -> Made:
        """What ``make`` makes of ``text``; ``key`` says what that is. It is made again only where it has been forgotten."""
        known = (text, key)
        if known in self._kept:
            made: Made = self._kept.pop(known)
        else:
            made = make()
            self._characters += len(text)
        self._kept[known] = made
        while self._characters > self._most:
            (oldest, _) = forgotten = next(iter(self._kept))
            del self._kept[forgotten]
            self._characters -= len(oldest)
        return made
