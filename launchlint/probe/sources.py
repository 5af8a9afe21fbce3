"""The source code to probe: repositories fetched with git, local checkouts read from disk; both end as members of one tar archive.

A repository is never checked out on this machine: git fetches objects into a bare repository in the cache and packs a commit's tree as a
tar stream. So no hook, filter, submodule or link of it has anything to act on.
"""

from __future__ import annotations

import hashlib
import io
import os
import re
import stat
import subprocess
import tarfile
from collections.abc import Collection, Iterator, Sequence

from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.probe.configuration import Repository
from launchlint.probe.words import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO, Any

LARGEST_FILE = 256 * 2**20
LARGEST_TREE = 4 * 2**30
"""Bytes of all files of one repository."""
MOST_FILES = 300_000
PATIENCE = 1800
"""Seconds for one git command."""

_NOT_SOURCE = frozenset((".git", ".hg", ".svn", ".tox", ".venv", "node_modules", "__pycache__"))
_BUILT = frozenset(("build", "devel", "install", "logs", "log"))
"""What catkin leaves at the top of a workspace."""


class Tree(NamedTuple):
    """A source tree: the directory it gets below the workspace, where it is from, its commit, and a tar file or a local directory with
    it.
    """

    name: str
    url: str
    ref: str
    commit: str
    archive: str
    directory: str


def fetch(repository: Repository, cache: str) -> Tree:
    """Fetch a repository at its ref into the cache.

    Raises:
        UsageError: git is missing, or cannot fetch it; the message says what git said.
    """
    digest = hashlib.sha256(repository.url.encode()).hexdigest()[:24]
    bare = os.path.join(cache, "repositories", digest)
    os.makedirs(bare, exist_ok=True)
    if not os.path.isdir(os.path.join(bare, "objects")):
        _git(["init", "--quiet", "--bare", bare], f"{repository.url}: git cannot make a repository in the cache")
    commit = _known_commit(bare, repository.ref)
    if commit is None:
        _git(
            [
                "-C",
                bare,
                "fetch",
                "--quiet",
                "--no-tags",
                "--no-recurse-submodules",
                "--depth=1",
                "--",
                repository.url,
                f"+{repository.ref}:refs/launchlint/wanted",
            ],
            f"{repository.url}: git cannot fetch {repository.ref!r}",
        )
        commit = _git(
            ["-C", bare, "rev-parse", "--verify", "refs/launchlint/wanted^{commit}"], f"{repository.url}: {repository.ref!r} is no commit"
        ).strip()
    archive = os.path.join(bare, f"{commit}.tar")
    if not os.path.isfile(archive):
        temporary = f"{archive}.{os.getpid()}.tmp"
        try:
            _git(["-C", bare, "archive", "--format=tar", f"--output={temporary}", commit], f"{repository.url}: git cannot pack {commit}")
            os.replace(temporary, archive)
        finally:
            if os.path.exists(temporary):
                os.unlink(temporary)
    name = re.sub(r"[^A-Za-z0-9_.-]", "_", repository.url.rstrip("/").rpartition("/")[2].removesuffix(".git")).lstrip(".-") or "repository"
    return Tree(f"{name}-{digest[:8]}", repository.url, repository.ref, commit, archive, "")


def _known_commit(bare: str, ref: str) -> str | None:
    """A full commit id that was fetched before needs no network."""
    if len(ref) != 40 or set(ref) - set("0123456789abcdef"):
        return None
    done = _run_git(["-C", bare, "cat-file", "-e", f"{ref}^{{commit}}"])
    return ref if done.returncode == 0 else None


def local(path: str, taken: Collection[str] = ()) -> Tree:
    """A local checkout as it is, uncommitted changes included, under a name that is not ``taken``."""
    done = _run_git(["-C", path, "rev-parse", "--verify", "--quiet", "HEAD^{commit}"])
    commit = done.stdout.decode("ascii", "replace").strip() if done.returncode == 0 else ""
    plain_name = re.sub(r"[^A-Za-z0-9_.-]", "_", os.path.basename(path)).lstrip(".-") or "checkout"
    name, number = plain_name, 2
    while name in taken:
        name, number = f"{plain_name}-{number}", number + 1
    return Tree(name, "", "", commit, "", path)


