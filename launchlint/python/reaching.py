"""What can be reached from values of a followed program: whether something that a function wrote outlives its call."""

from __future__ import annotations

from launchlint.python.values import Class, Failure, Handle, Instance, Map, Module, Scope, Seq, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Set

MOST_LOOKED_AT = 20_000
"""Values; where there are more, anything may be among them."""

_HOLDERS = (Seq, Map, Scope, Module, Class, Instance, Handle, Failure)
_PLAIN = ("own", "name", "path", "routines", "set_later", "stars", "kind", "_made")
"""What these have that holds no values."""


def reaches(roots: list[Value], mappings: Set[int]) -> bool:
    """Whether one of ``mappings``, named by their identities, holds what can be read by whoever has ``roots``."""
    if not mappings:
        return False
    seen: set[int] = set()
    waiting = [*roots]
    while waiting:
        each = waiting.pop()
        if isinstance(each, (dict, list, tuple, *_HOLDERS)):
            if id(each) in seen:
                continue
            if id(each) in mappings or len(seen) >= MOST_LOOKED_AT:
                return True
            seen.add(id(each))
            if isinstance(each, dict):
                waiting.extend(each.values())
            elif isinstance(each, (list, tuple)):
                waiting.extend(each)
            else:
                waiting.extend(
                    getattr(each, name) for kind in type(each).__mro__ for name in getattr(kind, "__slots__", ()) if name not in _PLAIN
                )
    return False
