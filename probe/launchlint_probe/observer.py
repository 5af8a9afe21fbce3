"""Watches the graph of a domain of ROS 2, and stands in for what a node waits for: ``python3 observer.py``, a program of its own.

It is the only part of the probe that needs rclpy, and runs on the Python that this is installed for. Commands come as lines of JSON on
standard input, what it knows goes out likewise: ``{"graph": …}`` whenever the graph has changed, ``{"answer": ID, …}`` to each command.
"""

import importlib
import json
import os
import re
import select
import sys
import time
from functools import partial
from typing import Any, Callable, Dict, List, Optional, Set, Tuple

Json = Dict[str, Any]

NODE, NAMESPACE = "launchlint_observer", "/launchlint_probe"
OWN = (NAMESPACE, NODE)
STEP = 0.02
"""Seconds between two looks at the input."""
LOOK = 0.1
"""Seconds between two looks at the graph."""
MOST_TOPICS = 2_000
ANSWER = 3.0
"""Seconds that a node is given to answer a question."""
LOADING = 15.0
"""Seconds that a container is given to load a component."""
TICK = 0.1
"""Seconds between two messages of the clock."""
ROBOT = '<robot name="launchlint"><link name="base_link"/></robot>'
INFINITE = 9223372036854775807
CONFIGURE, ACTIVATE = 1, 3
"""Of lifecycle_msgs/Transition."""
SERVICE_TYPES = {
    "list": ("list_parameters", "rcl_interfaces/srv/ListParameters"),
    "describe": ("describe_parameters", "rcl_interfaces/srv/DescribeParameters"),
    "get": ("get_parameters", "rcl_interfaces/srv/GetParameters"),
    "set": ("set_parameters", "rcl_interfaces/srv/SetParameters"),
}
VALUES = (
    ("", ""),
    ("bool", "bool_value"),
    ("integer", "integer_value"),
    ("double", "double_value"),
    ("string", "string_value"),
    ("byte_array", "byte_array_value"),
    ("bool_array", "bool_array_value"),
    ("integer_array", "integer_array_value"),
    ("double_array", "double_array_value"),
    ("string_array", "string_array_value"),
)
"""The types of a param by their numbers (rcl_interfaces/ParameterType), and where a ParameterValue has its value."""
NOT_DECLARED = re.compile(r"not declared|undeclared")
"""What rclcpp and rclpy say of a param that a node has not declared."""
STRANGE_PARAM = "launchlint_undeclared"
"""No node declares it: who takes it takes any."""


class Unknown(Exception):
    """A type is not installed."""


def interface_class(kind: str) -> Any:
    """The Python class of ``package/msg/Name``. Raises Unknown."""
    package, _, rest = kind.partition("/")
    folder, _, name = rest.partition("/")
    try:
        return getattr(importlib.import_module("{}.{}".format(package, folder)), name)
    except (ImportError, AttributeError, ValueError):
        raise Unknown(kind) from None


def seconds(duration: Any) -> Any:
    """A time of a QoS profile; None where it says nothing."""
    nanoseconds = duration.nanoseconds
    if nanoseconds <= 0:
        return None
    return "infinite" if nanoseconds >= INFINITE else nanoseconds / 1e9


def word(policy: Any) -> Optional[str]:
    """A policy in the words of the library; None where it is not known."""
    name = str(getattr(policy, "name", policy)).lower()
    return None if name == "unknown" else name


def profile(qos: Any) -> Json:
    """What is known of a QoS profile."""
    found = {
        "reliability": word(qos.reliability),
        "durability": word(qos.durability),
        "history": word(qos.history),
        "depth": qos.depth if word(qos.history) == "keep_last" and qos.depth > 0 else None,
        "deadline": seconds(qos.deadline),
        "lifespan": seconds(qos.lifespan),
        "liveliness": word(qos.liveliness),
        "lease": seconds(qos.liveliness_lease_duration),
    }
    return {key: value for key, value in found.items() if value is not None}


def plain(value: Any) -> Any:
    """A value of a message as JSON has it."""
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, bytes):
        return list(value)
    return [each[0] if isinstance(each, bytes) and len(each) == 1 else each for each in value]