def _run_git(words: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
    environment = {
        **os.environ,
        "GIT_TERMINAL_PROMPT": "0",
        "GIT_OPTIONAL_LOCKS": "0",
        "GIT_LFS_SKIP_SMUDGE": "1",
        "GIT_ALLOW_PROTOCOL": "https:http:ssh:git:file",
        "LC_ALL": "C",
    }
    safe = ["-c", "core.hooksPath=/dev/null", "-c", "safe.directory=*"]
    try:
        return subprocess.run(
            ["git", *safe, *words], capture_output=True, stdin=subprocess.DEVNULL, check=False, env=environment, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        raise UsageError(f"git {words[-1]}: it did not end within {PATIENCE // 60} minutes") from None
    except OSError as error:
        raise UsageError(
            f"git cannot be run: {error.strerror or error}; install git to probe repositories, or name local checkouts by `path`"
        ) from None


def _git(words: Sequence[str], failure: str) -> str:
    done = _run_git(words)
    if done.returncode:
        raise UsageError(f"{failure}: {plain(done.stderr.decode('utf-8', 'replace')) or 'it says nothing more'}")
    return done.stdout.decode("utf-8", "replace")


class Member(NamedTuple):
    """A file or link of a source tree, its path within it, and whether it is a program."""

    path: str
    size: int
    runs: bool
    link: str
    source: Any


def members(tree: Tree) -> Iterator[Member]:
    """The files of a tree, in order. What leads out of it, and what is neither a file nor a link, is left out.

    Raises:
        UsageError: it is larger than a source tree can be, or cannot be read.
    """
    count, total = 0, 0
    for member in _of_archive(tree.archive) if tree.archive else _of_directory(tree.directory):
        count, total = count + 1, total + member.size
        if count > MOST_FILES or total > LARGEST_TREE:
            raise UsageError(
                f"{plain(tree.url or tree.directory)}: this is more than {MOST_FILES} files or {LARGEST_TREE // 2**30} GiB of source code"
            )
        yield member


def _of_archive(path: str) -> Iterator[Member]:
    with tarfile.open(path) as archive:
        for info in archive:
            if not _stays_inside(info.name) or info.size > LARGEST_FILE:
                continue
            if info.issym():
                if _stays_inside(os.path.join(os.path.dirname(info.name), info.linkname)):
                    yield Member(info.name, 0, False, info.linkname, None)
            elif info.isfile():
                yield Member(info.name, info.size, bool(info.mode & 0o100), "", archive.extractfile(info))


def _of_directory(top: str) -> Iterator[Member]:
    for directory, inner, files in os.walk(top):
        is_top = directory == top
        inner[:] = sorted(name for name in inner if name not in _NOT_SOURCE and not (is_top and name in _BUILT))
        for name in sorted([*files, *(each for each in inner if os.path.islink(os.path.join(directory, each)))]):
            path = os.path.join(directory, name)
            inside = os.path.relpath(path, top)
            try:
                status = os.lstat(path)
                if stat.S_ISLNK(status.st_mode):
                    goal = os.readlink(path)
                    if _stays_inside(os.path.join(os.path.dirname(inside), goal)):
                        yield Member(inside, 0, False, goal, None)
                elif stat.S_ISREG(status.st_mode) and status.st_size <= LARGEST_FILE:
                    with open(path, "rb") as file:
                        yield Member(inside, status.st_size, bool(status.st_mode & 0o100), "", file)
            except OSError as error:
                raise UsageError(f"{plain(path)}: it cannot be read: {error.strerror or error}") from None


def _stays_inside(path: str) -> bool:
    """Whether a relative path stays in its tree."""
    normal = os.path.normpath(path)
    return not os.path.isabs(path) and normal != ".." and not normal.startswith("../") and "\0" not in path and "\n" not in path


def put(archive: tarfile.TarFile, path: str, data: bytes | IO[bytes], size: int, *, runs: bool = False) -> None:
    """Add a file to an archive, always in the same way, so that the same files are the same layer of an image."""
    info = tarfile.TarInfo(path)
    info.size = size
    info.mode = 0o755 if runs else 0o644
    archive.addfile(info, io.BytesIO(data) if isinstance(data, bytes) else data)


def put_link(archive: tarfile.TarFile, path: str, goal: str) -> None:
    """Add a symbolic link to an archive."""
    info = tarfile.TarInfo(path)
    info.type = tarfile.SYMTYPE
    info.linkname = goal
    archive.addfile(info)
