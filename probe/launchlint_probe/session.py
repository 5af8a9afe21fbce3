"""Running one node, or one launch file, against a recorder: start, watch, wake, harvest, stop."""

import os
import shlex
import subprocess
import tempfile
import time
from typing import Any, Dict, List, Optional, Tuple

from launchlint_probe import processes
from launchlint_probe.diagnose import MOST_PRINTED, Outcome, diagnose
from launchlint_probe.interface import FULL, NAMESPACE, NODE, Harvest, interface, is_infrastructure, per_node, spelled
from launchlint_probe.recorder import Recorder
from launchlint_probe.tcpros import Subscription, reconfigure_description, service_header

STEP = 0.05
"""Seconds between two looks at a node."""
OUTPUT_KEPT = 64 * 1024
"""Bytes of a node's output that are kept, from its end."""
MOST_WOKEN = 500
"""Publishers that are connected to."""
PATIENCE = 5
"""A node that has contacted the master but registered nothing of its own is given this many times ``quiet``: it may be slow to begin."""
HALF = 0.5
"""Where a node's publishers are woken, there is a silence before and one after it, each this part of ``quiet``."""
RESTLESS = 4
"""What never rests is taken to be ready when nothing new has come for this many times as long."""
ANSWERING = 2.0
"""Seconds that publishers are given to answer after all else is quiet."""
LOOKS = 10
"""How often, within a tenth of a second, it is looked whether a node computes."""
PLACE = "{}"
"""Stands in arguments and params for a word that the probe makes up, to find it again in names."""


class Plan:
    """How one node is run; times in seconds.

    Args:
        label: ``package/executable`` or so, for the record.
        command: the program and its own arguments.
        params: private (``~x``), relative or global names of params → values, set before it starts.
        remap: names → names.
        environment: further variables.
        files: name → text of files put into its working directory.
        quiet: this long nothing new must come before it is taken to be ready.
        limit: it is stopped after this.
        with_name: whether it is given ``__name`` and ``__log``.
        many: whether it starts nodes rather than being one (a launch file).

    ``tokens`` are the words put where arguments and params say ``{}``, each with the template that stands for it.
    """

    def __init__(
        self,
        label: str,
        command: List[str],
        params: Optional[Dict[str, Any]] = None,
        remap: Optional[Dict[str, str]] = None,
        environment: Optional[Dict[str, str]] = None,
        files: Optional[Dict[str, str]] = None,
        quiet: float = 1.0,
        limit: float = 15.0,
        with_name: bool = True,
        arguments: str = "",
        many: bool = False,
    ) -> None:
        self.label = label
        self.tokens: Dict[str, str] = {}
        words = shlex.split(arguments)
        for number, word in enumerate(words, 1):
            if PLACE in word:
                words[number - 1] = self._token("arg", number, word, "{{arg:{}}}".format(number))
        self.command = command + words
        self.params = dict(params or {})
        for number, (name, value) in enumerate(sorted(self.params.items()), 1):
            if isinstance(value, str) and PLACE in value:
                self.params[name] = self._token("param", number, value, "{{param:{}}}".format(name))
        self.many = many
        self.remap = remap or {}
        self.environment = environment or {}
        self.files = files or {}
        self.quiet = quiet
        self.limit = limit
        self.with_name = with_name

    def _token(self, kind: str, number: int, text: str, template: str) -> str:
        made = text.replace(PLACE, "launchlint_{}_{}_".format(kind, number))
        self.tokens[made.strip("/~")] = template
        return made


def full_name(name: str) -> str:
    """Where a param of the configuration is set: ``~x`` is private to the node, ``x`` in its namespace."""
    if name.startswith("/"):
        return name
    return "{}/{}".format(FULL, name[1:]) if name.startswith("~") else "{}/{}".format(NAMESPACE, name)


def run(plan: Plan) -> Dict[str, Any]:
    """Run a node. Returns its record: ``status``, ``interface``, ``problems``, ``seconds``, and what was left running (nothing, if all
    is well).
    """
    given = {full_name(name): value for name, value in plan.params.items()}
    recorder = Recorder(given)
    mark = "{}-{}".format(os.getpid(), int(time.monotonic() * 1e6))
    began = time.monotonic()
    try:
        with tempfile.TemporaryDirectory(prefix="probe-") as directory:
            return _run(plan, recorder, given, mark, directory, began)
    finally:
        recorder.close()


