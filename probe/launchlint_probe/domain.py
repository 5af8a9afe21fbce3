"""The counterpart of a node of ROS 2: a domain of its own, and in it an observer that reads the graph and offers what is waited for."""

import json
import os
import socket
import subprocess
import tempfile
import threading
import time
from typing import Any, Dict, List, Optional, Set, Tuple

from launchlint_probe.counterpart import Counterpart, Known, Name, Seen
from launchlint_probe.interface import NAMESPACE, NODE
from launchlint_probe.plan import Plan
from launchlint_probe.ros2_graph import Facts, Key, Owner, full, interface, possible_names, spelled_for, spelled_names

PROBE = "/launchlint_probe"
"""The namespace of the probe's own nodes."""
CONTAINER = "launchlint_container"
BEGINNING = 30.0
"""Seconds that the observer is given to begin."""
ANSWER = 25.0
"""Seconds that it is given for a command."""
MOST_NAMES = 5_000
LONGEST_LINE = 16 * 1024 * 1024
MARKER = "launchlint_given"
"""A param that no node declares: who has it after its start declares whatever it is given."""
ROBOT = '<robot name="launchlint"><link name="base_link"/></robot>'
STATES = (("constructed", "", 1), ("configured", "configure", 1), ("active", "activate", 3))
"""The states that a node is led through: name, what leads there, and the number of that (lifecycle_msgs/Transition)."""

DOMAINS = range(1, 101)
"""Their ports are below those that a system gives out itself; 0 is everybody's."""


def _take_domain() -> Tuple[int, socket.socket]:
    """A domain that no other run on this machine has, and what keeps it so until it is closed: a name that the kernel gives to one only."""
    first = os.getpid() % len(DOMAINS)
    while True:
        for number in list(DOMAINS[first:]) + list(DOMAINS[:first]):
            keeper = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
            try:
                keeper.bind("\0launchlint-probe-domain-{}".format(number))
                return number, keeper
            except OSError:
                keeper.close()
        time.sleep(0.1)


