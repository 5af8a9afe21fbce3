"""What any result may hang on beside the launch files: settings, launchlint itself, packages, and which files there are.

Modification times play no part, so that the cache holds across fresh checkouts. Launch files and parameter files count by their names only:
each result says which of them it was made from.
"""

from __future__ import annotations

import hashlib
import os
import stat
import sys
from collections.abc import Iterable, Iterator
from typing import Any

from launchlint import __version__
from launchlint.check.options import Options
from launchlint.workspace.looking import directory_state
from launchlint.workspace.packages import DEBIAN_CATKIN, Packages
from launchlint.workspace.source_lists import is_source_list

FORMAT = 10
"""Of what the cache keeps; another one makes a new cache."""
MOST_FILES = 300_000
"""With more files than this there is no cache: to look at all of them would take longer than the check."""
LARGEST_READ = 1 << 20
"""Bytes: no more of a manifest, build file or plugin description is read by any room (launchlint.workspace.reading)."""
CONTENT_NAMES = frozenset(("CMakeLists.txt", ".catkin"))
CONTENT_ENDS = (".cmake", ".xml")
ENTRY_ENDS = (".launch.xml",)
VARIABLES = ("ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", "ROS_DISTRO", "ROS_VERSION")


class _TooMany(Exception):
    """There are more than :data:`MOST_FILES` files."""


class Surroundings:
    """What was there. ``name`` is equal for equal surroundings, in hexadecimal; None where there are too many files to tell."""

    def __init__(self, options: Options, packages: Packages) -> None:
        self._listings: dict[str, tuple[str, ...]] = {}
        self._contents: dict[str, str] = {}
        self._said: dict[tuple[str, str], bool] = {}
        self.name = self._digest(options, packages)

    def say(self, path: str, state: str) -> bool:
        """Whether the name already says that this is the state (:func:`launchlint.workspace.looking.state`) of an absolute path."""
        key = path, state
        known = self._said.get(key)
        if known is None:
            known = self._said[key] = self._says(path, state)
        return known

    def _says(self, path: str, state: str) -> bool:
        if not state:
            directory, _, name = path.rpartition(os.sep)
            return directory in self._listings and name not in self._listings[directory]
        if path in self._listings:
            return state == directory_state(self._listings[path])
        return path in self._contents and state == f"file {self._contents[path]}"

    def _digest(self, options: Options, packages: Packages) -> str | None:
        found = hashlib.sha256(_settings(options).encode("utf-8", "surrogateescape"))
        for library in options.library:
            found.update(_content(library).encode())
        for own in _own_code():
            found.update(own)
        try:
            for line in self._files(packages):
                found.update(line.encode("utf-8", "surrogateescape"))
        except _TooMany:
            return None
        return found.hexdigest()[:40]

    def _files(self, packages: Packages) -> Iterator[str]:
        """One line for each file of the workspaces, of packages elsewhere, and of what is built or installed of all packages."""
        seen: set[tuple[int, int]] = set()
        left = [MOST_FILES]
        for workspace in packages.workspaces:
            yield from self._tree(workspace, seen, left)
        for place in packages.places:
            for package in place.everything:
                yield f"{package.name}\0{package.directory}\0{package.broken}\n"
                yield from self._tree(package.directory, seen, left)
        prefixes = [prefix.path for prefix in packages.prefixes]
        if os.path.isdir(DEBIAN_CATKIN):
            prefixes.append("/usr")
        for prefix in packages.prefixes:
            yield f"{prefix.path}\0{prefix.is_catkin}\0{prefix.is_ros}\0{prefix.sources()}\n"
        for name in packages.names():
            for prefix_path in prefixes:
                for part in ("share", "lib", "libexec"):
                    yield from self._tree(os.path.join(prefix_path, part, name), seen, left)

    def _tree(self, root: str, seen: set[tuple[int, int]], left: list[int]) -> Iterator[str]:
        """All below ``root``, links followed, each directory once; hidden directories are looked into by nobody."""
        try:
            status = os.stat(root)
        except OSError:
            return
        waiting = [root] if stat.S_ISDIR(status.st_mode) and _is_new(status, seen) else []
        while waiting:
            directory = waiting.pop()
            yield f"{directory}\n"
            try:
                with os.scandir(directory) as scan:
                    entries = sorted(scan, key=lambda entry: entry.name)
            except OSError as error:
                yield f"{error.errno}\n"
                continue
            left[0] -= len(entries)
            if left[0] < 0:
                raise _TooMany
            self._listings[directory] = tuple(entry.name for entry in entries)
            yield from self._entries(entries, waiting, seen)

    def _entries(self, entries: Iterable[os.DirEntry[str]], waiting: list[str], seen: set[tuple[int, int]]) -> Iterator[str]:
        for entry in entries:
            name = entry.name
            target = content = ""
            try:
                if entry.is_symlink():
                    target = os.readlink(entry.path)
                status = entry.stat()
            except OSError as error:
                yield f"{name}\0{target}\0{error.errno}\n"
                continue
            if stat.S_ISDIR(status.st_mode):
                yield f"{name}/\0{target}\n"
                if name[0] != "." and _is_new(status, seen):
                    waiting.append(entry.path)
            else:
                if _counts(name):
                    content = self._contents[entry.path] = _content(entry.path)
                yield f"{name}\0{target}\0{status.st_mode}\0{content}\n"


def _settings(options: Options) -> str:
    settings: list[Any] = [
        FORMAT, __version__, sys.version, sorted(options.rules), options.workspaces, options.explicit, options.root, options.complete,
        options.default_only, options.style, options.extract, options.distro, [options.variables.get(name) for name in VARIABLES],
        os.geteuid() if hasattr(os, "geteuid") else None,
    ]  # fmt: skip
    return repr(settings)


def _own_code() -> Iterator[bytes]:
    """The files of launchlint itself, and the one of PyYAML that names its version: a checkout changes without a new version."""
    import launchlint
    from launchlint.knowledge.code import ROOMS, code_digest

    yield code_digest().encode()
    top = os.path.dirname(launchlint.__file__)
    for directory, directories, files in os.walk(top):
        directories[:] = sorted(name for name in directories if name != "__pycache__" and (directory != top or name not in ROOMS))
        for name in sorted(files):
            yield name.encode("utf-8", "surrogateescape")
            yield _content(os.path.join(directory, name)).encode()
    for directory in sys.path:
        yaml = os.path.join(directory, "yaml", "__init__.py")
        if os.path.isfile(yaml):
            yield _content(yaml).encode()
            return


def _counts(name: str) -> bool:
    return name in CONTENT_NAMES or (name.endswith(CONTENT_ENDS) and not name.endswith(ENTRY_ENDS)) or is_source_list(name)


def _is_new(status: os.stat_result, seen: set[tuple[int, int]]) -> bool:
    key = (status.st_dev, status.st_ino)
    if key in seen:
        return False
    seen.add(key)
    return True


def _content(path: str) -> str:
    from launchlint.workspace.reading import read_bytes

    try:
        return hashlib.sha1(read_bytes(path, LARGEST_READ), usedforsecurity=False).hexdigest()
    except OSError as error:
        return str(error)
