"""One entity of a launch file, however it is written: a tag with attributes and children, each with its place.

What is read of it is remembered, so that the rest can be told of, as launch's ``Entity`` does. Source: ``launch_xml.entity`` and
``launch_yaml.entity``.
"""

from __future__ import annotations

from abc import ABC, abstractmethod

from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2.written import Written

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.problem import Problem
    from launchlint.syntax.ros2.values import Plain


class Value(NamedTuple):
    """The value of an attribute, converted to the type that was wanted.

    ``written`` is the text where ``plain`` is one; ``items`` are those of a list, None for what is no text. ``place`` is where it is shown.
    """

    plain: Plain
    place: Place
    written: Written | None = None
    items: tuple[Written | None, ...] = ()

    @property
    def text(self) -> Written:
        """The text; for a value of another type, how it is written."""
        return Written(self.place.text, self.place) if self.written is None else self.written


class Entity(ABC):
    """A tag with all that stands in it."""

    __slots__ = ("tag",)
    tag: str

    @property
    @abstractmethod
    def name_place(self) -> Place:
        """The tag's name."""

    @property
    @abstractmethod
    def place(self) -> Place:
        """Where it begins: the start tag, or the key."""

    @property
    @abstractmethod
    def given(self) -> tuple[str, ...]:
        """The names of its attributes, in order."""

    def shapeless(self) -> Problem | None:
        """The problem of an entity that launch cannot even look for attributes in."""
        return None

    @abstractmethod
    def attribute_place(self, name: str) -> Place:
        """The name of an attribute that is given."""

    @abstractmethod
    def value(self, name: str, wanted: str, problems: list[Problem]) -> Value | None:
        """The attribute ``name`` as a ``wanted`` type (one of the names that ``type`` of ``<param>`` has); it counts as read.

        None where it is not there, and where launch refuses its value: that is put to ``problems``.
        """

    @abstractmethod
    def has(self, name: str) -> bool:
        """Whether there is an attribute ``name``; it does not count as read."""

    @abstractmethod
    def named(self, name: str, problems: list[Problem]) -> list[Entity] | None:
        """The children with the tag ``name``, which count as read; None where there are none."""

    @abstractmethod
    def children(self, problems: list[Problem]) -> list[Entity]:
        """The children that are actions, or may be; all count as read."""

    @abstractmethod
    def unread(self) -> tuple[list[Entity], list[str]]:
        """The children and the attributes that were not read, in order."""
