"""Runs of launchlint during which somebody else changes a file of the repository, at any moment.

``python -m tests.meeting.meddling [warm] DIRECTORY FILE CHANGE WORD…`` copies ``DIRECTORY/repository`` for most of the times that
``launchlint WORD…`` opens a file for reading, runs the command in the copy, and just before that file is opened does ``CHANGE``
(``vanish``, ``text`` or ``directory``) to ``FILE``. With ``warm`` an earlier run has kept all results, nothing counts as written a
moment ago, and it is done just before a directory is listed, too, since next to no file is opened then. Prints a line of JSON for
each run: how it ended, what it said, what ``FILE`` holds then, and what two runs of ``check`` say afterwards, one that uses what
was kept and one that does not. Every run is a fork of this process, which saves its start; results are kept for any number of
launch files.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

from launchlint.check import run
from launchlint.cli import main as launchlint
from launchlint.workspace import contents
from tests.cli.forking import import_everything

EVERY, STEP, MOST = 8, 9, 500
"""The first moments are all tried, then one in so many, up to the last."""
OTHER = '<launch>\n  <node name="other" pkg="demo" type="talk.py" reqiured="true"/>\n</launch>\n'
"""What the file holds after ``text``: a mistake that ``--fix`` mends."""


def forked(directory: Path, cache: Path, words: Sequence[str], before: Callable[[], None]) -> tuple[int, str]:
    """The exit status of a run in ``directory``, and all that it said."""
    with tempfile.TemporaryFile() as said:
        child = os.fork()
        if child == 0:
            status = 70
            try:
                os.chdir(directory)
                os.environ["XDG_CACHE_HOME"] = str(cache)
                os.dup2(said.fileno(), 1)
                os.dup2(said.fileno(), 2)
                before()
                status = launchlint(list(words), standalone_mode=False)
            finally:
                sys.stdout.flush()
                sys.stderr.flush()
                os._exit(status)
        _, ended = os.waitpid(child, 0)
        said.seek(0)
        return os.waitstatus_to_exitcode(ended), said.read().decode()


def meddler(directory: Path, file: str, change: str, moment: int, events: Sequence[str]) -> Callable[[], None]:
    """A function that lets ``change`` happen to ``file`` at the ``moment``-th of these ``events`` in the repository (from 0 on)."""
    opened = 0
    inside = str(directory) + os.sep

    def hook(event: str, arguments: tuple[object, ...]) -> None:
        nonlocal opened
        if event not in events or not isinstance(arguments[0], str) or not f"{os.path.abspath(arguments[0])}/".startswith(inside):
            return
        if event == "open" and isinstance(arguments[2], int) and arguments[2] & (os.O_WRONLY | os.O_RDWR):
            return
        opened += 1
        if opened == moment + 1:
            happen(directory / file, change)

    return lambda: sys.addaudithook(hook)


def happen(file: Path, change: str) -> None:
    """What somebody else does to the file, in one step that a reader sees whole."""
    if change == "text":
        other = file.with_name("other.tmp")
        other.write_text(OTHER, encoding="utf-8")
        other.replace(file)
    else:
        file.unlink()
        if change == "directory":
            file.mkdir()


def main() -> int:
    """See the module."""
    warm = sys.argv[1] == "warm"
    base, file, change, *words = sys.argv[2:] if warm else sys.argv[1:]
    run.CACHE_PAYS = 1
    import_everything()
    events = ["open"]
    if warm:
        contents.RACY = 0
        contents.WORTH_WRITING = 1
        events += ["os.scandir", "os.listdir"]
    for moment in (*range(EVERY), *range(EVERY, MOST, STEP)):
        directory, cache = Path(base, str(moment), "repository"), Path(base, str(moment), "cache")
        shutil.copytree(Path(base, "repository"), directory)
        untouched = (directory / file).read_bytes()
        if warm:
            forked(directory, cache, words, lambda: None)
        status, said = forked(directory, cache, words, meddler(directory, file, change, moment, events))
        target = directory / file
        holds = target.read_text(encoding="utf-8") if target.is_file() else None
        happened = not target.is_file() if change != "text" else b"other" in target.read_bytes()
        again, anew = (forked(directory, cache, ("check", "--jobs", "1", *more, "."), lambda: None) for more in ((), ("--no-cache",)))
        kept = {"status": status, "said": said, "holds": holds, "happened": happened, "again": again, "anew": anew}
        print(json.dumps({**kept, "untouched": untouched.decode()}), flush=True)
        shutil.rmtree(Path(base, str(moment)))
        if not happened:
            return 0
    return 1


if __name__ == "__main__":
    sys.exit(main())
