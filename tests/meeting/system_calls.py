"""Runs of launchlint in which the kernel does what it seldom does: a process ends in the middle of its work, a disk is full."""

from __future__ import annotations

import collections
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.cli.running import Ran, clean_environment

WRITING = (
    "write",
    "pwrite64",
    "rename",
    "renameat",
    "renameat2",
    "unlink",
    "unlinkat",
    "ftruncate",
    "chmod",
    "fchmod",
    "mkdir",
    "fdatasync",
)
"""System calls that change a file; before each of them a run can be stopped."""
GROWING = ("write", "pwrite64", "mkdir")
"""Those that need room on the disk."""


def traced(directory: Path, cache: Path, words: Sequence[str], *inject: str, log: Path, **variables: str) -> Ran:
    """Run ``launchlint WORDS`` in ``directory`` under strace, with these injections; ``log`` gets the system calls that write.

    ``variables`` are those of the environment besides the usual ones.
    """
    command = ["strace", "-qq", "-o", str(log), "-e", f"trace={','.join(WRITING)}"]
    for each in inject:
        command += ["-e", f"inject={each}"]
    command += [sys.executable, "-m", "launchlint", *words]
    environment = clean_environment(cache, PYTHONDONTWRITEBYTECODE="1", **variables)
    done = subprocess.run(command, cwd=directory, env=environment, capture_output=True, timeout=120, check=False)
    return Ran(done.returncode, done.stdout.decode(), done.stderr.decode())


def moments(log: Path, *, of_files: bool = False) -> Iterator[tuple[str, int]]:
    """Each system call of a run as ``(name, how many of that name came up to it)``; with ``of_files`` without what is said on the standard
    streams.
    """
    seen: collections.Counter[str] = collections.Counter()
    for match in re.finditer(r"^(\w+)\((.*)", log.read_text("utf-8", "replace"), re.MULTILINE):
        seen[match[1]] += 1
        if not (of_files and match[1] == "write" and match[2].startswith(("1,", "2,"))):
            yield match[1], seen[match[1]]
