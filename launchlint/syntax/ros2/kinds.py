"""What the value of an attribute becomes, by its kind."""

from __future__ import annotations

from launchlint.source import Origin
from launchlint.syntax.ros2.command_line import command_line
from launchlint.syntax.ros2.problems import BrokenInFrontend, NegativeValue, WrongValue
from launchlint.syntax.ros2.substitutions import unescaped
from launchlint.syntax.ros2.tables import Kind
from launchlint.syntax.ros2.words import EXPECTED

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeAlias

    from launchlint.syntax.ros2.entity import Value
    from launchlint.syntax.ros2.parsing import Parser

    Make: TypeAlias = "Callable[[Parser, str, str, Value], object]"

WANTED = {Kind.FLAG: "bool", Kind.FLAG_OR_TEXT: "bool", Kind.INTEGER: "int", Kind.SECONDS: "float", Kind.PERIOD: "float"}
"""The type that launch asks its front ends for, where it is not text."""


def made(parser: Parser, tag: str, name: str, kind: Kind, value: Value) -> object:
    """What ``value`` of the attribute ``name`` of ``tag`` is; None where launch refuses it."""
    return _MAKE[kind](parser, tag, name, value)


def _text(parser: Parser, tag: str, name: str, value: Value) -> object:
    return parser.text(value.text)


def _word(parser: Parser, tag: str, name: str, value: Value) -> object:
    return unescaped(value.text.text)


def _command(parser: Parser, tag: str, name: str, value: Value) -> object:
    return command_line(parser.text(value.text), tag, name, parser.problems)


def _flag(parser: Parser, tag: str, name: str, value: Value) -> object:
    return bool(value.plain)


def _or_text(parser: Parser, tag: str, name: str, value: Value) -> object:
    return parser.text(value.text) if isinstance(value.plain, str) else value.plain


def _plain(parser: Parser, tag: str, name: str, value: Value) -> object:
    return value.plain


def _seconds(parser: Parser, tag: str, name: str, value: Value) -> object:
    origin, plain = Origin(value.place), value.plain
    if isinstance(plain, str):
        if "$(" in plain:
            parser.problems.append(BrokenInFrontend(origin=origin, refused=True, what="number", name=name))
        else:
            expected = EXPECTED["float"]
            parser.problems.append(WrongValue(origin=origin, refused=True, tag=tag, attribute=name, value=plain, expected=expected))
        return None
    if isinstance(plain, float) and plain < 0:
        parser.problems.append(NegativeValue(origin=origin, refused=True, tag=tag, attribute=name, value=value.place.text))
        return None
    return plain


def _shutdown(parser: Parser, tag: str, name: str, value: Value) -> object:
    if value.plain == "shutdown":
        return "shutdown"
    parser.problems.append(
        WrongValue(
            origin=Origin(value.place),
            refused=True,
            tag=tag,
            attribute=name,
            value=str(value.plain),
            expected="shutdown",
            choices=("shutdown",),
        )
    )
    return None


_MAKE: dict[Kind, Make] = {
    Kind.TEXT: _text,
    Kind.WORD: _word,
    Kind.COMMAND: _command,
    Kind.FLAG: _flag,
    Kind.FLAG_OR_TEXT: _or_text,
    Kind.INTEGER: _plain,
    Kind.SECONDS: _seconds,
    Kind.PERIOD: _or_text,
    Kind.SHUTDOWN: _shutdown,
}
