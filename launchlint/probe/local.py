"""The same program without a container, with the ROS of this machine. Nothing protects the machine from the nodes that are run."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from launchlint.errors import UsageError
from launchlint.probe.context import program_directory
from launchlint.probe.words import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO

LAST_WORDS = 2_000
"""Bytes of its standard error that are shown."""
PATIENCE = 30.0
"""Seconds for the program to end its nodes."""


class Local:
    """A started program: its output, and how it is stopped."""

    def __init__(self, process: subprocess.Popen[bytes], output: IO[bytes], complaints: IO[bytes]) -> None:
        self._process = process
        self._output = output
        self._complaints = complaints
        self.timed_out = False

    def output(self, seconds: float) -> Iterator[bytes]:
        """What it prints, as it comes. After ``seconds`` it is stopped, and ``timed_out`` says so."""
        timer = threading.Timer(seconds, self._expire)
        timer.daemon = True
        timer.start()
        try:
            while chunk := os.read(self._output.fileno(), 65536):
                yield chunk
        finally:
            timer.cancel()

    def _expire(self) -> None:
        self.timed_out = True
        self.kill()

    def kill(self) -> None:
        """Ask it to end all its nodes and itself; insist after a while."""
        if self._process.poll() is not None:
            return
        self._process.send_signal(signal.SIGTERM)
        try:
            self._process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()

    def last_words(self) -> str:
        """What it wrote to its standard error last."""
        self._complaints.seek(0, os.SEEK_END)
        self._complaints.seek(max(0, self._complaints.tell() - LAST_WORDS))
        return plain(self._complaints.read().decode("utf-8", "replace"))

    def died_of_memory(self) -> bool:
        """Nobody bounds its memory here."""
        return False


@contextmanager
def program(job: bytes) -> Iterator[Local]:
    """The program with a job, started; all it started is gone when the block ends.

    Raises:
        UsageError: this machine has no ROS.
    """
    if not has_ros():
        raise UsageError(
            "this machine has no ROS that could be probed: source its setup.bash first, or leave --local out to probe in a container"
        )
    command = [sys.executable, "-I", os.path.join(program_directory(), "launchlint_probe", "__main__.py")]
    with tempfile.TemporaryFile() as complaints:
        # A session of its own: Ctrl-C reaches launchlint, which ends the program in order, and never the nodes behind its back.
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=complaints, start_new_session=True)
        if process.stdin is None or process.stdout is None:
            raise AssertionError("pipes were asked for")
        running = Local(process, process.stdout, complaints)
        try:
            try:
                process.stdin.write(job)
                process.stdin.close()
            except BrokenPipeError:  # it says itself why it ended
                pass
            yield running
        finally:
            running.kill()
            process.wait()
            process.stdout.close()


def has_ros() -> bool:
    """Whether something of ROS is installed here."""
    return (
        bool(os.environ.get("ROS_DISTRO") or os.environ.get("AMENT_PREFIX_PATH"))
        or shutil.which("rosversion") is not None
        or shutil.which("roslaunch") is not None
        or any(os.path.isdir(path) for path in ("/usr/share/roscpp", "/usr/lib/python3/dist-packages/rospy", "/usr/share/rosout"))
        or (os.path.isdir("/opt/ros") and bool(os.listdir("/opt/ros")))
    )
