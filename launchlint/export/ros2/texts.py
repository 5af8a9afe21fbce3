r"""Texts back to what the front ends read: substitutions as ``$(name word)``, and literal text that must not be taken for one.

The other way round is :mod:`launchlint.syntax.ros2.substitutions`, which reads whatever is written here before it is used: some texts
cannot be written at all (a backslash right before a substitution, a blank in a word of a substitution that stands inside quotes).
"""

from __future__ import annotations

from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.command_line import command_line as read_command_line
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.substitutions import parse, unescaped
from launchlint.syntax.ros2.written import Written

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from launchlint.problem import Problem
    from launchlint.syntax.ros2.tables import Distribution

    Pieces = tuple[str | Substitution, ...]

NOWHERE = Place(Source("", ""), Span(0, 0))
_SHELL = frozenset(" \t\r\n'\"\\")


class CannotWrite(Exception):
    """The front ends have no way to say it; ``reason`` in plain words, to stand behind "since"."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


def joined(pieces: Iterable[str | Substitution]) -> Pieces:
    """The same pieces, with texts beside each other as one and none that is empty."""
    found: list[str | Substitution] = []
    for piece in pieces:
        if isinstance(piece, str) and found and isinstance(found[-1], str):
            found[-1] += piece
        elif piece != "":
            found.append(piece)
    return tuple(found)


def same_pieces(one: Text, other: Text) -> bool:
    """Whether two texts say the same, wherever they are written."""
    waiting = [(one, other)]
    while waiting:
        first, second = (joined(each.pieces) for each in waiting.pop())
        if len(first) != len(second):
            return False
        for piece, twin in zip(first, second, strict=True):
            if isinstance(piece, str) or isinstance(twin, str):
                if piece != twin:
                    return False
            elif piece.name != twin.name or len(piece.arguments) != len(twin.arguments):
                return False
            else:
                waiting.extend(zip(piece.arguments, twin.arguments, strict=True))
    return True


def substitutions_in(item: object) -> Iterator[Substitution]:
    """All substitutions in actions or in a text, those in each other, too."""
    waiting = [item]
    while waiting:
        each = waiting.pop()
        if isinstance(each, Substitution):
            yield each
        if isinstance(each, tuple) and not isinstance(each, Place):
            waiting.extend(each)


def asked_variables(item: object) -> dict[str, None]:
    """The environment variables that actions or a text ask for, where their names are known."""
    asked = (each.arguments[0].literal for each in substitutions_in(item) if each.name == "env" and each.arguments)
    return dict.fromkeys(name for name in asked if name)


class TextWriter:
    """Writes texts for one distribution."""

    def __init__(self, distribution: Distribution) -> None:
        self._distribution = distribution

    def text(self, text: Text) -> str:
        """``text`` as the value of an attribute. Raises CannotWrite."""
        try:
            result = self._template(joined(text.pieces), "")
        except RecursionError:
            raise CannotWrite("substitutions stand in each other too deep") from None
        if not same_pieces(self._read(result), text):
            raise CannotWrite("it cannot be put into quotes so that launch reads the same")
        return result

    def command_line(self, words: Sequence[Text]) -> str:
        """``words`` as one value that launch splits into them again. Raises CannotWrite."""
        pieces: list[str | Substitution] = []
        for number, word in enumerate(words):
            if number:
                pieces.append(" ")
            own = joined(word.pieces)
            pieces.extend(_for_shell(piece) if isinstance(piece, str) else piece for piece in own or ("",))
        whole = Text(joined(pieces), NOWHERE)
        result = self.text(whole)
        problems: list[Problem] = []
        again = read_command_line(self._read(result), "", "", problems)
        if problems or len(again) != len(words) or not all(map(same_pieces, again, words)):
            raise CannotWrite("launch would split it into other words")
        return result

    @staticmethod
    def word(text: str) -> str:
        """``text`` where substitutions are not looked for. Raises CannotWrite."""
        result = text.replace("\\", "\\\\")
        if unescaped(result) != text:
            raise CannotWrite("its backslashes would be read otherwise")
        return result

    def _read(self, written: str) -> Text:
        problems: list[Problem] = []
        read = parse(Written(written, NOWHERE), self._distribution, problems)
        if problems:
            raise CannotWrite(_why(problems[0]))
        return read

    def _template(self, pieces: Pieces, quote: str) -> str:
        """Text and substitutions at the top, or inside of ``quote``."""
        found: list[str] = []
        for piece in pieces:
            if isinstance(piece, Substitution):
                found.append(self._substitution(piece, quote))
                continue
            text = piece.replace("\\", "\\\\").replace("$(", "\\$(")
            found.append(text.replace(quote, f"\\{quote}") if quote else text)
        return "".join(found)

    def _substitution(self, substitution: Substitution, quote: str) -> str:
        words = [self._word(joined(each.pieces), quote) for each in substitution.arguments]
        return f"$({' '.join((substitution.name, *words))})"

    def _word(self, pieces: Pieces, quote: str) -> str:
        if quote:
            return self._bare(pieces, quote)
        literal = "".join(piece for piece in pieces if isinstance(piece, str))
        simple = pieces and not any(char in literal for char in " \t\r\n'\"()\\") and "$(" not in literal
        if simple:
            return self._bare(pieces, "")
        marks = ("'", '"') if literal.count("'") <= literal.count('"') else ('"', "'")
        refused = ""
        for mark in (*marks, ""):
            try:
                word = f"{mark}{self._template(pieces, mark)}{mark}" if mark else self._bare(pieces, "")
                (again,) = self._read(f"$(anon {word})").pieces
            except CannotWrite as error:
                refused = refused or error.reason
                continue
            except ValueError:
                continue
            if isinstance(again, Substitution) and len(again.arguments) == 1 and same_pieces(again.arguments[0], Text(pieces, NOWHERE)):
                return word
        raise CannotWrite(refused or "it cannot be put into quotes so that launch reads the same")

    def _bare(self, pieces: Pieces, quote: str) -> str:
        """A word without quotes of its own; ``quote`` are those around the substitution that it stands in, if any."""
        found: list[str] = []
        escaped = f"()\\{quote}" if quote else "()\\'\""
        for piece in pieces:
            if isinstance(piece, Substitution):
                found.append(self._substitution(piece, quote))
            elif " " in piece:
                raise CannotWrite("a word of a substitution inside quotes cannot hold a blank")
            else:
                found.append("".join(f"\\{char}" if char in escaped else char for char in piece))
        if not "".join(found):
            raise CannotWrite("a word of a substitution inside quotes cannot be empty")
        return "".join(found)


def _for_shell(text: str) -> str:
    """``text`` as one word, or a part of one, on a command line."""
    if text and not any(char in _SHELL for char in text):
        return text
    if "'" not in text:
        return f"'{text}'"
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _why(problem: Problem) -> str:
    facts = vars(problem)
    if "reason" in facts:
        return f"launch cannot read it: {facts['reason']}"
    if "name" in facts:
        return f"$({facts['name']} …) cannot be used in this way in XML and YAML"
    return "launch would refuse it"
