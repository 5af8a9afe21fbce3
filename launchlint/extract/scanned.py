"""What source files include and mention, told from their text once for all the programs that they are part of."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.workspace import looking

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n\0]{1,300})[>"]', re.MULTILINE)
_QUOTED = re.compile(r'"([\w:/]{3,200})"')
_LOADER = re.compile(r"\bnodelet::Loader\b")
_CLASS_LOADER = re.compile(r"\bClassLoader\s*<")
# An object of its own at the level of a namespace: Registry::Entry<Map> Map::entry("Map"); or a macro that makes one.
_REGISTERS = re.compile(
    r"^[ \t]*(?:static[ \t]+)?(?:const[ \t]+)?"
    r"[\w:]{0,200}[Rr]egist[\w:]{0,200}(?:[ \t]*<[^;{}()<>]{1,300}>)?[ \t\n]+[\w:]{1,200}[ \t\n]*[({=]"
    r"|^[ \t]*(?!PLUGINLIB_|NODELET_|POINT_CLOUD_|GZ_|CLASS_LOADER_)[A-Z_]{0,200}REGISTER[A-Z_]{0,200}[ \t]*\(",
    re.MULTILINE,
)
_MOST_KEPT = 20_000
_MOST_HEADERS = 200_000
_MOST_TEXT = 32 << 20
_MOST_LISTED = 4_000
_HERE = (".", "..")


class Scan(NamedTuple):
    """What the text of a file says: the headers that it includes (in quotes?, name), the literals in it that may name a plugin, and whether
    it loads nodelets or other classes; ``registers``: it has objects that are made as its library is loaded, and tell of its classes.
    """

    includes: tuple[tuple[bool, str], ...]
    quoted: frozenset[str]
    loads_nodelets: bool
    loads_classes: bool
    registers: bool


def scan(text: str) -> Scan:
    """What a text says."""
    return Scan(
        tuple(dict.fromkeys((quote == '"', name) for quote, name in INCLUDE.findall(text))),
        frozenset(_QUOTED.findall(text)),
        # A word is looked for first, which is many times as fast, and is in few files.
        "Loader" in text and _LOADER.search(text) is not None,
        "ClassLoader" in text and _CLASS_LOADER.search(text) is not None,
        ("egist" in text or "REGISTER" in text) and _REGISTERS.search(text) is not None,
    )


class Files:
    """Source files, each read and scanned once; what is found of headers is kept for each list of directories."""

    def __init__(self) -> None:
        self._scans: dict[str, Scan] = {}
        self._texts: dict[str, str] = {}
        self._characters = 0
        self._headers: dict[tuple[str, ...], dict[tuple[str, str], str | None]] = {}
        self._found = 0
        self._looked_for = Headers()

    def text(self, path: str) -> str:
        """The text of a file; empty where it cannot be read."""
        looking.note((os.path.abspath(path),))
        if path not in self._texts:
            if self._characters > _MOST_TEXT:
                self._texts.clear()
                self._characters = 0
            self._texts[path] = text_of(path)
            self._characters += len(self._texts[path])
        return self._texts[path]

    def scan(self, path: str) -> Scan:
        """What a file says."""
        looking.note((os.path.abspath(path),))
        if path not in self._scans:
            if len(self._scans) >= _MOST_KEPT:
                self._scans.clear()
            self._scans[path] = scan(self.text(path))
        return self._scans[path]

    def header(self, path: str, quoted: bool, name: str, directories: tuple[str, ...]) -> str | None:
        """The header that a file includes by a name; None where it is not here."""
        if self._found >= _MOST_HEADERS:
            self._headers.clear()
            self._found = 0
        known = self._headers.setdefault(directories, {})
        key = (os.path.dirname(path) if quoted else "", name)
        if key not in known:
            known[key] = self._looked_for.found(name, quoted, path, directories)
            self._found += 1
        return known[key]

    def included(self, path: str, directories: tuple[str, ...]) -> list[str]:
        """The headers that a file includes and that are here."""
        found = [self.header(path, quoted, name, directories) for quoted, name in self.scan(path).includes]
        return [each for each in found if each is not None]


class Headers:
    """Looks for headers, beside files and in directories, whose names it keeps."""

    def __init__(self) -> None:
        self._listed: dict[str, frozenset[str]] = {}

    def found(self, name: str, quoted: bool, includer: str, directories: Sequence[str]) -> str | None:
        """The file that ``#include`` means, beside the includer or in the directories; None where it is not here."""
        if "\0" in name or os.path.isabs(name):
            return None
        first = name.partition("/")[0]
        beside = os.path.dirname(includer)
        near = (os.path.join(beside, "include"), os.path.join(os.path.dirname(beside), "include"))
        # Where a header is not found, a directory called include beside the file is looked into, too.
        for directory in (beside, *directories, *near) if quoted else directories:
            if first in _HERE or first in self._names(directory):
                path = f"{directory}/{name}" if directory else name
                if os.path.isfile(path):
                    return os.path.normpath(path)
        return None

    def _names(self, directory: str) -> frozenset[str]:
        if directory not in self._listed:
            if len(self._listed) >= _MOST_LISTED:
                self._listed.clear()
            try:
                self._listed[directory] = frozenset(os.listdir(directory or "."))
            except (OSError, ValueError):
                self._listed[directory] = frozenset()
        return self._listed[directory]


def text_of(path: str) -> str:
    """The text of a file; empty where it cannot be read."""
    try:
        return looking.read_bytes(path).decode("utf-8", "replace")
    except OSError:
        return ""
