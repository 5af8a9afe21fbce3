"""What a table of the library format is made of: each of these small classes is a *shape*, a kind of value that a key may hold."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

LONGEST_NAME = 1_000
"""Characters of a name, type or other single word."""
LONGEST_TEXT = 100_000
"""Characters of a message definition or a build error."""


class Text(NamedTuple):
    """A string; ``one_of`` where only some are allowed, ``syntax`` names a finer check of the validator.

    ``templates``: a template is allowed in place of one of them.
    """

    one_of: tuple[str, ...] = ()
    syntax: str = ""
    longest: int = LONGEST_NAME
    templates: bool = False


class Number(NamedTuple):
    """A whole number, at least ``least``."""

    least: int = 0


class Amount(NamedTuple):
    """A number, not below zero, or a template for it. ``whole``: no fraction; ``words`` stand for what no number says."""

    whole: bool = False
    words: tuple[str, ...] = ()


class Flag(NamedTuple):
    """True or false."""


class Plain(NamedTuple):
    """Any JSON value: a param's default, a probe's own notes."""


class Rule(NamedTuple):
    """Something with a grammar of its own: ``condition`` or ``each``."""

    grammar: str


class Items(NamedTuple):
    """A list of ``each``."""

    each: Shape


class Entries(NamedTuple):
    """A mapping from names to ``each``; ``named`` says in messages what its keys are."""

    each: Shape
    named: str


class Keys(NamedTuple):
    """A mapping with known keys; ``name`` says in messages what it is."""

    name: str
    keys: Mapping[str, Shape]
    required: tuple[str, ...] = ()


class Choice(NamedTuple):
    """A mapping that is of one of several shapes: its ``key`` says of which, or ``default`` where it lacks the key."""

    key: str
    default: str
    shapes: Mapping[str, Keys]

    def of(self, value: Any) -> Keys:
        """The shape of a mapping; the default one where its key says nothing that there is."""
        said = value.get(self.key, self.default) if isinstance(value, dict) else self.default
        return self.shapes.get(said if isinstance(said, str) else "", self.shapes[self.default])


Shape = Text | Number | Amount | Flag | Plain | Rule | Items | Entries | Keys | Choice
