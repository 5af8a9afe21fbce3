"""Values of one evaluation that say how another file can write them.

A launch configuration has its value only while the launch runs: in a file without it stands what it was made from. What can be
different on another machine (where a package is, an environment variable, what a command says) stays a substitution; all else is a text.
"""

from __future__ import annotations

from launchlint.evaluate.ros2.context import NAMESPACE, Context
from launchlint.evaluate.ros2.performing import Performer
from launchlint.export.ros2.texts import NOWHERE, joined
from launchlint.model import Unknown
from launchlint.syntax.ros2.description import CALLED, Substitution, Text, unknown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from launchlint.evaluate.ros2.context import Setting, Value
    from launchlint.evaluate.session import Session
    from launchlint.export.ros2.texts import Pieces
    from launchlint.source import Source

STAYING = frozenset(
    (
        "env",
        "find-pkg-share",
        "find-pkg-prefix",
        "exec-in-pkg",
        "find-exec",
        "command",
        "log_dir",
        "launch_log_dir",
        "anon",
        "file-content",
    )
)
"""Substitutions that mean something of the machine or of the moment."""
_CHOOSING = ("var", "param", "if")
"""Substitutions that give one of their words."""
_IN_PLACE = frozenset(("find-pkg-share", "path-join"))
"""Substitutions whose value is known all the same: a path that is looked for in packages again."""


class KeepingContext(Context):
    """A context that knows of launch configurations what they are written with.

    ``last`` is the value that was made last, with its pieces: what is set next is made of it.
    """

    __slots__ = ("_kept", "last")

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.last: tuple[Value, Pieces] | None = None
        self._kept: dict[int, tuple[Setting, Pieces]] = {}

    def set(self, name: str, setting: Setting) -> None:
        """As in any context."""
        super().set(name, setting)
        if self.last is not None and self.last[0] is setting.value and name != NAMESPACE:
            self.keep(name, self.last[1])

    def keep(self, name: str, pieces: Pieces) -> None:
        """Say what a configuration that is set is written with."""
        setting = self.configurations[name]
        self._kept[id(setting)] = (setting, pieces)

    def pieces(self, name: str) -> Pieces:
        """What a configuration that is set is written with."""
        setting = self.configurations[name]
        if id(setting) in self._kept:
            return self._kept[id(setting)][1]
        value = setting.value
        if isinstance(value, str):
            return (value,) if value else ()
        place = NOWHERE if setting.origin is None else setting.origin.place
        return unknown(value.reason, place).pieces


class Keeper(Performer):
    """Performs texts to values that know how they are written.

    ``decided`` are environment variables that are written as what they say here; ``by_content`` the launch configurations that files of
    params have asked for, since their substitutions are performed (``allow_substs``). ``pieces`` are those of the text that was performed
    last.
    """

    __slots__ = ("_arguments", "_said", "by_content", "decided", "pieces")

    context: KeepingContext

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        self.decided: frozenset[str] = frozenset()
        self.by_content: list[str] = []
        self.pieces: Pieces = ()
        self._said: list[Pieces] = []
        self._arguments: dict[int, Pieces] | None = None

    def written(self, text: Text) -> Text:
        """How another file can write ``text``. Raises Failure where launch stops."""
        outer, self._arguments = self._arguments, {}
        try:
            self.perform(text)
            return Text(self._arguments[id(text)], text.place)
        finally:
            self._arguments = outer

    def perform(self, text: Text) -> Value:
        """As any performer does."""
        outer, self._said = self._said, []
        try:
            value = super().perform(text)
            said = iter(self._said)
        finally:
            self._said = outer
        pieces = joined(each for piece in text.pieces for each in ((piece,) if isinstance(piece, str) else next(said)))
        if self._arguments is not None:
            self._arguments[id(text)] = pieces
        self.pieces = pieces
        return value

    def substitute(self, substitution: Substitution) -> Value:
        """As any performer does."""
        outer, self._arguments = self._arguments, {}
        try:
            value = super().substitute(substitution)
            found = self._arguments
        finally:
            self._arguments = outer
        self._said.append(self._pieces(substitution, value, found))
        return value

    def perform_content(self, source: Source) -> Value:
        """As any performer does."""
        from launchlint.syntax.ros2.substitutions import parse
        from launchlint.syntax.ros2.tables import distribution
        from launchlint.syntax.ros2.written import InText

        self.by_content += _asked(parse(InText(source), distribution(self.rules.distro), []))
        return super().perform_content(source)

    def _pieces(self, substitution: Substitution, value: Value, performed: Mapping[int, Pieces]) -> Pieces:
        """What stands for a substitution that gave ``value``; ``performed`` are those of its words that were asked for, by identity."""
        words = tuple(Text(performed.get(id(each), each.pieces), each.place) for each in substitution.arguments)
        name = words[0].literal if words else None
        kept = substitution._replace(arguments=words)
        if substitution.name == "anon" and name is not None:
            self.context.keep(f"anon{name}", (kept,))
        if substitution.name == "var" and name in self.context.configurations:
            return self.context.pieces(name)
        if substitution.name in _CHOOSING and _is_settled(words[0]):
            taken = next((each for each, word in zip(words[1:], substitution.arguments[1:], strict=True) if id(word) in performed), None)
            if taken is not None:
                return taken.pieces
        if substitution.name in STAYING and not (substitution.name == "env" and name in self.decided):
            return (kept,)
        if isinstance(value, str) and all(map(_is_settled, words)):
            return (value,) if value else ()
        whole = all(id(each) in performed for each in substitution.arguments)
        if isinstance(value, Unknown) and (substitution.name in (*_CHOOSING, CALLED) or not whole):
            return unknown(value.reason, substitution.place).pieces
        return (kept,)


def _is_settled(text: Text) -> bool:
    """Whether a text is the same on every machine, but for where packages are."""
    return all(isinstance(piece, str) or (piece.name in _IN_PLACE and all(map(_is_settled, piece.arguments))) for piece in text.pieces)


def _asked(text: Text) -> list[str]:
    """The names of the launch configurations that a text asks for."""
    found: list[str] = []
    waiting = [text]
    while waiting:
        for piece in waiting.pop().pieces:
            if isinstance(piece, str):
                continue
            waiting.extend(piece.arguments)
            if piece.name == "var" and piece.arguments and piece.arguments[0].literal:
                found.append(piece.arguments[0].literal)
    return found
