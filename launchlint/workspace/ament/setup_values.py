"""What a ``setup.py`` has in its variables, as far as it can be known without running it."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeAlias

    Value: TypeAlias = Any
    """Plain Python (text, numbers, lists, tuples, dictionaries, pure paths), or one of the classes below."""

_MOST_LOOKED_AT = 50_000


class Unknown:
    """What cannot be known; in a list it stands for any number of items."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "UNKNOWN"


UNKNOWN = Unknown()


class Name(NamedTuple):
    """A module, or what is in one: ``os.path.join``, ``glob.glob``; of builtins the name alone."""

    dotted: str


class Method(NamedTuple):
    """A method of a value."""

    of: Value
    name: str


class Function(NamedTuple):
    """A function or lambda of the file, with the variables that it was made among."""

    arguments: ast.arguments
    body: list[ast.stmt] | ast.expr
    around: dict[str, Value]


def is_known(value: Value) -> bool:
    """Whether all of it is known, to the last item; false for what is too large to look through."""
    waiting = [value]
    for _ in range(_MOST_LOOKED_AT):
        if not waiting:
            return True
        each = waiting.pop()
        if isinstance(each, Mapping):
            waiting += [*each.keys(), *each.values()]
        elif isinstance(each, (Unknown, Name, Method, Function)):
            return False
        elif isinstance(each, (list, tuple, set, frozenset)):
            waiting += each
    return False


def items(value: Value) -> list[Value] | None:
    """What a loop goes through; ``None`` where that cannot be known."""
    return list(value) if isinstance(value, (list, tuple, set, frozenset, dict, str, range)) else None
