"""``NamedTuple``, made in a tenth of the time.

For a type checker it is typing.NamedTuple. When the program runs, typing would compile every annotation of every class first, which nobody
asks for: a fifth of what checking one file costs. Everything that a class of it has is here: fields by name and position, defaults, ``_replace``,
``_asdict``, ``_fields``, comparison, hashing, pickling and a repr.
"""

from __future__ import annotations

from _collections import _tuplegetter  # type: ignore[import-not-found]  # what collections.namedtuple is made of (CPython, PyPy)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NamedTuple
else:

    class _Maker(type):
        """Makes a subclass of tuple of each class that is derived from :class:`NamedTuple`."""

        def __new__(cls, name, bases, namespace):
            if not bases:
                return type.__new__(cls, name, bases, namespace)
            fields = tuple(namespace.get("__annotations__", ()))
            defaults = tuple(namespace.pop(field) for field in fields if field in namespace)
            for index, field in enumerate(fields):
                namespace[field] = _tuplegetter(index, "")
            listed = "".join(f", {field}" for field in fields)
            new = eval(f"lambda _cls{listed}: _new(_cls, ({listed[2:]}{',' if fields else ''}))", {"_new": tuple.__new__})  # noqa: S307 - field names of this program's own classes
            new.__defaults__ = defaults or None
            return type(
                name,
                (tuple,),
                {**_SHARED, **namespace, "__slots__": (), "__new__": new, "__match_args__": fields, "_fields": fields,
                 "_field_defaults": dict(zip(fields[len(fields) - len(defaults) :], defaults, strict=True)),
                 "_places": {field: index for index, field in enumerate(fields)}},
            )  # fmt: skip

    class NamedTuple(metaclass=_Maker):
        """Base of all records; see typing.NamedTuple."""

    def _replace(self, /, **changes):
        values = list(self)
        places = self._places
        try:
            for name, value in changes.items():
                values[places[name]] = value
        except KeyError:
            raise ValueError(f"got unexpected field names: {[name for name in changes if name not in places]!r}") from None
        return tuple.__new__(self.__class__, values)

    def _asdict(self):
        return dict(zip(self._fields, self, strict=True))

    def _repr(self):
        fields = ", ".join(f"{name}={value!r}" for name, value in zip(self._fields, self, strict=True))
        return f"{self.__class__.__name__}({fields})"

    def _getnewargs(self):
        return tuple(self)

    def _make(cls, values):
        made = tuple.__new__(cls, values)
        if len(made) != len(cls._fields):
            raise TypeError(f"expected {len(cls._fields)} arguments, got {len(made)}")
        return made

    _SHARED = {
        "_replace": _replace,
        "__replace__": _replace,
        "_asdict": _asdict,
        "__repr__": _repr,
        "__getnewargs__": _getnewargs,
        "_make": classmethod(_make),
    }

__all__ = ["NamedTuple"]