class Observer:
    """The observer's node, and what it has offered."""

    def __init__(self) -> None:
        self.rclpy: Any = importlib.import_module("rclpy")
        self.qos: Any = importlib.import_module("rclpy.qos")
        self.rclpy.init(args=[])
        self.node: Any = self.rclpy.create_node(NODE, namespace=NAMESPACE, start_parameter_services=False, enable_rosout=False)
        self.kept: Dict[Tuple[str, str], Any] = {}
        self.refused: Set[Tuple[str, str]] = set()
        self.graph: Json = {}
        self.clock: Any = None
        self.last_tick = 0.0

    # -- looking -----------------------------------------------------------------------------------------------

    def look(self) -> Json:
        """The graph without what is the observer's own."""
        node = self.node
        found: Dict[Tuple[str, str], Json] = {}
        for name, namespace in node.get_node_names_and_namespaces():
            if (namespace, name) != OWN:
                found.setdefault((namespace, name), {"name": name, "namespace": namespace})
        topics = node.get_topic_names_and_types()
        for topic, _ in topics[:MOST_TOPICS]:
            for category, look in (
                ("publishers", node.get_publishers_info_by_topic),
                ("subscribers", node.get_subscriptions_info_by_topic),
            ):
                for each in look(topic):
                    owner = found.get((each.node_namespace, each.node_name))
                    if owner is not None:
                        owner.setdefault(category, []).append([topic, each.topic_type, profile(each.qos_profile)])
        for (namespace, name), owner in found.items():
            for category, ask in (
                ("services", node.get_service_names_and_types_by_node),
                ("clients", node.get_client_names_and_types_by_node),
            ):
                try:
                    owner[category] = sorted([each, kinds[0]] for each, kinds in ask(name, namespace))
                except Exception:  # (the node has gone in between; each version has another exception for that)
                    continue
        for owner in found.values():
            for category in ("publishers", "subscribers"):
                if category in owner:
                    owner[category].sort(key=lambda each: (each[0], each[1], json.dumps(each[2], sort_keys=True)))
        return {"nodes": list(found.values()), "overflow": len(topics) > MOST_TOPICS}

    def others(self, category: str) -> Dict[str, str]:
        """Name → type of one category of all nodes."""
        return {entry[0]: entry[1] for node in self.graph.get("nodes", []) for entry in node.get(category, [])}

    # -- giving ------------------------------------------------------------------------------------------------

    def offer(self, kind: str, name: str, make: Callable[[], Any]) -> bool:
        """Make something once. Returns whether it was made now."""
        key = (kind, name)
        if key in self.kept or key in self.refused:
            return False
        try:
            self.kept[key] = make()
            return True
        except Exception:  # (a type that is not installed, or a name that this version does not take)
            self.refused.add(key)
            return False

    def listen(self, names: List[List[str]]) -> int:
        """Subscribe to topics; a subscriber with the least demands hears everybody."""
        return sum(self.offer("subscription", name, partial(self.subscription, name, kind)) for name, kind in names)

    def subscription(self, name: str, kind: str) -> Any:
        """A subscriber."""
        weak = self.qos.QoSProfile(
            depth=1, reliability=self.qos.ReliabilityPolicy.BEST_EFFORT, durability=self.qos.DurabilityPolicy.VOLATILE
        )
        return self.node.create_subscription(interface_class(kind), name, _ignore, weak, raw=True)

    def serve(self, names: List[List[str]]) -> int:
        """Serve services with empty answers; each goal of an action succeeds."""
        made = 0
        for name, kind in names:
            base, _, last = name.rpartition("/_action/")
            if base:
                if last == "send_goal":
                    made += self.offer("action", base, partial(self.action_server, base, kind))
            else:
                made += self.offer("service", name, partial(self.service, name, kind))
        return made

    def service(self, name: str, kind: str) -> Any:
        """A service that answers with what an answer is at first."""
        return self.node.create_service(interface_class(kind), name, lambda request, response: response)

    def action_server(self, name: str, kind: str) -> Any:
        """A server whose goals succeed at once."""
        action = interface_class(kind[: -len("_SendGoal")])

        def succeed(goal: Any) -> Any:
            goal.succeed()
            return action.Result()

        return importlib.import_module("rclpy.action").ActionServer(self.node, action, name, succeed)

    def send(self, names: List[List[str]]) -> int:
        """Publish an empty message on topics; a publisher that promises most is heard by everybody."""
        made = 0
        for name, kind in names:
            if name == "/clock":
                if self.clock is None:
                    self.clock = self.node.create_publisher(interface_class(kind), name, 10)
                    made += 1
            else:
                made += self.offer("publisher", name, partial(self.publisher, name, kind))
        return made

    def publisher(self, name: str, kind: str) -> Any:
        """A publisher that has sent its message, to whoever was there in time."""
        strong = self.qos.QoSProfile(
            depth=1, reliability=self.qos.ReliabilityPolicy.RELIABLE, durability=self.qos.DurabilityPolicy.TRANSIENT_LOCAL
        )
        message = interface_class(kind)()
        if name.rpartition("/")[2] == "robot_description" and kind == "std_msgs/msg/String":
            message.data = ROBOT
        publisher = self.node.create_publisher(type(message), name, strong)
        end = time.monotonic() + 1.0
        while publisher.get_subscription_count() == 0 and time.monotonic() < end:
            self.rclpy.spin_once(self.node, timeout_sec=STEP)
        publisher.publish(message)
        return publisher

    # -- asking ------------------------------------------------------------------------------------------------

    def ask(self, name: str, kind: str, request: Callable[[Any], Any], patience: float = ANSWER) -> Any:
        """The answer of a service; None where there is none in time."""
        try:
            service = interface_class(kind)
        except Unknown:
            return None
        client = self.node.create_client(service, name)
        try:
            end = time.monotonic() + patience
            while not client.service_is_ready():
                if time.monotonic() > end:
                    return None
                self.rclpy.spin_once(self.node, timeout_sec=STEP)
            future = client.call_async(request(service.Request()))
            while not future.done() and time.monotonic() < end:
                self.rclpy.spin_once(self.node, timeout_sec=STEP)
            return future.result() if future.done() else None
        finally:
            self.node.destroy_client(client)

    def params(self, node: str) -> Json:
        """The params of a node, with what it says of them; ``answered`` is false where it does not."""

        def about(question: str, request: Callable[[Any], Any]) -> Any:
            service, kind = SERVICE_TYPES[question]
            return self.ask("{}/{}".format(node, service), kind, request)

        listed = about("list", lambda request: request)
        if listed is None:
            return {"answered": False}
        names = list(listed.result.names)
        described = about("describe", lambda request: _with(request, names=names))
        got = about("get", lambda request: _with(request, names=names))
        if described is None or got is None or len(described.descriptors) != len(names) or len(got.values) != len(names):
            return {"answered": False}
        found = []
        for name, descriptor, value in zip(names, described.descriptors, got.values):
            kind, member = VALUES[value.type] if value.type < len(VALUES) else VALUES[0]
            entry: Json = {"name": name, "type": VALUES[descriptor.type][0] if descriptor.type < len(VALUES) else ""}
            if member:
                entry["default"] = plain(getattr(value, member))
                entry["type"] = entry["type"] or kind
            for bounds in list(descriptor.floating_point_range) + list(descriptor.integer_range):
                entry.update({"min": bounds.from_value, "max": bounds.to_value})
                if bounds.step:
                    entry["step"] = bounds.step
            if descriptor.description:
                entry["description"] = descriptor.description
            if descriptor.read_only:
                entry["read_only"] = True
            if getattr(descriptor, "dynamic_typing", False):
                entry["dynamic"] = True
            found.append(entry)
        return {"answered": True, "params": found}

    def takes_any(self, node: str) -> Json:
        """Whether a node takes a param that it has not declared: also where it is only this one's value that it does not want."""
        service, kind = SERVICE_TYPES["set"]
        strange = interface_class("rcl_interfaces/msg/Parameter")()
        strange.name = STRANGE_PARAM
        strange.value.type, strange.value.bool_value = 1, True
        done = self.ask("{}/{}".format(node, service), kind, lambda request: _with(request, parameters=[strange]))
        if done is None or not done.results:
            return {"taken": False}
        return {"taken": bool(done.results[0].successful or not NOT_DECLARED.search(done.results[0].reason))}

    def change_state(self, node: str, transition: int) -> Json:
        """Configure or activate a node with a lifecycle."""

        def request(made: Any) -> Any:
            made.transition.id = transition
            return made

        done = self.ask("{}/change_state".format(node), "lifecycle_msgs/srv/ChangeState", request, LOADING)
        return {"done": bool(done is not None and done.success), "answered": done is not None}

    def load(self, container: str, package: str, plugin: str, name: str, namespace: str, params: Json, remap: List[str]) -> Json:
        """Load a component into a container."""

        def request(made: Any) -> Any:
            made.package_name, made.plugin_name, made.node_name, made.node_namespace = package, plugin, name, namespace
            made.remap_rules = remap
            made.parameters = [self.parameter(each, value) for each, value in sorted(params.items())]
            return made

        done = self.ask("{}/_container/load_node".format(container), "composition_interfaces/srv/LoadNode", request, LOADING)
        if done is None:
            return {"done": False, "why": "the container does not answer"}
        return {"done": bool(done.success), "why": str(done.error_message), "node": str(done.full_node_name)}

    def parameter(self, name: str, value: Any) -> Any:
        """A param with its value as a message."""
        made = interface_class("rcl_interfaces/msg/Parameter")()
        made.name = name
        kinds = ("bool", "integer", "double", "string")
        single = value[0] if isinstance(value, list) and value else value
        kind = next((kind for kind, known in zip(kinds, (bool, int, float, str)) if isinstance(single, known)), "string")
        number = next(index for index, (each, _) in enumerate(VALUES) if each == (kind + "_array" if isinstance(value, list) else kind))
        made.value.type = number
        setattr(made.value, VALUES[number][1], value)
        return made

    # -- the loop ----------------------------------------------------------------------------------------------

    def run(self) -> None:
        """Look and obey until the input ends."""
        say({"ready": True})
        rest, next_look = b"", 0.0
        while True:
            self.rclpy.spin_once(self.node, timeout_sec=STEP)
            self.tick()
            if time.monotonic() >= next_look:
                graph = self.look()
                if graph != self.graph:
                    self.graph = graph
                    say({"graph": graph})
                next_look = time.monotonic() + LOOK
            if select.select([0], [], [], 0)[0]:
                chunk = os.read(0, 65536)
                if not chunk:
                    return
                *lines, rest = (rest + chunk).split(b"\n")
                for line in lines:
                    command = json.loads(line.decode("utf-8"))
                    say(dict(self.obey(command), answer=command["id"]))

    def tick(self) -> None:
        """Let the clock go on, where there is one."""
        now = time.monotonic()
        if self.clock is not None and now - self.last_tick >= TICK:
            self.last_tick = now
            message = self.clock.msg_type()
            message.clock.sec, message.clock.nanosec = divmod(int(time.time() * 1e9), 1_000_000_000)
            self.clock.publish(message)

    def obey(self, command: Json) -> Json:
        """Do what a command says."""
        do = command["do"]
        if do in ("listen", "serve", "send"):
            made = {"listen": self.listen, "serve": self.serve, "send": self.send}[do](command["names"])
            return {"made": made, "refused": sorted(name for _, name in self.refused)}
        if do == "params":
            return self.params(command["node"])
        if do == "takes_any":
            return self.takes_any(command["node"])
        if do == "state":
            return self.change_state(command["node"], command["transition"])
        return self.load(**command["what"])


def _ignore(message: Any) -> None:
    """Whatever is said: it is enough that somebody listens."""


def _with(message: Any, **values: Any) -> Any:
    for name, value in values.items():
        setattr(message, name, value)
    return message


def say(record: Json) -> None:
    """Write one line."""
    sys.stdout.write(json.dumps(record) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    try:
        Observer().run()
    except (BrokenPipeError, KeyboardInterrupt):
        os._exit(0)
    os._exit(0)  # nothing is worth waiting for, and some middlewares wait long
