"""What a value is made of: text that stands for itself, and what the launcher puts something else in place of.

The types are the same for every dialect, the grammar is the dialect's own (:mod:`launchlint.syntax.ros1.substitutions`). Each part says
where it begins and ends in the value; :meth:`launchlint.syntax.tree.Attribute.span_of` turns that into a place in the file, also where the
value holds references such as ``&quot;``. The texts of all parts, joined, are the value.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias


class Word(NamedTuple):
    """One word of a substitution. ``text`` is as written; ``parts`` is what it is made of, where the dialect lets more than text stand in
    it (quotes, other substitutions), else empty.
    """

    text: str
    start: int
    end: int
    parts: tuple[Part, ...] = ()


class Literal(NamedTuple):
    """Text that stands for itself."""

    text: str
    start: int
    end: int


class Substitution(NamedTuple):
    """``$(command word word)``: ``words`` are all of them, the command is the first. There are none in ``$( )``."""

    text: str
    start: int
    end: int
    words: tuple[Word, ...]

    @property
    def command(self) -> str:
        """The first word; empty where there is none."""
        return self.words[0].text if self.words else ""

    @property
    def only(self) -> str:
        """The word behind the command, where it is the only one; else empty."""
        return self.words[1].text if len(self.words) == 2 else ""


class Expression(NamedTuple):
    """``$(eval …)`` that is computed as a whole: ``code`` is what stands inside, from ``code_start`` on."""

    text: str
    start: int
    end: int
    code: str
    code_start: int


class Malformed(NamedTuple):
    """What looks like a substitution and is none.

    ``kind`` is one of the dialect's. ``refused`` says why the launcher stops when it gets here, in plain words; where it is empty the text
    stays in the value as it is. ``words`` are those of the substitution that was meant.
    """

    text: str
    start: int
    end: int
    kind: str
    words: tuple[Word, ...] = ()
    refused: str = ""


Part: TypeAlias = "Literal | Substitution | Expression | Malformed"


class Parts(NamedTuple):
    """A whole value, taken apart.

    ``alone`` is the part that the value consists of, where something is put in its place and nothing stands beside it. ``refused`` is the
    first part for which the launcher refuses the whole value.
    """

    text: str
    parts: tuple[Part, ...]
    alone: Substitution | Expression | None = None
    refused: Malformed | None = None

    @property
    def expression(self) -> Expression | None:
        """The expression that the value consists of."""
        return self.alone if isinstance(self.alone, Expression) else None

    @property
    def computed(self) -> bool:
        """Whether something is put in place of any of it."""
        return any(isinstance(part, (Substitution, Expression)) for part in self.parts)

    def substitutions(self, command: str = "") -> Iterator[Substitution]:
        """Its substitutions in order, those with ``command`` only where one is given."""
        for part in self.parts:
            if isinstance(part, Substitution) and (not command or part.command == command):
                yield part

    def names(self, command: str) -> Iterator[str]:
        """What is asked for by the substitutions with ``command`` and a single further word."""
        return (part.only for part in self.substitutions(command) if part.only)

    def beside(self, instead: str = "") -> str:
        """The text that stands for itself, with ``instead`` in place of each substitution."""
        return "".join(instead if isinstance(part, (Substitution, Expression)) else part.text for part in self.parts)

    def filled(self) -> str:
        """The text with dots in place of each substitution, as many as it has characters: for what is to be looked for between them."""
        return "".join("." * len(part.text) if isinstance(part, (Substitution, Expression)) else part.text for part in self.parts)
