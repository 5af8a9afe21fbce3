"""Commands of launchlint without the time that Python and its modules take to start.

``python -m tests.cli.forking REQUESTS ANSWERS`` (file descriptors) imports all modules of launchlint, and forks for each command that it is
asked for: a line of JSON with ``directory``, ``words``, ``environment`` and ``streams``, the names of files for the three standard streams.
Where ``program`` names a file, that is executed instead of launchlint; ``memory`` is how many bytes of addresses there may be, if not 0. It
answers with two lines: the number of the process, and, once that has ended, how.

A command finds a process of its own in which nothing has happened but imports; what happens while Python starts is tried elsewhere
(``tests/test_startup.py``).
"""

from __future__ import annotations

import atexit
import gc
import json
import os
import pkgutil
import resource
import runpy
import signal
import subprocess
import sys
import tempfile
import traceback
from collections.abc import Mapping, Sequence
from functools import cache
from importlib import import_module
from math import ceil
from pathlib import Path
from select import select
from typing import Any

import launchlint

ROOT = Path(__file__).resolve().parents[2]
LONGEST = 120
"""Seconds of processor that a command may take."""
PATIENCE = 5
"""Seconds to wait for each of them: on a busy machine others are served, too."""


@cache
def import_everything() -> None:
    """Import all modules of launchlint."""
    for module in pkgutil.walk_packages(launchlint.__path__, "launchlint."):
        if not module.name.endswith("__main__"):
            import_module(module.name)


class Forks:
    """A process that forks for each command; it ends with this one."""

    def __init__(self, environment: Mapping[str, str]) -> None:
        asked, self._requests = os.pipe()
        self._answers, told = os.pipe()
        command = [sys.executable, "-m", "tests.cli.forking", str(asked), str(told)]
        self._process = subprocess.Popen(
            command, cwd=ROOT, env=environment, pass_fds=(asked, told), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL
        )
        os.close(asked)
        os.close(told)
        atexit.register(self._end)

    def _end(self) -> None:
        os.close(self._requests)
        os.close(self._answers)
        self._process.wait()

    def run(
        self,
        directory: Path,
        words: Sequence[str],
        environment: Mapping[str, str],
        data: bytes = b"",
        *,
        program: str = "",
        seconds: float = LONGEST,
        memory: int = 0,
    ) -> tuple[int, bytes, bytes]:
        """Exit status and both outputs of ``launchlint WORDS``, or of a program in Python, as :func:`subprocess.run` gives them."""
        with tempfile.TemporaryDirectory() as place:
            streams = [Path(place, name) for name in ("stdin", "stdout", "stderr")]
            for stream in streams:
                stream.write_bytes(data if stream.name == "stdin" else b"")
            request = {"directory": str(directory), "words": words, "environment": environment, "streams": list(map(str, streams))}
            if program:
                Path(place, "program.py").write_text(program, encoding="utf-8")
                request["program"] = str(Path(place, "program.py"))
            _write(self._requests, json.dumps({**request, "memory": memory, "processor": ceil(seconds)}))
            process = _line(self._answers, None)
            status = _line(self._answers, PATIENCE * seconds)
            if status is None:
                os.kill(int(str(process)), signal.SIGKILL)
                _line(self._answers, None)
            if status is None or int(status) == -signal.SIGXCPU:
                raise subprocess.TimeoutExpired(["launchlint", *words], seconds)
            return int(status), streams[1].read_bytes(), streams[2].read_bytes()


@cache
def forks() -> Forks:
    """The process that forks for the commands of this one."""
    from tests.cli.running import clean_environment

    return Forks(clean_environment(Path(tempfile.gettempdir()) / "launchlint-of-tests"))


def _write(to: int, line: str) -> None:
    data = line.encode() + b"\n"
    while data:
        data = data[os.write(to, data) :]


def _line(of: int, seconds: float | None) -> str | None:
    """The next line that is told; None where none comes within so many seconds."""
    line = b""
    while not line.endswith(b"\n"):
        if not select([of], [], [], seconds)[0]:
            return None
        character = os.read(of, 1)
        if not character:
            raise RuntimeError("the process that forks for commands has ended")
        line += character
    return line.decode()[:-1]


def _execute(request: Mapping[str, Any]) -> int:
    """Be the command: its exit status."""
    os.chdir(request["directory"])
    os.environ.clear()
    os.environ.update(request["environment"])
    for number, name in enumerate(request["streams"]):
        stream = os.open(name, os.O_WRONLY if number else os.O_RDONLY)
        os.dup2(stream, number)
        os.close(stream)
    if request["memory"]:
        resource.setrlimit(resource.RLIMIT_AS, (request["memory"], request["memory"]))
    resource.setrlimit(resource.RLIMIT_CPU, (request["processor"], request["processor"] + 1))
    sys.argv = ["launchlint", *request["words"]]
    sys.path[0] = request["directory"]
    status = 0
    try:
        if "program" in request:
            runpy.run_path(request["program"], run_name="__main__")
        else:
            runpy.run_module("launchlint", run_name="__main__", alter_sys=True)
    except SystemExit as ended:
        status = ended.code if isinstance(ended.code, int) else int(ended.code is not None)
    except BaseException:
        traceback.print_exc()
        status = 1
    atexit._run_exitfuncs()
    sys.stdout.flush()
    sys.stderr.flush()
    return status


def main() -> None:
    """See the module."""
    requests, answers = map(int, sys.argv[1:])
    import_everything()
    gc.freeze()
    while True:
        try:
            line = _line(requests, None)
        except RuntimeError:  # nobody asks any more
            return
        request = json.loads(str(line))
        child = os.fork()
        if child == 0:
            status = 70
            try:
                os.close(requests)
                os.close(answers)
                status = _execute(request)
            finally:
                os._exit(status)
        _write(answers, str(child))
        _, ended = os.waitpid(child, 0)
        _write(answers, str(os.waitstatus_to_exitcode(ended)))


if __name__ == "__main__":
    main()
