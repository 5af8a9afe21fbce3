"""Exceptions of followed programs: which class an exception is of, and which handler takes it."""

from __future__ import annotations

import builtins

from launchlint.named_tuple import NamedTuple
from launchlint.python.memory import Ended
from launchlint.python.values import Class, External, Failure, Instance, Seq, Value, alternatives

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.python.values import Scope

_BASES = {
    "ament_index_python.packages.PackageNotFoundError": "builtins.KeyError",
    "ament_index_python.PackageNotFoundError": "builtins.KeyError",
    "json.JSONDecodeError": "builtins.ValueError",
    "json.decoder.JSONDecodeError": "builtins.ValueError",
    "yaml.scanner.ScannerError": "yaml.YAMLError",
    "yaml.parser.ParserError": "yaml.YAMLError",
    "yaml.YAMLError": "builtins.Exception",
    "subprocess.CalledProcessError": "builtins.Exception",
    "subprocess.TimeoutExpired": "builtins.Exception",
    "configparser.Error": "builtins.Exception",
}
"""Classes of exceptions outside of Python's builtins, with the class that they are made of."""


class Asked(NamedTuple):
    """What a program asks for and what is not here: the ``name`` of a substitution that asks for the same, and its ``word``."""

    name: str
    word: str


class Raised(Ended):
    """The followed program raises an exception: a :class:`Failure`, or an object of a followed class.

    ``stated``: it says so itself, by ``raise`` or ``assert``. ``where`` is the innermost piece of the program that raises it, with its
    scope, where that is known; ``asked`` what was asked for and is not there.
    """

    def __init__(self, value: Value, *, stated: bool = False, asked: Asked | None = None) -> None:
        super().__init__(said(value))
        self.value = value
        self.stated = stated
        self.asked = asked
        self.where: list[tuple[ast.AST, Scope]] = []


def failure(kind: str, *arguments: Value) -> Raised:
    """An exception of one of Python's own classes."""
    return Raised(Failure(External(f"builtins.{kind}"), arguments))


def of_python(error: Exception) -> Raised:
    """What Python itself raised when it worked out a value."""
    return failure(type(error).__name__, *(each if isinstance(each, (str, int, float)) else str(each) for each in error.args[:5]))


def said(value: Value) -> str:
    """What an exception is called, with what it says."""
    type_ = value.type if isinstance(value, (Failure, Instance)) else value
    name = type_.name.removeprefix("builtins.") if isinstance(type_, (External, Class)) else "an exception"
    arguments = value.arguments if isinstance(value, Failure) else ()
    given = value.attributes.get("args") if isinstance(value, Instance) else None
    if isinstance(given, Seq):
        arguments = tuple(given.items)
    return f"{name}: {arguments[0]}" if arguments and isinstance(arguments[0], (str, int, float)) else name


def is_failure_class(value: Value) -> bool:
    """Whether something outside is known to be a class of exceptions."""
    return isinstance(value, External) and (value.name in _BASES or _builtin(value.name) is not None)


def taken_by(value: Value, handler: Value) -> bool | None:
    """Whether ``except handler`` takes the exception ``value``; None where that is not known."""
    if isinstance(handler, Seq):
        answers = [taken_by(value, each) for each in handler.items]
        return True if True in answers else (None if None in answers or not handler.complete else False)
    type_ = value.type if isinstance(value, (Failure, Instance)) else None
    classes = list(type_.order) if isinstance(type_, Class) else [type_]
    if not isinstance(handler, (External, Class)) or any(not isinstance(each, (External, Class)) for each in classes):
        return None
    answers = [_is_below(each, handler) for _, one in [("", each) for each in classes] for _, each in alternatives(one)]
    return True if True in answers else (None if None in answers else False)


def _is_below(type_: Value, handler: Value) -> bool | None:
    if type_ is handler or type_ == handler:
        return True
    if isinstance(type_, Class) or isinstance(handler, Class):
        return False  # a class outside is made of none that is followed; followed ones stand in the order of their classes
    name = type_.name
    above = _builtin(handler.name)
    for _ in range(5):
        if name == handler.name:
            return True
        below = _builtin(name)
        if below is not None:
            return issubclass(below, above) if above is not None else (False if handler.name in _BASES else None)
        if name not in _BASES:
            return True if above in (Exception, BaseException) else None
        name = _BASES[name]
    return None


def _builtin(name: str) -> type[BaseException] | None:
    found = getattr(builtins, name.removeprefix("builtins."), None) if name.startswith("builtins.") else None
    return found if isinstance(found, type) and issubclass(found, BaseException) else None
