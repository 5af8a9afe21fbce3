"""Programs by what their sources say: from this run, kept from an earlier one as long as nothing it hangs on has changed, or read now."""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Iterator

from launchlint import __version__
from launchlint.knowledge.entry import Key, Known, States
from launchlint.knowledge.store import Store

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.knowledge.own import Home, OwnSources
    from launchlint.knowledge.reading import SourceReader

FORMAT = 1
"""Of what is kept; another one reads everything anew."""
_ROOMS = ("extract", "knowledge", "workspace")
"""The rooms of launchlint that what is read hangs on."""
_READERS = "tree_sitter"
"""What the names of the installed libraries that read C++ begin with."""


class Programs:
    """What is known of each program of ``own``, kept in ``directory``."""

    def __init__(self, own: OwnSources, directory: str | None) -> None:
        self._own = own
        self._store = Store(directory)
        self._states = States()
        self._known: dict[Key, Known] = {}
        self._reader: SourceReader | None = None
        self._surroundings = ""

    def known(self, key: Key, home: Home) -> Known:
        """What the sources of a program of the package at ``home`` say."""
        if key not in self._known:
            self._known[key] = self._kept(key, home) or self._read_once(key, home)
        return self._known[key]

    def take(self, key: Key, known: Known) -> None:
        """What another process has read."""
        self._known[key] = known

    def keep_in(self, directory: str) -> None:
        """As :meth:`launchlint.knowledge.own.OwnSources.keep_in`."""
        store = Store(directory)
        for key, known in self._known.items():
            home = self._own.home(key[0])
            if home is not None:
                store.put(self._name(key, home), known)

    def digest(self, key: Key, home: Home) -> str:
        """As :meth:`launchlint.knowledge.own.OwnSources.digest`."""
        known = self._known.get(key) or self._kept(key, home)
        if known is None:
            return ""
        self._known[key] = known
        return known.digest

    def _kept(self, key: Key, home: Home) -> Known | None:
        """What is kept of a program, if it is still true."""
        kept = self._store.get(self._name(key, home))
        return kept if kept is not None and self._states.hold(kept.looks, home.root) else None

    def _read_once(self, key: Key, home: Home) -> Known:
        if home.copies > 1:
            return Known(None, f"{home.copies} packages of the workspace are called {key[0]}", ())
        name = self._name(key, home)
        with self._store.alone(name):
            kept = self._kept(key, home)
            if kept is not None:
                return kept
            if self._reader is None:
                from launchlint.knowledge.reading import SourceReader

                homes = [each for name in self._own.names() if (each := self._own.home(name)) is not None]
                self._reader = SourceReader([each.package for each in homes], [root for root, _ in self._own.places()], self._states)
            known = self._reader.read(key, home.package, home.root)
            self._store.put(name, known)
            return known

    def _name(self, key: Key, home: Home) -> str:
        """What is known of a program is kept under this name: the same wherever the workspace lies."""
        if not self._surroundings:
            self._surroundings = self._digest()
        text = "\0".join((self._surroundings, os.path.relpath(home.package.directory, home.root), *key))
        return hashlib.sha1(text.encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()

    def _digest(self) -> str:
        """Of what everything hangs on: launchlint, what it reads with, and which packages there are."""
        found = hashlib.sha1(f"{FORMAT} {__version__} {sys.version}".encode(), usedforsecurity=False)
        for line in (*_own_code(), *_installed()):
            found.update(line)
        for root, packages in self._own.places():
            for name, copies in packages.items():
                lines = [f"{name}\0{os.path.relpath(package.directory, root)}\n" for package in copies]
                found.update("".join(lines).encode("utf-8", "surrogateescape"))
        return found.hexdigest()


def _own_code() -> Iterator[bytes]:
    """The files of launchlint that matter: a checkout changes without a new version."""
    top = os.path.dirname(os.path.dirname(__file__))
    for room in _ROOMS:
        for directory, directories, files in os.walk(os.path.join(top, room)):
            directories[:] = sorted(name for name in directories if name != "__pycache__")
            for name in sorted(files):
                yield name.encode("utf-8", "surrogateescape")
                with open(os.path.join(directory, name), "rb") as file:
                    yield hashlib.sha1(file.read(), usedforsecurity=False).digest()


def _installed() -> Iterator[bytes]:
    """Names and versions of the libraries that C++ is read with."""
    for directory in sys.path:
        try:
            names = sorted(name for name in os.listdir(directory or os.curdir) if name.startswith(_READERS))
        except OSError:
            continue
        yield from (os.fsencode(name) for name in names)
