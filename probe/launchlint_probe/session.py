"""Running one node, or one launch file, beside its counterpart: start, watch, wake, harvest, stop."""

import os
import subprocess
import tempfile
import time
from typing import Any, Callable, Dict, List, Optional, Set

from launchlint_probe import processes
from launchlint_probe.bounds import Usage
from launchlint_probe.counterpart import Counterpart, Name
from launchlint_probe.diagnose import Outcome, diagnose
from launchlint_probe.plan import Plan
from launchlint_probe.watching import Watch

OUTPUT_KEPT = 64 * 1024
"""Bytes of a node's output that are kept, from its end."""
LOOKS = 10
"""How often, within a tenth of a second, it is looked whether a node computes."""
Opposite = Callable[[Plan], Counterpart]
"""Makes the counterpart of a node."""


class Run:
    """One run: its record (``status``, ``interface``, ``problems``, ``seconds``, and what was ``left`` running: nothing, if all is well),
    all its topics and services, and whether all those of another run were seen again.
    """

    def __init__(self, record: Dict[str, Any], every: Set[Name], reached: bool = False) -> None:
        self.record = record
        self.every = every
        self.reached = reached


def run(plan: Plan, opposite: Opposite, expected: Optional[Set[Name]] = None) -> Run:
    """Run a node. With ``expected`` (``every`` name of another run) it is stopped as soon as it has those again."""
    mark = "{}-{}".format(os.getpid(), int(time.monotonic() * 1e6))
    counterpart = opposite(plan)
    try:
        with tempfile.TemporaryDirectory(prefix="probe-") as directory:
            return _Session(plan, counterpart, mark, directory).run(expected)
    finally:
        counterpart.close()


class _Session:
    """One node, from its start to its end, in a directory of its own."""

    def __init__(self, plan: Plan, counterpart: Counterpart, mark: str, directory: str) -> None:
        self.plan = plan
        self.counterpart = counterpart
        self.mark = mark
        self.directory = directory
        self.output = os.path.join(directory, ".output")
        self.began = time.monotonic()

    def run(self, expected: Optional[Set[Name]]) -> Run:
        """Start it, watch it, end it, and say what it was."""
        for name, text in self.plan.files.items():
            with open(os.path.join(self.directory, os.path.basename(name)), "w", encoding="utf-8") as file:
                file.write(text)
        controller, terminal = os.openpty()
        started = 0
        try:
            try:
                process = self._start(terminal)
            except OSError as error:
                problem = {"code": "not-started", "detail": "it cannot be started: {}".format(error.strerror or error)}
                failed = {"status": "failed", "interface": {}, "seconds": 0.0, "left": [], "problems": [problem]}
                return Run(dict(failed, label=self.plan.label), set())
            started = process.pid
            os.close(terminal)
            terminal = -1
            processes.prefer_as_victim(process.pid)
            processes.bound_files(process.pid, self.plan.bounds.disk)
            return self._watch(process, expected)
        finally:
            if started:
                processes.stop(self.mark, started, 0.1)
            os.close(controller)
            if terminal >= 0:
                os.close(terminal)

    def _start(self, terminal: int) -> Any:
        with open(self.output, "wb") as output:
            return subprocess.Popen(
                self.counterpart.command(self.directory),
                cwd=self.directory,
                env=self._environment(),
                stdin=terminal,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )

    def _watch(self, process: Any, expected: Optional[Set[Name]]) -> Run:
        plan, counterpart = self.plan, self.counterpart
        usage = Usage(plan.bounds, self.directory)
        seen = Watch(counterpart, process, self.mark, self.output, plan.quiet, plan.limit, usage, expected).run()
        counterpart.harvest(seen)
        seen.excess = seen.excess or counterpart.refusal()
        alive = processes.belonging(self.mark, process.pid)
        busy = bool(alive) and not counterpart.known().registered and _is_busy(alive)
        devices = processes.open_devices(alive)
        timed_out = time.monotonic() - self.began >= plan.limit and not seen.ended
        said = _tail(self.output)
        before = said if seen.sent is None else _tail(self.output, seen.sent)
        left = processes.stop(self.mark, process.pid)
        code = process.poll() if left else process.wait()
        printed = os.path.getsize(self.output)
        outcome = Outcome(
            counterpart.known(),
            _tail(self.output).replace(self.directory, "."),
            said.replace(self.directory, "."),
            before.replace(self.directory, "."),
            code if seen.ended else None,
            timed_out,
            busy,
            devices,
            printed,
            seen.sent is not None,
            seen.excess,
        )
        status, problems = diagnose(outcome)
        found: Dict[str, Any] = {"interface": {}}
        if status != "not-a-node" and not any(problem["code"] == "too-many-names" for problem in problems):
            found = counterpart.interface(seen)
        record = {
            "label": plan.label,
            "status": status,
            "problems": problems + (counterpart.doubts() if status == "ok" else []),
            "seconds": round(time.monotonic() - self.began, 3),
            "left": left,
        }
        return Run({**record, **found}, counterpart.names(), seen.reached)

    def _environment(self) -> Dict[str, str]:
        environment = dict(os.environ, **self.plan.environment)
        environment.update(self.counterpart.environment(self.directory))
        environment.update(
            {
                "ROS_HOME": self.directory,
                "HOME": self.directory,
                "ROS_LOG_DIR": self.directory,
                "TMPDIR": self.directory,
                "PYTHONUNBUFFERED": "1",
                "QT_QPA_PLATFORM": "offscreen",
                processes.MARK: self.mark,
            }
        )
        for name in ("ROS_HOSTNAME", "DISPLAY", "WAYLAND_DISPLAY"):  # also: no windows on the screen of whoever probes locally
            environment.pop(name, None)
        # Scripts ask for "python3": that must be the one ROS is installed for, not another one that the user has.
        environment["PATH"] = os.pathsep.join(["/usr/bin", environment.get("PATH", "/bin")])
        return environment


def _is_busy(alive: List[int]) -> bool:
    """Whether these compute without pause, or would if others let them."""
    before = processes.busy_time(alive)
    runnable = 0
    for _ in range(LOOKS):
        time.sleep(0.01)
        runnable += processes.want_to_run(alive)
    return 2 * runnable > LOOKS or processes.busy_time(alive) - before >= 0.03 * os.sysconf("SC_CLK_TCK")


def _tail(path: str, end: Optional[int] = None) -> str:
    """The last of what was printed; with ``end`` of what had been printed when it was so many bytes."""
    with open(path, "rb") as file:
        size = file.seek(0, os.SEEK_END) if end is None else end
        file.seek(max(0, size - OUTPUT_KEPT))
        return file.read(min(size, OUTPUT_KEPT)).decode("utf-8", "replace")