class Domain(Counterpart):
    """See the module. ``python`` is the interpreter that has rclpy."""

    def __init__(self, plan: Plan, python: str) -> None:
        self.plan = plan
        self.facts = Facts()
        self._number, self._keeper = _take_domain()
        self._changed = time.monotonic()
        self._lock = threading.Lock()
        self._answers: Dict[int, Dict[str, Any]] = {}
        self._answered = threading.Condition(self._lock)
        self._next = 0
        self._ready = False
        self._ended = False
        self._overflow = False
        self._refusal: Optional[Tuple[str, str]] = None
        self._loaded = plan.component is None
        self._state = 0
        self._doubts: List[Dict[str, str]] = []
        self._offered: Dict[str, Set[str]] = {"listen": set(), "serve": set(), "send": set()}
        self._refused: Set[str] = set()
        self._steps: List[Tuple[str, Set[Key]]] = []
        observer = os.path.join(os.path.dirname(os.path.abspath(__file__)), "observer.py")
        self._process = subprocess.Popen(
            [python, observer],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=dict(os.environ, HOME=tempfile.gettempdir(), ROS_LOG_DIR=tempfile.gettempdir(), **self._variables()),
            start_new_session=True,
        )
        self._reader = threading.Thread(target=self._read)
        self._reader.daemon = True
        self._reader.start()
        with self._answered:
            self._answered.wait_for(lambda: self._ready or self._ended, BEGINNING)
        self._changed = time.monotonic()

    def close(self) -> None:
        with self._lock:
            self._ended = True
        self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                try:
                    stream.close()
                except OSError:
                    pass
        self._reader.join(1.0)
        self._keeper.close()

    # -- talking with the observer -----------------------------------------------------------------------------

    def _read(self) -> None:
        stream = self._process.stdout
        while stream is not None:
            try:
                line = stream.readline(LONGEST_LINE)
            except (OSError, ValueError):
                line = b""
            if not line:
                break
            try:
                self._take(json.loads(line.decode("utf-8", "replace")))
            except (ValueError, KeyError, TypeError):  # not the observer's own words
                continue
        with self._answered:
            if not self._ended:
                self._ended = True
                self._refusal = self._refusal or ("observer-ended", "what watches it was ended")
            self._answered.notify_all()

    def _take(self, record: Dict[str, Any]) -> None:
        with self._answered:
            if "graph" in record:
                graph = record["graph"]
                nodes = [node for node in graph["nodes"] if node["namespace"] != PROBE]
                if self.facts.add({"nodes": nodes}):
                    self._changed = time.monotonic()
                self._overflow = self._overflow or bool(graph["overflow"]) or len(self.facts.seen) > MOST_NAMES
                if any(node["namespace"] == PROBE for node in graph["nodes"]) and not self._loaded:
                    self._loaded = True
                    threading.Thread(target=self._load, daemon=True).start()
            elif "answer" in record:
                self._answers[record["answer"]] = record
            else:
                self._ready = True
            self._answered.notify_all()

    def _tell(self, do: str, **more: Any) -> Dict[str, Any]:
        """Give the observer a command; its answer, empty where there is none."""
        stream = self._process.stdin
        with self._answered:
            if self._ended or stream is None:
                return {}
            self._next += 1
            number = self._next
            try:
                stream.write(json.dumps(dict(more, do=do, id=number)).encode() + b"\n")
                stream.flush()
            except (OSError, ValueError):
                return {}
            self._answered.wait_for(lambda: number in self._answers or self._ended, ANSWER)
            return self._answers.pop(number, {})

    def _load(self) -> None:
        """Have the component loaded into its container."""
        if self.plan.component is None:
            return
        package, plugin = self.plan.component
        plan = self.plan
        what = {
            "container": "{}/{}".format(PROBE, CONTAINER),
            "package": package,
            "plugin": plugin,
            "name": NODE if plan.with_name else "",
            "namespace": NAMESPACE if plan.with_namespace else "",
            "params": self._params(),
            "remap": ["{}:={}".format(*each) for each in sorted(plan.remap.items())],
        }
        done = self._tell("load", what=what)
        if done and not done.get("done"):
            self._refusal = ("not-loaded", "it could not be loaded: {}".format(done.get("why") or "the container does not say why"))

    # -- what the node does ------------------------------------------------------------------------------------

    def news(self) -> float:
        return self._changed

    def touch(self) -> None:
        self._changed = time.monotonic()

    def names(self) -> Set[Name]:
        with self._lock:
            return spelled_names(self.facts, self.plan.tokens) if self.plan.with_namespace else possible_names(self.facts)

    def is_there(self) -> bool:
        return bool(self.facts.owners)

    def has_registered(self) -> bool:
        with self._lock:
            return bool(self.facts.own())

    def asks(self) -> bool:
        return False  # who waits for a service shows that like everything else

    def overflows(self) -> bool:
        return self._overflow

    def refusal(self) -> Optional[Tuple[str, str]]:
        return self._refusal

    # -- what it is given --------------------------------------------------------------------------------------

    def advance(self) -> bool:
        """Its params are asked for in every state: it may declare some on the way."""
        with self._lock:
            owners, stateful = self.facts.named(), self.facts.lifecycle()
        if not owners or self._state >= len(STATES) or (self._state and not stateful):
            return False
        name = STATES[self._state][0]
        self._ask_for_params(owners, name)
        with self._lock:
            self.facts.states[name] = set(self.facts.seen)
        self._state += 1
        if not stateful:
            self.facts.states.clear()
            return False
        if self._state == len(STATES):
            return False
        _, doing, transition = STATES[self._state]
        done = [self._tell("state", node=full(owner), transition=transition) for owner in stateful]
        if all(each.get("done") for each in done):
            return True
        why = "refused that" if all(each.get("answered") for each in done) else "did not answer"
        self._doubts.append({"code": "not-{}".format(STATES[self._state][0]), "detail": "it was told to {} and {}".format(doing, why)})
        self._state = len(STATES)
        return False

    def _ask_for_params(self, owners: List[Owner], state: str) -> None:
        for owner in owners:
            answer = self._tell("params", node=full(owner))
            self.facts.params.setdefault(owner, []).append((state, answer.get("params") if answer.get("answered") else None))

    def _open(self, category: str, without: str = "") -> Dict[str, str]:
        """Topics or services of one category that the nodes do not have in another: name → type."""
        with self._lock:
            own = self.facts.own()
            others = {name for _, each, name in own if each == without}
            return {
                name: self.facts.seen[(owner, each, name)][0][0]
                for owner, each, name in own
                if each == category and name not in others and not (category in ("publishers", "subscribers") and "/_action/" in name)
            }

    def _offer(self, do: str, names: Dict[str, str]) -> bool:
        new = {name: kind for name, kind in names.items() if name not in self._offered[do]}
        if not new:
            return False
        self._offered[do].update(new)
        answer = self._tell(do, names=sorted(new.items()))
        self._refused.update(answer.get("refused", ()))
        return bool(answer.get("made"))

    def has_unheard(self) -> bool:
        return any(name not in self._offered["listen"] for name in self._open("publishers"))

    def listen(self) -> bool:
        return self._offer("listen", self._open("publishers"))

    def is_settled(self) -> bool:
        return True

    def serve(self) -> bool:
        return self._offer("serve", self._open("clients", without="services"))

    def send(self) -> bool:
        with self._lock:
            ticking = {
                name: kinds[0][0]
                for (_, category, name), kinds in self.facts.seen.items()
                if category == "subscribers" and name == "/clock"
            }
        self._note("message")
        return self._offer("send", dict(self._open("subscribers", without="publishers"), **ticking))

    def _note(self, upon: str) -> None:
        """Remember what is there before something is given: what comes later came upon that."""
        with self._lock:
            if not any(upon == each for each, _ in self._steps):
                self._steps.append((upon, set(self.facts.seen)))

    # -- what is made of it ------------------------------------------------------------------------------------

    def _variables(self) -> Dict[str, str]:
        return {
            "ROS_DOMAIN_ID": str(self._number),
            "ROS_LOCALHOST_ONLY": "1",
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
            "RCUTILS_COLORIZED_OUTPUT": "0",
        }

    def environment(self, directory: str) -> Dict[str, str]:
        return self._variables()

    def _params(self) -> Dict[str, Any]:
        robot = {"robot_description": ROBOT, MARKER: True}
        return dict(robot, **{name.lstrip("~/").replace("/", "."): value for name, value in self.plan.params.items()})

    def command(self, directory: str) -> List[str]:
        plan = self.plan
        if plan.component is not None:
            return list(plan.command) + ["--ros-args", "-r", "__ns:=" + PROBE, "-r", "__node:=" + CONTAINER]
        words = list(plan.command)
        if not plan.with_name and not plan.with_namespace and not plan.remap and not plan.params:
            return words
        words.append("--ros-args")
        for name, target in sorted(plan.remap.items()):
            words += ["-r", "{}:={}".format(name, target)]
        if plan.with_namespace:
            words += ["-r", "__ns:=" + NAMESPACE]
        if plan.with_name:
            words += ["-r", "__node:=" + NODE]
        for name, value in sorted(self._params().items()):
            words += ["-p", "{}:={}".format(name, json.dumps(value))]
        return words

    def harvest(self, seen: Seen) -> None:
        with self._lock:
            owners = self.facts.named()
        if seen.ended or not owners:
            return
        self._ask_for_params(owners, STATES[min(self._state, len(STATES)) - 1][0] if self.facts.states else STATES[0][0])
        for owner in owners:
            listed = {param["name"] for _, params in self.facts.params.get(owner, []) for param in params or []}
            if MARKER in listed or (listed and self._tell("takes_any", node=full(owner)).get("taken")):
                self.facts.undeclared.add(owner)

    def interface(self, seen: Seen) -> Dict[str, Any]:
        with self._lock:
            facts = self.facts
            owners = facts.named()
            if not owners:
                return {"interface": {}}
            for owner in facts.undeclared:  # it has what the probe gave it, and nothing can be made of that
                facts.params[owner] = [
                    (state, [param for param in params or [] if param["name"] not in (MARKER, "robot_description")])
                    for state, params in facts.params[owner]
                ]
            traits: Dict[str, Any] = {}
            if facts.lifecycle():
                traits["lifecycle"] = True
            if facts.undeclared:
                traits["undeclared"] = True
            woken = {key: upon for upon, before in self._steps for key in facts.seen if key not in before}
            found = interface(facts, self.plan.tokens, woken, set(self._params()))
            nodes = [] if self.plan.with_namespace and self.plan.with_name else [list(owner) for owner in owners]
            return {"interface": found, "traits": traits, "nodes": nodes}

    def known(self) -> Known:
        with self._lock:
            owners, own = list(self.facts.owners), self.facts.own()
            lost = {
                category: sorted(
                    spelled_for(owner, name, self.plan.tokens) for owner, each, name in own if each == category and name in self._refused
                )
                for category in ("subscribers", "clients")
            }
        return Known(
            contacted=bool(owners),
            registered=bool(owners),
            has_names=bool(own),
            count=len(own),
            overflow=self._overflow,
            unanswered=lost["clients"],
            untold=lost["subscribers"],
            missed=[],
            silence="it never showed up among the nodes",
            misses_nothing=False,
        )

    def doubts(self) -> List[Dict[str, str]]:
        with self._lock:
            mute = [owner for owner in self.facts.named() if all(params is None for _, params in self.facts.params.get(owner, []))]
        found = list(self._doubts)
        if mute:
            which = "it" if len(mute) == len(self.facts.named()) else ", ".join(each[1] for each in mute[:5])
            found.append({"code": "params-unanswered", "detail": "{} said nothing of its params when it was asked".format(which)})
        return found
