"""The files of a git revision, put into a directory: to look at what was before.

Only ``git rev-parse``, ``ls-tree`` and ``cat-file`` are run: they read objects, and run neither hooks nor filters of the repository.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator, Sequence

from launchlint.errors import UsageError

LARGEST_FILE = 4 << 20
"""Bytes; a larger file is made empty: nothing that launchlint reads is so large."""
MOST_FILES = 200_000

_LINK, _FILE = "120000", ("100644", "100755", "100664")


def resolve(repository: str, revision: str) -> str:
    """The commit that ``revision`` names.

    Raises:
        UsageError: there is none, or no git.
    """
    given = f"{revision}^{{commit}}"
    done = _git(repository, ["rev-parse", "--verify", "--quiet", "--end-of-options", given])
    commit = done.stdout.decode("ascii", "replace").strip()
    if done.returncode or not commit:
        reason = " ".join(done.stderr.decode("utf-8", "replace").split()) or "git knows no such commit, branch or tag here"
        raise UsageError(f"{revision!r} is no revision of {repository}: {reason}; in CI, fetch it first (git fetch --depth=1 origin …)")
    return commit


def is_revision(repository: str, revision: str) -> bool:
    """Whether ``revision`` names a commit; False, too, where there is no git."""
    try:
        return bool(resolve(repository, revision))
    except UsageError:
        return False


def unpack(repository: str, revision: str, directory: str) -> None:
    """Write the files of ``revision`` below ``directory``, which is empty. Links that lead out of it are left out, and submodules.

    Raises:
        UsageError: there is no such revision, or git fails.
    """
    commit = resolve(repository, revision)
    listed = _git(repository, ["ls-tree", "-r", "-z", "--long", "--full-tree", commit])
    if listed.returncode:
        raise UsageError(f"git cannot list {revision!r}: {listed.stderr.decode('utf-8', 'replace').strip()}")
    entries = list(_entries(listed.stdout))
    if len(entries) > MOST_FILES:
        raise UsageError(f"{revision!r} has more than {MOST_FILES} files")
    small = [entry for entry in entries if entry[2] <= LARGEST_FILE]
    contents = _contents(repository, [name for _, name, _, _ in small])
    data = dict(zip((path for _, _, _, path in small), contents, strict=True))
    for mode, _, _, path in entries:
        _place(directory, path, mode, data.get(path, b""))


def _entries(listing: bytes) -> Iterator[tuple[str, str, int, str]]:
    """Mode, object, size and path of each file and link."""
    for line in listing.split(b"\0"):
        if not line:
            continue
        facts, _, path = line.partition(b"\t")
        mode, _, name, size = facts.decode("ascii").split()
        if mode in _FILE or mode == _LINK:
            yield mode, name, int(size), os.fsdecode(path)


def _contents(repository: str, names: Sequence[str]) -> Iterator[bytes]:
    """The contents of objects, in order."""
    if not names:
        return
    done = _git(repository, ["cat-file", "--batch"], "".join(f"{name}\n" for name in names).encode())
    output = done.stdout
    at = 0
    for name in names:
        end = output.index(b"\n", at)
        words = output[at:end].split()
        if len(words) != 3:
            raise UsageError(f"git cannot read the object {name}: is this a shallow or partial clone?")
        size = int(words[2])
        yield output[end + 1 : end + 1 + size]
        at = end + 1 + size + 1


def _place(directory: str, path: str, mode: str, data: bytes) -> None:
    parts = path.split("/")
    if ".." in parts or path.startswith("/") or ".git" in (part.lower() for part in parts):
        return
    target = os.path.join(directory, *parts)
    if os.path.realpath(os.path.dirname(target)) != os.path.normpath(os.path.join(os.path.realpath(directory), *parts[:-1])):
        return  # a link stands in the way
    os.makedirs(os.path.dirname(target), exist_ok=True)
    if mode == _LINK:
        goal = os.fsdecode(data)
        inside = os.path.normpath(os.path.join(os.path.dirname(path), goal))
        if not os.path.isabs(goal) and not inside.startswith("..") and "\0" not in goal:
            os.symlink(goal, target)
        return
    with open(target, "wb") as file:
        file.write(data)
    if mode == "100755":
        os.chmod(target, 0o755)


def _git(repository: str, words: Sequence[str], given: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    environment = {**os.environ, "GIT_TERMINAL_PROMPT": "0", "GIT_OPTIONAL_LOCKS": "0", "LC_ALL": "C", "GIT_NO_LAZY_FETCH": "1"}
    try:
        return subprocess.run(
            ["git", "-C", repository, "-c", "core.fsmonitor=false", *words], input=given, capture_output=True, check=False, env=environment
        )
    except OSError as error:
        raise UsageError(f"git cannot be run: {error.strerror or error}; revisions can only be compared where git is installed") from None
