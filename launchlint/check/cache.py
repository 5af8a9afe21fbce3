"""Results of earlier runs, used again where nothing they depend on has changed.

What every result depends on (:mod:`.surroundings`) is in the name of the database. What one result depends on is checked for each: the
content of every file that was read, the value of every environment variable, what was there wherever a rule looked around, and the sources
of the programs that were asked for.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launchlint.atomic import seal
from launchlint.check.codec import entry_from_json, entry_to_json, file_from_json, file_to_json
from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.file import INTERNAL_ERROR, FileResult
from launchlint.check.options import EntryRequest
from launchlint.check.surroundings import Surroundings
from launchlint.workspace.looking import PART, content_state, state
from launchlint.workspace.states import Look, Looks, States, state_of

if TYPE_CHECKING:
    import sqlite3

MOST_DATABASES = 24
"""Databases that are kept, the latest used; each set of options and workspaces has one."""
BROKEN = (ValueError, TypeError, KeyError, IndexError, AttributeError, RecursionError)
"""What reading a row that somebody else wrote may raise."""


class Cache:
    """The database for one set of options and workspaces. Whatever goes wrong with it, the check goes on without."""

    def __init__(self, directory: str, checker: EntryChecker) -> None:
        import sqlite3

        self._error: tuple[type[Exception], ...] = (OSError, sqlite3.Error, *BROKEN)
        self._session = checker.session
        self._variables = checker.options.variables
        self._own = checker.own
        self._states = checker.states = States(self._state)
        self._parts: dict[str, str] = {}
        self._shared: dict[str, bool] = {}
        self._files: dict[str, FileResult | None] = {}
        self._database: sqlite3.Connection | None = None
        self._surroundings = Surroundings(checker.options, checker.packages)
        name = self._surroundings.name
        try:
            if name is not None:
                self._database = self._open(directory, f"{name}.sqlite")
        except self._error:
            self._database = None

    def _open(self, directory: str, name: str) -> sqlite3.Connection:
        import sqlite3

        os.makedirs(directory, mode=0o700, exist_ok=True)
        file = os.path.join(directory, name)
        if not os.path.exists(file):
            _forget_oldest(directory)
        database = sqlite3.connect(file, timeout=2)
        try:
            database.execute("CREATE TABLE IF NOT EXISTS entries (key TEXT PRIMARY KEY, value TEXT)")
            database.execute("CREATE TABLE IF NOT EXISTS files (path TEXT PRIMARY KEY, value TEXT)")
            database.execute("CREATE TABLE IF NOT EXISTS parts (path TEXT PRIMARY KEY, value TEXT)")
            database.execute("CREATE TABLE IF NOT EXISTS shared (name TEXT PRIMARY KEY, value TEXT)")
        except sqlite3.DatabaseError as error:
            database.close()
            if isinstance(error, sqlite3.OperationalError):
                raise
            os.unlink(file)  # it is no database (any more)
            raise
        os.utime(file)
        return database

    def look_up(self, requests: Sequence[EntryRequest]) -> list[EntryResult | None]:
        """For each request its result, where it is known and still true."""
        return [self._look_up(request) for request in requests]

    def _look_up(self, request: EntryRequest) -> EntryResult | None:
        value = self._row("SELECT value FROM entries WHERE key = ?", _key(request))
        if value is None or not _is_plain(request):
            return None
        try:
            dependencies, variables, looks, shared, programs, names, entry = value
            if any(self._variables.get(name) != text for name, text in variables):
                return None
            if any(self._session.read(path).digest != known for path, known in dependencies) or not self._holds(looks, shared):
                return None
            own = self._own
            if any(own is None or own.of(ware).digest((package, table, name)) != known for ware, package, table, name, known in programs):
                return None
            known_files = {name: self._file(name) for name in names}
            files = {name: file for name, file in known_files.items() if file is not None}
            return entry_from_json(entry, request, files)
        except BROKEN:
            return None

    def _row(self, query: str, key: str) -> Any:
        """The value of a row; None where there is none, or where it is not what was written."""
        if self._database is None:
            return None
        try:
            row = self._database.execute(query, (key,)).fetchone()
            if row is None or row[0][:40] != seal(key, row[0][40:]):
                return None
            return json.loads(row[0][40:])
        except self._error:
            return None

    def _file(self, key: str) -> FileResult | None:
        """The result of one launch file, where it is known and still true."""
        if key not in self._files:
            self._files[key] = None
            value = self._row("SELECT value FROM files WHERE path = ?", key)
            if value is not None:
                known, looks, shared, told = value
                result = file_from_json(told)
                if self._session.read(os.path.join(self._session.root, result.path)).digest == known and self._holds(looks, shared):
                    self._files[key] = result
        return self._files[key]

    def _holds(self, looks: Iterable[Look], shared: Iterable[str]) -> bool:
        """Whether all is as it was, where one result looked around, and where it did together with others."""
        return all(map(self._shared_holds, shared)) and all(self._states.of(path) == known for path, known in looks)

    def _shared_holds(self, name: str) -> bool:
        if name not in self._shared:
            looks = self._row("SELECT value FROM shared WHERE name = ?", name)
            self._shared[name] = looks is not None and self._holds(looks, ())
        return self._shared[name]

    def _state(self, path: str) -> str:
        """That of a part of a text takes time to find: it is kept with the content of the whole text, and found anew with another."""
        if PART not in path:
            return state_of(path)
        content = content_state(path.partition(PART)[0])
        kept = self._row("SELECT value FROM parts WHERE path = ?", path)
        if content and kept is not None and kept[0] == content:
            return str(kept[1])
        found = state(path)
        if content:
            self._parts[path] = _sealed(path, [content, found])
        return found

    def store(self, results: Iterable[EntryResult]) -> None:
        """Keep the results of this run."""
        if self._database is None:
            return
        entries: list[tuple[str, str]] = []
        files: dict[str, str] = {}
        shared: dict[str, str] = {}

        def names_of(looks: Looks) -> list[str]:
            for each in looks.shared:
                if each.name not in shared:
                    shared[each.name] = _sealed(each.name, self._unsaid(each.looks))
            return [each.name for each in looks.shared]

        try:
            for result in results:
                if not _is_plain(result.request) or _has_crashed(result):
                    continue
                digests = dict(result.dependencies)
                for file in result.files:
                    if file.key not in files:
                        content = digests[os.path.abspath(os.path.join(self._session.root, file.path))]
                        files[file.key] = _sealed(
                            file.key, [content, self._unsaid(file.looks.own), names_of(file.looks), file_to_json(file)]
                        )
                names = [file.key for file in result.files]
                looks = result.looks
                around = [self._unsaid(looks.own), names_of(looks)]
                value = [result.dependencies, result.variables, *around, result.programs, names, entry_to_json(result)]
                entries.append((_key(result.request), _sealed(_key(result.request), value)))
            with self._database:
                self._database.executemany(
                    "DELETE FROM shared WHERE name = ?", [(name,) for name, holds in self._shared.items() if not holds]
                )
                self._database.executemany("INSERT OR REPLACE INTO shared VALUES (?, ?)", shared.items())
                self._database.executemany("INSERT OR REPLACE INTO entries VALUES (?, ?)", entries)
                self._database.executemany("INSERT OR REPLACE INTO files VALUES (?, ?)", files.items())
        except self._error:
            return

    def _unsaid(self, looks: Iterable[Look]) -> list[Look]:
        """The looks of which the name of the database says nothing."""
        return [look for look in looks if not self._surroundings.say(*look)]

    def close(self) -> None:
        """Keep what was found of parts of texts, and close the database."""
        if self._database is None:
            return
        try:
            if self._parts:
                with self._database:
                    self._database.executemany("INSERT OR REPLACE INTO parts VALUES (?, ?)", self._parts.items())
        except self._error:
            return
        finally:
            self._database.close()


def _is_plain(request: EntryRequest) -> bool:
    """Whether the file is judged as what it is; text that stands in for another file is not kept."""
    return request.file == request.at


def _has_crashed(result: EntryResult) -> bool:
    findings = (*result.findings, *(guarded.finding for file in result.files for guarded in file.findings))
    return any(finding.rule == INTERNAL_ERROR for finding in findings)


def _key(request: EntryRequest) -> str:
    return _dump([request.file, request.at, request.arguments, request.declared])


def _dump(value: Any) -> str:
    return json.dumps(value, ensure_ascii=True, separators=(",", ":"))


def _sealed(key: str, value: Any) -> str:
    text = _dump(value)
    return seal(key, text) + text


def _forget_oldest(directory: str) -> None:
    """Make room for one more database."""
    databases = [entry for entry in os.scandir(directory) if entry.name.endswith(".sqlite") and entry.is_file(follow_symlinks=False)]
    databases.sort(key=lambda entry: (entry.stat().st_mtime, entry.name), reverse=True)
    for entry in databases[MOST_DATABASES - 1 :]:
        os.unlink(entry.path)
