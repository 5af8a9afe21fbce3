"""Results of earlier runs, used again where nothing they depend on has changed.

An entry's result depends on launchlint's version, the options, the names of the files of the workspaces and what their manifests and build files say (all in
the name of the database), and on the content of every file that was looked at and the value of every environment variable (checked
for each result). Modification times play no part, so that the cache holds across fresh checkouts.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from launchlint import __version__
from launchlint.check.codec import entry_from_json, entry_to_json, file_from_json, file_to_json
from launchlint.check.entry import EntryResult
from launchlint.check.file import FileResult
from launchlint.check.options import EntryRequest, Options
from launchlint.evaluate.session import Session

if TYPE_CHECKING:
    import sqlite3

FORMAT = 1
MOST_FILES = 300_000
CONTENT_COUNTS = ("package.xml", "manifest.xml", "CMakeLists.txt", "CATKIN_IGNORE", "rospack_nosubdirs", ".catkin")
LAUNCH_ENDS = (".launch", ".test", ".xml", ".yaml", ".yml")


class Cache:
    """The database for one set of options and workspaces. Whatever goes wrong with it, the check goes on without."""

    def __init__(self, directory: str, options: Options) -> None:
        self.file = os.path.join(directory, f"{_fingerprint(options)}.sqlite")
        self.variables = options.variables
        self._database: sqlite3.Connection | None = None
        try:
            self._database = self._open(directory)
        except (OSError, self._error()):
            self._database = None

    @staticmethod
    def _error() -> type[Exception]:
        import sqlite3

        return sqlite3.Error

    def _open(self, directory: str) -> sqlite3.Connection:
        import sqlite3

        os.makedirs(directory, mode=0o700, exist_ok=True)
        database = sqlite3.connect(self.file, timeout=2)
        database.execute("CREATE TABLE IF NOT EXISTS entries (key TEXT PRIMARY KEY, value TEXT)")
        database.execute("CREATE TABLE IF NOT EXISTS files (path TEXT PRIMARY KEY, digest TEXT, value TEXT)")
        return database

    def look_up(self, requests: Sequence[EntryRequest], session: Session) -> list[EntryResult | None]:
        """For each request its result, where it is known and still true."""
        if self._database is None:
            return [None] * len(requests)
        try:
            rows = dict(self._database.execute("SELECT key, value FROM entries"))
            files = self._files(session)
        except self._error():
            return [None] * len(requests)
        return [self._known(rows.get(_key(request)), request, files, session) for request in requests]

    def _files(self, session: Session) -> dict[str, FileResult]:
        assert self._database is not None
        files: dict[str, FileResult] = {}
        for path, digest, value in self._database.execute("SELECT path, digest, value FROM files"):
            if session.read(os.path.join(session.root, path)).digest == digest:
                try:
                    files[path] = file_from_json(json.loads(value))
                except (ValueError, TypeError, KeyError):
                    continue
        return files

    def _known(self, row: str | None, request: EntryRequest, files: dict[str, FileResult], session: Session) -> EntryResult | None:
        if row is None:
            return None
        try:
            result = entry_from_json(json.loads(row), request, files)
        except (ValueError, TypeError, KeyError):
            return None
        if any(self.variables.get(name) != value for name, value in result.variables):
            return None
        if any(session.read(path).digest != digest for path, digest in result.dependencies):
            return None
        return result

    def store(self, results: Iterable[EntryResult], session: Session) -> None:
        """Keep the results of this run."""
        if self._database is None:
            return
        try:
            with self._database:
                seen: set[str] = set()
                for result in results:
                    self._database.execute("INSERT OR REPLACE INTO entries VALUES (?, ?)", (_key(result.request), _dump(entry_to_json(result))))
                    for file in result.files:
                        if file.path not in seen:
                            seen.add(file.path)
                            digest = session.read(os.path.join(session.root, file.path)).digest
                            self._database.execute("INSERT OR REPLACE INTO files VALUES (?, ?, ?)", (file.path, digest, _dump(file_to_json(file))))
        except (OSError, ValueError, self._error()):
            return

    def close(self) -> None:
        """Close the database."""
        if self._database is not None:
            self._database.close()


def _key(request: EntryRequest) -> str:
    return _dump([request.file, request.at, request.arguments, request.declared])


def _dump(value: Any) -> str:
    return json.dumps(value, ensure_ascii=True, separators=(",", ":"))


def _fingerprint(options: Options) -> str:
    """Of everything that may change any result and is not a file some entry reads."""
    settings = [
        FORMAT, __version__, sorted(options.rules), options.workspaces, options.explicit, options.root, options.complete, options.default_only,
        [options.variables.get(name) for name in ("ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", "ROS_DISTRO", "ROS_NAMESPACE")],
    ]  # fmt: skip
    digest = hashlib.sha256(_dump(settings).encode())
    for workspace in options.workspaces:
        for line in _listing(workspace):
            digest.update(line.encode("utf-8", "surrogateescape"))
    return digest.hexdigest()[:40]


def _listing(workspace: str) -> Iterator[str]:
    """One line for each file of a workspace: its path, whether it may be executed, and what packages and rules read of it."""
    count = 0
    for directory, directories, files in os.walk(workspace, followlinks=False):
        directories[:] = sorted(name for name in directories if name != ".git")
        for name in sorted(files):
            count += 1
            if count > MOST_FILES:
                return
            path = os.path.join(directory, name)
            yield f"{path}\0{_facts(path, name)}\n"


def _facts(path: str, name: str) -> str:
    if name in CONTENT_COUNTS:
        try:
            with open(path, "rb") as file:
                return hashlib.sha1(file.read(1 << 22), usedforsecurity=False).hexdigest()
        except OSError:
            return "unreadable"
    if name.endswith(LAUNCH_ENDS):
        return ""
    try:
        executable = bool(os.stat(path).st_mode & stat.S_IXUSR)
        with open(path, "rb") as file:
            return f"{executable} {file.read(2)!r}"
    except OSError:
        return "unreadable"
