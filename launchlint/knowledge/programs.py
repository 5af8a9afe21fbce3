"""Programs by what their sources say: from this run, kept from an earlier one as long as nothing it hangs on has changed, or read now."""

from __future__ import annotations

import hashlib
import os

from launchlint.knowledge.code import code_digest
from launchlint.knowledge.entry import Key, Known, absolute, hold
from launchlint.knowledge.store import Store
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import unnoted
from launchlint.workspace.states import Look, States

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.knowledge.own import Home, OwnSources
    from launchlint.knowledge.reading import SourceReader

FORMAT = 1
"""Of what is kept; another one reads everything anew."""


class Digest(NamedTuple):
    """What :class:`launchlint.knowledge.entry.Known` has without what is known: its digest, and what that hangs on."""

    digest: str
    looks: tuple[Look, ...]


class Programs:
    """What is known of each program of ``own``, kept in ``directory``; ``states`` are what there is on disk."""

    def __init__(self, own: OwnSources, directory: str | None, states: States | None = None) -> None:
        self._own = own
        self._store = Store(directory)
        self._states = states or States()
        self._known: dict[Key, Known] = {}
        self._reader: SourceReader | None = None
        self._surroundings = ""
        self._names: dict[Key, str] = {}
        self._directories: dict[str, str] = {}
        self.digests: dict[str, Digest] = {}
        self.remembered: dict[str, Digest] = {}

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
        found = self._digest_of(key, home)
        return "" if found is None else found.digest

    def looks(self, key: Key, home: Home) -> tuple[Look, ...]:
        """All that the digest hangs on, by absolute paths."""
        found = self._digest_of(key, home)
        return () if found is None else tuple((absolute(path, home.root), state) for path, state in found.looks)

    def _digest_of(self, key: Key, home: Home) -> Digest | None:
        """What is remembered of the program as long as it is true, else that of what is kept of it."""
        with unnoted():
            name = self._name(key, home)
            known = self._known.get(key)
            if known is None:
                found = self.digests.get(name) or self.remembered.get(name)
                if found is not None and home.copies == 1 and hold(found.looks, home.root, self._states):
                    self.digests[name] = found
                    return found
                known = self._without_reading(key, home)
            if known is None:
                return None
            self._known[key] = known
            found = self.digests[name] = Digest(known.digest, known.looks)
            return found

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
        if key not in self._names:
            self._surroundings = self._surroundings or self._digest()
            directory = home.package.directory
            if directory not in self._directories:
                self._directories[directory] = os.path.relpath(directory, home.root)
            text = "\0".join((self._surroundings, self._directories[directory], *key))
            self._names[key] = hashlib.sha1(text.encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()
        return self._names[key]

    def _digest(self) -> str:
        """Of what everything hangs on: launchlint, what it reads with, and which packages there are."""
        found = hashlib.sha1(f"{FORMAT} {self._own.middleware} {code_digest()}".encode(), usedforsecurity=False)
        for root, packages in self._own.places():
            for name, copies in packages.items():
                lines = [f"{name}\0{os.path.relpath(package.directory, root)}\n" for package in copies]
                found.update("".join(lines).encode("utf-8", "surrogateescape"))
        return found.hexdigest()
