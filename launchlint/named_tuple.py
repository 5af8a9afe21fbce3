"""``NamedTuple`` as ``typing`` has it, made in a fraction of the time.

A check of one file makes some 170 such classes. ``typing`` compiles every annotation of each to look whether it could be a type; mypy looks
at that better, so here annotations are kept as they are written, and nothing of ``typing`` is imported. ``collections.namedtuple`` compiles
a constructor for each class and makes each its own methods; here one constructor is compiled for each number of fields, from which others
differ in their parameters' names alone, and the methods are shared.
"""

from __future__ import annotations

from collections import namedtuple
from functools import lru_cache
from types import FunctionType

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any
    from typing import NamedTuple as NamedTuple
else:

    @lru_cache(maxsize=64)
    def _numbered(count: int) -> type:
        """A named tuple of so many fields, whose names are numbers."""
        return namedtuple("_numbered", [f"field{number}" for number in range(count)])

    def _make(cls: type, values: Iterable[Any]) -> Any:
        """As :meth:`somenamedtuple._make` of ``collections``."""
        made = tuple.__new__(cls, values)
        if len(made) != len(cls._fields):
            raise TypeError(f"Expected {len(cls._fields)} arguments, got {len(made)}")
        return made

    def _replace(self: Any, /, **changed: Any) -> Any:
        """As :meth:`somenamedtuple._replace` of ``collections``."""
        made = self._make(map(changed.pop, self._fields, self))
        if changed:
            raise ValueError(f"Got unexpected field names: {list(changed)!r}")
        return made

    def _asdict(self: Any) -> dict[str, Any]:
        """As :meth:`somenamedtuple._asdict` of ``collections``."""
        return dict(zip(self._fields, self, strict=True))

    def _repr(self: Any) -> str:
        return f"{type(self).__name__}({', '.join(f'{field}={value!r}' for field, value in zip(self._fields, self, strict=True))})"

    def _arguments(self: Any) -> tuple[Any, ...]:
        return tuple(self)

    _SHARED = {
        "__slots__": (),
        "_make": classmethod(_make),
        "_replace": _replace,
        "_asdict": _asdict,
        "__repr__": _repr,
        "__getnewargs__": _arguments,
    }

    class _Maker(type):
        """What makes a tuple of the fields that are annotated in the body of a class, with the methods that stand there."""

        def __new__(cls, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> type:
            if not bases:
                return super().__new__(cls, name, bases, body)
            fields = tuple(body.get("__annotations__", ()))
            defaults = {field: body.pop(field) for field in fields if field in body}
            numbered = _numbered(len(fields))
            code = numbered.__new__.__code__.replace(co_varnames=("_cls", *fields))
            constructor = FunctionType(code, numbered.__new__.__globals__, "__new__", tuple(defaults.values()))
            constructor.__qualname__ = f"{name}.__new__"
            read = {field: vars(numbered)[each] for field, each in zip(fields, numbered._fields, strict=True)}
            described = {"_fields": fields, "__match_args__": fields, "_field_defaults": defaults, "__new__": constructor}
            return type(name, (tuple,), {**_SHARED, **described, **read, **body})

    class NamedTuple(metaclass=_Maker):
        """As :class:`typing.NamedTuple`."""
