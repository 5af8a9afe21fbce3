"""The launch files that git would commit: those of its index, with the content that is staged.

Files that git does not know are none of them, so that a copy somebody keeps beside the real file cannot clash with it.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Sequence

from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.discovery import is_launch_content, may_be_launch_file
from launchlint.workspace.git import FILE_MODES, contents, git, reason
from launchlint.workspace.listing import may_be_source
from launchlint.workspace.patterns import matches_any
from launchlint.workspace.revision import index_of

_LARGEST_FILE = 64 << 20
_STAGES = ("0", "2", "3")
"""Of an index: merged; of a file in conflict, our side and theirs."""


class Staged(NamedTuple):
    """Launch files by path, sorted, and the ``content`` of those whose working copy is another (or gone), by absolute path."""

    files: tuple[str, ...]
    content: dict[str, bytes]


def staged(repository: str, paths: Sequence[str], exclude: Sequence[str] = (), base: str | None = None) -> Staged:
    """The launch files of the index of the repository at the directory ``repository``, as :func:`discovery.discover` tells them.

    Args:
        repository: its top directory.
        paths: files and directories; what is elsewhere is left out.
        exclude: patterns of files and directories to leave out.
        base: the directory that patterns are relative to; the current directory where not given.

    Raises:
        UsageError: it is no repository, or git fails.
    """
    root = os.path.realpath(repository)
    if not os.path.exists(os.path.join(root, ".git")):
        raise UsageError(f"{repository} is not in a git repository: nothing is staged there")
    listed = git(root, ["ls-files", "--cached", "--stage", "-z"], index_of(root))
    if listed.returncode:
        raise UsageError(f"git cannot list the files that are staged in {repository}: {reason(listed.stderr)}")
    wanted = [os.path.realpath(path) for path in paths]
    directory = os.path.abspath(base or os.curdir)
    here = os.path.realpath(os.curdir)
    candidates: list[tuple[str, str, bytes | None]] = []
    for name, object_ in _entries(listed.stdout):
        if not may_be_launch_file(name):
            continue
        path = os.path.join(root, name)
        if not any(path == each or path.startswith(each.rstrip("/") + "/") for each in wanted):
            continue
        shown = os.path.relpath(path, here)
        hidden = any(part.startswith(".") for part in name.split("/")[:-1])
        if path not in wanted and (hidden or (exclude and matches_any(exclude, os.path.relpath(os.path.abspath(shown), directory)))):
            continue
        candidates.append((shown, object_, _working_copy(path, object_)))
    stored = iter([*contents(root, [object_ for _, object_, copy in candidates if copy is None])])
    files: list[str] = []
    other: dict[str, bytes] = {}
    for shown, _, copy in candidates:
        content = next(stored) if copy is None else copy
        if is_launch_content(shown, content):
            files.append(shown)
            if copy is None:
                other[os.path.abspath(shown)] = content
    return Staged(tuple(sorted(files)), other)


def has_other_sources(repository: str) -> bool:
    """Whether what nodes are read from is another in the working tree than git would commit: changed there, gone, or not known to git.

    Raises:
        UsageError: git fails.
    """
    root = os.path.realpath(repository)
    index = index_of(root)
    for words in (["diff-files", "--name-only", "-z"], ["ls-files", "--others", "--exclude-standard", "-z"]):
        listed = git(root, words, index)
        if listed.returncode:
            raise UsageError(f"git cannot compare {repository} with what is staged: {reason(listed.stderr)}")
        if any(may_be_source(os.fsdecode(name)) for name in listed.stdout.split(b"\0") if name):
            return True
    return False


def _entries(listing: bytes) -> Iterator[tuple[str, str]]:
    """Path and object of each regular file; of a file in conflict, our side of it."""
    seen = ""
    for line in listing.split(b"\0"):
        facts, _, path = line.partition(b"\t")
        words = facts.decode("ascii", "replace").split()
        if len(words) != 3 or words[0] not in FILE_MODES or words[2] not in _STAGES:
            continue
        name = os.fsdecode(path)
        if name != seen:
            seen = name
            yield name, words[1]


def _working_copy(path: str, object_: str) -> bytes | None:
    """What is in the file at ``path``, where that is what git holds as ``object_``; else None."""
    try:
        if os.path.islink(path) or os.path.getsize(path) > _LARGEST_FILE:
            return None
        with open(path, "rb") as file:
            content = file.read()
    except OSError:
        return None
    digest = hashlib.sha1(usedforsecurity=False) if len(object_) == 40 else hashlib.sha256()
    digest.update(b"blob %d\0" % len(content))
    digest.update(content)
    return content if digest.hexdigest() == object_ else None
