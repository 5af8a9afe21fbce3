"""A declarative launch file as a tree that XML and YAML are written from."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.source import Place

    Scalar: TypeAlias = "bool | int | float | str"
    Plain: TypeAlias = "Scalar | list[Scalar]"


class Branch:
    """One tag with what stands in it.

    ``attributes`` hold values as YAML has them; ``typed`` names those whose text in XML is read as YAML, too. ``named`` are inner tags that
    YAML keeps under their name, ``actions`` the others; None where the tag takes no actions. ``place`` is where it comes from.
    ``above``, ``beside`` and ``below`` are lines of comments: before it, behind it in its line, and as the last thing inside.
    """

    __slots__ = ("above", "actions", "attributes", "below", "beside", "named", "place", "tag", "typed")

    def __init__(self, tag: str, place: Place) -> None:
        self.tag = tag
        self.place = place
        self.attributes: dict[str, Plain] = {}
        self.typed: set[str] = set()
        self.named: list[Branch] = []
        self.actions: list[Branch] | None = None
        self.above: list[str] = []
        self.beside: list[str] = []
        self.below: list[str] = []

    @property
    def inner(self) -> list[Branch]:
        """All that stands in it."""
        return [*self.named, *(self.actions or ())]
