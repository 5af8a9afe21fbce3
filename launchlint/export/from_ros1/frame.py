"""What one translation collects, and what is in force where something of the file is translated."""

from __future__ import annotations

from launchlint.export.ros2.losses import Lost, Remark
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Condition, ParameterSource, Text


class Account:
    """What has no counterpart, and what a person should look at. ``dropped`` are the places of elements that the proof leaves out."""

    def __init__(self) -> None:
        self.lost: list[Lost] = []
        self.remarks: list[Remark] = []
        self.dropped: list[Place] = []

    def lose(self, place: Place, what: str, why: str) -> None:
        """Note that ``what`` is not in what is written."""
        self.lost.append(Lost(place, what, why))
        self.dropped.append(place)

    def say(self, place: Place, what: str, why: str) -> None:
        """The same for a part of something that is written otherwise."""
        self.lost.append(Lost(place, what, why))

    def remark(self, place: Place, words: str) -> None:
        """Note what a person should know."""
        self.remarks.append(Remark(place, words))


class Setting(NamedTuple):
    """A remap or a ``~param`` that acts on the nodes that follow; ``key`` is what a later one replaces, empty where computed."""

    key: str
    condition: Condition | None
    place: Place
    remap: tuple[Text, Text] | None = None
    sources: tuple[ParameterSource, ...] = ()


class Scope:
    """What is in force at one point of a file. ``declared`` are the args that are known there."""

    def __init__(self, outer: Scope | None = None) -> None:
        self.remaps: list[Setting] = [] if outer is None else list(outer.remaps)
        self.private: list[Setting] = [] if outer is None else list(outer.private)
        self.declared: list[str] = [] if outer is None else list(outer.declared)

    def add(self, settings: list[Setting], new: Setting) -> None:
        """Add ``new``; an earlier one of the same key goes, where both always act."""
        if new.key and new.condition is None:
            settings[:] = [each for each in settings if each.key != new.key or each.condition is not None]
        settings.append(new)
