"""The files of a program: its sources, and those headers that are found beside them or in the given directories."""

from __future__ import annotations

import os
import re
from codecs import BOM_UTF8
from collections import OrderedDict
from collections.abc import Sequence

from launchlint.extract.cpp.syntax import Root, parse
from launchlint.extract.scanned import Headers
from launchlint.extract.template import Template, filled
from launchlint.workspace.looking import LARGEST_FILE, read_bytes

_MOST_FILES = 600
_MOST_BYTES = 8 << 20
_INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]{1,300})[>"]', re.MULTILINE)
_MOST_KEPT = _MOST_BYTES  # as much as one program may have, so that the next one finds all of it
_MOST_HEADERS = 100_000


class Trees:
    """The trees of the files that were read last, for programs that share them, and what their headers were found to be.

    Those of the program that is being read are there in any case, so that only the others are bounded: a program that is larger than
    the bound would otherwise leave nothing to the next one, which reads the same headers in the same order.
    """

    def __init__(self) -> None:
        self._kept: OrderedDict[tuple[str, int, int], tuple[Root, list[tuple[str, bool]]]] = OrderedDict()
        self._present: set[tuple[str, int, int]] = set()
        self._spare = 0
        self._headers: dict[tuple[str, ...], dict[tuple[str, str], str | None]] = {}
        self._found = 0
        self._looked_for = Headers()
        self._real: dict[str, str] = {}

    def real(self, path: str) -> str:
        """A path without links."""
        if path not in self._real:
            if len(self._real) >= _MOST_HEADERS:
                self._real.clear()
            self._real[path] = os.path.realpath(path)
        return self._real[path]

    def header(self, name: str, quoted: bool, path: str, directories: tuple[str, ...]) -> str | None:
        """The header that the file at ``path`` includes, as :meth:`launchlint.extract.scanned.Headers.found` says."""
        known = self._headers.setdefault(directories, {})
        key = (os.path.dirname(path) if quoted else "", name)
        if key not in known:
            if self._found >= _MOST_HEADERS:
                self._headers, self._found = {}, 0
                known = self._headers.setdefault(directories, {})
            known[key] = self._looked_for.found(name, quoted, path, directories)
            self._found += 1
        return known[key]

    def of(self, real: str, data: bytes) -> tuple[Root, list[tuple[str, bool]]]:
        """The tree of the file at ``real``, a path without links, with content ``data``; and the headers that it includes, each with
        whether it stands in quotes.
        """
        key = (real, len(data), hash(data))
        known = self._kept.get(key)
        if known is None:
            known = self._kept[key] = parse(data), [(one[2].decode("utf-8", "replace"), one[1] == b'"') for one in _INCLUDE.finditer(data)]
        elif key not in self._present:
            self._spare -= len(data)
        self._kept.move_to_end(key)
        self._present.add(key)
        return known

    def next_program(self) -> None:
        """What was read until now is of programs that are done: as much of it is kept as the bound says, what was read last first."""
        self._spare += sum(size for _, size, _ in self._present)
        self._present = set()
        while self._spare > _MOST_KEPT:
            (_, size, _), _ = self._kept.popitem(last=False)
            self._spare -= size


class File:
    """One file that was read: ``path`` relative to the root, with its tree."""

    __slots__ = ("path", "root")

    def __init__(self, path: str, root: Root) -> None:
        self.path = path
        self.root = root


def read_files(
    sources: Sequence[str], include_directories: Sequence[str], root: str, templates: Sequence[Template], trees: Trees
) -> tuple[list[File], list[str], list[tuple[str, bool]]]:
    """The files, included ones before those that include them, templates filled in; what could not be read, each with the reason; and the
    headers that are not here, each with whether it stands in quotes.
    """
    trees.next_program()
    found: list[File] = []
    missing: dict[tuple[str, bool], None] = {}
    problems: list[str] = []
    seen: set[str] = set()
    total = 0
    directories = tuple(include_directories)
    pending: list[tuple[str, Root | None]] = [(each, None) for each in reversed(list(dict.fromkeys(sources)))]
    while pending:
        path, tree = pending.pop()
        if tree is not None:
            found.append(File(_relative(path, root), tree))
            continue
        real = trees.real(path)
        if real in seen:
            continue
        seen.add(real)
        if len(seen) > _MOST_FILES or total > _MOST_BYTES:
            problems.append("the program has too many files to read them all")
            break
        try:
            data = read_bytes(path, LARGEST_FILE).removeprefix(BOM_UTF8)
        except OSError as error:
            problems.append(f"{_relative(path, root)} cannot be read: {error.strerror or error}")
            continue
        total += len(data)
        if any(each.path == path for each in templates):
            data = filled(data.decode("utf-8", "replace"), path, templates).encode()
        tree, spelled = trees.of(real, data)
        pending.append((path, tree))
        included = [trees.header(name, quoted, path, directories) for name, quoted in spelled]
        missing.update((each, None) for each, header in zip(spelled, included, strict=True) if header is None)
        pending += [(each, None) for each in reversed(included) if each is not None]
    return found, problems, list(missing)


def _relative(path: str, root: str) -> str:
    return os.path.relpath(path or ".", root).replace(os.sep, "/")
