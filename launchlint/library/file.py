"""Reading one library file. A large one is indexed once: later only the packages that are asked for are read.

The index is kept under the digest of the file's content, so it can never be out of date; a broken or missing index is made anew.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping

from launchlint import __version__
from launchlint.errors import LibraryError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Protocol

    class Packages(Protocol):
        """Where the packages of a library come from: memory or an index."""

        def get(self, name: str) -> Mapping[str, Any] | None:
            """A package."""

        def names(self) -> tuple[str, ...]:
            """All names, sorted."""

        def classes(self) -> Mapping[str, str]:
            """Nodelet class → package."""


LARGEST = 512 * 1024 * 1024
"""Bytes of a library file."""
INDEX_PAYS = 256 * 1024
"""Bytes from which a library is indexed: reading and validating a smaller one takes a few milliseconds."""

MOST_INDICES = 16
"""Indices that are kept, the latest made."""

_INDEX_VERSION = 1


class LibraryFile:
    """The packages of one library. ``digest`` is the SHA-256 of its content; ``path`` as people see it."""

    def __init__(self, path: str, digest: str, packages: Packages) -> None:
        self.path = path
        self.digest = digest
        self._packages = packages

    def package(self, name: str) -> Mapping[str, Any] | None:
        """What the library says of a package: validated JSON."""
        return self._packages.get(name)

    def package_of_class(self, nodelet: str) -> str | None:
        """The package that has a nodelet class."""
        return self._packages.classes().get(nodelet)

    def names(self) -> tuple[str, ...]:
        """The names of all packages, sorted."""
        return self._packages.names()


def open_library(path: str, cache_directory: str | None = None) -> LibraryFile:
    """Read a library, or its index from ``cache_directory``.

    Raises:
        LibraryError: it cannot be read, or is not a library; the message says where.
    """
    data = read(path)
    digest = hashlib.sha256(data).hexdigest()
    index = None
    if cache_directory is not None and len(data) >= INDEX_PAYS:
        index = os.path.join(cache_directory, f"library-{_INDEX_VERSION}-{__version__}-{digest[:32]}.index")
        known = _Indexed.open(index)
        if known is not None:
            return LibraryFile(path, digest, known)
    document = parse(data, path)
    if index is not None:
        _write_index(index, document["packages"])
    return LibraryFile(path, digest, _Loaded(document["packages"]))


def read(path: str) -> bytes:
    """The bytes of a library file.

    Raises:
        LibraryError: it cannot be read, or is too large.
    """
    try:
        with open(path, "rb") as file:
            data = file.read(LARGEST + 1)
    except OSError as error:
        raise LibraryError(f"{path}: the library cannot be read: {error.strerror or error}") from None
    if len(data) > LARGEST:
        raise LibraryError(f"{path}: the library is larger than {LARGEST // 2**20} MiB")
    return data


def parse(data: bytes, path: str) -> Any:
    """The validated JSON of a library.

    Raises:
        LibraryError: with one line for each fault, each beginning with ``path:line:column``.
    """
    document, problems = examine(data, path)
    if problems:
        more = f"\n{path}: and {len(problems) - 10} more: launchlint library validate {path}" if len(problems) > 10 else ""
        raise LibraryError("\n".join(problems[:10]) + more)
    return document


def examine(data: bytes, path: str) -> tuple[Any, list[str]]:
    """The JSON of a library and all that breaks the format in it, each line beginning with ``path:line:column``."""
    from launchlint.library.validate import faults

    try:
        text, document = decode(data, path)
    except LibraryError as error:
        return None, [str(error)]
    found = faults(document)
    if not found:
        return document, []
    from launchlint.library.position import located

    return document, located(text, path, found)


def decode(data: bytes, path: str, mapping: Callable[[list[tuple[str, Any]]], Any] | None = None) -> tuple[str, Any]:
    """The text of a library and its JSON, not validated. ``mapping`` makes a mapping of its pairs.

    Raises:
        LibraryError: it is no JSON, or holds what no other program could read; the message begins with ``path:line:column``.
    """
    from launchlint.library.position import line_and_column, lone_surrogate, unreadable_number

    def wrong(text: str, at: int, said: str) -> LibraryError:
        line, column = line_and_column(text, at)
        return LibraryError(f"{path}:{line}:{column}: the library is not {said}")

    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise wrong(before := data[: error.start].decode("utf-8-sig"), len(before), "UTF-8") from None
    try:
        document = json.loads(text, parse_constant=_refuse, parse_float=_finite, object_pairs_hook=mapping)
    except json.JSONDecodeError as error:
        raise wrong(text, error.pos, f"JSON: {error.msg[:1].lower()}{error.msg[1:]}") from None
    except RecursionError:
        raise wrong(text, 0, "JSON that can be read: it is nested too deep") from None
    except ValueError:
        at, word = unreadable_number(text) or (0, "")
        raise wrong(text, at, f"JSON: {word if len(word) <= 20 else word[:17] + '…'} is no number that can be held") from None
    lone = lone_surrogate(text)
    if lone is not None:
        raise wrong(text, lone, f"JSON that can be read: {text[lone : lone + 6]} is half of a character")
    return text, document


def _refuse(word: str) -> float:
    raise ValueError(word)


def _finite(word: str) -> float:
    value = float(word)
    return value if value - value == 0 else _refuse(word)


class _Loaded:
    """Packages that are in memory."""

    def __init__(self, packages: Mapping[str, Any]) -> None:
        self._packages = packages
        self._classes: dict[str, str] | None = None

    def get(self, name: str) -> Any:
        return self._packages.get(name)

    def names(self) -> tuple[str, ...]:
        return tuple(sorted(self._packages))

    def classes(self) -> Mapping[str, str]:
        if self._classes is None:
            self._classes = classes_of(self._packages)
        return self._classes


def classes_of(packages: Mapping[str, Any]) -> dict[str, str]:
    """Nodelet class → package; of several the first by name."""
    found: dict[str, str] = {}
    for package in sorted(packages):
        for name in packages[package].get("nodelets", ()):
            found.setdefault(name, package)
    return found


class _Indexed:
    """Packages that are read from an index: a first line that says where each is, then one line for each."""

    def __init__(self, data: bytes, head: Any, start: int) -> None:
        self._data = data
        self._packages: dict[str, list[int]] = head["packages"]
        self._classes: dict[str, str] = head["classes"]
        self._start = start
        self._read: dict[str, Any] = {}

    @classmethod
    def open(cls, path: str) -> _Indexed | None:
        """The index at ``path``; None where there is none that can be used."""
        try:
            with open(path, "rb") as file:
                data = file.read(LARGEST + 1)
            end = data.index(b"\n")
            head = json.loads(data[:end])
            if head["digest"] != hashlib.sha256(data[end + 1 :]).hexdigest():
                return None
            return cls(data, head, end + 1)
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None

    def get(self, name: str) -> Any:
        if name not in self._read:
            place = self._packages.get(name)
            self._read[name] = None if place is None else json.loads(self._data[self._start + place[0] : self._start + place[1]])
        return self._read[name]

    def names(self) -> tuple[str, ...]:
        return tuple(self._packages)

    def classes(self) -> Mapping[str, str]:
        return self._classes


def _write_index(path: str, packages: Mapping[str, Any]) -> None:
    """Keep an index; where that cannot be done, the next run reads the library again."""
    from launchlint.atomic import write_text

    places: dict[str, tuple[int, int]] = {}
    lines: list[str] = []
    at = 0
    for name in sorted(packages):
        line = json.dumps(packages[name], separators=(",", ":"))
        places[name] = (at, at + len(line))
        lines.append(line)
        at += len(line) + 1
    body = "\n".join(lines)
    head = {"digest": hashlib.sha256(body.encode()).hexdigest(), "packages": places, "classes": classes_of(packages)}
    try:
        os.makedirs(os.path.dirname(path), mode=0o700, exist_ok=True)
        _forget_oldest(os.path.dirname(path))
        write_text(path, f"{json.dumps(head, separators=(',', ':'))}\n{body}")
    except (OSError, UsageError):
        pass


def _forget_oldest(directory: str) -> None:
    """Make room for one more index: those that were made last stay."""
    with os.scandir(directory) as listed:
        known = sorted((each.stat().st_mtime, each.path) for each in listed if each.name.startswith("library-"))
    for _, path in known[: max(0, len(known) - MOST_INDICES + 1)]:
        os.unlink(path)
