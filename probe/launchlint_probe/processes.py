"""The processes of one node: all that carry its mark in their environment or are in its session, whoever their parent is by now."""

import ctypes
import os
import resource
import signal
import time
from typing import Dict, List, Set, Tuple

MARK = "LAUNCHLINT_PROBE_MARK"

_STATE, _PARENT, _SESSION, _USER_TIME, _SYSTEM_TIME = 0, 1, 3, 11, 12
"""Fields of ``/proc/PID/stat`` behind the name (proc(5))."""
_SET_CHILD_SUBREAPER = 36
"""Of prctl(2)."""


def adopt() -> None:
    """From now on orphans below this process become its children: none can get away by forking twice."""
    try:
        ctypes.CDLL(None).prctl(_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    except (OSError, AttributeError):  # no Linux: marks must do
        return


def _fields(process: int) -> List[str]:
    with open("/proc/{}/stat".format(process), "rb") as file:
        return file.read().decode("ascii", "replace").rpartition(")")[2].split()


def _all() -> List[int]:
    return [int(name) for name in os.listdir("/proc") if name.isdigit()]


def belonging(mark: str, session: int) -> List[int]:
    """The ids of all living processes of a node. A process may leave its session or clear its environment; few do both, see
    ``descendants``.
    """
    wanted = "{}={}".format(MARK, mark).encode()
    found = []
    for process in _all():
        if process == os.getpid():
            continue
        try:
            fields = _fields(process)
            if fields[_STATE] in ("Z", "X"):
                continue
            if int(fields[_SESSION]) == session:
                found.append(process)
                continue
            with open("/proc/{}/environ".format(process), "rb") as file:
                if wanted in file.read().split(b"\0"):
                    found.append(process)
        except (OSError, IndexError, ValueError):
            continue
    return sorted(found)


def descendants() -> Tuple[List[int], List[int]]:
    """All processes below this one: those that live, and the ids of its own children that have ended and were not asked for."""
    parents: Dict[int, Tuple[int, str]] = {}
    for process in _all():
        try:
            fields = _fields(process)
            parents[process] = (int(fields[_PARENT]), fields[_STATE])
        except (OSError, IndexError, ValueError):
            continue
    mine: Set[int] = {os.getpid()}
    grown = True
    while grown:
        more = {process for process, (parent, _) in parents.items() if parent in mine} - mine
        grown = bool(more)
        mine |= more
    mine.discard(os.getpid())
    ended = [process for process in mine if parents[process][1] in ("Z", "X")]
    own = [process for process in ended if parents[process][0] == os.getpid()]
    return sorted(mine - set(ended)), sorted(own)


def end_all() -> List[int]:
    """End whatever is left below this process when all work is done. Returns what could not be ended: nothing, if all is well."""
    end = time.monotonic() + 3.0
    while True:
        living, ended = descendants()
        for process in ended:
            try:
                os.waitpid(process, os.WNOHANG)
            except OSError:
                continue
        if not living or time.monotonic() > end:
            return living
        for process in living:
            _send(process, signal.SIGKILL)
        time.sleep(0.02)


def busy_time(processes: List[int]) -> float:
    """Processor time that these have used so far, in clock ticks."""
    total = 0.0
    for process in processes:
        try:
            fields = _fields(process)
            total += int(fields[_USER_TIME]) + int(fields[_SYSTEM_TIME])
        except (OSError, IndexError, ValueError):
            continue
    return total


def want_to_run(processes: List[int]) -> bool:
    """Whether any of these is running, or waits for nothing but a processor."""
    for process in processes:
        try:
            if _fields(process)[_STATE] == "R":
                return True
        except (OSError, IndexError, ValueError):
            continue
    return False


def prefer_as_victim(process: int) -> None:
    """Where memory runs out, the kernel ends this process before the probe itself."""
    try:
        with open("/proc/{}/oom_score_adj".format(process), "w") as file:
            file.write("1000")
    except OSError:
        return


def bound_files(process: int, largest: int) -> None:
    """No file that this process, or one that it starts, writes may have more bytes."""
    try:
        resource.prlimit(process, resource.RLIMIT_FSIZE, (largest, largest))
    except (OSError, ValueError):  # it has ended, or there is a tighter bound
        return


def memory(processes: List[int]) -> int:
    """Bytes of memory that these take, without what they share with others."""
    page = os.sysconf("SC_PAGE_SIZE")
    total = 0
    for process in processes:
        try:
            with open("/proc/{}/statm".format(process), "rb") as file:
                fields = file.read().split()
            total += (int(fields[1]) - int(fields[2])) * page
        except (OSError, IndexError, ValueError):
            continue
    return total


_ORDINARY = ("/dev/null", "/dev/zero", "/dev/pts", "/dev/ptmx", "/dev/tty ", "/dev/random", "/dev/urandom", "/dev/shm", "/dev/full")


def open_devices(processes: List[int]) -> List[str]:
    """The devices that these have open, for the diagnosis."""
    found = set()
    for process in processes:
        try:
            for name in os.listdir("/proc/{}/fd".format(process)):
                target = os.readlink("/proc/{}/fd/{}".format(process, name))
                if target.startswith("/dev/") and target != "/dev/tty" and not target.startswith(_ORDINARY):
                    found.add(target)
        except OSError:
            continue
    return sorted(found)


def stop(mark: str, group: int, patience: float = 2.0) -> List[int]:
    """End all processes of a node: SIGINT, SIGTERM, SIGKILL, each after ``patience`` seconds. Returns what is left: nothing, if all is
    well.
    """
    if not belonging(mark, group):
        return []
    for sign, wait in ((signal.SIGINT, patience), (signal.SIGTERM, patience / 2)):
        _send_group(group, sign)
        for process in belonging(mark, group):
            if process != group:
                _send(process, sign)
        end = time.monotonic() + wait
        while time.monotonic() < end:
            if not belonging(mark, group):
                return []
            time.sleep(0.02)
    end = time.monotonic() + 3.0
    while True:  # again and again: what forks all the time may do so between two looks
        left = belonging(mark, group)
        if not left or time.monotonic() > end:
            return left
        _send_group(group, signal.SIGKILL)
        for process in left:
            _send(process, signal.SIGKILL)
        time.sleep(0.01)


def _send(process: int, sign: int) -> None:
    try:
        os.kill(process, sign)
    except OSError:
        return


def _send_group(group: int, sign: int) -> None:
    if group <= 1:
        return
    try:
        os.killpg(group, sign)
    except OSError:
        return
