"""``NamedTuple`` as ``typing`` has it, made in less than half the time.

A check of one file makes some 150 such classes, and ``typing`` compiles every annotation of each to look whether it could be a type. mypy
looks at that better, so here annotations are kept as they are written, and nothing of ``typing`` is imported.
"""

from __future__ import annotations

from collections import namedtuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any
    from typing import NamedTuple as NamedTuple
else:

    class _Maker(type):
        """What makes a tuple of the fields that are annotated in the body of a class, with the methods that stand there."""

        def __new__(cls, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> type:
            if not bases:
                return super().__new__(cls, name, bases, body)
            fields = body.pop("__annotations__", {})
            defaults = [body.pop(field) for field in fields if field in body]
            made = namedtuple(name, fields, defaults=defaults, module=body.pop("__module__"))
            made.__annotations__ = fields
            for key, value in body.items():
                setattr(made, key, value)
            return made

    class NamedTuple(metaclass=_Maker):
        """As :class:`typing.NamedTuple`."""
