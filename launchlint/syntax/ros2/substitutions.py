r"""The grammar of substitutions in ROS 2 launch files: text to pieces, each with its place.

``$(name word word)``: one blank between words and nowhere else; a word is ``'…'``, ``"…"`` or characters other than a blank, quotes
and parentheses. Substitutions stand in words, too, also in quotes; in quotes, the words of these have no quotes of their own: a quote of
the other sort is part of the word. ``\x`` is ``x``; a ``$`` behind a backslash, or without ``(`` behind it, is text.

Source: ``launch/frontend/grammar.lark`` and ``launch.frontend.parse_substitution``.
"""

from __future__ import annotations

import re

from launchlint.source import Origin
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.of_ros1 import SUBSTITUTIONS as SUBSTITUTIONS_OF_ROS1
from launchlint.syntax.ros2.problems import (
    BrokenInFrontend,
    NotInDistribution,
    OfRos1,
    SubstitutionArity,
    UnknownSubstitution,
    UnreadableSubstitution,
)
from launchlint.syntax.ros2.tables import SUBSTITUTIONS, Distribution
from launchlint.syntax.ros2.written import Written

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.problem import Problem
    from launchlint.syntax.ros2.problems import Where

DEEPEST = 100
"""Substitutions that may stand in each other."""

_ESCAPE = re.compile(r"\\(.)")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_LONE = r"\$(?!\()|(?<=\\)\$"
_BRACKET = r"(?<=\\)[()]"
_TEXT = {
    "": re.compile(rf"(?:[^$]|{_LONE})+"),
    "'": re.compile(rf"(?:\\'|\\|[^'\\$]|{_LONE})+"),
    '"': re.compile(rf'(?:\\"|\\|[^"\\$]|{_LONE})+'),
}
_WORD = {
    "": re.compile(rf"""(?:\\["']|\\|[^ '\\"$()]|{_BRACKET}|{_LONE})+"""),
    "'": re.compile(rf"(?:\\'|\\|[^ '\\$()]|{_BRACKET}|{_LONE})+"),
    '"': re.compile(rf'(?:\\"|\\|[^ "\\$()]|{_BRACKET}|{_LONE})+'),
}
"""What is text, and what is a word of a substitution: outside of quotes, and in either sort."""


def unescaped(text: str) -> str:
    """``text`` without the backslashes that stand before a character."""
    return _ESCAPE.sub(r"\1", text) if "\\" in text else text


def parse(written: Written, distribution: Distribution, problems: list[Problem]) -> Text:
    """The pieces of a value; what launch refuses in it is put to ``problems``, in the order in which launch meets it.

    A value that cannot be read, and a substitution that is unknown, become a :class:`Substitution` all the same (the former with an empty
    name), so that nothing of it is taken for known.
    """
    text = written.text
    if "$(" not in text:
        return Text((unescaped(text),) if text else (), written.place)
    reader = _Reader(written)
    try:
        pieces = reader.template("", 0)
    except _Bad as bad:
        at = written.at(min(bad.at, len(text) - 1), min(bad.at, len(text) - 1) + 1)
        problems.append(
            UnreadableSubstitution(
                origin=Origin(written.at(bad.start, len(text))), refused=True, related=((at, bad.here),), text=text, reason=bad.reason
            )
        )
        return Text((Substitution("", (), written.place),), written.place)
    for each in reader.found:
        check(each, distribution, problems)
    return Text(pieces, written.place)


def check(substitution: Substitution, distribution: Distribution, problems: list[Problem]) -> None:
    """Put to ``problems`` what launch refuses in one substitution, its words left out."""
    name, words, place = substitution.name, substitution.arguments, substitution.place
    origin = Origin(place)
    arity = SUBSTITUTIONS.get(name)
    if arity is None:
        problems.append(_unknown(substitution, distribution))
        return
    if name not in distribution.substitutions:
        _absent(substitution, "substitution", arity.since, distribution, problems)
        return
    count = len(words)
    most = distribution.most(arity)
    if most < count <= arity.most:
        _absent(substitution, "words", arity.since, distribution, problems)
    elif not arity.fewest <= count <= most:
        problems.append(SubstitutionArity(origin=origin, refused=True, name=name, count=count, fewest=arity.fewest, most=most))
    elif arity.broken:
        problems.append(BrokenInFrontend(origin=origin, refused=True, what="any-all", name=name))
    elif name == "eval" and count == 2 and words[1].pieces and not isinstance(words[1].pieces[0], str):
        problems.append(BrokenInFrontend(origin=Origin(words[1].place), refused=True, what="modules", name=name))