def _run(plan: Plan, recorder: Recorder, given: Dict[str, Any], mark: str, directory: str, began: float) -> Dict[str, Any]:
    for name, text in plan.files.items():
        with open(os.path.join(directory, os.path.basename(name)), "w", encoding="utf-8") as file:
            file.write(text)
    output_path = os.path.join(directory, ".output")
    controller, terminal = os.openpty()
    subscriptions: Dict[Tuple[str, str], Subscription] = {}
    started = 0
    try:
        with open(output_path, "wb") as output:
            try:
                process = subprocess.Popen(
                    _command(plan, directory),
                    cwd=directory,
                    env=_environment(plan, recorder, mark, directory),
                    stdin=terminal,
                    stdout=output,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                )
            except OSError as error:
                return {
                    "label": plan.label,
                    "status": "failed",
                    "interface": {},
                    "seconds": 0.0,
                    "left": [],
                    "problems": [{"code": "not-started", "detail": "it cannot be started: {}".format(error.strerror or error)}],
                }
        started = process.pid
        os.close(terminal)
        terminal = -1
        processes.prefer_as_victim(process.pid)
        before, ended = _watch(plan, recorder, process, mark, output_path, began, subscriptions)
        facts = recorder.facts
        services = {
            name: service_header(api, name)
            for (_, name), (api, _) in list(facts.services.items())[:MOST_WOKEN]
            if not is_infrastructure(name)
        }
        headers = {name: each.header for (_, name), each in subscriptions.items() if each.header}
        harvest = Harvest(headers, services, _woken(recorder, before), _reconfigure(subscriptions), given, plan.tokens)
        alive = processes.belonging(mark, process.pid)
        busy = bool(alive) and not facts.nodes and _is_busy(alive)
        devices = processes.open_devices(alive)
        timed_out = time.monotonic() - began >= plan.limit and not ended
        for each in subscriptions.values():
            each.close()
        left = processes.stop(mark, process.pid)
        code = process.poll() if left else process.wait()
        outcome = Outcome(
            facts,
            _tail(output_path).replace(directory, "."),
            code if ended else None,
            timed_out,
            busy,
            devices,
            os.path.getsize(output_path),
        )
        status, problems = diagnose(outcome)
        found: Dict[str, Any] = {}
        if status != "not-a-node" and not any(problem["code"] == "too-many-names" for problem in problems):
            found = {"nodes": per_node(facts), "params": _set_params(facts)} if plan.many else interface(facts, harvest)
        return {
            "label": plan.label,
            "status": status,
            "interface": found,
            "problems": problems,
            "seconds": round(time.monotonic() - began, 3),
            "left": left,
        }
    finally:
        if started:
            processes.stop(mark, started, 0.1)
        os.close(controller)
        if terminal >= 0:
            os.close(terminal)


def _command(plan: Plan, directory: str) -> List[str]:
    words = list(plan.command) + ["{}:={}".format(name, target) for name, target in sorted(plan.remap.items())]
    if plan.with_name:
        words += ["__name:={}".format(NODE), "__log:={}".format(os.path.join(directory, ".log"))]
    return words


def _environment(plan: Plan, recorder: Recorder, mark: str, directory: str) -> Dict[str, str]:
    environment = dict(os.environ, **plan.environment)
    environment.update(
        {
            "ROS_MASTER_URI": recorder.uri,
            "ROS_NAMESPACE": NAMESPACE,
            "ROS_IP": "127.0.0.1",
            "ROS_HOME": directory,
            "HOME": directory,
            "ROS_LOG_DIR": directory,
            "PYTHONUNBUFFERED": "1",
            "QT_QPA_PLATFORM": "offscreen",
            processes.MARK: mark,
        }
    )
    for name in ("ROS_HOSTNAME", "DISPLAY", "WAYLAND_DISPLAY"):  # also: no windows on the screen of whoever probes locally
        environment.pop(name, None)
    # Scripts ask for "python3": that must be the one ROS is installed for, not another one that the user has.
    environment["PATH"] = os.pathsep.join(["/usr/bin", environment.get("PATH", "/bin")])
    return environment


