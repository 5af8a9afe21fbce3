"""Asking git about a repository: objects and the index are read; neither hooks nor filters of the repository are run.

Whatever a repository's own configuration says, git talks to no other machine and starts no other program here.
"""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Iterator, Mapping, Sequence

from launchlint.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO

LONGEST_ERROR = 500
FILE_MODES = ("100644", "100755", "100664")
"""How git lists regular files."""
_NOT_OURS = frozenset(
    {"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_OBJECT_DIRECTORY", "GIT_COMMON_DIR", "GIT_NAMESPACE", "GIT_PREFIX"}
)
"""What git tells its hooks: of the repository of the commit, which need not be the one that is looked at."""


def contents(repository: str, names: Sequence[str]) -> Iterator[bytes]:
    """The contents of objects, in order, one at a time."""
    if not names:
        return
    with tempfile.TemporaryFile() as wanted:
        wanted.write("".join(f"{name}\n" for name in names).encode("ascii"))
        wanted.seek(0)
        process = _start(repository, ["cat-file", "--batch"], wanted)
        assert process.stdout is not None
        try:
            for name in names:
                words = process.stdout.readline().split()
                if len(words) != 3 or not words[2].isdigit():
                    raise UsageError(f"git cannot read the object {name}: is this a partial clone? git fetch --refetch gets all of it")
                content = process.stdout.read(int(words[2]))
                process.stdout.read(1)
                yield content
        finally:
            process.stdout.close()
            process.kill()
            process.wait()


def sizes(repository: str, names: Sequence[str]) -> list[int]:
    """The sizes of objects, in order; 0 for one that is not here."""
    if not names:
        return []
    with tempfile.TemporaryFile() as wanted:
        wanted.write("".join(f"{name}\n" for name in names).encode("ascii"))
        wanted.seek(0)
        output, _ = _start(repository, ["cat-file", "--batch-check=%(objectsize)"], wanted).communicate()
    lines = output.splitlines()
    if len(lines) != len(names):
        raise UsageError(f"git cannot tell the sizes of {len(names)} objects of {repository}")
    return [int(line) if line.isdigit() else 0 for line in lines]


def reason(errors: bytes) -> str:
    """What git says, in one line."""
    return " ".join(errors.decode("utf-8", "replace").removeprefix("fatal: ").split())[:LONGEST_ERROR]


def git(repository: str, words: Sequence[str], variables: Mapping[str, str] | None = None) -> subprocess.CompletedProcess[bytes]:
    """Run git in the repository at the directory ``repository`` to its end.

    ``variables`` are further environment variables. Raises :class:`UsageError` where git is not installed.
    """
    process = _start(repository, words, None, variables)
    output, errors = process.communicate()
    return subprocess.CompletedProcess(words, process.returncode, output, errors)


def _start(
    repository: str, words: Sequence[str], given: IO[bytes] | None, variables: Mapping[str, str] | None = None
) -> subprocess.Popen[bytes]:
    environment = {name: value for name, value in os.environ.items() if name not in _NOT_OURS}
    environment.update(
        GIT_TERMINAL_PROMPT="0", GIT_OPTIONAL_LOCKS="0", GIT_NO_LAZY_FETCH="1", GIT_ALLOW_PROTOCOL="none", GIT_NO_REPLACE_OBJECTS="1",
        GIT_CEILING_DIRECTORIES=os.path.dirname(repository), LC_ALL="C",
        **(variables or {}),
    )  # fmt: skip
    command = ["git", "-C", repository, "-c", "core.fsmonitor=false", "-c", "safe.bareRepository=explicit", *words]
    try:
        return subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL if given is None else given,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE if given is None else subprocess.DEVNULL,
            env=environment,
        )
    except OSError as error:
        raise UsageError(f"git cannot be run: {error.strerror or error}; install it, or do without what asks for it") from None
