"""The packages the public ROS index knows, for telling a package that is merely not installed here from one nobody ever heard of.

The data is ``public_packages.txt`` beside this module, written by ``scripts/public_packages.py``. It is read when first asked for and
never parsed as a whole for a single lookup.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

_MANY = 50
"""Names that are asked for, from which it pays to list all of them: going through the text takes long for one that is not in it."""


class PublicPackages(Mapping[str, tuple[str, ...]]):
    """Package name → names of the distributions that released it (those of ROS 1 first), from a file of ``name<TAB>names`` lines."""

    __slots__ = ("_asked", "_by_length", "_lines", "_names", "_path", "_set")

    def __init__(self, path: str) -> None:
        self._path = path
        self._lines: str | None = None
        self._asked: dict[str, tuple[str, ...] | None] = {}
        self._names: list[str] | None = None
        self._set: frozenset[str] | None = None
        self._by_length: dict[int, list[str]] = {}

    @property
    def _text(self) -> str:
        if self._lines is None:
            with open(self._path, encoding="utf-8", newline="\n") as file:
                self._lines = "\n" + file.read()
        return self._lines

    def __getitem__(self, name: str) -> tuple[str, ...]:
        if name not in self._asked:  # going through the text takes long, and the same few names are asked for in every configuration
            self._asked[name] = self._find(name)
        found = self._asked[name]
        if found is None:
            raise KeyError(name)
        return found

    def _find(self, name: str) -> tuple[str, ...] | None:
        text = self._text
        if len(self._asked) > _MANY and name not in self._every:
            return None
        at = -1 if not name or "\n" in name or "\t" in name or name[0] == "#" else text.find(f"\n{name}\t")
        if at < 0:
            return None
        start = at + len(name) + 2
        return tuple(text[start : text.index("\n", start)].split(" "))

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and self.get(name) is not None

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    @property
    def _all(self) -> list[str]:
        if self._names is None:
            self._names = re.findall(r"^([^#\t\n][^\t\n]*)\t", self._text, re.MULTILINE)
        return self._names

    @property
    def _every(self) -> frozenset[str]:
        if self._set is None:
            self._set = frozenset(self._all)
        return self._set

    def about_as_long(self, name: str) -> list[str]:
        """The names that are as long as ``name``, or one letter longer or shorter: comparing with all of them takes too long."""
        if not self._by_length:
            for each in self._all:
                self._by_length.setdefault(len(each), []).append(each)
        return [each for length in range(len(name) - 1, len(name) + 2) for each in self._by_length.get(length, ())]


_PUBLIC = PublicPackages(os.path.join(os.path.dirname(os.path.abspath(__file__)), "public_packages.txt"))


def public_names() -> PublicPackages:
    """The bundled list; asking for it costs nothing before the first lookup."""
    return _PUBLIC