def _watch(
    plan: Plan, recorder: Recorder, process: Any, mark: str, output: str, began: float, subscriptions: Dict[Tuple[str, str], Subscription]
) -> Tuple[Any, bool]:
    """Wait until the node is ready, wake it, wait again. Returns the names it had before it was woken, and whether it ended by itself."""
    before: Any = None
    facts = recorder.facts
    idle_since = time.monotonic()
    last_busy = 0.0
    wants = False
    gone = 0
    while True:
        now = time.monotonic()
        if now - began >= plan.limit or facts.overflow or os.path.getsize(output) > MOST_PRINTED:
            return before, False
        alive = processes.belonging(mark, process.pid)
        gone = gone + 1 if not alive and process.poll() is not None else 0
        if gone > 1:  # once is not enough: a daemon forks between two looks
            return before, True
        busy = processes.busy_time(alive)
        wanted, wants = wants, processes.want_to_run(alive)
        if busy > last_busy + 1 or (wanted and wants):  # on a busy machine it may want to and not be let
            last_busy, idle_since = busy, now
        registered = any(
            not is_infrastructure(name) for table in (facts.publishers, facts.subscribers, facts.services) for _, name in list(table)
        )
        new = [(api, name) for (_, name), (_, api) in list(facts.publishers.items()) if _wants_waking(api, name, subscriptions)]
        wakes = before is not None or bool(new)
        needed = plan.quiet * (HALF if wakes else 1.0) * (1 if registered else PATIENCE)
        silence = now - facts.changed
        if facts.nodes and silence >= needed and (now - idle_since >= min(plan.quiet, 0.5) or silence >= RESTLESS * needed):
            if before is None:
                before = set(list(facts.publishers) + list(facts.subscribers) + list(facts.services))
            if not new or len(subscriptions) >= MOST_WOKEN:
                if silence < needed + ANSWERING and not all(each.is_settled for each in list(subscriptions.values())):
                    time.sleep(STEP)
                    continue
                return before, False
            for api, name in new[:MOST_WOKEN]:
                subscriptions[(api, name)] = Subscription(api, name)
            facts.changed = time.monotonic()
        time.sleep(STEP)


def _wants_waking(api: str, name: str, subscriptions: Dict[Tuple[str, str], Subscription]) -> bool:
    """Whether a publisher has not been listened to yet. To /rosout nobody needs to listen."""
    return (api, name) not in subscriptions and not name.startswith("/rosout")


def _is_busy(alive: List[int]) -> bool:
    """Whether these compute without pause, or would if others let them."""
    before = processes.busy_time(alive)
    runnable = 0
    for _ in range(LOOKS):
        time.sleep(0.01)
        runnable += processes.want_to_run(alive)
    return 2 * runnable > LOOKS or processes.busy_time(alive) - before >= 0.03 * os.sysconf("SC_CLK_TCK")


def _set_params(facts: Any) -> List[str]:
    """The names of the params that a launch file sets."""
    return sorted({spelled(name) for name in list(facts.writes) if not is_infrastructure(name)})


def _woken(recorder: Recorder, before: Any) -> Dict[str, str]:
    facts = recorder.facts
    tables = (facts.publishers, facts.subscribers, facts.services)
    return {} if before is None else {name: "subscriber" for table in tables for _, name in table if (_, name) not in before}


def _reconfigure(subscriptions: Dict[Tuple[str, str], Subscription]) -> Dict[str, Dict[str, Any]]:
    found: Dict[str, Dict[str, Any]] = {}
    for (_, name), each in subscriptions.items():
        if each.header.get("type") == "dynamic_reconfigure/ConfigDescription" and each.message:
            base = name.rpartition("/")[0]
            for param, known in reconfigure_description(each.message).items():
                found["{}/{}".format(base, param)] = known
    return found


def _tail(path: str) -> str:
    with open(path, "rb") as file:
        file.seek(0, os.SEEK_END)
        file.seek(max(0, file.tell() - OUTPUT_KEPT))
        return file.read().decode("utf-8", "replace")
