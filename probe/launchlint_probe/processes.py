"""The processes of one node: all that carry its mark in their environment, whoever their parent is by now."""

import os
import signal
import time
from typing import Dict, List

MARK = "LAUNCHLINT_PROBE_MARK"


def marked(mark: str) -> List[int]:
    """The ids of all processes with this mark, itself excluded. A process may leave its session and its parent, not its environment."""
    wanted = "{}={}".format(MARK, mark).encode()
    found = []
    for name in os.listdir("/proc"):
        if not name.isdigit() or int(name) == os.getpid():
            continue
        try:
            with open("/proc/{}/environ".format(name), "rb") as file:
                if wanted in file.read().split(b"\0"):
                    found.append(int(name))
        except OSError:
            continue
    return sorted(found)


def _state(process: int) -> List[str]:
    with open("/proc/{}/stat".format(process), "rb") as file:
        return file.read().decode("ascii", "replace").rpartition(")")[2].split()


def busy_time(processes: List[int]) -> float:
    """Processor time that these have used so far, in clock ticks."""
    total = 0.0
    for process in processes:
        try:
            fields = _state(process)
            total += int(fields[11]) + int(fields[12])
        except (OSError, IndexError, ValueError):
            continue
    return total


def waiting_for(processes: List[int]) -> Dict[int, str]:
    """The devices that these have open, for the diagnosis."""
    found = {}
    for process in processes:
        try:
            for name in os.listdir("/proc/{}/fd".format(process)):
                target = os.readlink("/proc/{}/fd/{}".format(process, name))
                if target.startswith("/dev/") and not target.startswith(("/dev/null", "/dev/pts", "/dev/ptmx", "/dev/urandom", "/dev/shm")):
                    found[process] = target
        except OSError:
            continue
    return found


def stop(mark: str, group: int, patience: float = 2.0) -> List[int]:
    """End all processes of a mark: SIGINT, SIGTERM, SIGKILL, each after ``patience`` seconds. Returns what is left: nothing, if all is well."""
    for sign, wait in ((signal.SIGINT, patience), (signal.SIGTERM, patience / 2), (signal.SIGKILL, 2.0)):
        _send_group(group, sign)
        for process in marked(mark):
            _send(process, sign)
        end = time.monotonic() + wait
        while time.monotonic() < end:
            if not [process for process in marked(mark) if not _is_dead(process)]:
                return []
            time.sleep(0.02)
    return [process for process in marked(mark) if not _is_dead(process)]


def _is_dead(process: int) -> bool:
    try:
        return _state(process)[0] in ("Z", "X")
    except (OSError, IndexError):
        return True


def _send(process: int, sign: int) -> None:
    try:
        os.kill(process, sign)
    except OSError:
        return


def _send_group(group: int, sign: int) -> None:
    try:
        os.killpg(group, sign)
    except OSError:
        return
