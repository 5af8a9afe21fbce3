"""Running one node, or one launch file, against a recorder: start, watch, wake, harvest, stop."""

import os
import shlex
import subprocess
import tempfile
import time
from typing import Any, Dict, List, Optional, Set, Tuple

from launchlint_probe import processes
from launchlint_probe.answering import Answers
from launchlint_probe.bounds import Bounds, Usage
from launchlint_probe.diagnose import Outcome, diagnose
from launchlint_probe.interface import FULL, NAMESPACE, NODE, Harvest, interface, is_infrastructure, per_node, spelled
from launchlint_probe.messages import Definitions
from launchlint_probe.recorder import Recorder
from launchlint_probe.tcpros import Subscription, reconfigure_description, service_header
from launchlint_probe.watching import MOST_WOKEN, Name, Seen, Watch, names

OUTPUT_KEPT = 64 * 1024
"""Bytes of a node's output that are kept, from its end."""
LOOKS = 10
"""How often, within a tenth of a second, it is looked whether a node computes."""
ROBOT = '<robot name="launchlint"><link name="base_link"/></robot>'
"""What a node finds as ``robot_description``, where the plan sets none: nodes that need one go no further without."""
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
        bounds: what it may take.

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
        bounds: Optional[Bounds] = None,
    ) -> None:
        self.bounds = bounds or Bounds()
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


class Run:
    """One run: its record (``status``, ``interface``, ``problems``, ``seconds``, and what was ``left`` running: nothing, if all is well),
    all its topics and services, and whether all those of another run were seen again.
    """

    def __init__(self, record: Dict[str, Any], every: Set[Name], reached: bool = False) -> None:
        self.record = record
        self.every = every
        self.reached = reached


def run(plan: Plan, definitions: Definitions, expected: Optional[Set[Name]] = None) -> Run:
    """Run a node. With ``expected`` (``every`` name of another run) it is stopped as soon as it has those again."""
    given = {full_name(name): value for name, value in plan.params.items()}
    robot = dict.fromkeys(("/robot_description", NAMESPACE + "/robot_description"), ROBOT)
    recorder = Recorder({**({} if plan.many else robot), **given})
    mark = "{}-{}".format(os.getpid(), int(time.monotonic() * 1e6))
    try:
        with tempfile.TemporaryDirectory(prefix="probe-") as directory:
            answers = None if plan.many else Answers(recorder, definitions)
            try:
                return _Session(plan, recorder, answers, given, mark, directory).run(expected)
            finally:
                if answers is not None:
                    answers.close()
    finally:
        recorder.close()


class _Session:
    """One node, from its start to its end, in a directory of its own."""

    def __init__(
        self, plan: Plan, recorder: Recorder, answers: Optional[Answers], given: Dict[str, Any], mark: str, directory: str
    ) -> None:
        self.plan = plan
        self.recorder = recorder
        self.answers = answers
        self.given = given
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
                _command(self.plan, self.directory),
                cwd=self.directory,
                env=_environment(self.plan, self.recorder, self.mark, self.directory),
                stdin=terminal,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )

    def _watch(self, process: Any, expected: Optional[Set[Name]]) -> Run:
        plan, facts = self.plan, self.recorder.facts
        usage = Usage(plan.bounds, self.directory)
        watch = Watch(self.recorder, self.answers, process, self.mark, self.output, plan.quiet, plan.limit, usage, expected)
        seen = watch.run()
        services = {
            name: service_header(api, name)
            for (_, name), (api, _) in list(facts.services.copy().items())[:MOST_WOKEN]
            if not is_infrastructure(name) and not seen.reached
        }
        harvest = self._harvest(watch, seen, services)
        alive = processes.belonging(self.mark, process.pid)
        busy = bool(alive) and not facts.nodes and _is_busy(alive)
        devices = processes.open_devices(alive)
        timed_out = time.monotonic() - self.began >= plan.limit and not seen.ended
        said = _tail(self.output)
        before = said if seen.sent is None else _tail(self.output, seen.sent)
        watch.close()
        left = processes.stop(self.mark, process.pid)
        code = process.poll() if left else process.wait()
        printed = os.path.getsize(self.output)
        outcome = Outcome(
            facts,
            _tail(self.output).replace(self.directory, "."),
            said.replace(self.directory, "."),
            before.replace(self.directory, "."),
            code if seen.ended else None,
            timed_out,
            busy,
            devices,
            printed,
            self._unanswered(),
            self.answers.untold() if self.answers is not None and not seen.ended else [],
            seen.sent is not None,
            seen.excess,
        )
        status, problems = diagnose(outcome)
        found: Dict[str, Any] = {}
        if status != "not-a-node" and not any(problem["code"] == "too-many-names" for problem in problems):
            found = {"nodes": per_node(facts), "params": _set_params(facts)} if plan.many else interface(facts, harvest)
        record = {
            "label": plan.label,
            "status": status,
            "interface": found,
            "problems": problems,
            "seconds": round(time.monotonic() - self.began, 3),
            "left": left,
        }
        return Run(record, names(self.recorder), seen.reached)

    def _harvest(self, watch: Watch, seen: Seen, services: Dict[str, Dict[str, str]]) -> Harvest:
        headers = {name: each.header for (_, name), each in watch.subscriptions.items() if each.header}
        clients = {} if self.answers is None else self.answers.clients
        return Harvest(
            headers, services, _upon(self.recorder, seen), _reconfigure(watch.subscriptions), self.given, self.plan.tokens, clients
        )

    def _unanswered(self) -> List[str]:
        """The services that the node looked for and that nobody could answer."""
        facts = self.recorder.facts
        own = {name for _, name in list(facts.services)}
        served = set() if self.answers is None else set(self.recorder.served) - self.answers.refused
        return sorted(name for name in list(facts.lookups) if name not in own and name not in served)


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
            "TMPDIR": directory,
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


def _upon(recorder: Recorder, seen: Seen) -> Dict[str, str]:
    """Name → what it appeared upon (``subscriber``, ``message``), of those that were not there from the start.

    What came when a service, an action or the clock was there belongs to the start: on a robot all that is there.
    """
    if seen.start is None:
        return {}
    found = {name: "subscriber" for _, name in (seen.woken or set()) - seen.start}
    if seen.served is not None:
        found.update({name: "message" for _, name in names(recorder) - seen.served})
    return found


def _reconfigure(subscriptions: Dict[Tuple[str, str], Subscription]) -> Dict[str, Dict[str, Any]]:
    found: Dict[str, Dict[str, Any]] = {}
    for (_, name), each in subscriptions.items():
        if each.header.get("type") == "dynamic_reconfigure/ConfigDescription" and each.message:
            base = name.rpartition("/")[0]
            for param, known in reconfigure_description(each.message).items():
                found["{}/{}".format(base, param)] = known
    return found


def _tail(path: str, end: Optional[int] = None) -> str:
    """The last of what was printed; with ``end`` of what had been printed when it was so many bytes."""
    with open(path, "rb") as file:
        size = file.seek(0, os.SEEK_END) if end is None else end
        file.seek(max(0, size - OUTPUT_KEPT))
        return file.read(min(size, OUTPUT_KEPT)).decode("utf-8", "replace")
