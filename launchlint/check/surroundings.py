"""What results may hang on beside the launch files: settings, launchlint itself, packages, and which files there are.

All hang on the settings, and on what lies outside of the workspaces; where somebody looks inside of them, it is noted. Modification times
play no part, so that the cache holds across fresh checkouts. Launch files and parameter files count by their names only: each result says
which of them it was made from.
"""

from __future__ import annotations

import hashlib
import os
import stat
import time
from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Any

from launchlint.check.options import Options
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.contents import Contents
from launchlint.workspace.listing import MOST_FILES as MOST_TREE_FILES
from launchlint.workspace.looking import ALL_BELOW, PART, directory_state, tree_state
from launchlint.workspace.packages import DEBIAN_CATKIN, Packages
from launchlint.workspace.place import Place
from launchlint.workspace.repository import LONGEST_PATH
from launchlint.workspace.source_lists import is_source_list

FORMAT = 14
"""Of what the cache keeps; another one makes a new cache."""
MOST_FILES = 300_000
"""With more files than this there is no cache: to look at all of them would take longer than the check."""
LARGEST_READ = 1 << 20
"""Bytes: no more of a manifest, build file or plugin description is read by any room (launchlint.workspace.reading)."""
CONTENT_NAMES = frozenset(("CMakeLists.txt", ".catkin"))
CONTENT_ENDS = (".cmake", ".xml")
ENTRY_ENDS = (".launch.xml",)
VARIABLES = ("ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", "ROS_DISTRO", "ROS_VERSION")
_ALL_BELOW = os.sep + ALL_BELOW


class _TooMany(Exception):
    """There are more than :data:`MOST_FILES` files."""


class _Inside(NamedTuple):
    """What a directory was seen to hold: a file with its mode bits, 0 where it is none; ``mode`` is None for a directory."""

    name: str
    mode: int | None
    is_link: bool


