"""Programs by what their sources say: from this run, kept from an earlier one as long as nothing it hangs on has changed, or read now."""

from __future__ import annotations

import hashlib
import os

from launchlint.knowledge.code import code_digest
from launchlint.knowledge.entry import Key, Known, hold
from launchlint.knowledge.store import Store
from launchlint.workspace.looking import unnoted
from launchlint.workspace.states import States

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.knowledge.own import Home, OwnSources
    from launchlint.knowledge.reading import SourceReader

FORMAT = 1
"""Of what is kept; another one reads everything anew."""


class Programs:
    """What is known of each program of ``own``, kept in ``directory``; ``states`` are what there is on disk."""

    def __init__(self, own: OwnSources, directory: str | None, states: States | None = None) -> None:
        self._own = own
        self._store = Store(directory)
        self._states = states or States()
        self._known: dict[Key, Known] = {}
        self._reader: SourceReader | None = None
        self._surroundings = ""

    def known(self, key: Key, home: Home) -> Known:
        """What the sources of a program of the package at ``home`` say."""
        if key not in self._known:
            with unnoted():  # what it hangs on is in its digest
                self._known[key] = self._without_reading(key, home) or self._read_once(key, home)
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
        with unnoted():
            known = self._known.get(key) or self._without_reading(key, home)
        if known is None:
            return ""
        self._known[key] = known
        return known.digest

    def _without_reading(self, key: Key, home: Home) -> Known | None:
        """What is known of a program without its sources: that nobody can say which package is meant, or what is kept."""
        if home.copies > 1:
            return Known(None, f"{home.copies} packages of the workspace are called {key[0]}", ())
        return self._kept(key, home)

    def _kept(self, key: Key, home: Home) -> Known | None:
        """What is kept of a program, if it is still true."""
        kept = self._store.get(self._name(key, home))
        return kept if kept is not None and hold(kept.looks, home.root, self._states) else None

    def _read_once(self, key: Key, home: Home) -> Known:
        name = self._name(key, home)
        with self._store.alone(name):
            kept = self._kept(key, home)
            if kept is not None:
                return kept
            if self._reader is None:
                from launchlint.knowledge.reading import SourceReader

                homes = [each for name in self._own.names() if (each := self._own.first(name)) is not None]
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
        found = hashlib.sha1(f"{FORMAT} {self._own.middleware} {code_digest()}".encode(), usedforsecurity=False)
        for root, packages in self._own.places():
            for name, copies in packages.items():
                lines = [f"{name}\0{os.path.relpath(package.directory, root)}\n" for package in copies]
                found.update("".join(lines).encode("utf-8", "surrogateescape"))
        return found.hexdigest()
