"""Reading one library file. A large one is indexed once: later only the packages that are asked for are read.

The index is kept under the digest of the file's content, so it can never be out of date; a broken or missing index is made anew.
"""

from __future__ import annotations

import gc
import json
import os
from collections.abc import Callable, Mapping
from functools import cached_property
from zlib import crc32

from launchlint import __version__
from launchlint.errors import LibraryError, UsageError
from launchlint.library.terms import TABLES, VERSION
from launchlint.model import ROS1, ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from mmap import mmap
    from typing import Any, Protocol

    class Packages(Protocol):
        """Where the packages of a library come from: memory or an index."""

        def get(self, name: str) -> Mapping[str, Any] | None:
            """A package."""

        def names(self) -> tuple[str, ...]:
            """All names, sorted."""

        def classes(self, middleware: str) -> Mapping[str, str]:
            """What can be loaded into a process, nodelet class or component → package."""


LARGEST = 512 * 1024 * 1024
"""Bytes of a library file."""
INDEX_PAYS = 256 * 1024
"""Bytes from which a library is indexed: reading and validating a smaller one takes a few milliseconds."""

MOST_INDICES = 16
"""Indices that are kept, the latest made."""

_DIGITS = 64
"""Of a SHA-256."""
_BLOCK = 1024 * 1024
_INDEX_VERSION = 3


class LibraryFile:
    """The packages of one library. ``path`` as people see it; ``digest`` of its content, or what makes it; ``version`` of the format."""

    def __init__(self, path: str, digest: Callable[[], str], packages: Packages, version: int) -> None:
        self.path = path
        self._digest = digest
        self._packages = packages
        self._serves_both = version == VERSION
        self._known: dict[tuple[str, str], Mapping[str, Any] | None] = {}

    @cached_property
    def digest(self) -> str:
        """The SHA-256 of its content."""
        return self._digest()

    def package(self, name: str, middleware: str = ROS1, *, borrowed: bool = True) -> Mapping[str, Any] | None:
        """What the library says of a package of ``middleware``: validated JSON.

        A package of version 1 is of ROS 1, and serves ROS 2 as well where ``borrowed``: :mod:`.borrowed`.
        """
        key = (name, middleware if borrowed else "")
        if key not in self._known:
            self._known[key] = self._package(name, middleware, borrowed=borrowed)
        return self._known[key]

    def _package(self, name: str, middleware: str, *, borrowed: bool) -> Mapping[str, Any] | None:
        known = self._packages.get(name)
        if known is None or known.get("middleware", ROS1) == middleware:
            return known
        if self._serves_both and borrowed and middleware == ROS2:
            from launchlint.library.borrowed import in_ros2

            return in_ros2(known)
        return None

    def package_of_class(self, name: str, middleware: str = ROS1) -> str | None:
        """The package that has a nodelet class or component."""
        found = self._packages.classes(middleware).get(name)
        return self._packages.classes(ROS1).get(name) if found is None and self._serves_both else found

    def names(self) -> tuple[str, ...]:
        """The names of all packages, sorted."""
        return self._packages.names()


def open_library(path: str, cache_directory: str | None = None) -> LibraryFile:
    """Read a library, or its index from ``cache_directory``.

    Raises:
        LibraryError: it cannot be read, or is not a library; the message says where.
    """
    data = read(path)
    if len(data) < INDEX_PAYS:  # to import what makes its digest takes longer than to read it, and seldom is it asked for
        document = parse(data, path)
        return LibraryFile(path, lambda: _digest(data), _Loaded(document["packages"]), document["version"])
    digest = _digest(data)
    index = None
    if cache_directory is not None:
        index = os.path.join(cache_directory, f"library-{_INDEX_VERSION}-{__version__}-{digest[:32]}.index")
        known = _Indexed.open(index, lambda: _Loaded(parse(read(path), path)["packages"]))
        if known is not None:
            return LibraryFile(path, lambda: digest, known, known.version)
    document = parse(data, path)
    if index is not None:
        _write_index(index, document["packages"], document["version"])
    return LibraryFile(path, lambda: digest, _Loaded(document["packages"]), document["version"])


def _digest(data: bytes) -> str:
    from hashlib import sha256

    return sha256(data).hexdigest()


