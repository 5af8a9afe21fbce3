"""The public repositories that the bundled library is read from: the list, and their files at one commit."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path
from shutil import copy
from typing import NamedTuple

import yaml

from launchlint.errors import UsageError
from launchlint.model import ROS1, DialectName
from launchlint.probe.configuration import Repository
from launchlint.probe.sources import Tree, fetch, members

LARGEST = 1 << 20
"""Larger files are no source code that could be read."""


class Wanted(NamedTuple):
    """A line of the list: a repository and commit, the packages to take besides those of the public index, what to leave out, and the
    repositories (``owner/name``) whose headers, base classes, modules and CMake commands it uses; and the file that its own build
    script makes ``package.xml`` of, where there is none.
    """

    name: str
    commit: str
    packages: tuple[str, ...]
    skip: frozenset[str]
    beside: tuple[str, ...]
    middleware: DialectName = ROS1
    manifest: str = ""

    @property
    def id(self) -> str:
        """How evidence names it: ``owner/name@commit``."""
        return f"{self.name}@{self.commit[:12]}"

    @property
    def address(self) -> str:
        """Where git finds it."""
        return f"https://github.com/{self.name}"


class Place(NamedTuple):
    """Where repositories are from: clones (``checkouts/owner/name``), or the network with a directory for what was fetched."""

    checkouts: Path | None
    cache: str


def read_list(path: Path, middleware: DialectName = ROS1) -> dict[str, Wanted]:
    """The repositories of the list, all of one middleware, by name, in its order: of a program that several have, the first one counts.

    One that is listed in several versions has ``@`` and a word behind its name in all lines but one.

    Raises:
        UsageError: a repository is to be read beside one that the list does not have.
    """
    document = yaml.load(path.read_text(encoding="utf-8"), Loader=yaml.BaseLoader)  # a commit may look like a number
    listed = {
        name: Wanted(
            name.partition("@")[0],
            entry["commit"],
            tuple(entry.get("packages", ())),
            frozenset(entry.get("skip", ())),
            tuple(entry.get("beside", ())),
            middleware,
            entry.get("manifest", ""),
        )
        for name, entry in (document or {}).items()
    }
    for each in listed.values():
        for other in each.beside:
            if other not in listed:
                raise UsageError(f"{path}: {each.name} is read beside {other}, which is not in the list")
    return listed


def unpack(wanted: Wanted, place: Place, directory: Path) -> None:
    """Write the files of a repository at its commit into ``directory``."""
    if place.checkouts is None:
        files = files_of_tree(fetch(Repository(wanted.address, wanted.commit), place.cache))
    else:
        files = files_of_clone(place.checkouts / wanted.name, wanted.commit)
    for path, runs, data in files:
        target = directory / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
        target.chmod(0o755 if runs else 0o644)
    if wanted.manifest:
        copy(directory / wanted.manifest, directory / wanted.manifest.rpartition("/")[0] / "package.xml")


def files_of_tree(tree: Tree) -> Iterator[tuple[str, bool, bytes]]:
    """Path, whether it is a program, and content of the files that were fetched."""
    for member in members(tree):
        if member.source is not None:
            data = member.source.read(LARGEST + 1)
            if len(data) <= LARGEST:
                yield member.path, member.runs, data


def files_of_clone(clone: Path, commit: str) -> Iterator[tuple[str, bool, bytes]]:
    """The same of a commit in a clone. Files that a partial clone lacks are left out."""
    git = ["git", "-c", "safe.directory=*", "-C", str(clone)]
    listed = subprocess.run([*git, "ls-tree", "-r", "-l", "-z", commit], capture_output=True, check=False)
    if listed.returncode:
        raise UsageError(f"{clone}: there is no commit {commit}")
    with subprocess.Popen([*git, "cat-file", "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as reading:
        if reading.stdin is None or reading.stdout is None:
            raise AssertionError("pipes were asked for")
        for line in listed.stdout.decode("utf-8", "surrogateescape").split("\0")[:-1]:
            (mode, kind, name, size), path = line.partition("\t")[0].split(), line.partition("\t")[2]
            if kind != "blob" or mode == "120000" or not size.isdigit() or int(size) > LARGEST:
                continue
            reading.stdin.write(f"{name}\n".encode())
            reading.stdin.flush()
            head = reading.stdout.readline().split()
            if head[-1:] != [b"missing"]:
                data = reading.stdout.read(int(head[2]))
                reading.stdout.readline()
                yield path, mode == "100755", data