def _unknown(substitution: Substitution, distribution: Distribution) -> Problem:
    name, place = substitution.name, substitution.place
    behind = place.text[len(name) + 2 : -1].strip()
    instead = SUBSTITUTIONS_OF_ROS1.get(name)
    if instead is None:
        return UnknownSubstitution(origin=Origin(place), refused=True, name=name, words=behind, known=tuple(distribution.substitutions))
    return OfRos1(
        origin=Origin(place),
        refused=True,
        tag="",
        what="substitution",
        construct=name,
        instead=f"$({instead} …)",
        renamed=instead,
        words=behind,
    )


def _absent(substitution: Substitution, what: Where, since: str, distribution: Distribution, problems: list[Problem]) -> None:
    problems.append(
        NotInDistribution(
            origin=Origin(substitution.place),
            refused=True,
            what=what,
            name=substitution.name,
            tag="",
            distro=distribution.name,
            since=since,
            sure=distribution.lacks_for_sure(substitution.name, since),
            words=substitution.arguments,
        )
    )


class _Bad(Exception):
    """The text cannot be read: the substitution that begins at ``start`` is wrong at ``at``."""

    def __init__(self, reason: str, here: str, start: int, at: int) -> None:
        super().__init__(reason)
        self.reason = reason
        self.here = here
        self.start = start
        self.at = at


class _Reader:
    """Reads one value; ``found`` are its substitutions, inner ones first, as launch makes them."""

    __slots__ = ("_depth", "_text", "_written", "at", "found")

    def __init__(self, written: Written) -> None:
        self._written = written
        self._text = written.text
        self._depth = 0
        self.at = 0
        self.found: list[Substitution] = []

    def template(self, quote: str, start: int) -> tuple[str | Substitution, ...]:
        """Text and substitutions up to the end, or to the closing ``quote``."""
        text, pieces = self._text, list[str | Substitution]()
        while self.at < len(text):
            match = _TEXT[quote].match(text, self.at)
            if match is not None:
                pieces.append(unescaped(match[0]))
                self.at = match.end()
            elif text.startswith("$(", self.at):
                pieces.append(self._substitution(quote))
            else:
                break
        if quote and not text.startswith(quote, self.at):
            raise _Bad(f"a {quote} is not closed", "the text ends here", start, len(text))
        return tuple(pieces)

    def _substitution(self, quote: str) -> Substitution:
        text, start = self._text, self.at
        self._depth += 1
        if self._depth > DEEPEST:
            raise _Bad(f"more than {DEEPEST} substitutions stand in each other", "this is one too many", start, start)
        name = _NAME.match(text, start + 2)
        if name is None:
            blank = text[start + 2 : start + 3].isspace()
            raise _Bad(
                "no blank may stand behind $(" if blank else "$( wants a name behind it", "the name has to begin here", start, start + 2
            )
        self.at = name.end()
        words: list[Text] = []
        while text.startswith(" ", self.at):
            self.at += 1
            words.append(self._word(quote, start))
        if not text.startswith(")", self.at):
            raise _Bad(*_why(text, self.at), start, self.at)
        self.at += 1
        self._depth -= 1
        made = Substitution(name[0], tuple(words), self._written.at(start, self.at))
        self.found.append(made)
        return made

    def _word(self, quote: str, opened: int) -> Text:
        text, start = self._text, self.at
        if not quote and text[start : start + 1] in ("'", '"'):
            self.at += 1
            pieces = self.template(text[start], opened)
            self.at += 1
            return Text(pieces, self._written.at(start + 1, self.at - 1))
        found: list[str | Substitution] = []
        while True:
            match = _WORD[quote].match(text, self.at)
            if match is not None:
                found.append(unescaped(match[0]))
                self.at = match.end()
            elif text.startswith("$(", self.at):
                found.append(self._substitution(quote))
            else:
                break
        if not found:
            raise _Bad(*_why(text, self.at), opened, self.at)
        return Text(tuple(found), self._written.at(start, self.at))


def _why(text: str, at: int) -> tuple[str, str]:
    """Why a substitution cannot go on at ``at``, in plain words, and what to write there."""
    here = text[at : at + 1]
    if not here:
        return "it is not closed", "a ) is missing"
    if here == " " or here == ")":
        return (
            "two blanks stand between words" if here == " " else "a blank stands before the )"
        ), "exactly one blank stands between words, none else"
    if here.isspace():
        return "only a blank may stand between words", "a tab or the end of a line stands here"
    if here in "'\"":
        return "a quote stands in a word", f"write \\{here}, or put the whole word in quotes"
    if here == "(":
        return "a parenthesis stands in a word", "write \\( and \\), or put the word in quotes"
    return "something stands right behind the closing quote", "a blank or ) has to stand here"