def read(path: str) -> bytes:
    """The bytes of a library file.

    Raises:
        LibraryError: it cannot be read, or is too large.
    """
    try:
        with open(path, "rb") as file:
            data = file.read(min(os.fstat(file.fileno()).st_size, LARGEST) + 1)
            while len(data) <= LARGEST and (more := file.read(_BLOCK)):  # a pipe has no size
                data += more
    except (OSError, ValueError) as error:  # ValueError: a null byte in the name
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise LibraryError(f"{path}: the library cannot be read: {reason}") from None
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
    collecting = gc.isenabled()
    gc.disable()  # JSON has no circles, and looking for them takes twice the time of reading it
    try:
        document = json.loads(text, parse_constant=_refuse, parse_float=_finite, object_pairs_hook=mapping)
    except json.JSONDecodeError as error:
        raise wrong(text, error.pos, f"JSON: {error.msg[:1].lower()}{error.msg[1:]}") from None
    except RecursionError:
        raise wrong(text, 0, "JSON that can be read: it is nested too deep") from None
    except ValueError:
        at, word = unreadable_number(text) or (0, "")
        raise wrong(text, at, f"JSON: {word if len(word) <= 20 else word[:17] + '…'} is no number that can be held") from None
    finally:
        if collecting:
            gc.enable()
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
        self._classes: dict[str, dict[str, str]] = {}

    def get(self, name: str) -> Any:
        return self._packages.get(name)

    def names(self) -> tuple[str, ...]:
        return tuple(sorted(self._packages))

    def classes(self, middleware: str) -> Mapping[str, str]:
        if middleware not in self._classes:
            self._classes[middleware] = classes_of(self._packages, middleware)
        return self._classes[middleware]


def classes_of(packages: Mapping[str, Any], middleware: str) -> dict[str, str]:
    """Nodelet class or component → package; of several the first by name."""
    found: dict[str, str] = {}
    for package in sorted(packages):
        for name in packages[package].get(TABLES[middleware][1], ()):
            found.setdefault(name, package)
    return found


class _Indexed:
    """Packages that are read from an index when they are asked for.

    Its first line is the SHA-256 of the second, the second says where each package is, with a checksum; then there is a line for each.
    Where a package is not what the checksum says, the library is read after all.
    """

    def __init__(self, data: mmap, head: Any, start: int, anew: Callable[[], Packages]) -> None:
        self._data = data
        self._places: dict[str, list[int]] = head["packages"]
        self._classes: dict[str, dict[str, str]] = head["classes"]
        self.version: int = head["version"]
        self._start = start
        self._anew = anew
        self._read: dict[str, Any] = {}

    @classmethod
    def open(cls, path: str, anew: Callable[[], Packages]) -> _Indexed | None:
        """The index at ``path``; None where there is none that can be used. ``anew`` reads the library itself."""
        from mmap import ACCESS_READ, mmap

        try:
            with open(path, "rb") as file:
                data = mmap(file.fileno(), 0, access=ACCESS_READ)
            end = data.find(b"\n", _DIGITS + 1)
            line = data[_DIGITS + 1 : end]
            if end < 0 or data[:_DIGITS] != _digest(line).encode():
                return None
            return cls(data, json.loads(line), end + 1, anew)
        except (OSError, ValueError):  # ValueError: it is empty
            return None

    def get(self, name: str) -> Any:
        if name not in self._read:
            place = self._places.get(name)
            self._read[name] = None if place is None else self._package(name, *place)
        return self._read[name]

    def _package(self, name: str, start: int, end: int, checksum: int) -> Any:
        line = self._data[self._start + start : self._start + end]
        return json.loads(line) if crc32(line) == checksum else self._anew().get(name)

    def names(self) -> tuple[str, ...]:
        return tuple(self._places)

    def classes(self, middleware: str) -> Mapping[str, str]:
        return self._classes[middleware]


def _write_index(path: str, packages: Mapping[str, Any], version: int) -> None:
    """Keep an index; where that cannot be done, the next run reads the library again."""
    from launchlint.atomic import write_text

    places: dict[str, tuple[int, int, int]] = {}
    lines = []
    at = 0
    for name in sorted(packages):
        line = json.dumps(packages[name], separators=(",", ":"))
        places[name] = (at, at + len(line), crc32(line.encode()))
        lines.append(line)
        at += len(line) + 1
    classes = {middleware: classes_of(packages, middleware) for middleware in TABLES}
    head = json.dumps({"version": version, "packages": places, "classes": classes}, separators=(",", ":"))
    try:
        os.makedirs(os.path.dirname(path), mode=0o700, exist_ok=True)
        _forget_oldest(os.path.dirname(path))
        write_text(path, "\n".join([_digest(head.encode()), head, *lines]))
    except (OSError, UsageError):
        return


def _forget_oldest(directory: str) -> None:
    """Make room for one more index: those that were made last stay."""
    with os.scandir(directory) as listed:
        known = sorted((each.stat().st_mtime, each.path) for each in listed if each.name.startswith("library-"))
    for _, path in known[: max(0, len(known) - MOST_INDICES + 1)]:
        os.unlink(path)
