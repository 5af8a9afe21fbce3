"""The files of a package as its ``setup.py`` sees them; nothing outside of the package is looked at."""

from __future__ import annotations

import os
from collections.abc import Iterator
from fnmatch import fnmatchcase

from launchlint.workspace.looking import exists, is_directory, is_file, names

_MOST_FOUND = 20_000
_MOST_LOOKED = 5_000
_MAGIC = frozenset("*?[")


class Files:
    """The files below ``root`` (absolute), which is the working directory of ``setup.py``."""

    __slots__ = ("_looked", "root")

    def __init__(self, root: str) -> None:
        self.root = root
        self._looked = 0

    def inside(self, path: str) -> str | None:
        """The absolute path for ``path``; ``None`` where it lies outside of the package."""
        whole = os.path.normpath(os.path.join(self.root, path))
        return whole if whole == self.root or whole.startswith(f"{self.root}/") else None

    def is_file(self, path: str) -> bool | None:
        """``None`` where it lies outside, as in the following."""
        whole = self.inside(path)
        return None if whole is None else is_file(whole)

    def is_directory(self, path: str) -> bool | None:
        """Whether it is one."""
        whole = self.inside(path)
        return None if whole is None else is_directory(whole)

    def exists(self, path: str) -> bool | None:
        """Whether there is anything."""
        whole = self.inside(path)
        return None if whole is None else exists(whole)

    def listed(self, path: str) -> list[str] | None:
        """As os.listdir, sorted."""
        whole = self.inside(path)
        return None if whole is None or not self._may_look() else names(whole)

    def walk(self, top: str) -> list[tuple[str, list[str], list[str]]] | None:
        """As os.walk."""
        if self.inside(top) is None:
            return None
        found: list[tuple[str, list[str], list[str]]] = []
        waiting = [top]
        while waiting:
            current = waiting.pop()
            listed = self.listed(current)
            if listed is None:
                return None
            below = [each for each in listed if self.is_directory(os.path.join(current, each))]
            if listed or self.is_directory(current):
                found.append((current, below, [each for each in listed if each not in below]))
            waiting += [
                os.path.join(current, each) for each in reversed(below) if not os.path.islink(os.path.join(self.root, current, each))
            ]
        return found

    def glob(self, pattern: str, *, recursive: bool) -> list[str] | None:
        """As glob.glob, sorted: hidden names only where the pattern names them."""
        if self.inside(pattern) is None or ".." in pattern.split("/"):
            return None
        found = list(self._matching(pattern, recursive))
        return None if len(found) > _MOST_FOUND or self._looked > _MOST_LOOKED else found

    def _matching(self, pattern: str, recursive: bool) -> Iterator[str]:
        """A part of the path after another, all that there is up to there."""
        start = "/" if pattern.startswith("/") else ""
        found = [start]
        parts = [each for each in pattern.split("/") if each]
        for number, part in enumerate(parts):
            last = number == len(parts) - 1 and not pattern.endswith("/")
            if _MAGIC.isdisjoint(part):
                found = [path for each in found if self.exists(path := os.path.join(each, part))]
            elif part == "**" and recursive:
                found = [path for each in found for path in self._below(each, directories_only=not last)]
            else:
                found = [
                    os.path.join(each, name)
                    for each in found
                    for name in self.listed(each or ".") or ()
                    if fnmatchcase(name, part) and (name[0] != "." or part[0] == ".")
                ]
                if not last:
                    found = [each for each in found if self.is_directory(each)]
            if len(found) > _MOST_FOUND:
                break
        yield from found

    def _below(self, path: str, *, directories_only: bool) -> Iterator[str]:
        yield path
        waiting = [path]
        while waiting:
            current = waiting.pop()
            for name in self.listed(current or ".") or ():
                each = os.path.join(current, name)
                if name[0] == ".":
                    continue
                is_below = self.is_directory(each)
                if is_below or not directories_only:
                    yield each
                if is_below and not os.path.islink(os.path.join(self.root, each)):
                    waiting.append(each)

    def _may_look(self) -> bool:
        self._looked += 1
        return self._looked <= _MOST_LOOKED