class Surroundings:
    """What was there. ``name`` is equal for equal settings and equal surroundings of the workspaces, in hexadecimal; None where there are
    too many files to tell. ``stamp`` is equal where what is in the workspaces is equal, too.

    ``held`` says what files hold, and is told of every file that was met; ``code`` is launchlint itself (:mod:`.own_code`).
    """

    def __init__(self, options: Options, packages: Packages, held: Contents, code: str) -> None:
        self._held = held
        self._inside: dict[str, list[_Inside]] = {}
        self._trees: dict[str, str] = {}
        self._listings: dict[str, tuple[str, ...]] = {}
        self._names: dict[str, frozenset[str]] = {}
        self._files: dict[str, None] = {}
        self._links: list[str] = []
        self._missing: dict[str, bool] = {}
        self._contents: dict[str, str] = {}
        self._said: dict[tuple[str, str], bool] = {}
        self._begin = time.time_ns()
        self.name, self.stamp = self._digests(options, packages, code)

    def say(self, path: str, state: str) -> bool:
        """Whether name and stamp already say that this is the state (:func:`launchlint.workspace.looking.state`) of an absolute path."""
        key = path, state
        known = self._said.get(key)
        if known is None:
            known = self._said[key] = self._says(path, state)
        return known

    def state(self, path: str) -> str | None:
        """The state of an absolute path, where it was met: a directory or all below, a small file, or that nothing is there; else None."""
        if path.endswith(_ALL_BELOW):
            return self._tree_state(path.removesuffix(_ALL_BELOW)) or None
        if path in self._listings:
            return directory_state(self._listings[path])
        if self._is_missing(path):
            return ""
        digest = self._held.sha1(path, LARGEST_READ)
        return None if digest is None else f"file {digest}"

    def has_met(self, path: str) -> bool:
        """Whether :attr:`all_files` tells what there is at an absolute path."""
        file = path.partition(PART)[0]
        if file.endswith(_ALL_BELOW):
            return bool(self._tree_state(file.removesuffix(_ALL_BELOW)))
        return file in self._files or file in self._listings or self._is_missing(file)

    def are_as_met(self, paths: Iterable[str]) -> bool:
        """Whether those of absolute paths that were met as files are now what they were then, by what ``stat`` says."""
        return all(self._held.is_as_seen(path) for path in paths if path in self._files)

    @cached_property
    def recent(self) -> frozenset[str]:
        """The files that were met and may change so that ``stat`` does not tell."""
        return frozenset(path for path in self._files if not self._held.tells(path, self._begin))

    @cached_property
    def all_files(self) -> str:
        """Equal where all that was met is as it was, by what ``stat`` says of each file."""
        found = hashlib.sha256(f"{self.name} {self.stamp}".encode())
        found.update("\n".join(f"{path}\0{self._held.mark(path)}" for path in self._files).encode("utf-8", "surrogateescape"))
        return found.hexdigest()

    def _says(self, path: str, state: str) -> bool:
        if path.endswith(_ALL_BELOW):
            return bool(state) and state == self._tree_state(path.removesuffix(_ALL_BELOW))
        if not state:
            return self._is_missing(path)
        if path in self._listings:
            return state == directory_state(self._listings[path])
        return path in self._contents and state == f"file {self._contents[path]}"

    def _is_missing(self, path: str) -> bool:
        """Whether nothing is at ``path``: its name is not in a directory that was met, or it would be below a file or below nothing."""
        known = self._missing.get(path)
        if known is None:
            known = self._missing[path] = len(path) <= LONGEST_PATH and self._leads_nowhere(path)
        return known

    def _leads_nowhere(self, path: str) -> bool:
        while True:
            directory, _, name = path.rpartition(os.sep)
            names = self._names.get(directory)
            if names is not None:
                return name not in names
            if not directory or directory in self._files:
                return bool(directory)
            path = directory

    def _tree_state(self, directory: str) -> str:
        """The state of all files below a directory; empty where links to directories, or something not met, are among them."""
        if directory not in self._trees:
            files = self._files_below(directory)
            self._trees[directory] = "" if files is None else tree_state(files, complete=True)
        return self._trees[directory]

    def _files_below(self, directory: str) -> dict[str, int] | None:
        """As :func:`launchlint.workspace.listing.files_of` lists them."""
        files: dict[str, int] = {}
        waiting = [""]
        while waiting:
            relative = waiting.pop()
            inside = self._inside.get(f"{directory}/{relative}".rstrip("/"))
            if inside is None or len(files) > MOST_TREE_FILES:
                return None
            start = f"{relative}/" if relative else ""
            files.update((start + each.name, each.mode) for each in inside if each.mode is not None)
            below = [each for each in inside if each.mode is None and each.name[0] != "."]
            if any(each.is_link for each in below):
                return None
            waiting += [start + each.name for each in reversed(below)]
        return files

    def _digests(self, options: Options, packages: Packages, code: str) -> tuple[str | None, str]:
        found, within = hashlib.sha256(_settings(options, code).encode("utf-8", "surrogateescape")), hashlib.sha256()
        for library in options.library:
            found.update(self._content(library).encode())
        seen: set[tuple[int, int]] = set()
        left = [MOST_FILES]
        try:
            for line in self._within(packages, seen, left):
                within.update(line.encode("utf-8", "surrogateescape"))
            for line in (*self._links, *self._outside(packages, seen, left)):
                found.update(line.encode("utf-8", "surrogateescape"))
        except _TooMany:
            return None, ""
        return found.hexdigest()[:40], within.hexdigest()[:40]

    def _within(self, packages: Packages, seen: set[tuple[int, int]], left: list[int]) -> Iterator[str]:
        """One line for each file of the workspaces, and for each package that was found in them."""
        for workspace in packages.workspaces:
            yield from self._tree(workspace, seen, left)
        for each in (packages, packages.colcon):
            for place in each.places[: len(each.workspaces)]:
                yield from _lines_of(place)
                for package in place.everything:
                    yield from self._tree(package.directory, seen, left)

    def _outside(self, packages: Packages, seen: set[tuple[int, int]], left: list[int]) -> Iterator[str]:
        """One line for each file of packages elsewhere, and of what is built or installed of all packages."""
        for each in (packages, packages.colcon):
            for place in each.places[len(each.workspaces) :]:
                yield from _lines_of(place)
                for package in place.everything:
                    yield from self._tree(package.directory, seen, left)
        prefixes = list(dict.fromkeys(prefix.path for each in (packages, packages.colcon) for prefix in each.prefixes))
        if os.path.isdir(DEBIAN_CATKIN):
            prefixes.append("/usr")
        for prefix in packages.prefixes:
            yield f"{prefix.path}\0{prefix.is_catkin}\0{prefix.is_ros}\0{prefix.sources()}\n"
        for name in sorted({*packages.names(), *packages.colcon.names()}):
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
            names = tuple(entry.name for entry in entries)
            self._listings[directory], self._names[directory] = names, frozenset(names)
            inside = self._inside[directory] = []
            yield from self._entries(entries, waiting, seen, inside)

    def _entries(
        self, entries: Iterable[os.DirEntry[str]], waiting: list[str], seen: set[tuple[int, int]], inside: list[_Inside]
    ) -> Iterator[str]:
        for entry in entries:
            name = entry.name
            target = content = ""
            try:
                if entry.is_symlink():
                    target = os.readlink(entry.path)
                    self._links.append(f"{entry.path}\0{target}\n")
                status = entry.stat()
            except OSError as error:
                inside.append(_Inside(name, 0 if isinstance(error, FileNotFoundError) else None, True))
                yield f"{name}\0{target}\0{error.errno}\n"
                continue
            if stat.S_ISDIR(status.st_mode):
                inside.append(_Inside(name, None, bool(target)))
                yield f"{name}/\0{target}\n"
                if name[0] != "." and _is_new(status, seen):
                    waiting.append(entry.path)
            else:
                inside.append(_Inside(name, status.st_mode if stat.S_ISREG(status.st_mode) else 0, bool(target)))
                self._held.seen(entry.path, status)
                self._files[entry.path] = None
                if _counts(name):
                    content = self._contents[entry.path] = self._content(entry.path)
                yield f"{name}\0{target}\0{status.st_mode}\0{content}\n"

    def _content(self, path: str) -> str:
        """A digest of a small file, or why there is none."""
        digest = self._held.sha1(path, LARGEST_READ)
        if digest is not None:
            return digest
        from launchlint.workspace.reading import read_bytes

        try:
            return hashlib.sha1(read_bytes(path, LARGEST_READ), usedforsecurity=False).hexdigest()
        except OSError as error:
            return str(error)


def _lines_of(place: Place) -> Iterator[str]:
    yield f"{place.root}\0{place.way.name}\n"
    for package in place.everything:
        yield f"{package.name}\0{package.directory}\0{package.broken}\n"


def _settings(options: Options, code: str) -> str:
    settings: list[Any] = [
        FORMAT, code, sorted(options.rules), options.workspaces, options.explicit, options.root, options.complete,
        options.default_only, options.style, options.extract, options.distro, [options.variables.get(name) for name in VARIABLES],
        user(),
    ]  # fmt: skip
    return repr(settings)


def user() -> int | None:
    """Who looks: another one may be able to read other files."""
    return os.geteuid() if hasattr(os, "geteuid") else None


def _counts(name: str) -> bool:
    return name in CONTENT_NAMES or (name.endswith(CONTENT_ENDS) and not name.endswith(ENTRY_ENDS)) or is_source_list(name)


def _is_new(status: os.stat_result, seen: set[tuple[int, int]]) -> bool:
    key = (status.st_dev, status.st_ino)
    if key in seen:
        return False
    seen.add(key)
    return True
