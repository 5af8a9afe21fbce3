"""The rows of a cache: a database of values, each under a key and with a seal. Whatever goes wrong with it, nothing is in it."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from launchlint.atomic import seal
from launchlint.named_tuple import NamedTuple

if TYPE_CHECKING:
    import sqlite3

    from launchlint.workspace.states import States

MOST_DATABASES = 24
"""Databases that are kept, the latest used; each set of options and workspaces has one."""
BROKEN = (ValueError, TypeError, KeyError, IndexError, AttributeError, RecursionError)
"""What reading a row that somebody else wrote may raise."""
TABLES = ("entries", "files", "shared", "said", "held", "groups", "told")
LARGEST_DATABASE = 2 << 30
"""Bytes; a larger one, with results of what has long gone, is begun anew."""
SEAL = 40
"""Characters of a seal, with which a row begins."""
_AT_ONCE = 500
"""Keys that are asked for in one query."""


class Row(NamedTuple):
    """What is in a row: its seal, which no other content has, and the value."""

    seal: str
    value: Any


class Rows:
    """The database in ``directory`` that is called ``name``; None: there is none, and nothing is kept."""

    def __init__(self, directory: str, name: str | None) -> None:
        import sqlite3

        self._error: tuple[type[Exception], ...] = (OSError, sqlite3.Error, *BROKEN)
        self._database: sqlite3.Connection | None = None
        try:
            if name is not None:
                self._database = _open(directory, name)
        except self._error:
            self._database = None

    @property
    def is_open(self) -> bool:
        """Whether anything can be kept."""
        return self._database is not None

    def values(self, table: str, keys: Sequence[str]) -> Iterator[tuple[str, Row]]:
        """Those of ``keys`` that ``table`` has a row of which is what was written, in any order."""
        for start in range(0, len(keys), _AT_ONCE):
            for key, text in self._texts(table, keys[start : start + _AT_ONCE]):
                value = self._loaded(key, text)
                if value is not None:
                    yield key, Row(text[:SEAL], value)

    def _loaded(self, key: Any, text: Any) -> Any:
        """The value in a row; None where it is not what was written."""
        try:
            return json.loads(text[SEAL:]) if text[:SEAL] == seal(key, text[SEAL:]) else None
        except self._error:
            return None

    def _texts(self, table: str, keys: Sequence[str]) -> list[tuple[Any, Any]]:
        if self._database is None:
            return []
        places = ",".join("?" * len(keys))
        try:
            return self._database.execute(f"SELECT key, value FROM {table} WHERE key IN ({places})", keys).fetchall()
        except self._error:
            return []

    def write(self, rows: Mapping[str, Mapping[str, str]], gone: Mapping[str, Iterable[str]]) -> None:
        """Keep ``rows``, by table and key, as :func:`sealed` makes them, and leave out those that are ``gone``; all of it or nothing."""
        if self._database is None:
            return
        try:
            with self._database:
                for table, keys in gone.items():
                    self._database.executemany(f"DELETE FROM {table} WHERE key = ?", [(key,) for key in keys])
                for table, values in rows.items():
                    self._database.executemany(f"INSERT OR REPLACE INTO {table} VALUES (?, ?)", values.items())
        except self._error:
            return

    def close(self) -> None:
        """Close the database."""
        if self._database is not None:
            self._database.close()


def sealed(key: str, value: Any) -> str:
    """The text of a row."""
    text = dump(value)
    return seal(key, text) + text


def dump(value: Any) -> str:
    """As JSON, in as few characters as can be."""
    return json.dumps(value, ensure_ascii=True, separators=(",", ":"))


def with_digest(looks: Sequence[tuple[str, str]]) -> list[Any]:
    """What is kept of what the stamp tells: one digest of all states, and the paths."""
    return [digest_of(looks), [path for path, _ in looks]]


def states_digest(paths: Iterable[str], states: States) -> str:
    """The same of what there is at ``paths`` now."""
    return digest_of((path, states.of(path)) for path in paths)


def digest_of(looks: Iterable[tuple[str, str]]) -> str:
    """Equal for equal states at equal places."""
    text = "\0".join(f"{path}\0{state}" for path, state in looks)
    return hashlib.sha1(text.encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()


def _open(directory: str, name: str) -> sqlite3.Connection:
    import sqlite3

    os.makedirs(directory, mode=0o700, exist_ok=True)
    file = os.path.join(directory, name)
    if os.path.exists(file) and os.path.getsize(file) > LARGEST_DATABASE:
        os.unlink(file)
    if not os.path.exists(file):
        forget_oldest(directory, ".sqlite")
    database = sqlite3.connect(file, timeout=2)
    try:
        for table in TABLES:
            database.execute(f"CREATE TABLE IF NOT EXISTS {table} (key TEXT PRIMARY KEY, value TEXT)")
    except sqlite3.DatabaseError as error:
        database.close()
        if isinstance(error, sqlite3.OperationalError):
            raise
        os.unlink(file)  # it is no database (any more)
        raise
    os.utime(file)
    return database


def forget_oldest(directory: str, end: str) -> None:
    """Make room for one more file whose name has this ``end``. Raises OSError."""
    files = [entry for entry in os.scandir(directory) if entry.name.endswith(end) and entry.is_file(follow_symlinks=False)]
    files.sort(key=lambda entry: (entry.stat().st_mtime, entry.name), reverse=True)
    for entry in files[MOST_DATABASES - 1 :]:
        os.unlink(entry.path)
