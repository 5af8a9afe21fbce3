"""What a program includes and is not here: which classes and functions come from packages of ROS that may talk for themselves.

A header belongs to the package that its path begins with. One of a ROS package (public, or named in ``package.xml``) that is not known to
be silent may declare anything: what the program takes from it, by the words of the header's path, is not followed, and may make names.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from functools import lru_cache

from launchlint.extract.cpp.silent import BASES, NAMESPACES, PACKAGES
from launchlint.workspace.public_packages import public_names

_MESSAGES = re.compile(r"(?:msgs?|srvs|actions|messages|interfaces)$")
_GENERATED = re.compile(r"^(?:ui_|moc_)|\.pb$|_(?:version|export)$")
_LIBRARIES = ("boost", "Eigen", "tbb")
_SHORTEST_PREFIX = 6
_QT = re.compile(r"Q[A-Z]\w*")


class Foreign:
    """The headers of a program that are not here."""

    def __init__(self, missing: Iterable[tuple[str, bool]] = (), packages: Collection[str] = ()) -> None:
        self._packages = packages
        self._words: dict[str, str] = {}
        self._stems: dict[str, str] = {}
        self._of_functions: dict[str, str] = {}  # packages of which only headers are included that may be of messages
        for header, quoted in missing:
            self._add(header, quoted)

    def _add(self, header: str, quoted: bool) -> None:
        parts = header.split("/")
        package, stem = parts[0] if len(parts) > 1 else "", re.sub(r"\.\w+$", "", parts[-1])
        if _GENERATED.search(stem) or package in PACKAGES or _MESSAGES.search(package):
            return
        if len(parts) == 3 and parts[1] in ("msg", "srv", "action"):
            return  # a message of ROS 2
        if package in _LIBRARIES or (not package and "." not in header):
            return  # "string" is of the standard library, in quotes, too
        if not package:
            if quoted:
                self._stems.setdefault(_plain(stem), header)
            return
        if package not in self._packages and package not in public_names():
            return
        if len(parts) == 2 and stem[:1].isupper() and header.endswith(".h"):
            self._stems.setdefault(_plain(stem), header)  # a message, if it is used as one
            self._of_functions.setdefault(_plain(package), header)
            return
        self._stems.setdefault(_plain(stem), header)
        for word in parts[:-1]:
            if word not in NAMESPACES:
                self._words.setdefault(_plain(word), header)
        if package == "moveit":
            self._words.setdefault(_plain(stem), header)  # one directory for the headers of many packages

    def words_among(self, words: Iterable[str]) -> set[str]:
        """Those of the words that name something of these headers."""
        if not (self._words or self._stems):
            return set()
        return {each for each in words if (plain := _plain(each)) in self._words or (plain in self._stems and self.header_of(each))}

    def header_of_function(self, name: str, around: Iterable[str] = ()) -> str | None:
        """The header that may declare a function that is not here, and may talk; None where it is silent."""
        found = self.header_of(name, around)
        space = name.rpartition("::")[0]
        if found is None and space and not is_silent(name):
            return self._of_functions.get(_plain(space.partition("::")[0]))
        return found

    def header_of(self, name: str, around: Iterable[str] = ()) -> str | None:
        """The header that may declare a class or function that is not here, and may talk; None where it is silent.

        Args:
            name: its qualified name.
            around: the namespaces that it is looked up in: of the place, and those that are used there.
        """
        if not (self._words or self._stems) or is_silent(name) or len(name) == 1:
            return None  # one letter is an argument of a template
        *spaces, last = name.split("::")
        found = self._stems.get(_plain(last))
        if found is not None and (not spaces or found.partition("/")[0] != spaces[-1]):
            return found
        for space in spaces or around:
            if space and not is_silent(space):
                header = self._in(_plain(space.partition("::")[0] if not spaces else space))
                if header is not None:
                    return header
        return found

    def may_declare(self, space: str, included: bool) -> bool:
        """Whether a namespace, of which the message asked for is not included, may be one of these headers and call it by another name.

        They are of other packages, and it is the namespace of one of them, or of no package that is known.

        Args:
            space: the namespace.
            included: whether messages of a package of that name are included.
        """
        if _MESSAGES.fullmatch(space):
            return not included and space not in self._packages  # ``msgs``: a short name for some package
        if not self._words or is_of_messages(space) or space in PACKAGES:
            return False
        return _plain(space) in self._words or (not included and space not in self._packages and space not in public_names())

    def _in(self, word: str) -> str | None:
        if word in self._words:
            return self._words[word]
        if len(word) < _SHORTEST_PREFIX:
            return None
        return next((header for each, header in self._words.items() if each.startswith(word)), None)


def is_of_messages(package: str) -> bool:
    """Whether a package is called as those of messages are."""
    return _MESSAGES.search(package) is not None


@lru_cache(maxsize=16384)
def is_silent(name: str) -> bool:
    """Whether a class or namespace is of a library that makes no names."""
    parts = name.split("::")
    if name in BASES or _QT.fullmatch(parts[-1]) or _QT.fullmatch(parts[0]) or parts[0] in PACKAGES or _MESSAGES.search(parts[0]):
        return True
    return any("::".join(parts[:length]) in NAMESPACES for length in range(1, len(parts) + 1))


@lru_cache(maxsize=16384)
def _plain(word: str) -> str:
    return word.lower().replace("_", "").replace("-", "")
